// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/encoder_session.h"
#include "project/project.h"

namespace codewheel {

class Catalog;
class ProjectPlaces;

// What the encoder at a place shall have, wherever that was taken from.
struct TransferWish
{
    Place place;
    QString station{};
    unsigned deviceCode = 0; // of the device the values are for; 0: any
    QString deviceKey{};     // of the catalog; empty: the make is not known
    QString serialNumber{};  // on the label of the encoder the values are for; empty: not told
    ParameterValues values{};
    std::vector<CamProgram> cams{};
    // Set the position to this, in steps, after the values.
    std::optional<std::int64_t> position{};
    // An encoder nobody has seen before is brought to position mode first, where it has modes.
    bool toPositionMode = false;
    // Why it cannot be, where that is known already: nothing is compared then.
    std::optional<Refusal> hindrance{};
};

enum class TransferSource : std::uint8_t { wanted, stored };

// What the project wants of the device, or what was stored of it; not where it stands on its bus.
TransferWish wishOf(const ProjectDevice &device, TransferSource source, const ProjectPlaces &places,
                    const Catalog &catalog);

// What was stored of the device that an encoder of this description may be given (isSetting).
ParameterValues storedSettings(const ProjectDevice &device, const DeviceDescription *description);

// What is known of one encoder, for another of the same kind (encodersDiffer). The zero offset stays behind:
// it belongs to the way the encoder is mounted.
TransferWish wishToClone(const EncoderSession &from, const EncoderSession &to, bool withCams);

// Without address and baud rate: with another one an encoder has to be looked for.
ParameterValues withoutItsPlace(ParameterValues values);

// Whether this is something an encoder is set to, and another one, or the same one later, can be given: not
// what it only tells, as the preset of one whose command for it sets the position, and not where it stands on
// its bus (address, baud rate). `device`: null where it is not known.
bool isSetting(const DeviceDescription *device, const ParameterValue &value);

} // namespace codewheel
