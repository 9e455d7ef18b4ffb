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
        const double begin = part(cam.start);
        const double end = part(cam.stop + 1); // the last position belongs to it
        if (cam.start <= cam.stop) {
            bars.push_back({number, begin, end, cam.active});
        } else {
            bars.push_back({number, 0, end, cam.active});
            bars.push_back({number, begin, 1, cam.active});
        }
    }
    return bars;
}

} // namespace codewheel
