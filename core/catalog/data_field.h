// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "words/k3_word.h"
#include "words/la66_word.h"

namespace codewheel {

// The largest value that can be told to an encoder of this profile: 25 bit at a K3 (ENCOM profile 71,
// D24..D0), 24 bit at an LA-66 (D23..D0), 8 hexadecimal digits on a serial line. All values there are from 0.
constexpr std::int64_t largestData(Profile profile)
{
    if (profile == Profile::esc)
        return std::int64_t{0xFFFF'FFFF};
    return profile == Profile::la66 ? std::int64_t{la66::dataMask} : std::int64_t{k3::dataMask};
}

} // namespace codewheel
