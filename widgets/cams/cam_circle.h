// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/cam_program.h"
#include "vocabulary/circle.h"

#include <algorithm>
#include <vector>

// A cam as an arc of the circle of positions 0..total - 1, so that moving it past one end of the range simply
// goes on at the other (FRABA manual 5.4.4; wrap-around assumed). Used by the cam ruler.
namespace codewheel::cam_circle {

// Positions on which the cam is on: 1..total.
constexpr std::int64_t length(const Cam &cam, std::int64_t total) noexcept
{
    return modulo(cam.stop - cam.start, total) + 1;
}

constexpr Cam arc(Cam cam, std::int64_t start, std::int64_t length, std::int64_t total) noexcept
{
    cam.start = modulo(start, total);
    cam.stop = modulo(start + length - 1, total);
    return cam;
}

constexpr Cam moved(const Cam &cam, std::int64_t by, std::int64_t total) noexcept
{
    return arc(cam, cam.start + by, length(cam, total), total);
}

// One edge moved; the other stays. The cam keeps at least one position and covers at most all of them.
constexpr Cam startMoved(const Cam &cam, std::int64_t by, std::int64_t total) noexcept
{
    const std::int64_t before = length(cam, total);
    const std::int64_t after = std::clamp(before - by, std::int64_t{1}, total);
    return arc(cam, cam.start + before - after, after, total);
}

constexpr Cam stopMoved(const Cam &cam, std::int64_t by, std::int64_t total) noexcept
{
    return arc(cam, cam.start, std::clamp(length(cam, total) + by, std::int64_t{1}, total), total);
}

// A cam nobody has set yet.
constexpr bool isEmpty(const Cam &cam) noexcept
{
    return !cam.active && cam.start == cam.stop;
}

// A stretch of positions from first to last, both included, without wrap-around.
struct Stretch
{
    std::int64_t first = 0;
    std::int64_t last = 0;
    bool hasStart = false; // first is where the cam starts
    bool hasStop = false;

    friend constexpr bool operator==(const Stretch &, const Stretch &) = default;
};

// One stretch, or two where the cam passes through zero.
inline std::vector<Stretch> stretches(const Cam &cam, std::int64_t largest)
{
    if (cam.start <= cam.stop)
        return {{cam.start, cam.stop, true, true}};
    return {{cam.start, std::max(cam.start, largest), true, false}, {0, cam.stop, false, true}};
}

} // namespace codewheel::cam_circle
