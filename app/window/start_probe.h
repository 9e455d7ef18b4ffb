// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

// Measures a start for tools/bench: if CODEWHEEL_MEASURE_START is set to the time in nanoseconds of the
// monotonic clock when the process was started, reportFirstPaint() prints "first paint: N ms" and returns
// true; without it, it prints nothing and returns false.
bool reportFirstPaint();

// Prints "memory: N MB": the memory of the process, including shared libraries (VmRSS).
void reportMemory();

} // namespace codewheel
