// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace codewheel::test {

// How often to try something that must hold each time. A sanitizer examines what the program does, not how
// often it survives, and each try takes ten times as long: a fifth of the tries is enough for it, but at
// least a dozen.
constexpr int times(int wanted)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return std::clamp(wanted, 1, std::max(12, wanted / 5));
#else
    return wanted;
#endif
}

} // namespace codewheel::test
