// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/cam_program.h"
#include "encoder/known.h"
#include "line/line_wish.h"
#include "project/word_list.h"
#include "ring/participant.h"

#include <QDateTime>
#include <QString>

#include <map>
#include <optional>
#include <vector>

namespace codewheel {

// What the user reads from the label of a device; 0 or empty: not told.
struct DeviceLabel
{
    int turns = 0;
    int stepsPerTurn = 0;
    QString serialNumber;

    friend bool operator==(const DeviceLabel &, const DeviceLabel &) = default;
};

// A value an encoder was known to have, kept in the project.
struct StoredValue
{
    Parameter parameter = Parameter::steps;
    std::int64_t value = 0;
    Evidence evidence = Evidence::told;
    QDateTime at; // UTC

    friend bool operator==(const StoredValue &, const StoredValue &) = default;
};
struct StoredCams
{
    CamProgram program;
    Evidence evidence = Evidence::read;
    QDateTime at; // UTC

    friend bool operator==(const StoredCams &, const StoredCams &) = default;
};

// The position an encoder showed last, for the one that replaces it.
struct LastPosition
{
    std::int64_t position = 0; // steps
    QDateTime at;              // UTC

    friend bool operator==(const LastPosition &, const LastPosition &) = default;
};

// One device of the planned bus, and what is wanted and known of it.
struct ProjectDevice
{
    BusId bus = firstRing;
    Participant
        participant; // its number follows from its place and level, or is its address on a serial line
    QString station; // "Crane 1, hoist"; empty: none
    QString group;
    QString note;
    DeviceLabel label;
    std::optional<int> inAddress; // given by hand, in bytes; nothing: automatic
    std::optional<int> outAddress;
    ParameterValues wanted;             // by parameter
    std::vector<CamProgram> wantedCams; // by number
    std::vector<StoredValue> stored;    // by parameter
    std::vector<StoredCams> storedCams; // by number
    std::optional<LastPosition> lastPosition;
    bool swapsWarningBytes = false; // on a serial line: its warnings come with the low byte first

    Place place() const { return {bus, participant.number}; }
    void standAt(Place place)
    {
        bus = place.bus;
        participant.number = place.node;
    }

    friend bool operator==(const ProjectDevice &, const ProjectDevice &) = default;
};

// The USB adapter that a serial line is connected by, as far as it tells: by its serial number, else by its
// place on USB, it is known again after it was plugged in elsewhere. 0 or empty: not told.
struct LineAdapter
{
    int vendor = 0;
    int product = 0;
    QString serialNumber;
    QString usbPath; // "1-2.4:1.0"

    friend bool operator==(const LineAdapter &, const LineAdapter &) = default;
};

// A serial line beside the ring.
struct ProjectLine
{
    LineWish wish; // the file keeps of its timing: time-out, retries, and the quiet after a write
    LineAdapter adapter;
    std::vector<ProjectDevice> encoders; // by address

    friend bool operator==(const ProjectLine &, const ProjectLine &) = default;
};

struct ProjectSequence
{
    QString name;
    WordList list;

    friend bool operator==(const ProjectSequence &, const ProjectSequence &) = default;
};

// How addresses in the process image are counted and checked.
struct AddressRules
{
    enum class Unit : std::uint8_t { byte, word };

    Unit unit = Unit::byte; // shown and typed
    int first = 0;          // of automatic addresses, bytes
    bool step5 = false;     // encoders must stand above P127 (Step 5)

    friend bool operator==(const AddressRules &, const AddressRules &) = default;
};

// The link the project is used with: its kind ("training") and settings, as its file keeps them.
struct ProjectLink
{
    QString kind = QStringLiteral("training");
    std::map<QString, QString> settings;

    friend bool operator==(const ProjectLink &, const ProjectLink &) = default;
};

// The document: a planned bus with what is wanted of its encoders, and a serial line beside it. A value;
// edits make a new one. Its file is documented in docs/project-files.md.
struct Project
{
    QString title;
    QString note;
    ProjectLink link;
    AddressRules addresses;
    double cableKilometres = 0;
    std::vector<ProjectDevice> devices; // in ring order
    std::vector<ProjectSequence> sequences;
    std::optional<ProjectLine> line;

    friend bool operator==(const Project &, const Project &) = default;
};

// The device of this number in the ring or on the serial line; null: the project has none.
const ProjectDevice *findDevice(const Project &project, Place number);
ProjectDevice *findDevice(Project &project, Place number);

} // namespace codewheel
