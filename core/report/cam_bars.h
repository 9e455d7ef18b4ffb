// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"

namespace codewheel {

// A piece of the range in which a cam is on, as a fraction of the whole: 0 is position 0, 1 is just past the
// last.
struct CamBar
{
    std::size_t cam = 0;
    double begin = 0;
    double end = 1;
    bool active = false;

    friend bool operator==(const CamBar &, const CamBar &) = default;
};

// The bars of a picture, by cam. A cam through zero has two, and an inverted one may; one that was never set
// (inactive, 0 to 0) has none.
std::vector<CamBar> camBars(const CamPicture &picture);

} // namespace codewheel
