// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "catalog/json_object.h"

#include <QCoreApplication>

namespace codewheel {

// What a description has to satisfy so that what is sent to the encoder is right, as far as its protocol
// decides it (docs/device-descriptions.md, "What belongs together"). Violations are reported to their object.
// One object per protocol; the base class stands for a protocol without parameters.
class ProtocolRules
{
public:
    virtual ~ProtocolRules() = default;

    // Whether an encoder has parameters that this program can write or read.
    virtual bool hasParameters() const { return false; }
    // In the process image of its bus, with an ID code; otherwise it is asked by requests.
    virtual bool hasWords() const { return true; }
    // Whether the service or command that sets the position carries the value; a K3 has it as a parameter.
    virtual bool presetsByCommand() const { return false; }
    // The largest that can be sent to an encoder. All values start at 0.
    virtual std::int64_t largestData() const { return 0; }

    // For the row a parameter was read from: its range, and the words or commands the protocol has for it.
    virtual void checkParameter(const JsonObject &row, const ParameterDescription &parameter,
                                const DeviceDescription &device) const;
    // Adds what the protocol knows beyond the row.
    virtual void complete(ParameterDescription & /*parameter*/) const {}
    // For the capabilities: where the new position comes from.
    virtual void checkPresets(const JsonObject & /*json*/, const DeviceDescription & /*device*/) const {}
};

const ProtocolRules &protocolRules(Profile profile);

// Words have no letters, while the commands of a description are letters.
void refuseCommands(const JsonObject &row);

// Where the protocol fixes what a parameter is read or written with, as shown: a word or a service that moves
// the position must not pass for one that stores a value.
void checkPlace(const JsonObject &row, const char *key, const QString &given, const QString &known,
                const ParameterDescription &parameter, Profile profile);

} // namespace codewheel
