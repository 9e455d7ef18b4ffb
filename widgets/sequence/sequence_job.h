// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"

#include <QPointer>

namespace codewheel {

// A sequence being sent to one encoder. It goes on when another encoder is selected.
class SequenceJob : public QObject
{
    Q_OBJECT

public:
    using QObject::QObject;

    Result<void> start(EncoderSession &encoder, const SendWords &words);
    void cancel(OnCancel how);
    bool isRunning() const { return m_job.has_value(); }

Q_SIGNALS:
    void reached(int word); // from 0; now being sent
    // words: how many were sent completely
    void ended(const codewheel::Outcome &outcome, int words);

private:
    void takeProgress(const Progress &progress);
    void takeOutcome(const Outcome &outcome);

    QPointer<EncoderSession> m_encoder;
    std::optional<JobId> m_job;
    int m_words = 0;
    int m_index = 0;
};

} // namespace codewheel
