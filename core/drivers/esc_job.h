// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivers/esc_agreement.h"
#include "drivers/esc_encoder.h"
#include "drivers/esc_position_agreement.h"
#include "drivers/esc_search.h"

#include <optional>
#include <vector>

namespace codewheel {

// A job of an encoder on a serial line on its way: its requests one after the other, and what their answers
// mean. Nothing is written twice: after a write without an answer the encoder is read, and the outcome says
// whether it was done. Used by EscDriver, which sends what this wants.
class EscJob
{
public:
    // The job has been checked (EscPlan). The encoder must outlive this.
    EscJob(JobId id, Job job, Pace pace, EscEncoder &encoder);

    // The next request; nothing while it waits for the user, and when it is done.
    std::optional<esc::Request> next(Instant now);
    void answered(const esc::ExchangeResult &result, Instant now);

    bool waits() const { return m_waits && !m_mayBegin; } // for the user
    bool isDone() const { return m_isDone; }              // the outcome is among the events of the encoder
    // The encoder is looked for: nothing else may be asked of it meanwhile.
    bool isSearching() const
    {
        return m_index < m_steps.size() && m_steps[m_index].task == EscStep::Task::search;
    }

    void proceed() { m_mayBegin = m_waits; }
    void cancel(OnCancel how);
    void stop(const Refusal &why);

private:
    // What tells whether a preset was done.
    struct Preset
    {
        std::optional<Instant> sentAt;
        QByteArray line;                         // the command
        std::optional<std::int64_t> valueBefore; // S
        std::optional<std::int64_t> valueAfter;
    };
    // A position that reads agreed on.
    struct AgreedPosition
    {
        EscPositionAgreement::Sample sample;
        double speed = 0; // steps per us
    };
    enum class Said : std::uint8_t { done, notDone, nothing };

    // esc_job.cpp
    void settle();
    void leaveOutWhatIsThere();
    void noteWhatWasSetAlong();
    void checkPreset();
    bool mayBegin();
    void begin(Instant now);
    void readAnswered(const esc::ExchangeResult &result, Instant now);
    void readAgreed(Instant now);
    void refreshAnswered(const esc::ExchangeResult &result, Instant now);
    void finish(Result<void> result);
    void reportProgress(bool waits);
    Result<void> result() const;
    EscStep &current() { return m_steps[m_index]; }
    const EscStep &current() const { return m_steps[m_index]; }
    void stepDone();

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
    Said positionSays() const;
    bool hasTurnedFrom(const EscPositionAgreement::Sample &before, double speedThen) const;
    bool hasTurnedFromPreset() const;
    Said presetValueSays() const;

    // esc_job_search.cpp
    void beginSearch();
    void searchAnswered(const esc::ExchangeResult &result, Instant now);
    void foundAtAddress(LineAddress found, Instant now);
    void foundAtBaudRate(std::optional<int> found, Instant now);

    // esc_job_cancel.cpp
    void dropFrom(std::size_t first, std::optional<Parameter> refused = {});
    void appendRestore();
    bool canRestore() const;
    bool hasTaken() const;

    Refusal refusalOf(const esc::ExchangeResult &result) const;
    Refusal disagreed() const;

    JobId m_id;
    Job m_job;
    Pace m_pace;
    EscEncoder &m_encoder;
    EscSteps m_steps;
    std::size_t m_index = 0;
    bool m_isBegun = false;
    bool m_isUnderWay = false; // a request of the step is on the line
    bool m_waits = false;
    bool m_mayBegin = false;
    bool m_isCompared = false;
    bool m_isDone = false;
    EscAgreement m_reads;
    EscPositionAgreement m_positions;
    std::optional<AgreedPosition> m_positionBefore;
    std::optional<AgreedPosition> m_positionAfter;
    std::optional<EscStep> m_unanswered; // the write of which nothing is known yet
    std::optional<EscSearch> m_search;
    std::optional<int> m_rateBefore; // the search for another baud rate
    Preset m_preset;
    std::optional<Refusal> m_failure;
    std::optional<OnCancel> m_cancelled;
    bool m_isRestoring = false;
    int m_writesBefore;
    ParameterValues m_before;
    Outcome m_outcome;
};

} // namespace codewheel
