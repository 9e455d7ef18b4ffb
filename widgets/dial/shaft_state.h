// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/parameter.h"
#include "widgets/dial/dial_state.h"

#include <array>
#include <cstdint>

namespace codewheel {

class EncoderSession;

// What has to be known of an encoder for its disc to turn.
inline constexpr std::array shaftValues{Parameter::steps, Parameter::revolutions, Parameter::scaling,
                                        Parameter::direction, Parameter::coding};

// How a position turns the disc.
struct ShaftScale
{
    double stepsPerTurn = 0;
    bool clockwise = true;
    bool countsTurns = true;

    double turns(std::int64_t position) const { return static_cast<double>(position) / stepsPerTurn; }
    double turnFraction(std::int64_t position) const { return partOfTurn(turns(position), clockwise); }
};

// Empty where something of it is not known.
std::optional<ShaftScale> shaftScale(const EncoderSession &encoder);
// What the dial shows of the encoder now. `missing`: the names of the shaftValues that are not known.
DialState shaftState(const EncoderSession &encoder, const std::optional<ShaftScale> &scale,
                     const QString &missing);

} // namespace codewheel
