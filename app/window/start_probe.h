// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

// Measures a start for tools/bench: with CODEWHEEL_MEASURE_START set to the nanoseconds of the monotonic
// clock at which the process was begun, reportFirstPaint() prints "first paint: N ms" and says true; without
// it, nothing and false.
bool reportFirstPaint();

// Prints "memory: N MB": what the process has in memory, shared libraries included (VmRSS).
void reportMemory();

} // namespace codewheel
