// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "project/project.h"
#include "vocabulary/encoder_session.h"

namespace codewheel {

class Catalog;
class ProjectPlaces;

// What the encoder at a place shall have, wherever that comes from.
struct TransferWish
{
    Place place;
    QString station{};
    unsigned deviceCode = 0; // of the device the values are for; 0: any
    QString deviceKey{};     // from the catalog; empty: the make is not known
    QString serialNumber{};  // on the label of the encoder the values are for; empty: not given
    ParameterValues values{};
    std::vector<CamProgram> cams{};
    // Set the position to this, in steps, after the values.
    std::optional<std::int64_t> position{};
    // An encoder never seen before is brought to position mode first, if it has modes.
    bool toPositionMode = false;
    // What the encoder is that replaces another at its place: nothing that is known of the place is known of
    // it. Empty: the encoder is the one that is there.
    std::optional<DeviceDescription> newEncoder{};
    // Why it cannot be done, if that is already known: nothing is compared then.
    std::optional<Refusal> hindrance{};
};

enum class TransferSource : std::uint8_t { wanted, stored };

// What the project wants of the device, or what was stored of it; not its place on the bus.
TransferWish wishOf(const ProjectDevice &device, TransferSource source, const ProjectPlaces &places,
                    const Catalog &catalog);

// What is wanted of the device that a transfer may write: neither its place on the bus nor commands
// (isCommand).
ParameterValues wantedSettings(const ProjectDevice &device, const DeviceDescription *description);

// What was stored of the device that an encoder of this description may be given (isSetting).
ParameterValues storedSettings(const ProjectDevice &device, const DeviceDescription *description);

// What is known of one encoder, for another of the same kind (encodersDiffer). The zero offset is left out:
// it belongs to the way the encoder is mounted.
TransferWish wishToClone(const EncoderSession &from, const EncoderSession &to, bool withCams);

// Without address and baud rate: after changing them an encoder has to be searched for.
ParameterValues withoutItsPlace(ParameterValues values);

// Whether this is something an encoder is set to and that can be given to another one, or later to the same
// one: not what it merely reports, such as the preset of an encoder whose preset command sets the position,
// not its place on the bus (address, baud rate), and no command (isCommand). `device`: null if not known.
bool isSetting(const DeviceDescription *device, const ParameterValue &value);

} // namespace codewheel
