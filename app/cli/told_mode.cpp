// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/told_mode.h"

namespace codewheel {
namespace {

constexpr std::int64_t startsUpAsK3 = 1; // read-out 9, FRABA manual 10.2

} // namespace

void tellMode(EncoderSession &encoder, const Arguments &arguments)
{
    if (arguments.has(inPositionModeOption.name) && !encoder.latest().mode)
        encoder.tell(Parameter::startUpMode, startsUpAsK3);
}

} // namespace codewheel
