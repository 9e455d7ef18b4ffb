// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

class RingSession;

// Whether the segment shall be switched off: names the devices that go out of the data cycles with it, and
// those of their outputs that are not 0 now.
QString segmentQuestion(const RingSession &bus, int segment);

} // namespace codewheel
