// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel {

// What has come so far of a word that is in OUT.
enum class WordAnswer : std::uint8_t {
    waiting,
    done,
    error,     // the encoder has refused it
    noAnswer,  // for too long
    restarted, // the encoder has lost power meanwhile
};

} // namespace codewheel
