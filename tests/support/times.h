// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace codewheel::test {

// How often something is tried that has to hold each time. A sanitizer looks at what the program does, not at
// how often it survives, and each try takes ten times as long: a fifth of them tells it as much, and a dozen
// at least.
constexpr int times(int wanted)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return std::clamp(wanted, 1, std::max(12, wanted / 5));
#else
    return wanted;
#endif
}

} // namespace codewheel::test
