// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_texts.h"

#include "vocabulary/refusal_text.h"
#include "widgets/cams/cam_circle.h"

#include <QCoreApplication>
#include <QLocale>

namespace codewheel::cam_texts {
namespace {

// The context of these texts.
struct CamTexts
{
    Q_DECLARE_TR_FUNCTIONS(CamTexts)
};

QString encoderText(const CamSheet &sheet, std::size_t cam)
{
    const auto known = sheet.known(sheet.number());
    if (!known)
        return CamTexts::tr("What the encoder has is not known.");
    const Cam &there = known->cam.at(cam);
    const QString has = there == sheet.cam(cam)
                            ? sheet.isOld() ? CamTexts::tr("The encoder had the same.")
                                            : CamTexts::tr("The encoder has the same.")
                            : (sheet.isOld() ? CamTexts::tr("The encoder had %1, %2.", "21 to 531, active")
                                             : CamTexts::tr("The encoder has %1, %2.", "21 to 531, active"))
                                  .arg(range(there), activity(there));
    return has + u'\n' + sheet.howKnown(sheet.number());
}

} // namespace

QString position(std::int64_t position)
{
    return QLocale().toString(qlonglong{position});
}

QString name(std::size_t cam)
{
    return CamTexts::tr("Cam %1").arg(cam);
}

QString range(const Cam &cam)
{
    const QString pattern =
        cam.start > cam.stop ? CamTexts::tr("%1 to %2, through zero") : CamTexts::tr("%1 to %2");
    return pattern.arg(position(cam.start), position(cam.stop));
}

QString activity(const Cam &cam)
{
    return cam.active ? CamTexts::tr("active") : CamTexts::tr("inactive");
}

QString movement(std::size_t cam, CamGrip grip)
{
    const QString pattern = grip == CamGrip::bar     ? CamTexts::tr("Move cam %1")
                            : grip == CamGrip::start ? CamTexts::tr("Start of cam %1")
                                                     : CamTexts::tr("Stop of cam %1");
    return pattern.arg(cam);
}

QString state(std::optional<bool> isOn, bool isTold)
{
    if (!isOn)
        return CamTexts::tr("not known");
    if (isTold)
        return *isOn ? CamTexts::tr("on") : CamTexts::tr("off");
    return *isOn ? CamTexts::tr("would be on") : CamTexts::tr("would be off");
}

QString description(const CamSheet &sheet, std::size_t number)
{
    const Cam &cam = sheet.cam(number);
    QStringList sentences;
    if (cam_circle::isEmpty(cam))
        sentences << CamTexts::tr("%1 is not set.").arg(name(number));
    else
        sentences << CamTexts::tr("%1: %2, %3.", "Cam 3: 21 to 531, active")
                         .arg(name(number), range(cam), activity(cam));
    if (const auto checked = sheet.check(number, cam); !checked)
        sentences << refusalText(checked.error());
    if (cam.hysteresis > 0)
        sentences << CamTexts::tr("Hysteresis: %1.").arg(position(cam.hysteresis));
    if (cam.isInverted)
        sentences << CamTexts::tr("It is on outside of these positions.");
    if (const auto isOn = sheet.isOn(number); isOn || sheet.live().position)
        sentences << CamTexts::tr("Now: %1.").arg(state(isOn, sheet.live().isTold));
    sentences << encoderText(sheet, number);
    return sentences.join(QLatin1Char('\n'));
}

} // namespace codewheel::cam_texts
