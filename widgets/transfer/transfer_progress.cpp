// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/transfer_progress.h"

#include "widgets/job/cancel_question.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>

#include <algorithm>

namespace codewheel {
TransferProgress::TransferProgress(JobRound &round, QWidget *parent)
    : QWidget(parent)
    , m_round(round)
    , m_text(new QLabel(this))
    , m_encoders(
          describe(new QProgressBar(this), tr("Encoders done"), tr("Encoders done, of all that were chosen")))
    , m_steps(
          describe(new QProgressBar(this), tr("Steps of this encoder"), tr("Steps of the running handshake")))
    , m_cancel(describe(new QPushButton(lineIcon(Icon::cancel), tr("&Cancel"), this), "transferCancel",
                        tr("Ends the running handshake, after asking how to leave the encoder; the others "
                           "are not begun.")))
{
    m_encoders->setTextVisible(false);
    m_steps->setTextVisible(false);
    m_text->setObjectName(QStringLiteral("transferProgress"));
    auto *layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(grid::unit);
    layout->addWidget(m_text, 0, 0, 1, 2);
    layout->addWidget(m_encoders, 1, 0);
    layout->addWidget(m_steps, 1, 1);
    layout->addWidget(m_cancel, 0, 2, 2, 1);
    setFocusProxy(m_cancel);
    connect(&round, &JobRound::progressed, this, &TransferProgress::showProgress);
    connect(m_cancel, &QPushButton::clicked, this, &TransferProgress::cancel);
}

void TransferProgress::showProgress()
{
    const RoundProgress progress = m_round.progress();
    QString text = tr("Encoder %1 of %2: %3, step %4 of %5")
                       .arg(progress.encoder + 1)
                       .arg(progress.encoders)
                       .arg(progress.place.shown())
                       .arg(std::min(progress.step + 1, progress.steps))
                       .arg(progress.steps);
    if (m_round.beginsNoOther() && progress.encoder + 1 < progress.encoders)
        text += QStringLiteral(". ") + tr("No other is begun.");
    m_text->setText(text);
    m_encoders->setRange(0, std::max(progress.encoders, 1));
    m_encoders->setValue(m_round.isRunning() ? progress.encoder : progress.encoders);
    m_steps->setRange(0, std::max(progress.steps, 1));
    m_steps->setValue(progress.step);
    m_cancel->setEnabled(m_round.isRunning());
    m_asksIfTaken = m_asksIfTaken && m_round.isRunning();
    if (m_asksIfTaken && m_round.jobProgress().hasTaken) {
        m_asksIfTaken = false;
        QTimer::singleShot(0, this, &TransferProgress::ask); // not amid the signals of the bus
    }
}

// No other encoder is begun from here on, whatever becomes of the one that runs.
void TransferProgress::cancel()
{
    if (!m_round.isRunning() || m_round.encoder() == nullptr)
        return;
    m_round.beginNothingElse();
    if (m_round.jobProgress().hasTaken) {
        ask();
    } else {
        m_asksIfTaken = true;
        m_round.cancel(OnCancel::ifNothingTaken);
    }
}

// The question lapses when the encoder is done.
void TransferProgress::ask()
{
    EncoderSession *encoder = m_round.encoder();
    if (encoder == nullptr)
        return;
    if (const auto how = askHowToCancel(window(), *encoder, situationOf(*encoder, m_round.jobProgress())))
        m_round.cancel(*how);
    else
        m_round.finishThisEncoder();
    showProgress();
}

} // namespace codewheel
