// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/encoder/jobs.h"
#include "vocabulary/encoder_session.h"

#include <QJsonObject>

namespace codewheel {

// What became of values that were to be written, by the best evidence the encoder has. Made after the job.
class WriteAccount
{
public:
    WriteAccount(const EncoderSession &encoder, const ParameterValues &wanted, const FinishedJob &job);
    virtual ~WriteAccount() = default;
    Q_DISABLE_COPY_MOVE(WriteAccount)

    QString toText() const;
    // What only this kind of bus has to say about it.
    virtual QJsonObject toJson() const { return {}; }
    virtual QString whereItWasLeft() const; // in a sentence

protected:
    virtual QString fateOf(const ParameterValue &value) const; // in words

    const EncoderSession &encoder() const { return m_encoder; }
    const ParameterValues &wanted() const { return m_wanted; }
    const Outcome &outcome() const { return m_job.outcome; }
    const Progress &lastStep() const { return m_job.lastStep; }

private:
    QString fateOfUnconfirmed() const;

    const EncoderSession &m_encoder;
    const ParameterValues &m_wanted;
    const FinishedJob &m_job;
};

} // namespace codewheel
