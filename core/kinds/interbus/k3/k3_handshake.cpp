// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_handshake.h"

#include "kinds/interbus/k3/k3_reading.h"
#include "kinds/interbus/words/k3_cam_fields.h"
#include "kinds/interbus/words/k3_cam_word.h"

namespace codewheel {
namespace {

using K3State = K3Handshake::State;

bool confirms(Word in, Word out)
{
    return k3::isConfirmation(in) && k3::number(in) == k3::number(out);
}

// IN after an accepted run: a position, or 80000000h if the encoder runs but has no valid one.
bool runs(Word in)
{
    return k3::isOperation(in) || in == k3::error;
}

} // namespace

void K3Handshake::begin(const K3Step &step, Word in, Instant now)
{
    m_step = step;
    m_inAtBegin = in;
    m_inChanged = false;
    m_hasConfirmed = false;
    m_answered = false;
    m_sawZero = false;
    m_cycles = 0;
    m_begin = now;
    m_now = now;
    m_answeredSince = now;
}

K3State K3Handshake::cycle(Word in, Word out, Instant now)
{
    if (out != m_step.out)
        return K3State::waiting; // another word went out in this cycle
    m_now = now;
    ++m_cycles;
    m_inChanged = m_inChanged || in != m_inAtBegin;
    m_hasConfirmed = m_hasConfirmed || (m_inChanged && confirmsStep(in));
    const K3State state = answerTo(in);
    if (state == K3State::waiting && now - m_begin >= m_timing.timeOut && m_cycles >= cyclesOfAnswer)
        return isErrorAnswer(in, m_dialect) ? K3State::error : K3State::noAnswer;
    return state;
}

K3State K3Handshake::answerTo(Word in)
{
    const bool answered = [&] {
        switch (m_step.kind.as<StepKind>()) {
        case StepKind::parameter:
            return confirmsStep(in);
        case StepKind::run:
            return runs(in);
        case StepKind::toNormal:
            return m_step.mustOperate ? runs(in) : !showsReadOut(in);
        case StepKind::switchMode:
            return in != 0 || !k3::isProgramWord(m_step.out);
        default:
            return true;
        }
    }();
    if (answered && !m_answered)
        m_answeredSince = m_now;
    m_answered = answered;

    switch (m_step.kind.as<StepKind>()) {
    case StepKind::parameter:
        return confirmation(in);
    case StepKind::run:
        return runAnswer(in);
    case StepKind::initialisePreset:
        return presetAnswer(in);
    case StepKind::manufacturerPreset:
        return K3State::done; // one cycle, and no more
    case StepKind::switchMode:
        return switchAnswer(in);
    case StepKind::toNormal:
        return normalAnswer(in);
    case StepKind::readOut:
        return readOutAnswer(in);
    case StepKind::endReadOut:
        return readOutEnd(in);
    case StepKind::camReadOut:
        return camReadOutAnswer(in);
    case StepKind::camParameter:
        return camAcknowledgement(in);
    case StepKind::word:
        return wordAnswer(in);
    default:
        break;
    }
    return K3State::waiting;
}

// Its number has been confirmed before, so its data decide as well.
bool K3Handshake::confirmsStep(Word in) const
{
    return confirms(in, m_step.out) && (!m_step.isRepeated || k3::data(in) == k3::data(m_step.out));
}

// FRABA confirms first and refuses afterwards, so a confirmation has to last for the settle time.
K3State K3Handshake::confirmation(Word in) const
{
    if (isNewError(in))
        return K3State::error;
    return confirmsStep(in) && hasSettled() ? K3State::done : K3State::waiting;
}

K3State K3Handshake::runAnswer(Word in)
{
    if (isNewError(in))
        return m_step.tolerateError ? K3State::done : K3State::error;
    if (!k3::isOperation(m_inAtBegin)) {
        if (in == 0) {
            m_sawZero = true;
            return m_now - m_answeredSince >= m_timing.restart ? K3State::done : K3State::waiting;
        }
        if (k3::isOperation(in))
            return K3State::done;
        if (m_sawZero && k3::isConfirmation(in)) // C0000000h: the checks at start-up
            return K3State::restarted;
    }
    return runs(in) && hasSettled() ? K3State::done : K3State::waiting;
}

// 40000000h is not acknowledged: what the position does then proves it (K3PresetProof).
K3State K3Handshake::presetAnswer(Word in) const
{
    if (isNewError(in))
        return K3State::error;
    return k3::isOperation(in) && hasSettled() ? K3State::done : K3State::waiting;
}

// A mode word acts at once, without acknowledgement or run (FRABA manual 5.4.2, 5.4.4). If IN becomes
// 00000000h, the encoder may have lost power before it took the word: the word stays until that is over.
K3State K3Handshake::switchAnswer(Word in) const
{
    if (isNewError(in))
        return K3State::error;
    const bool isWatched = m_answered ? hasSettled() : m_now - m_begin >= m_timing.restart;
    return m_cycles >= m_step.holdCycles && isWatched ? K3State::done : K3State::waiting;
}

K3State K3Handshake::normalAnswer(Word in) const
{
    if (m_step.mustOperate && isErrorAnswer(in, m_dialect))
        return K3State::error;
    const bool normal = m_step.mustOperate ? runs(in) : !showsReadOut(in);
    return normal && hasSettled() ? K3State::done : K3State::waiting;
}

K3State K3Handshake::readOutAnswer(Word in) const
{
    if (!k3::isReadOutAnswer(in))
        return K3State::waiting;
    return k3::number(in) == 0 ? K3State::done : K3State::error; // A4......: unknown parameter in read-out
}

// Outside cam mode 2020xxxx is an undefined word: 84000000. An answer after a long 00000000h comes from an
// encoder that has just started, in an unknown program.
K3State K3Handshake::camReadOutAnswer(Word in) const
{
    if (isNewError(in))
        return K3State::error;
    const K3State answer = readOutAnswer(in);
    const bool hasStarted = m_inAtBegin == 0 && m_now - m_begin >= m_timing.restart;
    return answer == K3State::done && hasStarted ? K3State::restarted : answer;
}

// IN = OUT with D31 D30 = 11, or an error in its place (FRABA manual 5.4.4, 10.6).
K3State K3Handshake::camAcknowledgement(Word in) const
{
    if (isNewError(in))
        return K3State::error;
    return in == (m_step.out | k3::confirmation) ? K3State::done : K3State::waiting;
}

K3State K3Handshake::readOutEnd(Word in) const
{
    return showsReadOut(in) ? K3State::waiting : K3State::done;
}

// Words as given by the user: each until it is acknowledged, by the manual's table, without settling.
K3State K3Handshake::wordAnswer(Word in) const
{
    const Word out = m_step.out;
    if (m_step.inCamMode && fieldSetBy(out))
        return camAcknowledgement(in);
    if (k3::isParameterWord(out)) {
        if (isNewError(in))
            return K3State::error;
        const bool numberStoodBefore = confirms(m_inAtBegin, out);
        const bool echoed =
            confirms(in, out) && (!numberStoodBefore || k3::data(in) == k3::data(out) || m_inChanged);
        return echoed ? K3State::done : K3State::waiting;
    }
    if (out == k3::run) {
        if (isNewError(in))
            return K3State::error;
        if (k3::isOperation(in) && !k3::isOperation(m_inAtBegin))
            return K3State::done;
        return runs(in) && m_cycles >= m_step.holdCycles ? K3State::done : K3State::waiting;
    }
    const bool readsCams = m_step.inCamMode && k3::isCamReadOutRequest(out);
    if (readsCams || (k3::isReadOutRequest(out) && m_dialect == k3::Dialect::fraba)) {
        if (!k3::isReadOutAnswer(in) ||
            (k3::isReadOutAnswer(m_inAtBegin) && !m_inChanged && m_cycles < m_step.holdCycles))
            return K3State::waiting;
        return k3::number(in) == 0 ? K3State::done : K3State::error;
    }
    if (isNewError(in))
        return K3State::error;
    return m_cycles >= m_step.holdCycles ? K3State::done : K3State::waiting;
}

bool K3Handshake::showsReadOut(Word in) const
{
    return stateOf(in, m_dialect) == EncoderState::readOut;
}

bool K3Handshake::isNewError(Word in) const
{
    return isErrorAnswer(in, m_dialect) && m_inChanged;
}

} // namespace codewheel
