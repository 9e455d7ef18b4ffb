// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "jobs/known_values.h"
#include "kinds/interbus/k3/k3_cam_knowledge.h"
#include "kinds/interbus/k3/k3_mode.h"
#include "vocabulary/event.h"

#include <map>
#include <optional>

namespace codewheel {

// What a K3 encoder is known to have, learned from the words that pass, whoever sent them: a confirmation
// makes a value pending, run answered by operation makes it active, a read-out reports it. Counts EEPROM
// writes the same way.
class K3Knowledge
{
public:
    enum class SentBy : std::uint8_t { job, hand };

    explicit K3Knowledge(const DeviceDescription &device)
        : m_device(device)
    {}

    // Replaces all that is known, e.g. after the user told something.
    void set(const std::vector<Known> &known);
    // It may be another encoder by now.
    void forget();
    void setCams(const std::vector<KnownCams> &known) { m_cams.set(known); }
    void observe(Word in, Word out, Instant now);
    // Nobody sees any more what IN shows, nor what becomes of `out`, which is in OUT or on its way there:
    // what it may have changed, or what may become active by it, is not known from now on. Returns how many
    // writes that may cost which are not counted.
    int loseSight(Word out, SentBy by);
    // What that may change of what this program has sent, as far as words tell: values, reset, position.
    InDoubt inDoubtWith(Word out) const;
    void beginJob() { m_jobRuns = true; }
    // How many writes the job may have cost besides those counted, as far as it saw what became of its words.
    int endJob();
    Word lastOut() const { return m_out; }
    // What is in OUT and confirmed has been written: counted before its word leaves OUT.
    void countStanding();
    // From now on a read-out answer with the low half of the last position counts only after another read-out
    // word stood between, and it came again (spec modbus-gateway.md).
    void expectTornWords() { m_wordsMayTear = true; }
    void setOthersWrite(bool on) { m_othersWrite = on; }
    bool isDoubtful(unsigned readOut) const { return m_doubtful && m_doubtful->code == readOut; }

    const KnownValues &known() const { return m_known; }
    std::optional<std::int64_t> value(Parameter parameter) const { return m_known.value(parameter); }
    ParameterValues values() const { return m_known.values(); }
    std::optional<Mode> mode() const { return m_mode.now(); }
    // By somebody's word, which no word that passed has borne out.
    bool modeIsOnlyTold() const { return m_mode.isOnlyBelieved(); }
    // What the encoder does contradicts a mode that was only told.
    void doubtMode(Instant now);
    // Whether its preset is programmed and not yet activated (FRABA manual 5.4.1); empty: not known.
    std::optional<bool> isPresetArmed() const { return m_presetArmed; }
    // The cam program the encoder is in, in cam mode.
    std::optional<unsigned> camProgram() const { return m_mode.camProgram(); }
    std::optional<KnownCams> cams(unsigned program) const { return m_cams.known(program); }
    // The cam program that was changed, or perhaps was, and is not saved.
    std::optional<unsigned> unsavedCams() const { return m_cams.unsaved(); }
    // 60000000h acts in every cycle it is in OUT (FRABA manual 5.4.1); in cam mode it is another word.
    bool isManufacturerPreset(Word out) const;
    std::optional<PositionCoding> coding() const;
    // Whether the encoder takes and reports steps - 1 (flag_mt_stepsm1); empty: not known yet.
    std::optional<bool> countsStepsMinusOne() const;
    int eepromWrites() const { return m_known.eepromWrites(); }

    // The data of the word that gives `parameter` this value, and the reverse for a read-out.
    Word dataFor(Parameter parameter, std::int64_t value) const;
    std::optional<std::int64_t> valueOfReadOut(Parameter parameter, Word data) const;

    // What changed since the last call; empty if nothing did.
    std::optional<KnowledgeChanged> takeChanges();

private:
    void observeConfirmation(Word in, Word out);
    bool provesCamMode(Word in, Word out) const;
    void observeError(Word in, Word out, Instant now);
    void observeReadOut(Word in, Word out, Instant now);
    bool mayBeTorn(unsigned code, Word in);
    void observeOperation(Word in, Word out, Instant now);
    void observeRun(Word in, Instant now);
    void activateUnseen();
    void forgetUnseenRun();
    void observeMode(Word out, Instant now);
    void tellMode(std::optional<Mode> mode, std::optional<unsigned> camProgram = {});
    bool mayHoldOldCams() const;
    void leaveCams(bool isCertain, bool mayBeOld);
    void observePreset(Word out);
    void observeManufacturerPreset();
    void countConfirmed();
    bool isConfirmed(Word out) const;
    int writesInDoubt(Word out);
    bool losesCams(Word out, SentBy by);
    bool setsPositionBy(Word out) const;
    void forgetNumber(unsigned number);
    void activate(unsigned number, std::optional<Word> data, Instant now);
    void reset(bool isProven, Instant now);
    void learn(Parameter parameter, std::int64_t value, Evidence evidence, Instant now);

    const DeviceDescription &m_device;
    KnownValues m_known;
    std::map<unsigned, std::optional<Word>>
        m_pending; // by number; no data: confirmed, but not certain with what
    std::optional<unsigned> m_lastConfirmed;
    std::optional<Word> m_foundConfirmed; // IN of a parameterization that others, or nobody, saw begin
    std::optional<Word>
        m_asked; // a parameter word that is not answered; it may still be taken after it left OUT
    Word m_inWhenAsked = 0;
    bool m_askedIsProcessed = false;
    // Activated by a run that was answered by 00000000h, which an encoder without power shows too: known once
    // a position shows.
    std::map<unsigned, std::optional<Word>> m_unproven;
    K3Mode m_mode;
    K3CamKnowledge m_cams;
    bool m_mayHoldOldCams = true; // a program that was changed, and not saved, before it was seen
    Instant m_modeSince{};        // anything told before that is out of date
    bool m_hasRun = false;        // what was confirmed became active, whether known or not
    bool m_answerIsFresh = false; // IN has held no read-out answer since the request was put into OUT
    struct Doubtful
    {
        unsigned code = 0;
        Word answer = 0;
        bool anotherCame = false; // since
    };
    bool m_wordsMayTear = false;
    bool m_othersWrite = false;
    std::optional<Doubtful> m_doubtful; // the last read-out that may be torn
    Word m_lastPosition = 0;            // IN in operation
    bool m_jobRuns = false;
    int m_perhapsWritten = 0;    // by it
    bool m_presetIsOpen = false; // it was sent, and stores once it is there
    std::optional<bool> m_presetArmed;
    bool m_hasSeenWords = false;
    bool m_wordIsOfOthers = false; // the last parameter word, or it was counted already
    Word m_out = 0;
    Word m_in = 0;
};

} // namespace codewheel
