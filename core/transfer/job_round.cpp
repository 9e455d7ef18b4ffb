// SPDX-License-Identifier: GPL-3.0-or-later
#include "transfer/job_round.h"

#include "bus/buses.h"

namespace codewheel {
namespace {

// Without its link a bus has no other encoder either. The write that was under way then is reported with an
// id of its own.
bool losesBus(const Refusal &why)
{
    return why.id == RefusalId::linkFailed || why.id == RefusalId::portLost ||
           (why.id == RefusalId::stoppedInWrite && why.kind == RefusalKind::link);
}

// An encoder that was found in error had no position before, whatever it shows once it has its values.
void takePositions(EncoderResult &result, const Outcome &outcome, bool wasInError)
{
    if (!result.positionBefore && !wasInError)
        result.positionBefore = outcome.positionBefore;
    if (outcome.positionAfter)
        result.positionAfter = outcome.positionAfter;
}

} // namespace

JobRound::JobRound(const Buses &buses, QObject *parent)
    : QObject(parent)
    , m_buses(buses)
{}

void JobRound::start(std::vector<EncoderJobs> encoders, AfterRefusal afterRefusal)
{
    m_encoders = std::move(encoders);
    m_afterRefusal = afterRefusal;
    m_results.clear();
    for (const EncoderJobs &one : m_encoders)
        m_results.push_back({.place = one.place});
    m_index = 0;
    m_isRunning = true;
    m_beginsNoOther = m_beginsNoJob = false;
    beginEncoder();
}

void JobRound::cancel(OnCancel how)
{
    if (!m_isRunning)
        return;
    beginNothingElse();
    if (m_encoder)
        m_encoder->cancel(how);
}

RoundProgress JobRound::progress() const
{
    const std::size_t shown = std::min(m_index, m_encoders.empty() ? 0 : m_encoders.size() - 1);
    return {.encoder = static_cast<int>(shown),
            .encoders = static_cast<int>(m_encoders.size()),
            .place = m_encoders.empty() ? Place() : m_encoders[shown].place,
            .step = m_jobProgress.index,
            .steps = static_cast<int>(m_jobProgress.steps.size())};
}

QDateTime JobRound::now() const
{
    return m_buses.now(m_encoders[m_index].place);
}

void JobRound::beginEncoder()
{
    if (m_index == m_encoders.size()) {
        end();
        return;
    }
    m_job = 0;
    m_jobProgress = {};
    const Place place = m_encoders[m_index].place;
    m_encoder = m_buses.encoder(place);
    current().begun = now();
    if (!m_encoder) {
        endEncoder(m_buses.whyNotThere(place));
        return;
    }
    if (!m_encoder->agreesOnPositions())
        current().positionBefore = m_encoder->latest().position;
    m_wasInError = m_encoder->latest().state == EncoderState::error;
    connect(m_encoder, &EncoderSession::finished, this, &JobRound::takeOutcome);
    connect(m_encoder, &EncoderSession::progressed, this, [this](const Progress &progress) {
        if (progress.job != m_id)
            return;
        m_jobProgress = progress;
        Q_EMIT progressed();
    });
    connect(m_encoder, &QObject::destroyed, this, [this, place] { endEncoder(m_buses.whyNotThere(place)); });
    beginJob();
}

void JobRound::beginJob()
{
    const std::vector<Job> &jobs = m_encoders[m_index].jobs;
    if (m_job == jobs.size()) {
        endEncoder(std::nullopt);
        return;
    }
    m_jobProgress = {};
    const auto started = m_encoder->start(jobs[m_job]);
    if (!started) {
        endEncoder(started.error());
        return;
    }
    m_id = *started;
    Q_EMIT progressed();
}

void JobRound::takeOutcome(const Outcome &outcome)
{
    if (outcome.job != m_id)
        return;
    m_id.reset();
    current().outcomes.push_back(outcome);
    takePositions(current(), outcome, m_wasInError);
    if (!outcome.result)
        endEncoder(outcome.result.error());
    else if (m_beginsNoJob && m_job + 1 < m_encoders[m_index].jobs.size())
        endEncoder(Refusal{RefusalKind::stopped, RefusalId::cancelled, {}}); // its job had ended meanwhile
    else {
        ++m_job;
        beginJob();
    }
}

void JobRound::endEncoder(std::optional<Refusal> why)
{
    EncoderResult &result = current();
    m_id.reset();
    if (m_encoder) {
        m_encoder->disconnect(this);
        result.leftIn = result.outcomes.empty() ? m_encoder->latest().state : result.outcomes.back().leftIn;
        if (!m_encoder->agreesOnPositions())
            result.positionAfter = m_encoder->latest().position;
    }
    m_encoder = nullptr;
    if (why && losesBus(*why))
        result.leftIn = EncoderState::unknown;
    result.lastJob = m_jobProgress;
    result.why = std::move(why);
    result.ended = now();
    ++m_index;
    const bool isLost = result.why && losesBus(*result.why);
    const bool isStopped = result.why && result.why->kind == RefusalKind::stopped && !isLost;
    if (m_beginsNoOther || isStopped || (result.why && m_afterRefusal == AfterRefusal::stop))
        m_index = m_encoders.size();
    else if (isLost)
        skipBus(result.place.bus);
    beginEncoder();
}

void JobRound::skipBus(BusId lost)
{
    while (m_index < m_encoders.size() && m_encoders[m_index].place.bus == lost)
        ++m_index;
}

void JobRound::end()
{
    m_isRunning = false;
    Q_EMIT progressed();
    Q_EMIT finished();
}

} // namespace codewheel
