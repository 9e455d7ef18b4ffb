// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/cancel_question.h"

#include "encoder/encoder_session.h"
#include "journal/eeprom_cost.h"
#include "widgets/eeprom/eeprom_question.h"
#include "widgets/job/known_text.h"
#include "widgets/models/device_traits.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace codewheel {
namespace {

// The context of these texts.
struct CancelQuestion
{
    Q_DECLARE_TR_FUNCTIONS(CancelQuestion)
};

QString takenText(const EncoderSession &encoder, const ParameterValues &taken)
{
    return taken.empty() ? CancelQuestion::tr("a value it has not confirmed yet")
                         : valueList(encoder.device(), taken);
}

QString explanation(const EncoderSession &encoder, const CancelSituation &situation)
{
    QStringList lines;
    if (!situation.isActive || !situation.taken.empty())
        lines += CancelQuestion::tr("It has already taken: %1.").arg(takenText(encoder, situation.taken));
    if (situation.canRestore)
        lines += CancelQuestion::tr("Restore writes the values from before again and runs with them.");
    else
        lines += CancelQuestion::tr("The values from before are not all known, so they cannot be restored.");
    if (situation.isActive)
        lines += CancelQuestion::tr("What it has taken is valid already.");
    else
        lines += CancelQuestion::tr("Run makes what it has taken valid.");
    if (!situation.positionNote.isEmpty())
        lines += situation.positionNote;
    if (!situation.isActive)
        lines +=
            CancelQuestion::tr("Left in parameterization, it gives no position until somebody sends run.");
    return lines.join(QLatin1Char('\n'));
}

// A word that is in OUT, and was not confirmed yet.
bool isTakingValue(const Progress &progress)
{
    if (progress.waitsForUser || progress.index >= std::ssize(progress.steps))
        return false;
    const Step &step = progress.steps[static_cast<std::size_t>(progress.index)];
    return takesValue(step) || step.kind == StepKind::camParameter ||
           (step.kind == StepKind::word && k3::isParameterWord(step.out));
}

} // namespace

CancelSituation situationOf(const EncoderSession &encoder, const Progress &progress)
{
    const bool isActive = progress.confirmed.empty() && !isTakingValue(progress) &&
                          encoder.latest().state == EncoderState::operation;
    return {.taken = progress.confirmed,
            .isActive = !activatesByRun(encoder.device()) || isActive,
            .canRestore = progress.canRestore,
            .writesToRestore = mostWritesToRestore(progress),
            .positionNote = {}};
}

std::optional<OnCancel> askHowToCancel(QWidget *parent, EncoderSession &encoder,
                                       const CancelSituation &situation)
{
    QMessageBox box(parent);
    box.setObjectName(QStringLiteral("cancelQuestion"));
    box.setIcon(QMessageBox::Question);
    box.setWindowTitle(CancelQuestion::tr("Cancel the handshake"));
    box.setText(CancelQuestion::tr("How shall the encoder %1 be left?").arg(encoder.place().shown()));
    box.setInformativeText(explanation(encoder, situation));
    QPushButton *restore =
        box.addButton(CancelQuestion::tr("&Restore values from before"), QMessageBox::AcceptRole);
    const QPushButton *run = situation.isActive ? nullptr
                                                : box.addButton(CancelQuestion::tr("R&un with what it has"),
                                                                QMessageBox::AcceptRole);
    const QPushButton *leave =
        box.addButton(situation.isActive ? CancelQuestion::tr("&Leave it with what it has")
                                         : CancelQuestion::tr("&Leave in parameterization"),
                      QMessageBox::AcceptRole);
    QPushButton *goOn =
        box.addButton(CancelQuestion::tr("&Go on with the handshake"), QMessageBox::RejectRole);
    restore->setEnabled(situation.canRestore);
    box.setDefaultButton(situation.canRestore ? restore : goOn);
    box.setEscapeButton(goOn);
    QObject::connect(&encoder, &EncoderSession::finished, &box, &QDialog::reject);
    QObject::connect(&encoder, &QObject::destroyed, &box, &QDialog::reject);

    box.exec();
    if (box.clickedButton() == restore)
        return askForEeprom(parent, encoder, situation.writesToRestore)
                   ? std::optional(OnCancel::restorePrevious)
                   : std::nullopt;
    if (run != nullptr && box.clickedButton() == run)
        return OnCancel::runWithWhatItHas;
    if (box.clickedButton() == leave)
        return OnCancel::leaveAsIs;
    return std::nullopt;
}

} // namespace codewheel
