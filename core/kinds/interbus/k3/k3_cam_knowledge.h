// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/words/k3_cam_fields.h"
#include "kinds/interbus/words/k3_explain.h"
#include "vocabulary/event.h"

#include <array>

namespace codewheel {

// What is known of a FRABA encoder's cam programs, learned from the words that pass, whoever sent them: a
// read-out reports a value, an acknowledgement sets it. A changed program is saved on leaving it, and lost if
// power goes off before that. Part of K3Knowledge.
class K3CamKnowledge
{
public:
    void set(const std::vector<KnownCams> &known);
    // What the words mean depends on.
    struct Seen
    {
        std::optional<Mode> mode{};
        std::optional<unsigned> program{}; // in cam mode
        bool isOfOthers = false;           // what is in OUT
    };
    // One bus cycle.
    void observe(Word in, Word out, const Seen &seen, Instant now);
    // Of the program in use, since it was entered; `perhaps` by a word that left OUT without an answer.
    enum class Change : std::uint8_t { no, perhaps, certainly };
    // A word that leaves the program was taken: a change costs an EEPROM write.
    Change leave();
    void forgetAll();
    // But a program that was changed is still saved when it is left.
    void forgetValues();
    // What one job or one hand has sent last, and nobody sees the answer to.
    struct Unseen
    {
        Word out = 0; // in OUT, or on its way there
        bool mayBeCamMode = false;
        bool mayLeave = false; // a word that leaves the program, this one or that before
        bool isOfJob = false;
    };
    // Nobody sees any more what becomes of it, nor of what was changed and is not saved. True: the program
    // was perhaps saved, or a job leaves what this program changed to be saved when nobody counts. It is not
    // counted later.
    bool loseSight(const Unseen &unseen);
    // The program in use that was changed, or perhaps was, and is not saved.
    std::optional<unsigned> unsaved() const;

    // The program as the encoder has it now; empty while one of its values is not known.
    std::optional<KnownCams> known(unsigned program) const;
    // Adds what has changed since the last call; returns whether anything has.
    bool mayHaveChanged() const { return m_isDirty; } // since the last call of takeChanges()
    bool takeChanges(KnowledgeChanged &changes);

private:
    struct Value
    {
        std::int64_t data = 0;
        Evidence evidence = Evidence::read;
    };
    struct Program
    {
        std::array<std::optional<Value>, camFieldCount> values;
        Instant at{};
    };

    void observeOut(Word out, bool mayBeCamMode, bool isOfOthers);
    void observeAnswer(Word in);
    void observeOperation(Word in);
    void observeReadOut(Word in, Word out);
    void observeError(Word in);
    void learn(unsigned program, CamField field, Value value);
    void beginChange(Change how);
    void raiseChange(Change how);
    void doubtAsked();
    void loseChange(bool certainly);

    std::array<Program, CamProgram::programs + 1> m_programs; // by number
    std::array<std::optional<KnownCams>, CamProgram::programs + 1> m_told;
    std::optional<unsigned> m_program; // the one in use
    Change m_change = Change::no;      // not yet saved
    Program m_saved;                   // that program, before the first change
    bool m_isOwnChange = false;        // or some of it
    std::optional<Word> m_asked;       // a cam word not yet answered, still in OUT or not
    bool m_askedByOthers = false;
    bool m_isParameterized = false; // an acknowledgement was in IN, and its end has not been seen
    bool m_mayEnd = false;          // run has been sent since, or another mode
    bool m_answerIsFresh = false;   // IN has held no read-out answer since the request was put into OUT
    bool m_isDirty = false;
    Word m_shown = 0; // last in operation
    Word m_in = 0;
    Word m_out = 0;
    Instant m_now{};
};

} // namespace codewheel
