// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "jobs/job_run.h"
#include "kinds/esc/driver/esc_agreement.h"
#include "kinds/esc/driver/esc_encoder.h"
#include "kinds/esc/driver/esc_preset_proof.h"
#include "kinds/esc/driver/esc_search.h"

#include <optional>
#include <vector>

namespace codewheel {

// A job of an encoder on a serial line in progress: its requests one after the other, and what their answers
// mean. Nothing is written twice: after a write without an answer the encoder is read, and the outcome says
// whether it was done. Used by EscDriver, which sends what the job wants.
class EscJob final : public JobRun<EscStep>
{
public:
    // The job has been checked (EscPlan). The encoder must outlive this.
    EscJob(JobId id, Job job, Pace pace, EscEncoder &encoder);

    // The next request; empty while it waits for the user, and when it is done.
    std::optional<esc::Request> next(Instant now);
    void answered(const esc::ExchangeResult &result, Instant now);

    // The encoder is being searched for: nothing else may be asked of it meanwhile.
    bool isSearching() const { return !m_steps.atEnd() && m_steps.current().task == EscStep::Task::search; }
    void stop(const Refusal &why);

    bool isPreset() const { return job<SetPreset>() != nullptr; }
    // It was confirmed and goes on to write, and nothing of that was sent yet.
    bool hasYetToWrite() const;
    // The encoder did not answer for so long that it is no longer what was confirmed.
    void endUnsent(std::chrono::seconds unanswered);

private:
    using Said = EscPresetProof::Said;
    // What the reads of a step have yielded so far.
    enum class Heard : std::uint8_t { nothing, tooLittle, value, error, contradiction };

    // esc_job.cpp
    void settle();
    void leaveOutWhatIsThere();
    void noteWhatWasSetAlong();
    void checkPreset();
    bool mayBegin();
    void begin(Instant now);
    Heard hear(const esc::ExchangeResult &result);
    void readAnswered(const esc::ExchangeResult &result, Instant now);
    void readAgreed(Instant now);
    void refreshAnswered(const esc::ExchangeResult &result, Instant now);
    void complete(Outcome &outcome) override;
    bool isPositionStep(const EscStep &step) const override;

    // esc_job_write.cpp
    void writeAnswered(const esc::ExchangeResult &result, Instant now);
    void accepted(Instant now);
    void notAnswered();
    void readBackAnswered(const esc::ExchangeResult &result, Instant now);
    void readBackAgreed(Instant now);
    void isThere(const ParameterValue &value);
    void isNotThere(std::int64_t has);
    void notRead(const Refusal &why);
    void failAsUnknown();
    void fail(Refusal why);

    // esc_job_preset.cpp
    void positionAnswered(const esc::ExchangeResult &result, Instant now);
    void positionAgreed();
    void positionNotRead(const Refusal &why);
    void positionStepDone();
    void presetDone();
    void judgeAccepted(Said position, Said value);
    void judgeUnanswered(Said position, Said value);

    // esc_job_search.cpp
    void beginSearch();
    void searchAnswered(const esc::ExchangeResult &result, Instant now);
    void foundAtAddress(EscLineAddress found, Instant now);
    void foundAtBaudRate(std::optional<int> found, Instant now);

    // esc_job_cancel.cpp
    void dropFrom(std::size_t first, std::optional<Parameter> refused = {});
    void leaveOffAt(Instant now) override;
    void giveBack();
    bool hasTaken() const override;

    Refusal refusalOf(const esc::ExchangeResult &result) const;
    Refusal whyNotRead(Heard heard, const esc::ExchangeResult &result) const;

    EscEncoder &m_encoder;
    bool m_isUnderWay = false; // a request of the step is on the line
    bool m_isCompared = false;
    EscAgreement m_reads;
    EscPositionAgreement m_positions;
    std::optional<EscStep> m_unanswered; // the write whose outcome is not known yet
    std::optional<EscSearch> m_search;
    std::optional<int> m_rateBefore; // the baud rate before the search for another one
    EscPresetProof m_proof;
};

} // namespace codewheel
