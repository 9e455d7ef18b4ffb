// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_live.h"

#include "cams/cam_states.h"
#include "vocabulary/encoder_session.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr int partBits = 17; // D24..D8

// Nothing where no part is shown, or where it fits several positions of the range.
std::optional<CamLive::Position> positionOf(const Reading::Cams &cams, unsigned shift, std::int64_t largest)
{
    if (shift >= CamProgram::largestShift || largest >> shift >= std::int64_t{1} << partBits)
        return std::nullopt;
    const std::int64_t first = std::int64_t{cams.positionPart} << shift;
    return CamLive::Position{first, first + (std::int64_t{1} << shift) - 1};
}

} // namespace

bool CamLive::knowsAny() const
{
    return std::ranges::any_of(on, [](const std::optional<bool> &one) { return one.has_value(); });
}

CamLive camLive(const EncoderSession &encoder, const CamProgram &shown, std::int64_t largest)
{
    const Reading &reading = encoder.latest();
    CamLive live;
    live.isOld = encoder.freshness().isOld();
    if (reading.cams) {
        const auto running = reading.camProgram ? encoder.cams(*reading.camProgram) : std::nullopt;
        if (running)
            live.position = positionOf(*reading.cams, running->program.shift, largest);
        if (reading.camProgram == shown.number && !live.isOld) {
            for (std::size_t n = 0; n < CamProgram::cams; ++n)
                live.on.at(n) = (reading.cams->on >> n & 1U) != 0;
            live.isTold = true;
            return live;
        }
    } else if (reading.position && *reading.position >= 0) {
        live.position = CamLive::Position{*reading.position, *reading.position};
    }
    if (live.position && !live.isOld)
        for (std::size_t n = 0; n < CamProgram::cams; ++n)
            live.on.at(n) = isOn(shown.cam.at(n), live.position->first, live.position->last);
    return live;
}

} // namespace codewheel
