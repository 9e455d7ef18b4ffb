// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sequence/sequence_job.h"

namespace codewheel {

Result<void> SequenceJob::start(EncoderSession &encoder, const SendWords &words)
{
    const Result<JobId> started = encoder.start(words);
    if (!started)
        return tl::unexpected(started.error());
    m_encoder = &encoder;
    m_job = *started;
    m_words = static_cast<int>(words.words.size());
    m_index = 0;
    connect(&encoder, &EncoderSession::progressed, this, &SequenceJob::takeProgress);
    connect(&encoder, &EncoderSession::finished, this, &SequenceJob::takeOutcome);
    connect(&encoder, &QObject::destroyed, this, [this] {
        if (m_job)
            takeOutcome({.job = *m_job,
                         .result = refuse(RefusalKind::stopped, RefusalId::busStopped),
                         .written = {},
                         .alreadyThere = {},
                         .read = {},
                         .positionBefore = {},
                         .positionAfter = {}});
    });
    return {};
}

void SequenceJob::cancel(OnCancel how)
{
    if (m_encoder && m_job)
        m_encoder->cancel(how);
}

// After a failure or cancel come other steps, which bring OUT back.
void SequenceJob::takeProgress(const Progress &progress)
{
    if (progress.job != m_job || progress.index >= m_words)
        return;
    const Effect effect = progress.steps.at(static_cast<std::size_t>(progress.index)).effect;
    if (effect != Effect::byHand && effect != Effect::takesByHand)
        return;
    m_index = progress.index;
    Q_EMIT reached(m_index);
}

void SequenceJob::takeOutcome(const Outcome &outcome)
{
    if (outcome.job != m_job)
        return;
    if (m_encoder)
        m_encoder->disconnect(this);
    m_job.reset();
    Q_EMIT ended(outcome, outcome.result ? m_words : m_index);
}

} // namespace codewheel
