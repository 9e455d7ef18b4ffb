// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"

namespace codewheel {

// The picture as <svg>: a row for each cam, active ones filled, inactive ones as an outline.
QString camPictureAsSvg(const CamPicture &picture);

} // namespace codewheel
