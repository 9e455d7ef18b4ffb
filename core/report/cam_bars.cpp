// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/cam_bars.h"

#include <algorithm>

namespace codewheel {

std::vector<CamBar> camBars(const CamPicture &picture)
{
    const auto part = [&](std::int64_t position) {
        return std::clamp(static_cast<double>(position) / static_cast<double>(picture.positions), 0.0, 1.0);
    };
    std::vector<CamBar> bars;
    for (std::size_t number = 0; number < CamProgram::cams; ++number) {
        const Cam &cam = picture.program.cam[number];
        if (cam == Cam{})
            continue;
        const bool throughZero = cam.start > cam.stop;
        const double start = part(cam.start);
        const double end = part(cam.stop + 1); // the last position is included
        const auto add = [&](double from, double to) {
            if (from < to || !cam.isInverted)
                bars.push_back({number, from, to, cam.active});
        };
        if (throughZero == cam.isInverted) {
            add(std::min(start, end), std::max(start, end));
        } else {
            add(0, std::min(start, end));
            add(std::max(start, end), 1);
        }
    }
    return bars;
}

} // namespace codewheel
