// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel {

// What came of a word that stands in OUT by now.
enum class WordAnswer : std::uint8_t {
    waiting,
    done,
    error,     // the encoder has refused it
    noAnswer,  // for too long
    restarted, // the encoder has lost its power meanwhile
};

} // namespace codewheel
