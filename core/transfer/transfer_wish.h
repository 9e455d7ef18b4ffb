// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/encoder_session.h"
#include "project/project.h"

namespace codewheel {

class ProjectPlaces;

// What the encoder at a place shall have, wherever that was taken from.
struct TransferWish
{
    Place place;
    QString station{};
    unsigned deviceCode = 0; // of the device the values are for; 0: any
    QString deviceKey{};     // of the catalog; empty: the make is not known
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

// What the project wants of the device, or what was stored of it.
TransferWish wishOf(const ProjectDevice &device, TransferSource source, const ProjectPlaces &places);

// What was stored of the device, without what it tells of itself.
ParameterValues storedSettings(const ProjectDevice &device);

// What is known of one encoder, for another of the same kind (encodersDiffer). The zero offset stays behind:
// it belongs to the way the encoder is mounted.
TransferWish wishToClone(const EncoderSession &from, const EncoderSession &to, bool withCams);

// Whether this is something an encoder is set to, not something it tells of itself.
bool isSetting(Parameter parameter);

} // namespace codewheel
