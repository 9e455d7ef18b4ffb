// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/job_strip.h"

#include "jobs/step_text.h"
#include "widgets/job/job_cancel.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/on_event.h"
#include "widgets/look/wrapped_label.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

namespace codewheel {

JobStrip::JobStrip(QWidget *parent)
    : JobStrip(nullptr, parent)
{}

JobStrip::JobStrip(JobRound &round, QWidget *parent)
    : JobStrip(&round, parent)
{
    connect(&round, &JobRound::progressed, this, &JobStrip::showRound);
}

JobStrip::JobStrip(JobRound *round, QWidget *parent)
    : QWidget(parent)
    , m_round(round)
    , m_step(wrappedLabel(this, "jobProgress"))
    , m_encoders(
          describe(new QProgressBar(this), tr("Encoders done"), tr("Encoders done, of all that were chosen")))
    , m_bar(describe(new QProgressBar(this), tr("Progress of the job"), tr("Steps of the running job")))
    , m_button(describe(new QPushButton(lineIcon(Icon::cancel), tr("&Cancel"), this), "cancelJob",
                        round ? tr("Ends the job, after asking in which state to leave the encoder; the "
                                   "others are not started")
                              : tr("Ends the job; asks in which state to leave the encoder")))
    , m_question(round ? nullptr : new CancelQuestion(this))
    , m_cancel(new JobCancel(this, m_question))
{
    layOut();
    connect(m_button, &QPushButton::clicked, this, &JobStrip::cancel);
    connect(m_cancel, &JobCancel::leaves, this, &JobStrip::leave);
    connect(m_cancel, &JobCancel::goesOn, this, &JobStrip::goOn);
}

void JobStrip::layOut()
{
    auto *row = new QHBoxLayout;
    for (QProgressBar *bar : {m_encoders, m_bar}) {
        bar->setTextVisible(false);
        bar->setFixedHeight(2 * grid::unit);
        row->addWidget(bar, 1);
    }
    m_encoders->setVisible(m_round != nullptr);
    row->addWidget(m_button);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_step);
    layout->addLayout(row);
    if (m_question) {
        layout->addWidget(m_question, 1);
        onEventOf(m_question, {QEvent::ShowToParent, QEvent::HideToParent}, this, [this] {
            const bool comes = !m_question->isHidden();
            for (QWidget *part : std::initializer_list<QWidget *>{m_step, m_bar, m_button})
                part->setVisible(!comes);
            Q_EMIT asks(comes);
        });
    }
    setFocusProxy(m_button);
}

void JobStrip::setEncoder(EncoderSession *encoder)
{
    if (m_encoder)
        m_encoder->disconnect(this);
    m_encoder = encoder;
    m_cancel->begin(encoder);
    if (encoder == nullptr)
        return;
    connect(encoder, &EncoderSession::progressed, this, &JobStrip::showProgress);
    connect(encoder, &EncoderSession::finished, this, [this] { m_cancel->begin(m_encoder); }); // asks no more
}

void JobStrip::begin()
{
    m_cancel->begin(m_encoder);
    m_step->setText(tr("The job begins."));
    m_bar->setRange(0, 0);
    m_button->setEnabled(true);
}

void JobStrip::showProgress(const Progress &progress)
{
    const int count = static_cast<int>(progress.steps.size());
    m_bar->setRange(0, count);
    m_bar->setValue(progress.index);
    QStringList sentences = roundTexts();
    if (progress.index < count)
        sentences << tr("Step %1 of %2: %3")
                         .arg(progress.index + 1)
                         .arg(count)
                         .arg(stepText(m_encoder->device(),
                                       progress.steps[static_cast<std::size_t>(progress.index)]));
    if (!sentences.isEmpty())
        m_step->setText(sentences.join(u' '));
    m_cancel->follow(progress);
}

void JobStrip::showRound()
{
    if (m_encoder != m_round->encoder()) {
        m_encoder = m_round->encoder();
        m_cancel->begin(m_encoder);
    }
    if (!m_encoder)
        return;
    m_encoders->setRange(0, m_round->progress().encoders);
    m_encoders->setValue(m_round->progress().encoder);
    showProgress(m_round->jobProgress());
}

QStringList JobStrip::roundTexts() const
{
    if (m_round == nullptr)
        return {};
    const RoundProgress at = m_round->progress();
    QStringList texts{tr("Encoder %1 of %2: %3.").arg(at.encoder + 1).arg(at.encoders).arg(at.place.shown())};
    if (m_round->beginsNoOther() && at.encoder + 1 < at.encoders)
        texts << tr("No other is started.");
    return texts;
}

void JobStrip::cancel()
{
    if (!m_encoder)
        return;
    m_button->setEnabled(false);
    if (m_round)
        m_round->beginNothingElse();
    m_cancel->cancel();
}

void JobStrip::goOn()
{
    m_button->setEnabled(true);
    if (m_round && m_round->encoder()) {
        m_round->finishThisEncoder();
        showRound();
    }
}

void JobStrip::leave(OnCancel how)
{
    m_button->setEnabled(false);
    if (m_round)
        m_round->cancel(how);
    else if (m_encoder)
        m_encoder->cancel(how);
}

} // namespace codewheel
