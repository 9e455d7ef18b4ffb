// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "words/k3_explain.h"

#include <optional>

namespace codewheel {

// "Set encoder to default", 0E000000h (FRABA manual 10.1, Baumer manual 5).
inline constexpr unsigned resetNumber = 7;

// The mode of an encoder that has several (FRABA): known once told, or once a word that passed has switched
// it (FRABA manual 5.4.2, 5.4.4). Without that it stays unknown, and nothing is guessed.
class K3Mode
{
public:
    // An encoder takes a word that has stood for 2 cycles (assumed); the third one shows the new mode.
    static constexpr int cyclesUntilTaken = 3;

    void tell(std::optional<Mode> mode) { m_mode = mode; }
    // True once a word has switched the mode, be it to the one it was in.
    bool observe(Word out);
    std::optional<Mode> now() const { return m_mode; }

private:
    bool switchedBy(Word out);

    std::optional<Mode> m_mode;
    Word m_out = 0;
    int m_stoodFor = 0;
};

// The mode that an encoder has after power-up with this start-up mode (read-out 9, FRABA manual 10.2).
std::optional<Mode> modeAfterStartUp(std::int64_t startUpMode);

} // namespace codewheel
