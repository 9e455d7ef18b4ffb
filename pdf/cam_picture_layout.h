// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pdf/sheet_flow.h"
#include "report/report.h"

namespace codewheel {

// The picture on one sheet: a row for each cam, active ones filled, inactive ones as an outline.
void addCamPicture(SheetFlow &flow, const CamPicture &picture);

} // namespace codewheel
