// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "catalog/json_object.h"

#include <QCoreApplication>

namespace codewheel {

// What a description must be like so that what is sent to the encoder is right, as far as its protocol
// decides it (docs/device-descriptions.md, "What belongs together"). What breaks a rule is reported to its
// object. One object for each protocol; as it stands, of one without parameters.
class ProtocolRules
{
public:
    virtual ~ProtocolRules() = default;

    // Whether an encoder has parameters that this program can write or read.
    virtual bool hasParameters() const { return false; }
    // In the process image of its bus, with an ID code; else it is asked by requests.
    virtual bool hasWords() const { return true; }
    // Whether the service or command that sets the position brings the value along; a K3 has it as a
    // parameter.
    virtual bool presetsByCommand() const { return false; }
    // That can be told to an encoder. All values are from 0.
    virtual std::int64_t largestData() const { return 0; }

    // Of the row a parameter was read from: its range, and the words or commands that the protocol has for
    // it.
    virtual void checkParameter(const JsonObject &row, const ParameterDescription &parameter,
                                const DeviceDescription &device) const;
    // Gives what the protocol knows of it beside the row.
    virtual void complete(ParameterDescription & /*parameter*/) const {}
    // Of the capabilities: where the position that is set comes from.
    virtual void checkPresets(const JsonObject & /*json*/, const DeviceDescription & /*device*/) const {}
};

const ProtocolRules &protocolRules(Profile profile);

// Where the protocol decides what a parameter has for reading or writing it, as shown: a word or a service
// that moves the position must not pass for one that stores a value.
void checkPlace(const JsonObject &row, const char *key, const QString &given, const QString &known,
                const ParameterDescription &parameter, Profile profile);

} // namespace codewheel
