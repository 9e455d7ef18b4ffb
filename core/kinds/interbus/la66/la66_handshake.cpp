// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/la66/la66_handshake.h"

#include "kinds/interbus/words/la66_word.h"

namespace codewheel {
namespace {

using La66State = La66Handshake::State;

// A write comes back as it went out. Other data are the answer to an earlier service.
La66State answerToService(Word in, Word out)
{
    if (!la66::answers(in, out))
        return La66State::waiting;
    if (la66::hasError(in))
        return La66State::error;
    const bool isOurs = !la66::isWrite(out) || la66::data(in) == la66::data(out);
    return isOurs ? La66State::done : La66State::waiting;
}

// Without the service bit in OUT, the encoder must be in normal mode too.
bool isThrough(Word in, Word out)
{
    return la66::isServiceMode(out) || !la66::isServiceMode(in);
}

} // namespace

void La66Handshake::begin(const La66Step &step, Instant now)
{
    m_step = step;
    m_cycles = 0;
    m_stood = 0;
    m_begin = now;
}

La66State La66Handshake::cycle(Word in, Word out, Instant now)
{
    if (out != m_step.out)
        return La66State::waiting; // another word went out in this cycle
    ++m_stood;
    const La66State state = answerTo(in);
    const bool isTooLong = now - m_begin >= m_timing.timeOut && m_stood >= cyclesOfAnswer;
    return state == La66State::waiting && isTooLong ? La66State::noAnswer : state;
}

La66State La66Handshake::answerTo(Word in)
{
    switch (m_step.kind.as<StepKind>()) {
    case StepKind::serviceBit:
        return answerToService(in, m_step.out);
    case StepKind::service: // an old answer must be gone before the next service is asked for
        m_cycles = la66::isServiceMode(in) ? 0 : m_cycles + 1;
        return m_cycles >= m_timing.dataCycles ? La66State::done : La66State::waiting;
    case StepKind::word:
        return ++m_cycles >= m_step.holdCycles && isThrough(in, m_step.out) ? La66State::done
                                                                            : La66State::waiting;
    default:
        return isThrough(in, m_step.out) ? La66State::done : La66State::waiting;
    }
}

} // namespace codewheel
