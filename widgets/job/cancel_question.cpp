// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/cancel_question.h"

#include "journal/eeprom_cost.h"
#include "widgets/eeprom/eeprom_question.h"
#include "widgets/help/help_topic.h"
#include "widgets/job/known_text.h"
#include "widgets/look/content_scroll_area.h"
#include "widgets/look/folding_row.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/models/device_traits.h"

#include <QDialog>
#include <QPushButton>
#include <QTimer>

#include <algorithm>

namespace codewheel {
namespace {

QString takenText(const EncoderSession &encoder, const CancelSituation &situation)
{
    if (situation.tookCams)
        return CancelQuestion::tr("words of a cam program");
    return situation.taken.empty() ? CancelQuestion::tr("a value it has not confirmed yet")
                                   : valueList(encoder.device(), situation.taken);
}

QStringList restoringTexts(const EncoderSession &encoder, const CancelSituation &situation)
{
    if (situation.setsPosition)
        return {
            CancelQuestion::tr("The position was set. That cannot be undone, and by the earlier values the "
                               "encoder would show yet another one: they are not restored.")};
    if (!situation.canRestore)
        return {CancelQuestion::tr("The earlier values are not all known, so they cannot be restored.")};
    const QString restore =
        activatesByRun(encoder.device())
            ? CancelQuestion::tr("Restore writes the earlier values again and runs with them. EEPROM "
                                 "writes for that: %1 at most.")
            : CancelQuestion::tr(
                  "Restore writes the earlier values again. EEPROM writes for that: %1 at most.");
    QStringList lines{restore.arg(situation.writesToRestore)};
    if (!situation.isActive && restoresBehindRun(encoder.device()))
        lines +=
            CancelQuestion::tr("Before that, run makes valid what it has taken: until the earlier values are "
                               "written, the controller sees a position by these. Leave it in "
                               "parameterization to avoid that.");
    return lines;
}

QString explanation(const EncoderSession &encoder, const CancelSituation &situation)
{
    QStringList lines{
        CancelQuestion::tr("In which state should the encoder %1 be left?").arg(encoder.place().shown())};
    if (!situation.isActive || situation.tookCams || !situation.taken.empty())
        lines += CancelQuestion::tr("It has already taken: %1.").arg(takenText(encoder, situation));
    lines += restoringTexts(encoder, situation);
    if (situation.isActive)
        lines += CancelQuestion::tr("What it has taken is valid already.");
    else
        lines += CancelQuestion::tr("Run makes what it has taken valid.");
    if (situation.positionNote)
        lines += situation.positionNote();
    if (!situation.isActive)
        lines +=
            CancelQuestion::tr("Left in parameterization, it gives no position until somebody sends run.");
    return lines.join(QLatin1Char('\n'));
}

// A word is in OUT and not confirmed yet.
bool isTakingValue(const Progress &progress)
{
    if (progress.waitsForUser || progress.index >= std::ssize(progress.steps))
        return false;
    const Step &step = progress.steps[static_cast<std::size_t>(progress.index)];
    return takesValue(step) || step.effect == Effect::takesCams || step.effect == Effect::takesByHand;
}

bool tookCams(const Progress &progress)
{
    const auto done = std::min(std::ssize(progress.steps), std::ptrdiff_t{progress.index});
    return std::any_of(progress.steps.begin(), progress.steps.begin() + done,
                       [](const Step &step) { return step.effect == Effect::takesCams; });
}

} // namespace

CancelSituation situationOf(const EncoderSession &encoder, const Progress &progress)
{
    const EncoderState state = encoder.latest().state;
    const bool hasRun = state == EncoderState::operation || state == EncoderState::readOut; // read back
    const bool isActive = progress.confirmed.empty() && !isTakingValue(progress) && hasRun;
    return {.taken = progress.confirmed,
            .tookCams = tookCams(progress),
            .isActive = !activatesByRun(encoder.device()) || isActive,
            .canRestore = progress.canRestore,
            .setsPosition = progress.setsPosition,
            .writesToRestore = mostWritesToRestore(encoder, progress),
            .positionNote = {}};
}

CancelQuestion::CancelQuestion(QWidget *parent)
    : QWidget(parent)
    , m_text(wrappedLabel(this))
    , m_restore(new QPushButton(tr("&Restore earlier values"), this))
    , m_run(new QPushButton(tr("R&un with what it has"), this))
    , m_leave(new QPushButton(tr("&Leave in parameterization"), this))
    , m_goOn(new QPushButton(tr("&Go on with the handshake"), this))
{
    m_restore->setToolTip(tr("Writes the earlier values again"));
    m_run->setToolTip(tr("Sends run: what the encoder has taken becomes valid"));
    m_leave->setToolTip(tr("OUT goes back to 0, and the encoder keeps the state it is in"));
    m_goOn->setToolTip(tr("The job goes on"));
    m_text->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto *choices = new QWidget(this);
    layOutColumn(choices,
                 {new FoldingRow(m_restore, m_run, choices), new FoldingRow(m_leave, m_goOn, choices)},
                 {.margins = QMargins()});
    auto *choicesArea = new ContentScrollArea(choices, this); // large ones scroll in a low window
    choicesArea->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    layOutColumn(this, {{new ContentScrollArea(m_text, this), 1}, choicesArea}, {.margins = QMargins()});
    connect(m_restore, &QPushButton::clicked, this, [this] { answer(OnCancel::restorePrevious); });
    connect(m_run, &QPushButton::clicked, this, [this] { answer(OnCancel::runWithWhatItHas); });
    connect(m_leave, &QPushButton::clicked, this, [this] { answer(OnCancel::leaveAsIs); });
    connect(m_goOn, &QPushButton::clicked, this, &CancelQuestion::goesOn);
}

void CancelQuestion::ask(EncoderSession &encoder, const CancelSituation &situation)
{
    if (m_encoder)
        m_encoder->disconnect(this);
    m_encoder = &encoder;
    m_situation = situation;
    explain();
    if (situation.positionNote)
        connect(&encoder, &EncoderSession::latestChanged, this, &CancelQuestion::explain);
    m_restore->setEnabled(situation.canRestore);
    m_run->setVisible(!situation.isActive);
    m_leave->setText(situation.isActive ? tr("&Leave it with what it has")
                                        : tr("&Leave in parameterization"));
    if (isVisible())
        return; // it is asked already
    show();
    m_goOn->setDefault(true); // it changes nothing and costs nothing
    m_goOn->setFocus();
}

void CancelQuestion::explain()
{
    m_text->setText(explanation(*m_encoder, m_situation));
}

void CancelQuestion::answer(OnCancel how)
{
    const bool restores = how == OnCancel::restorePrevious;
    if (restores && m_encoder && !askForEeprom(window(), *m_encoder, m_situation.writesToRestore))
        Q_EMIT goesOn();
    else
        Q_EMIT answered(how);
}

std::optional<OnCancel> askHowToCancel(QWidget *parent, EncoderSession &encoder,
                                       const CancelSituation &situation)
{
    QDialog dialog(parent);
    setHelpTopic(dialog, "parameters.md#write");
    dialog.setObjectName(QStringLiteral("cancelQuestion"));
    dialog.setWindowTitle(CancelQuestion::tr("Cancel the handshake"));
    auto *question = new CancelQuestion(&dialog);
    layOutColumn(&dialog, {question});
    std::optional<OnCancel> answer;
    QObject::connect(question, &CancelQuestion::answered, &dialog, [&](OnCancel how) {
        answer = how;
        dialog.accept();
    });
    QObject::connect(question, &CancelQuestion::goesOn, &dialog, &QDialog::reject);
    QObject::connect(&encoder, &EncoderSession::finished, &dialog, &QDialog::reject);
    QObject::connect(&encoder, &QObject::destroyed, &dialog, &QDialog::reject);
    question->ask(encoder, situation);
    // Once it has a width, it is known how high its text is; beside a scroll bar it was higher than that.
    const auto fit = [&dialog] { dialog.resize(dialog.width(), dialog.sizeHint().height()); };
    QTimer::singleShot(0, &dialog, [&dialog, fit] {
        fit();
        QTimer::singleShot(0, &dialog, fit);
    });
    dialog.exec();
    return answer;
}

} // namespace codewheel
