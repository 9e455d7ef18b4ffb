// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/functions/function_questions.h"

#include "catalog/device_description.h"
#include "jobs/protocol.h"
#include "jobs/values_to_write.h"
#include "jobs/what_run_makes_valid.h"
#include "journal/eeprom_cost.h"
#include "vocabulary/refusal_text.h"
#include "widgets/dial/now_and_then.h"
#include "widgets/help/help_topic.h"
#include "widgets/job/job_review.h"
#include "widgets/job/known_text.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QGuiApplication>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>

namespace codewheel {
namespace {

constexpr int dialWidth = 190;

struct Functions
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::EncoderFunctions)
};

bool isOutOfReach(const EncoderSession &encoder)
{
    const Freshness::Reason why = encoder.freshness().reason();
    return why == Freshness::Reason::disconnected || why == Freshness::Reason::linkLost;
}

// With a picture beside the text. Qt lays a message box out anew when the style changes, without it.
class BoxWithPicture : public QMessageBox
{
public:
    using QMessageBox::QMessageBox;

    void setPicture(QWidget *picture) // may be null
    {
        m_picture = picture;
        place();
    }

protected:
    bool event(QEvent *event) override
    {
        const bool handled = QMessageBox::event(event);
        place();
        return handled;
    }

private:
    void place()
    {
        auto *cells = qobject_cast<QGridLayout *>(layout());
        if (m_picture == nullptr || cells == nullptr || cells->indexOf(m_picture) >= 0)
            return;
        cells->addWidget(m_picture, 0, cells->columnCount(), 2, 1, Qt::AlignTop);
        cells->setRowStretch(1, 1); // the question stays above its explanation
    }

    QPointer<QWidget> m_picture;
};

// Lapses when the encoder goes, or takes up a job.
bool confirm(QWidget *window, const EncoderSession &encoder, const char *topic, const QString &question,
             const QStringList &paragraphs, const QString &doIt, const QString &toolTip,
             QWidget *picture = nullptr)
{
    BoxWithPicture box(QMessageBox::Question, QString(), question, QMessageBox::NoButton, window);
    setHelpTopic(box, topic);
    box.setWindowTitle(QGuiApplication::applicationDisplayName());
    box.setInformativeText(paragraphs.join(QStringLiteral("\n\n")));
    QPushButton *yes = box.addButton(doIt, QMessageBox::AcceptRole);
    yes->setToolTip(toolTip);
    box.setDefaultButton(box.addButton(QMessageBox::Cancel));
    box.setPicture(picture);
    QObject::connect(&encoder, &QObject::destroyed, &box, &QDialog::reject);
    QObject::connect(&encoder, &EncoderSession::jobStarted, &box, &QDialog::reject);
    QObject::connect(&encoder, &EncoderSession::freshnessChanged, &box, [&] {
        if (isOutOfReach(encoder)) // what it asks about may not be so any more
            box.reject();
    });
    box.exec();
    return box.clickedButton() == yes;
}

// Follows what becomes known meanwhile.
NowAndThen *pictureOfPreset(EncoderSession &encoder)
{
    auto *picture = new NowAndThen;
    picture->setFixedWidth(dialWidth);
    picture->setEncoder(encoder);
    const auto show = [&encoder, picture] {
        picture->setThenByPreset([&encoder](Parameter parameter) { return knownNumber(encoder, parameter); });
    };
    QObject::connect(&encoder, &EncoderSession::knownChanged, picture, show);
    show();
    return picture;
}

QString eepromWriteText(const EncoderSession &encoder)
{
    return eepromCountText(encoder) + u' ' + eepromCostText(encoder, 1);
}

QString whatIsLost(const EncoderSession &encoder)
{
    QStringList names;
    for (const ParameterDescription &parameter : encoder.device().parameters)
        if (parameter.canBeWritten)
            names << parameterName(parameter);
    QString text = Functions::tr("This is lost: %1.").arg(names.join(QStringLiteral(", ")));
    if (encoder.can().cams)
        text += u' ' + Functions::tr("All cam programs are lost, too, and the encoder is in position mode "
                                     "afterwards.");
    return text;
}

} // namespace

ModeAnswer askForMode(QWidget *window, const EncoderSession &encoder, Word out)
{
    QMessageBox box(QMessageBox::Question, QGuiApplication::applicationDisplayName(),
                    Functions::tr("In which mode is the encoder %1?").arg(encoder.place().shown()),
                    QMessageBox::NoButton, window);
    setHelpTopic(box, "manufacturer-functions.md#the-mode");
    box.setInformativeText(
        refusalText({RefusalKind::notSupported, RefusalId::modeNotKnown, {out}}) + QStringLiteral("\n\n") +
        Functions::tr(
            "It can also be put into position mode first: 20800000, then 20400000. Where it is in a "
            "cam program that was changed, that stores the program: one EEPROM write."));
    QPushButton *is = box.addButton(Functions::tr("It is in &position mode"), QMessageBox::AcceptRole);
    is->setToolTip(Functions::tr("Continues, since you have made sure"));
    QPushButton *put = box.addButton(Functions::tr("Put it into position &mode"), QMessageBox::AcceptRole);
    put->setToolTip(Functions::tr("Sends 20800000 and 20400000, then goes on"));
    box.setDefaultButton(box.addButton(QMessageBox::Cancel));
    box.exec();
    if (box.clickedButton() == is)
        return ModeAnswer::isInPositionMode;
    return box.clickedButton() == put ? ModeAnswer::switchFirst : ModeAnswer::cancel;
}

bool askToLeaveCamMode(QWidget *window, const EncoderSession &encoder)
{
    return confirm(window, encoder, "manufacturer-functions.md#the-mode",
                   Functions::tr("Leave cam mode at %1?").arg(encoder.place().shown()),
                   {Functions::tr("The cams switch no more. A cam program that was changed is stored when it "
                                  "is left: one EEPROM write.")},
                   Functions::tr("&Leave cam mode"), Functions::tr("Sends 20800000, then goes on"));
}

bool askForFrabaPreset(QWidget *window, EncoderSession &encoder)
{
    const auto preset = encoder.known(Parameter::preset);
    const QString value = preset ? valueWithUnit(encoder.device(), {Parameter::preset, preset->value})
                                 : Functions::tr("not known: read it, or write one, under Parameters");
    return confirm(
        window, encoder, "manufacturer-functions.md#the-two-presets-of-a-fraba-encoder",
        Functions::tr("Set the position of %1 to its preset?").arg(encoder.place().shown()),
        {Functions::tr(
             "FRABA preset: where the shaft stands now, the encoder will show its preset (%1). "
             "60000000 is sent for one bus cycle. It can be repeated, at one EEPROM write each time.")
             .arg(value),
         positionNowTexts(encoder).join(u' '), eepromWriteText(encoder)},
        Functions::tr("&Set position"), Functions::tr("Sends 60000000 for one bus cycle, then 00000000"),
        pictureOfPreset(encoder));
}

bool askForReset(QWidget *window, const EncoderSession &encoder)
{
    const QString after =
        encoder.can().reads
            ? Functions::tr("Afterwards the encoder is read, to see what it has then.")
            : Functions::tr(
                  "It cannot be read: afterwards it is assumed to have the factory settings of its manual.");
    return confirm(window, encoder, "manufacturer-functions.md#reset",
                   Functions::tr("Reset %1 to factory settings?").arg(encoder.place().shown()),
                   {Functions::tr("Sends 0E000000, then run. %1").arg(whatIsLost(encoder)),
                    eepromWriteText(encoder), after},
                   Functions::tr("&Reset"),
                   Functions::tr("Sends 0E000000, then run. This cannot be undone."));
}

bool askToSendRun(QWidget *window, const EncoderSession &encoder, const QString &positionThen)
{
    return confirm(window, encoder, "parameters.md#write",
                   Functions::tr("Send run to %1?").arg(encoder.place().shown()),
                   {whatRunMakesValid(encoder), whatFollowsRun(encoder, positionThen)},
                   Functions::tr("&Send run"), Functions::tr("Sends 80000000, then 00000000"));
}

bool askToRestore(QWidget *window, const EncoderSession &encoder, const ParameterValues &values)
{
    const auto steps =
        plannedSteps(encoder.device(), EndParameterization{values}, {.known = allKnown(encoder)});
    const bool runsFirst = !steps || steps->empty() || steps->front().effect == Effect::activates;
    const QString what =
        runsFirst
            ? Functions::tr("Run is sent first, and until the earlier values are written the encoder gives "
                            "its position by what it has taken. Then these are written: %1.")
            : Functions::tr(
                  "Written before run is sent, so that nothing it has taken so far becomes valid: %1.");
    return confirm(
        window, encoder, "parameters.md#write",
        Functions::tr("Restore the earlier values of %1?").arg(encoder.place().shown()),
        {what.arg(valueList(encoder.device(), values)),
         eepromCountText(encoder) + u' ' + eepromCostText(encoder, static_cast<int>(values.size()))},
        Functions::tr("&Restore"),
        runsFirst ? Functions::tr("Sends run, then writes the earlier values, then sends run again")
                  : Functions::tr("Writes the earlier values, then sends run"));
}

} // namespace codewheel
