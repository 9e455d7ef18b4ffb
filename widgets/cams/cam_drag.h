// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/cams/cam_document.h"
#include "widgets/cams/ruler_scale.h"

#include <optional>

namespace codewheel {

// The part of a cam that is moved.
enum class CamGrip : std::uint8_t { bar, start, stop };

// The part of the cam's bar at column x. Edges can be grasped from `reach` columns outside, and leave a third
// of the bar for moving it as a whole. Nothing: beside the bar.
std::optional<CamGrip> gripAt(const Cam &cam, double x, const RulerScale &scale, double reach);

// The cam with its grip moved, on a circle of `total` positions.
Cam gripMoved(const Cam &cam, CamGrip grip, std::int64_t by, std::int64_t total);

// A drag with the mouse in the cam ruler.
struct CamDrag
{
    std::size_t cam = 0;
    CamGrip grip = CamGrip::bar;
    bool creates = false; // draws a cam in an empty row
    Cam before;
    double from = 0; // position under the mouse when the drag began
    CamDocument::Gesture gesture = CamDocument::noGesture;

    // The cam with the mouse at `position`, which may lie outside the range.
    Cam at(double position, const RulerScale &scale) const;
};

} // namespace codewheel
