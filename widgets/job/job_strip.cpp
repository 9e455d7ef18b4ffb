// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/job_strip.h"

#include "widgets/job/cancel_question.h"
#include "widgets/job/step_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace codewheel {

JobStrip::JobStrip(QWidget *parent)
    : QWidget(parent)
    , m_step(new QLabel(this))
    , m_bar(new QProgressBar(this))
    , m_cancel(describe(new QPushButton(tr("&Cancel"), this), "cancelJob",
                        tr("Ends the job; asks how to leave the encoder")))
    , m_question(new CancelQuestion(this))
{
    m_step->setWordWrap(true);
    m_bar->setTextVisible(false);
    m_bar->setAccessibleName(tr("Progress of the job"));
    m_bar->setFixedHeight(2 * grid::unit);
    m_question->hide();

    auto *row = new QHBoxLayout;
    row->addWidget(m_bar, 1);
    row->addWidget(m_cancel);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_step);
    layout->addLayout(row);
    layout->addWidget(m_question);

    connect(m_cancel, &QPushButton::clicked, this, &JobStrip::cancel);
    connect(m_question, &CancelQuestion::answered, this, &JobStrip::leave);
    connect(m_question, &CancelQuestion::goesOn, this, &JobStrip::goOn);
}

void JobStrip::setEncoder(EncoderSession *encoder)
{
    if (m_encoder)
        m_encoder->disconnect(this);
    m_encoder = encoder;
    if (encoder != nullptr)
        connect(encoder, &EncoderSession::progressed, this, &JobStrip::showProgress);
}

void JobStrip::begin()
{
    m_progress = {};
    m_asksIfTaken = false;
    m_step->setText(tr("The job begins."));
    m_bar->setRange(0, 0);
    goOn();
}

void JobStrip::showProgress(const Progress &progress)
{
    m_progress = progress;
    const int count = static_cast<int>(progress.steps.size());
    m_bar->setRange(0, count);
    m_bar->setValue(progress.index);
    if (progress.index < count)
        m_step->setText(tr("Step %1 of %2: %3")
                            .arg(progress.index + 1)
                            .arg(count)
                            .arg(stepText(m_encoder->device(),
                                          progress.steps[static_cast<std::size_t>(progress.index)])));
    if (!m_question->isHidden() || (m_asksIfTaken && progress.hasTaken))
        ask(); // it may have taken more
}

// Before the encoder has taken anything, OUT goes back to 0 and that is all.
void JobStrip::cancel()
{
    if (!m_encoder)
        return;
    if (m_progress.hasTaken) {
        ask();
    } else {
        leave(OnCancel::ifNothingTaken);
        m_asksIfTaken = true;
    }
}

void JobStrip::ask()
{
    m_asksIfTaken = false;
    m_cancel->setEnabled(false);
    m_question->ask(*m_encoder, situationOf(*m_encoder, m_progress));
}

void JobStrip::goOn()
{
    m_question->hide();
    m_cancel->setEnabled(true);
}

void JobStrip::leave(OnCancel how)
{
    m_question->hide();
    m_cancel->setEnabled(false);
    if (m_encoder)
        m_encoder->cancel(how);
}

} // namespace codewheel
