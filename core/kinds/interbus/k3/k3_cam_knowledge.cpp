// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/k3/k3_cam_knowledge.h"

#include "kinds/interbus/words/k3_cam_word.h"

#include <algorithm>
#include <utility>

namespace codewheel {

void K3CamKnowledge::set(const std::vector<KnownCams> &known)
{
    for (const KnownCams &one : known)
        for (std::size_t i = 0; i < camFieldCount; ++i)
            m_programs.at(one.program.number).values[i] = {valueOf(one.program, camField(i)), one.evidence};
}

void K3CamKnowledge::observe(Word in, Word out, const Seen &seen, Instant now)
{
    m_program = seen.program;
    if (in == m_in && out == m_out)
        return;
    m_now = now;
    const bool mayBeCamMode = seen.mode.value_or(Mode::cam) == Mode::cam;
    if (out != m_out)
        observeOut(out, mayBeCamMode, seen.isOfOthers);
    if (k3::isConfirmation(in))
        observeAnswer(in);
    else if (k3::isOperation(in))
        observeOperation(in);
    else if (k3::isReadOutAnswer(in))
        observeReadOut(in, out);
    else if (in != m_in)
        observeError(in);
    m_answerIsFresh = m_answerIsFresh || !k3::isReadOutAnswer(in);
    m_in = in;
    m_out = out;
}

void K3CamKnowledge::observeOut(Word out, bool mayBeCamMode, bool isOfOthers)
{
    m_answerIsFresh = false;
    if (k3::isProgramWord(out)) {
        m_mayEnd = true;
    } else if ((out & k3::startBit) != 0) {
        m_mayEnd = true;
        doubtAsked();
    } else if (mayBeCamMode && fieldSetBy(out)) {
        m_mayEnd = false;
        doubtAsked();
        m_asked = out;
        m_askedByOthers = isOfOthers;
    }
}

// IN = OUT with D31 D30 = 11, even if the word has left OUT meanwhile. C0000000h that nobody asked for: the
// encoder is restarting.
void K3CamKnowledge::observeAnswer(Word in)
{
    if (!m_asked || in != (*m_asked | k3::confirmation)) {
        if (in == k3::confirmation && in != m_in)
            loseChange(true);
        return;
    }
    const Word asked = *m_asked;
    m_asked.reset();
    m_isParameterized = true;
    if (!m_program) {
        forgetAll(); // it was in cam mode, in an unknown program
        raiseChange(Change::certainly);
        return;
    }
    beginChange(Change::certainly);
    const CamField field = *fieldSetBy(asked);
    learn(*m_program, field, {dataOf(field, asked), Evidence::echoed});
}

// Only run and a change of program end a cam parameterization: otherwise the encoder has lost power. That may
// also be so if IN becomes 00000000h, which it did not show in operation before.
void K3CamKnowledge::observeOperation(Word in)
{
    if (m_isParameterized && !m_mayEnd)
        loseChange(true);
    else if (in == 0 && m_shown != 0)
        loseChange(false);
    m_isParameterized = false;
    m_shown = in;
}

void K3CamKnowledge::observeReadOut(Word in, Word out)
{
    if (!m_program || !m_answerIsFresh || k3::number(in) != 0)
        return;
    if (const auto field = fieldReadBy(out))
        learn(*m_program, *field, {k3::data(in), Evidence::read});
}

// Instead of the acknowledgement: the old value is kept.
void K3CamKnowledge::observeError(Word in)
{
    constexpr unsigned parametersLost = 3;
    m_asked.reset();
    if (k3::number(in) == parametersLost)
        forgetAll();
}

void K3CamKnowledge::beginChange(Change how)
{
    if (m_program && m_change == Change::no)
        m_saved = m_programs[*m_program];
    raiseChange(how);
}

void K3CamKnowledge::raiseChange(Change how)
{
    m_isOwnChange = (m_change != Change::no && m_isOwnChange) || !m_askedByOthers;
    m_change = std::max(m_change, how);
}

// A word that left OUT without an answer may be taken all the same.
void K3CamKnowledge::doubtAsked()
{
    if (!m_asked)
        return;
    if (!m_program) {
        forgetValues();
        raiseChange(Change::perhaps);
        return;
    }
    beginChange(Change::perhaps);
    m_programs[*m_program].values[indexOf(*fieldSetBy(*m_asked))].reset();
    m_isDirty = true;
}

bool K3CamKnowledge::loseSight(const Unseen &unseen)
{
    if (unseen.out != m_out)
        observeOut(unseen.out, unseen.mayBeCamMode, false);
    doubtAsked();
    loseChange(false);
    m_asked.reset();
    m_answerIsFresh = false;
    m_in = m_out = k3::normalRunning;
    if (!unseen.mayLeave && !(unseen.isOfJob && m_isOwnChange))
        return false;
    return std::exchange(m_change, Change::no) != Change::no;
}

std::optional<unsigned> K3CamKnowledge::unsaved() const
{
    return m_change != Change::no || m_asked ? m_program : std::nullopt;
}

// Power-off brings the program back as it was saved; if it is not certain, what differs is unknown.
void K3CamKnowledge::loseChange(bool certainly)
{
    if (certainly)
        m_asked.reset();
    if (m_change == Change::no || !m_program)
        return;
    Program &program = m_programs[*m_program];
    for (std::size_t i = 0; i < camFieldCount; ++i)
        if (certainly)
            program.values[i] = m_saved.values[i];
        else if (!m_saved.values[i] || !program.values[i] ||
                 program.values[i]->data != m_saved.values[i]->data)
            program.values[i].reset();
    if (certainly)
        m_change = Change::no;
    m_isDirty = true;
}

K3CamKnowledge::Change K3CamKnowledge::leave()
{
    doubtAsked();
    m_asked.reset();
    m_mayEnd = true;
    return std::exchange(m_change, Change::no);
}

void K3CamKnowledge::forgetAll()
{
    forgetValues();
    m_change = Change::no;
}

void K3CamKnowledge::forgetValues()
{
    m_programs = {};
    m_saved = {};
    m_isDirty = true;
}

void K3CamKnowledge::learn(unsigned program, CamField field, Value value)
{
    Program &known = m_programs.at(program);
    known.values[indexOf(field)] = value;
    known.at = m_now;
    m_isDirty = true;
}

std::optional<KnownCams> K3CamKnowledge::known(unsigned program) const
{
    const Program &known = m_programs.at(program);
    KnownCams cams{
        .program = {.number = program, .cam = {}, .shift = 0}, .evidence = Evidence::read, .at = known.at};
    for (std::size_t i = 0; i < camFieldCount; ++i) {
        const auto &value = known.values[i];
        if (!value)
            return std::nullopt;
        setValue(cams.program, camField(i), value->data);
        if (value->evidence != Evidence::read)
            cams.evidence = value->evidence;
    }
    return cams;
}

bool K3CamKnowledge::takeChanges(KnowledgeChanged &changes)
{
    if (!std::exchange(m_isDirty, false))
        return false;
    for (unsigned number = 1; number <= CamProgram::programs; ++number) {
        const auto now = known(number);
        if (now == m_told[number])
            continue;
        if (now)
            changes.cams.push_back(*now);
        else
            changes.camsNoLongerKnown.push_back(number);
        m_told[number] = now;
    }
    return !changes.cams.empty() || !changes.camsNoLongerKnown.empty();
}

} // namespace codewheel
