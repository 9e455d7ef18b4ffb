// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"
#include "report/reported_device.h"

namespace codewheel {

// The cam programs of an encoder, wanted next to known: a picture and a table for each that has something
// set.
std::vector<ReportBlock> camBlocks(const ReportedDevice &device, const QDateTime &now);

} // namespace codewheel
