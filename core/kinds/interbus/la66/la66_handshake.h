// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/la66/la66_step.h"
#include "kinds/interbus/words/word_answer.h"

namespace codewheel {

// One word and what ends it: a step of the handshake on the service bit (LA-66 manual 4). It is given what
// came in while its word was in OUT, and says whether to go on waiting.
class La66Handshake
{
public:
    using State = WordAnswer;

    explicit La66Handshake(La66Timing timing)
        : m_timing(timing)
    {}

    void begin(const La66Step &step, Instant now);
    State cycle(Word in, Word out, Instant now);

private:
    State answerTo(Word in);

    La66Timing m_timing;
    La66Step m_step;
    int m_cycles = 0; // for which the word has been in OUT, together with the IN it waits for
    int m_stood = 0;  // cycles in OUT
    Instant m_begin{};
};

} // namespace codewheel
