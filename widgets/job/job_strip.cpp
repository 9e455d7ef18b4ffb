// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/job_strip.h"

#include "journal/eeprom_cost.h"
#include "widgets/eeprom/eeprom_question.h"
#include "widgets/job/known_text.h"
#include "widgets/job/step_text.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/models/device_traits.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>

namespace codewheel {

namespace {

QPushButton *button(const QString &text, const QString &tip, QWidget *parent)
{
    auto *made = new QPushButton(text, parent);
    made->setToolTip(tip);
    return made;
}

// Cams are acknowledged one by one, too, but are no parameters.
bool tookCams(const Progress &progress)
{
    const auto done = std::min(progress.steps.size(), static_cast<std::size_t>(progress.index));
    return std::any_of(progress.steps.begin(), progress.steps.begin() + static_cast<std::ptrdiff_t>(done),
                       [](const Step &step) { return step.kind == StepKind::camParameter; });
}

} // namespace

JobStrip::JobStrip(QWidget *parent)
    : QWidget(parent)
    , m_step(new QLabel(this))
    , m_bar(new QProgressBar(this))
    , m_cancel(button(tr("&Cancel"), tr("Ends the job; asks how to leave the encoder"), this))
    , m_choices(new QWidget(this))
    , m_question(new QLabel(this))
    , m_restore(button(tr("&Restore previous"), tr("Writes the values from before again"), m_choices))
    , m_run(button(tr("R&un as it is"), tr("Sends run: what the encoder has taken becomes valid"), m_choices))
    , m_leave(button(tr("&Leave it so"), tr("OUT goes back to 0, and the encoder keeps the state it is in"),
                     m_choices))
    , m_goOn(button(tr("&Go on"), tr("The job goes on"), m_choices))
{
    m_step->setWordWrap(true);
    m_question->setWordWrap(true);
    m_bar->setTextVisible(false);
    m_bar->setAccessibleName(tr("Progress of the job"));
    m_bar->setFixedHeight(2 * grid::unit);
    m_cancel->setObjectName(QStringLiteral("cancelJob"));

    auto *ways = new QGridLayout;
    ways->addWidget(m_restore, 0, 0);
    ways->addWidget(m_run, 0, 1);
    ways->addWidget(m_leave, 1, 0);
    ways->addWidget(m_goOn, 1, 1);
    ways->setContentsMargins(0, 0, 0, 0);
    m_choices->setLayout(ways);
    m_choices->hide();
    m_question->hide();

    auto *row = new QHBoxLayout;
    row->addWidget(m_bar, 1);
    row->addWidget(m_cancel);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_step);
    layout->addLayout(row);
    layout->addWidget(m_question);
    layout->addWidget(m_choices);

    connect(m_cancel, &QPushButton::clicked, this, &JobStrip::cancel);
    connect(m_restore, &QPushButton::clicked, this, [this] { leave(OnCancel::restorePrevious); });
    connect(m_run, &QPushButton::clicked, this, [this] { leave(OnCancel::runWithWhatItHas); });
    connect(m_leave, &QPushButton::clicked, this, [this] { leave(OnCancel::leaveAsIs); });
    connect(m_goOn, &QPushButton::clicked, this, [this] { showChoices(false); });
}

void JobStrip::setEncoder(EncoderSession *encoder)
{
    if (m_encoder)
        m_encoder->disconnect(this);
    m_encoder = encoder;
    if (encoder != nullptr)
        connect(encoder, &EncoderSession::progressed, this, &JobStrip::showProgress);
    m_run->setVisible(encoder != nullptr && activatesByRun(encoder->device()));
}

void JobStrip::begin()
{
    m_progress = {};
    m_asksIfTaken = false;
    m_step->setText(tr("The job begins."));
    m_bar->setRange(0, 0);
    m_cancel->setEnabled(true);
    showChoices(false);
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
    m_restore->setEnabled(progress.canRestore);
    if (!m_choices->isHidden() || (m_asksIfTaken && progress.hasTaken))
        showChoices(true); // it may have taken more
}

// Before the encoder has taken anything, OUT goes back to 0 and that is all.
void JobStrip::cancel()
{
    if (!m_encoder)
        return;
    if (m_progress.hasTaken) {
        showChoices(true);
    } else {
        leave(OnCancel::ifNothingTaken);
        m_asksIfTaken = true;
    }
}

QString JobStrip::question() const
{
    if (tookCams(m_progress))
        return tr("The encoder has taken words of a cam program. How is it to be left?");
    if (m_progress.confirmed.empty())
        return tr("The encoder has taken, or is taking, what was sent. How is it to be left?");
    return tr("The encoder has taken: %1. How is it to be left?")
        .arg(valueList(m_encoder->device(), m_progress.confirmed));
}

void JobStrip::showChoices(bool visible)
{
    const bool appears = visible && m_choices->isHidden();
    m_asksIfTaken = false;
    if (visible)
        m_question->setText(question());
    m_restore->setEnabled(m_progress.canRestore);
    m_restore->setToolTip(m_progress.canRestore
                              ? tr("Writes the values from before again")
                              : tr("The values from before are not all known, so they cannot be restored"));
    m_cancel->setEnabled(!visible);
    m_question->setVisible(visible);
    m_choices->setVisible(visible);
    if (appears)
        (m_progress.canRestore ? m_restore : m_goOn)->setFocus();
}

void JobStrip::leave(OnCancel how)
{
    const bool restores = how == OnCancel::restorePrevious;
    if (restores && m_encoder && !askForEeprom(window(), *m_encoder, mostWritesToRestore(m_progress)))
        return;
    showChoices(false);
    m_cancel->setEnabled(false);
    if (m_encoder)
        m_encoder->cancel(how);
}

} // namespace codewheel
