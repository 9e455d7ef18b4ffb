// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/job_cancel.h"

#include <QTimer>

namespace codewheel {

JobCancel::JobCancel(QWidget *view, CancelQuestion *question, Situation situation)
    : QObject(view)
    , m_view(view)
    , m_question(question)
    , m_situation(std::move(situation))
{
    if (question == nullptr)
        return;
    question->hide();
    connect(question, &CancelQuestion::answered, this, &JobCancel::leaves);
    connect(question, &CancelQuestion::goesOn, this, &JobCancel::goesOn);
    connect(this, &JobCancel::leaves, question, &QWidget::hide);
    connect(this, &JobCancel::goesOn, question, &QWidget::hide);
}

void JobCancel::begin(EncoderSession *encoder)
{
    m_encoder = encoder;
    m_progress = {};
    m_asksIfTaken = false;
    if (m_question)
        m_question->hide();
}

void JobCancel::follow(const Progress &progress)
{
    m_progress = progress;
    const bool asksNow = m_asksIfTaken && progress.hasTaken;
    m_asksIfTaken = m_asksIfTaken && !asksNow;
    if (m_question && (asksNow || !m_question->isHidden())) // it may have taken more
        ask();
    else if (asksNow)
        QTimer::singleShot(0, this, &JobCancel::ask); // not from within the signals of the bus
}

// Before the encoder has taken anything, OUT simply goes back to 0.
void JobCancel::cancel()
{
    if (!m_encoder)
        return;
    m_asksIfTaken = !m_progress.hasTaken;
    if (m_asksIfTaken)
        Q_EMIT leaves(OnCancel::ifNothingTaken);
    else
        ask();
}

// The question lapses when the encoder is done.
void JobCancel::ask()
{
    if (!m_encoder)
        return;
    const CancelSituation situation = m_situation(*m_encoder, m_progress);
    if (m_question)
        m_question->ask(*m_encoder, situation);
    else if (const auto how = askHowToCancel(m_view->window(), *m_encoder, situation))
        Q_EMIT leaves(*how);
    else
        Q_EMIT goesOn();
}

} // namespace codewheel
