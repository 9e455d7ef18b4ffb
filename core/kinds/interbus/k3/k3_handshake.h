// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/k3/k3_step.h"
#include "kinds/interbus/words/k3_explain.h"
#include "kinds/interbus/words/word_answer.h"

namespace codewheel {

// One word and what ends it: the handshake of FRABA manual 5.3 and Baumer manual 6, step by step. It is given
// what came in while its word was in OUT, and says whether to go on waiting. It waits through an old
// confirmation, and through processing under the number 0 or the previous one (Baumer); an error counts once
// it is new.
class K3Handshake
{
public:
    using State = WordAnswer;

    K3Handshake(k3::Dialect dialect, K3Timing timing)
        : m_dialect(dialect)
        , m_timing(timing)
    {}

    // `in` is what is in IN when the word is put into OUT.
    void begin(const K3Step &step, Word in, Instant now);
    State cycle(Word in, Word out, Instant now);

    // The number of the step was confirmed, which does not yet mean acceptance.
    bool hasConfirmed() const { return m_hasConfirmed; }

private:
    State answerTo(Word in);
    bool confirmsStep(Word in) const;
    State confirmation(Word in) const;
    State runAnswer(Word in);
    State presetAnswer(Word in) const;
    State switchAnswer(Word in) const;
    State normalAnswer(Word in) const;
    State readOutAnswer(Word in) const;
    State readOutEnd(Word in) const;
    State camReadOutAnswer(Word in) const;
    State camAcknowledgement(Word in) const;
    State wordAnswer(Word in) const;
    bool isNewError(Word in) const;
    bool showsReadOut(Word in) const;
    bool hasSettled() const { return m_now - m_answeredSince >= m_timing.settle; }

    k3::Dialect m_dialect;
    K3Timing m_timing;
    K3Step m_step;
    Word m_inAtBegin = 0;
    bool m_inChanged = false;
    bool m_hasConfirmed = false;
    bool m_answered = false; // IN holds what the step waits for
    bool m_sawZero = false;  // run: IN was 00000000h, which an encoder without power shows too
    int m_cycles = 0;        // for which the word has been in OUT
    Instant m_begin{};
    Instant m_now{};
    Instant m_answeredSince{}; // since when IN has held the answer without interruption
};

} // namespace codewheel
