// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"

#include <QPointer>

namespace codewheel {

class Buses;

// The jobs of one encoder, one after the other.
struct EncoderJobs
{
    Place place;
    std::vector<Job> jobs;
};

// How far the jobs of one encoder got.
struct EncoderResult
{
    Place place;
    std::vector<Outcome> outcomes{}; // of the jobs that were accepted
    Progress lastJob{};              // how far the last of them got
    std::optional<Refusal> why{};    // why not everything was done
    EncoderState leftIn = EncoderState::notSeen;
    std::optional<std::int64_t> positionBefore{}; // steps
    std::optional<std::int64_t> positionAfter{};
    QDateTime begun{}; // invalid: not started
    QDateTime ended{};

    bool isBegun() const { return begun.isValid(); }
};

// How far a round has got.
struct RoundProgress
{
    int encoder = 0; // from 0
    int encoders = 0;
    Place place;
    int step = 0; // of the running job, from 0
    int steps = 0;
};

// Does the jobs of several encoders, one encoder after the other, and keeps what became of each. Used for
// transfers and storing. Lives in the thread of the bus sessions; `buses` must outlive it.
class JobRound : public QObject
{
    Q_OBJECT

public:
    enum class AfterRefusal : std::uint8_t {
        goOn, // with the next encoder
        stop, // the rest is not started
    };

    explicit JobRound(const Buses &buses, QObject *parent = nullptr);

    // Ends with finished(), which may come before start() returns.
    void start(std::vector<EncoderJobs> encoders, AfterRefusal afterRefusal);
    // Nothing more is started: neither another job of this encoder nor another encoder. What is running goes
    // on.
    void beginNothingElse() { m_beginsNoOther = m_beginsNoJob = true; }
    // The current encoder gets all its jobs after all; no other is started.
    void finishThisEncoder() { m_beginsNoJob = false; }
    // Cancels the running job, and starts nothing more.
    void cancel(OnCancel how);

    bool isRunning() const { return m_isRunning; }
    bool beginsNoOther() const { return m_beginsNoOther; }
    // The encoder whose job is running; null between jobs.
    EncoderSession *encoder() const { return m_encoder; }
    // Of the running job: what the encoder has confirmed, and whether the previous values are known.
    const Progress &jobProgress() const { return m_jobProgress; }
    RoundProgress progress() const;
    const std::vector<EncoderResult> &results() const { return m_results; }

Q_SIGNALS:
    void progressed();
    void finished();

private:
    void beginEncoder();
    void beginJob();
    void takeOutcome(const Outcome &outcome);
    void endEncoder(std::optional<Refusal> why);
    void skipBus(BusId lost);
    void end();
    EncoderResult &current() { return m_results[m_index]; }
    QDateTime now() const;

    const Buses &m_buses;
    std::vector<EncoderJobs> m_encoders;
    std::vector<EncoderResult> m_results; // one for each
    AfterRefusal m_afterRefusal = AfterRefusal::goOn;
    std::size_t m_index = 0;
    std::size_t m_job = 0;
    QPointer<EncoderSession> m_encoder;
    std::optional<JobId> m_id;
    Progress m_jobProgress;
    bool m_isRunning = false;
    bool m_wasInError = false;    // the encoder, before its first job
    bool m_beginsNoOther = false; // encoder
    bool m_beginsNoJob = false;
};

} // namespace codewheel
