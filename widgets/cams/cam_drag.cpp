// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_drag.h"

#include "widgets/cams/cam_circle.h"

#include <cmath>

namespace codewheel {
namespace {

constexpr double pull = 4; // within so many columns the last position attracts

// To a round number where a column is many positions; snaps to the last position.
std::int64_t rounded(double position, const RulerScale &scale)
{
    const std::int64_t step = scale.dragStep();
    const auto end = static_cast<double>(scale.total());
    if (step > 1 && std::abs(scale.x(position) - scale.x(end)) < pull)
        return scale.largest();
    return std::llround(position / static_cast<double>(step)) * step;
}

Cam drawnCam(double from, double to, const RulerScale &scale)
{
    const auto within = [&](double position) {
        return std::clamp<std::int64_t>(rounded(std::floor(position), scale), 0, scale.largest());
    };
    return {within(std::min(from, to)), within(std::max(from, to)), true};
}

} // namespace

std::optional<CamGrip> gripAt(const Cam &cam, double x, const RulerScale &scale, double reach)
{
    if (cam_circle::isEmpty(cam))
        return std::nullopt;
    for (const auto &stretch : cam_circle::stretches(cam, scale.largest())) {
        const double left = scale.x(static_cast<double>(stretch.first));
        const double right = scale.x(static_cast<double>(stretch.last) + 1);
        const double inside = std::min(reach, (right - left) / 3);
        if (stretch.hasStart && x >= left - reach && x < left + inside)
            return CamGrip::start;
        if (stretch.hasStop && x > right - inside && x <= right + reach)
            return CamGrip::stop;
        if (x >= left && x < right)
            return CamGrip::bar;
    }
    return std::nullopt;
}

Cam gripMoved(const Cam &cam, CamGrip grip, std::int64_t by, std::int64_t total)
{
    switch (grip) {
    case CamGrip::start:
        return cam_circle::startMoved(cam, by, total);
    case CamGrip::stop:
        return cam_circle::stopMoved(cam, by, total);
    case CamGrip::bar:
        break;
    }
    return cam_circle::moved(cam, by, total);
}

// Measured from the edge, so that it does not jump when the drag begins.
Cam CamDrag::at(double position, const RulerScale &scale) const
{
    if (creates)
        return drawnCam(from, position, scale);
    const std::int64_t total = scale.total();
    const std::int64_t edge =
        grip == CamGrip::stop ? before.start + cam_circle::length(before, total) - 1 : before.start;
    const std::int64_t way = rounded(static_cast<double>(edge) + position - from, scale) - edge;
    return gripMoved(before, grip, way, total);
}

} // namespace codewheel
