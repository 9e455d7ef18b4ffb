// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_live.h"

#include "cams/cam_states.h"
#include "encoder/encoder_session.h"

namespace codewheel {
namespace {

constexpr int partBits = 17; // D24..D8

// Nothing where no part is shown, or where it fits several places of the range.
std::optional<CamLive::Position> positionOf(const Reading::Cams &cams, unsigned shift, std::int64_t largest)
{
    if (shift >= CamProgram::largestShift || largest >> shift >= std::int64_t{1} << partBits)
        return std::nullopt;
    const std::int64_t first = std::int64_t{cams.positionPart} << shift;
    return CamLive::Position{first, first + (std::int64_t{1} << shift) - 1};
}

} // namespace

CamLive camLive(const EncoderSession &encoder, const CamProgram &shown, std::int64_t largest)
{
    const Reading &reading = encoder.latest();
    CamLive live;
    if (reading.cams) {
        const auto running = reading.camProgram ? encoder.cams(*reading.camProgram) : std::nullopt;
        if (running)
            live.position = positionOf(*reading.cams, running->program.shift, largest);
        if (reading.camProgram == shown.number) {
            live.on = reading.cams->on;
            live.isTold = true;
            return live;
        }
    } else if (reading.position && *reading.position >= 0) {
        live.position = CamLive::Position{*reading.position, *reading.position};
    }
    // Between the two ends of a coarse position a cam may be either.
    if (live.position && states(shown, live.position->first) == states(shown, live.position->last))
        live.on = states(shown, live.position->first);
    return live;
}

} // namespace codewheel
