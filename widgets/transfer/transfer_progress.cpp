// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/transfer/transfer_progress.h"

#include "journal/eeprom_cost.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/models/device_traits.h"
#include "widgets/wizard/cancel_question.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>

namespace codewheel {
namespace {

bool hasTaken(const EncoderSession &encoder, const Progress &progress)
{
    const auto end =
        progress.steps.begin() + std::min<std::ptrdiff_t>(progress.index + 1, std::ssize(progress.steps));
    return !progress.confirmed.empty() || encoder.latest().state == EncoderState::parameterization ||
           std::any_of(progress.steps.begin(), end, [](const Step &step) { return takesValue(step); });
}

} // namespace

TransferProgress::TransferProgress(JobRound &round, QWidget *parent)
    : QWidget(parent)
    , m_round(round)
    , m_text(new QLabel(this))
    , m_encoders(new QProgressBar(this))
    , m_steps(new QProgressBar(this))
    , m_cancel(new QPushButton(lineIcon(Icon::cancel), tr("&Cancel"), this))
{
    m_encoders->setAccessibleName(tr("Encoders done"));
    m_encoders->setTextVisible(false);
    m_encoders->setToolTip(tr("Encoders done, of all that were chosen"));
    m_steps->setAccessibleName(tr("Steps of this encoder"));
    m_steps->setTextVisible(false);
    m_steps->setToolTip(tr("Steps of the running handshake"));
    m_text->setObjectName(QStringLiteral("transferProgress"));
    m_cancel->setObjectName(QStringLiteral("transferCancel"));
    m_cancel->setToolTip(tr("Ends the running handshake, after asking how to leave the encoder; the others "
                            "are not begun."));
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
    m_text->setText(tr("Encoder %1 of %2: %3, step %4 of %5")
                        .arg(progress.encoder + 1)
                        .arg(progress.encoders)
                        .arg(progress.place.toString())
                        .arg(std::min(progress.step + 1, progress.steps))
                        .arg(progress.steps));
    m_encoders->setRange(0, std::max(progress.encoders, 1));
    m_encoders->setValue(m_round.isRunning() ? progress.encoder : progress.encoders);
    m_steps->setRange(0, std::max(progress.steps, 1));
    m_steps->setValue(progress.step);
    m_cancel->setEnabled(m_round.isRunning());
}

void TransferProgress::cancel()
{
    EncoderSession *encoder = m_round.encoder();
    if (!m_round.isRunning() || encoder == nullptr)
        return;
    const Progress progress = m_round.jobProgress();
    std::optional<OnCancel> how = OnCancel::leaveAsIs; // nothing was taken: OUT back to 0
    if (hasTaken(*encoder, progress))
        how = askHowToCancel(
            window(), *encoder,
            {.taken = progress.confirmed,
             .isActive = !activatesByRun(encoder->device()) ||
                         (progress.confirmed.empty() && encoder->latest().state == EncoderState::operation),
             .canRestore = progress.canRestore,
             .writesToRestore = mostWritesToRestore(progress),
             .positionNote = {}});
    if (how)
        m_round.cancel(*how);
}

} // namespace codewheel
