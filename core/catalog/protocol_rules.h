// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "catalog/json_object.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {

class WordMeanings;

// What a description has to satisfy so that what is sent to the encoder is right, as far as its protocol
// decides it (docs/device-descriptions.md, "What belongs together"). Violations are reported to their object.
// One object per protocol; the base class stands for one that knows nothing: no words, no parameters.
class ProtocolRules
{
public:
    virtual ~ProtocolRules() = default;

    // Whether an encoder has parameters that this program can write or read.
    virtual bool hasParameters() const { return false; }
    // In the process image of its bus, with an ID code; otherwise it is asked by requests.
    virtual bool hasWords() const { return false; }
    // What its words mean; null: it has none.
    virtual const WordMeanings *wordMeanings() const { return nullptr; }
    // The bits that a position can have at most.
    virtual int positionBits(const DeviceDescription &device) const { return device.inWords * 16; }
    // The positions that this are.
    std::int64_t largestTotalRange(const DeviceDescription &device) const
    {
        return std::int64_t{1} << positionBits(device);
    }
    // It tells the place on a rod, not turns.
    virtual bool measuresLength(const DeviceDescription & /*device*/) const { return false; }
    // What an encoder takes is valid only after run, not at once.
    virtual bool activatesByRun() const { return false; }
    // What is in force is kept without supply only after a step that stores it.
    virtual bool storesByStep() const { return false; }
    // Earlier values can be written again only behind a run, which first makes valid what was taken.
    virtual bool restoresBehindRun(const DeviceDescription & /*device*/) const { return false; }
    // Its positions have one coding, which nobody has to be told.
    virtual bool hasOneCoding(const DeviceDescription & /*device*/) const { return false; }
    // The makes differ so much that one that is not known may have modes, or store its preset.
    virtual bool dependsOnMake() const { return false; }
    // Its positions have the same coding for ever, which the description tells.
    virtual bool hasFixedCoding() const { return false; }
    // Whether the service or command that sets the position carries the value; a K3 has it as a parameter.
    virtual bool presetsByCommand() const { return false; }
    // The numbers that can be sent to an encoder.
    virtual std::int64_t smallestData() const { return 0; }
    virtual std::int64_t largestData() const { return 0; }
    // Parameters may be texts.
    virtual bool hasTexts() const { return false; }
    // Its parameters are objects of a dictionary.
    virtual bool hasObjects() const { return false; }

    // What a row may say of how its parameter is reached, whatever the protocol.
    static constexpr std::array reachKeys{"number", "readOut", "read", "write", "bit", "object"};
    // Likewise, only where there are objects.
    static constexpr std::array objectKeys{"object", "type", "access"};
    // Takes it over: `reach`, `canBeRead`, `canBeWritten`. A protocol that writes and reads nothing takes
    // nothing.
    virtual void readReach(const JsonObject & /*row*/, ParameterDescription & /*parameter*/,
                           const DeviceDescription & /*before*/) const
    {}
    // How it is written and read, as the manual calls it: "1" and "13", "GR" and "D"; empty: it is not.
    struct ReachText
    {
        QString write{};
        QString read{};
    };
    virtual ReachText reachText(const ParameterDescription & /*parameter*/) const { return {}; }

    // What makes of the same protocol do differently.
    virtual void readDialect(const JsonObject &json, DeviceDescription &device) const;
    // ID code and words.
    virtual void readPlaceOnBus(const JsonObject &json, DeviceDescription &device) const;

    // For the row a parameter was read from: its range, and the words or commands the protocol has for it.
    virtual void checkParameter(const JsonObject &row, const ParameterDescription &parameter,
                                const DeviceDescription &device) const;
    // Adds what the protocol knows beyond the row.
    virtual void complete(ParameterDescription & /*parameter*/) const {}
    // For the capabilities: where the new position comes from.
    virtual void checkPresets(const JsonObject & /*json*/, const DeviceDescription & /*device*/) const {}
    // What only some protocols and makes can do: cams, velocity, resets. Refused here.
    virtual void checkAbilities(const JsonObject &json, const DeviceDescription &device) const;
    // Refused here.
    virtual void checkQuirks(const JsonObject &json, const DeviceDescription &device) const;
};

// Of a profile that no kind has: those of the base class.
const ProtocolRules &protocolRules(Profile profile);

// Its words hold the position and nothing else that this program can read or write.
inline bool onlyTellsPosition(const DeviceDescription &device)
{
    return !protocolRules(device.profile).hasParameters();
}

// An encoder that tells the place on a rod, not turns.
inline bool isRod(const DeviceDescription &device)
{
    return protocolRules(device.profile).measuresLength(device);
}

// An object that can only be written is a command to its device, such as one that stores and resets: no
// setting that another encoder could be given.
inline bool isCommand(const DeviceDescription &device, const ParameterDescription &parameter)
{
    return protocolRules(device.profile).hasObjects() && parameter.canBeWritten && !parameter.canBeRead;
}

inline bool activatesByRun(const DeviceDescription &device)
{
    return protocolRules(device.profile).activatesByRun();
}

inline bool restoresBehindRun(const DeviceDescription &device)
{
    return protocolRules(device.profile).restoresBehindRun(device);
}

// "An encoder of the profile K1 cannot do this. Write false."
void refuseAbility(const JsonObject &json, const char *key, bool isClaimed, Profile profile);

// Words have no letters, while the commands of a description are letters.
void refuseCommands(const JsonObject &row);

// Where the protocol fixes what a parameter is read or written with, as shown: a word or a service that moves
// the position must not pass for one that stores a value.
void checkPlace(const JsonObject &row, const char *key, const QString &given, const QString &known,
                const ParameterDescription &parameter, Profile profile);

} // namespace codewheel
