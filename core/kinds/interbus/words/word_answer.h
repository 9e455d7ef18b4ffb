// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace codewheel {

// An encoder has answered within so many cycles (assumed). A slow gateway needs longer for them than the
// time-out, so it "does not answer" only after both.
inline constexpr int cyclesOfAnswer = 8;

// What has come so far of a word that is in OUT.
enum class WordAnswer : std::uint8_t {
    waiting,
    done,
    error,     // the encoder has refused it
    noAnswer,  // for too long
    restarted, // the encoder has lost power meanwhile
};

} // namespace codewheel
