// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_tables.h"
#include "catalog/ordering_key.h"
#include "catalog/profile.h"
#include "vocabulary/capabilities.h"
#include "vocabulary/find_by.h"
#include "vocabulary/kind_data.h"
#include "vocabulary/own_kind.h"
#include "vocabulary/parameter.h"
#include "vocabulary/position_coding.h"
#include "vocabulary/refusal.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <utility>
#include <vector>

namespace codewheel {

// A named value: direction 3 = "cw".
struct Choice
{
    std::int64_t value = 0;
    QString key; // language-neutral: "cw", "unsigned-ccw"

    friend bool operator==(const Choice &, const Choice &) = default;
};

enum class Unit : std::uint8_t {
    none,
    steps,
    revolutions,
    tenMinutes,
    tenthDegreeCelsius,
    micrometres,
    tenthHours,
    milliseconds
};

// Values that are not plain numbers, as the manual of their protocol writes them. What the options hold, only
// the protocol knows.
struct ValueForm
{
    using Range = std::pair<std::int64_t, std::int64_t>;

    QString (*text)(std::int64_t value, const KindData &options) = nullptr;
    // Set if the range of the value depends on the options; empty: they do not tell.
    std::optional<Range> (*range)(const KindData &options) = nullptr;
    QString (*rangeText)() = nullptr; // if the options are not known
    // The number that the encoder sends for it, where that may be another; empty: it is the same.
    std::optional<std::int64_t> (*asSent)(std::int64_t value, const KindData &options) = nullptr;
    bool (*isInWords)(std::int64_t value) = nullptr; // told without the unit of the parameter
    int typedHexDigits = 0; // it is typed as hexadecimal number with so many digits; 0: decimal
};

struct ParameterDescription
{
    Parameter parameter = Parameter::steps;
    KindData reach{}; // what its protocol writes and reads it with; made by ProtocolRules::readReach()
    bool canBeRead = false;
    bool canBeWritten = false;
    bool isNeededAfterLoss = false; // an encoder that has lost its parameters works again only with it
    std::int64_t minimum = 0;
    std::int64_t maximum = 0;
    std::optional<std::int64_t> factory;
    Unit unit = Unit::none;
    bool stored = true;              // in EEPROM
    bool onLabel = false;            // from the label, entered by the user; neither written nor read
    std::vector<Choice> choices;     // empty: any value within the range
    LocalText chapter{};             // of the manual; may be empty
    bool isDetail = false;           // read only if it is asked for, and folded away: a register of a chip
    int textLength = 0;              // a text of so many characters at most; 0: a number
    int hexDigits = 0;               // shown as hexadecimal number with so many digits; 0: decimal
    const ValueForm *form = nullptr; // null: a number
    LocalText name{};                // where only some encoders have it; empty: everybody knows it

    bool isText() const { return textLength > 0; }
    // A text that is short enough, one of the choices if there are any, otherwise any value within the range.
    bool takes(const Value &value) const;
    const Choice *findChoice(const Value &value) const { return findBy(choices, value, &Choice::value); }
    const Choice *findChoice(QStringView key) const { return findBy(choices, key, &Choice::key); }

    friend bool operator==(const ParameterDescription &, const ParameterDescription &) = default;
};

// An error number in IN (D28..D25) and what it means.
struct DeviceError
{
    unsigned number = 0;
    RefusalCode meaning = RefusalId::otherDeviceError;
    bool warning = false; // run is answered although the cause remains (Baumer 14)
    LocalText text{};     // as the manual puts it; may be empty

    friend bool operator==(const DeviceError &, const DeviceError &) = default;
};

// Where this make differs from the profile.
struct Quirks
{
    bool confirmsWhileProcessing = false; // FRABA: the number at once; Baumer: the previous number first
    bool presetNeedsRearming = false;     // FRABA: a programmed preset can be activated once
    bool mayCountStepsMinusOne = false;   // FRABA: flag_mt_stepsm1
    bool hasModes = false;                // FRABA: velocity and cam mode

    friend bool operator==(const Quirks &, const Quirks &) = default;
};

// One kind of encoder, as its JSON file in resources/devices describes it.
struct DeviceDescription
{
    QString key;     // "fraba-ocd-ib"
    QString vendor;  // "FRABA"; empty for a generic description
    QString name;    // "OCD-IB K3"
    QString manual;  // the source, with edition
    LocalText notes; // what is assumed where the manual is silent; may be empty
    Profile profile;
    OwnKind dialect;         // where makes of one protocol differ
    KindData ofKind{};       // what only its protocol asks for
    unsigned idCode = 0;     // 37h
    unsigned deviceCode = 0; // 0237h = length code << 8 | ID code
    int inWords = 2;         // 16 bit each
    int outWords = 2;
    int physicalStepsPerTurn = 0; // 0: not known
    int physicalTurns = 0;        // 0: not known
    // For the position of a K1 or K2. With a K3 it depends on the make or on a parameter.
    PositionCoding coding = PositionCoding::binary;
    std::vector<ParameterDescription> parameters;
    std::vector<DeviceError> errors;
    Capabilities capabilities;
    Quirks quirks;
    // What the manual's tables say of it; empty where it has none.
    std::vector<Connector> connectors;
    std::optional<Leds> leds;
    Supply supply;
    std::vector<LimitTable> limits;
    std::optional<OrderingKey> orderingKey;

    const ParameterDescription *find(Parameter parameter) const
    {
        return findBy(parameters, parameter, &ParameterDescription::parameter);
    }
    // All that can be read except details, which have to be asked for by name.
    std::vector<Parameter> readableValues() const;
    const DeviceError *findError(unsigned number) const
    {
        return findBy(errors, number, &DeviceError::number);
    }
    bool isGeneric() const { return vendor.isEmpty(); }
    // It is in the process image of its bus; an encoder without words is asked by requests.
    bool hasWords() const { return inWords > 0; }
    // FRABA has velocity and cam mode, and a K3 of unknown make may be a FRABA: then the mode has to be known
    // before sending a word that means something else in cam mode.
    bool mayHaveModes() const;
    // "FRABA OCD-IB K3"; "K3, make not known" for a generic description.
    QString fullName() const;
    // The resolution on a label takes precedence over the description; 0: not on the label.
    DeviceDescription labelled(int turns, int stepsPerTurn) const;
    QString notesText() const { return notes.toString(); }

    friend bool operator==(const DeviceDescription &, const DeviceDescription &) = default;
};

// As its description names it, in the user's language; others may name it otherwise.
QString parameterName(const ParameterDescription &parameter);
// Null, or without the parameter: as parameterName(Parameter).
QString parameterName(const DeviceDescription *device, Parameter parameter);
// The same in running text.
QString parameterNameInText(const DeviceDescription &device, Parameter parameter);

// Whether the word or command that sets the position may write to the EEPROM. A K3 of unknown make may be a
// FRABA, which stores the zero offset.
bool mayStorePreset(const DeviceDescription &device);

} // namespace codewheel
