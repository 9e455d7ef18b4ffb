// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/eeprom/eeprom_question.h"

#include "widgets/eeprom/eeprom_gate.h"
#include "widgets/help/help_topic.h"
#include "widgets/look/describe.h"
#include "widgets/look/layouts.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>

namespace codewheel {
namespace {

struct Question
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::EepromGate)
};

constexpr int textWidth = 420; // a comfortable line length

} // namespace

bool askForEeprom(QWidget *window, EncoderSession &encoder, const Job &job)
{
    return askForEeprom(window, encoder, mostEepromWrites(encoder, job));
}

bool askForEeprom(QWidget *window, EncoderSession &encoder, int planned)
{
    if (eepromConcern(encoder, planned) == EepromConcern::none)
        return true;

    QDialog dialog(window);
    setHelpTopic(dialog, "eeprom.md");
    dialog.setWindowTitle(QGuiApplication::applicationDisplayName());
    auto *question =
        new QLabel(Question::tr("Write to the EEPROM of %1?").arg(encoder.place().shown()), &dialog);
    QFont strong = question->font();
    strong.setBold(true);
    question->setFont(strong);
    auto *gate = new EepromGate(&dialog);
    gate->setWrites(encoder, planned);
    gate->setMinimumWidth(textWidth);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, &dialog);
    QPushButton *write = buttons->addButton(Question::tr("&Write"), QDialogButtonBox::AcceptRole);
    describe(write, "writeToEeprom", Question::tr("Starts what you asked for"));
    write->setEnabled(gate->isOpen());
    layOutColumn(&dialog, {question, gate, buttons});
    QObject::connect(gate, &EepromGate::changed, write, [=] { write->setEnabled(gate->isOpen()); });
    QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    const QPointer<EncoderSession> still(&encoder);
    return dialog.exec() == QDialog::Accepted && still;
}

} // namespace codewheel
