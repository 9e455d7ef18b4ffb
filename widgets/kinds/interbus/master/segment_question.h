// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

class RingSession;

// Asks whether to switch off the segment: names the devices that leave the data cycles with it, and those of
// their outputs that are not 0 now.
QString segmentQuestion(const RingSession &bus, int segment);

} // namespace codewheel
