// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/snapshot.h"

#include <QString>

#include <array>

namespace codewheel {

class EncoderSession;

// The LEDs on the housing of a device, as they should be according to the master: UL supply, RC remote bus
// check, BA bus active, RBDA remote bus disabled (FRABA manual 3.3).
enum class LedLight : std::uint8_t { off, on, blinking };
struct DeviceLeds
{
    LedLight ul = LedLight::on;
    LedLight rc = LedLight::off;
    LedLight ba = LedLight::off;
    LedLight rbda = LedLight::off;

    friend bool operator==(const DeviceLeds &, const DeviceLeds &) = default;
};

// `inRing` false: behind a fault, or switched off with its segment. No master can tell whether a device there
// has power; UL is assumed to be on.
constexpr DeviceLeds ledsOf(MasterState state, bool inRing)
{
    if (!inRing || state == MasterState::busFail)
        return {.rbda = LedLight::on};
    DeviceLeds leds{.rc = LedLight::on};
    if (state == MasterState::active)
        leds.ba = LedLight::blinking;
    else if (state == MasterState::run)
        leds.ba = LedLight::on;
    return leds;
}

// Whether its description covers these four. LWL encoders have two more, for the fibre; one on Loop 2 has a
// single one, and the manual does not say what it shows (FRABA manual 3.3).
bool hasRemoteBusLeds(const EncoderSession *encoder);

// "UL on, RC on, BA blinking, RBDA off", in the user's language.
QString ledText(const DeviceLeds &leds);
QString ledLightName(LedLight state);

} // namespace codewheel
