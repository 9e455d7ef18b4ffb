// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/simulator/line_training_acts.h"

#include <array>

namespace codewheel {
namespace {

class LineTraining
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::LineTraining)
};

constexpr char lineTrainingContext[] = "codewheel::LineTraining";

// By LineAct.
constexpr auto lineActRows = std::to_array<TrainingActRow>({
    {"lineShaftSpeed", QT_TRANSLATE_NOOP("codewheel::LineTraining", "Speed %1 rpm.")},
    {"bytesLost", QT_TRANSLATE_NOOP("codewheel::LineTraining", "Lost bytes: %1 of 1000.")},
    {"bytesWrong", QT_TRANSLATE_NOOP("codewheel::LineTraining", "Wrong bytes: %1 of 1000.")},
    {"bytesDoubled", QT_TRANSLATE_NOOP("codewheel::LineTraining", "Doubled bytes: %1 of 1000.")},
    {"bytesDelayed", QT_TRANSLATE_NOOP("codewheel::LineTraining", "Delayed bytes: %1 of 1000.")},
    {"echoOn", QT_TRANSLATE_NOOP("codewheel::LineTraining", "Echo on.")},
    {"echoOff", QT_TRANSLATE_NOOP("codewheel::LineTraining", "Echo off.")},
    {"allSilent", QT_TRANSLATE_NOOP("codewheel::LineTraining", "All encoders silent.")},
    {"allAnswer", QT_TRANSLATE_NOOP("codewheel::LineTraining", "All encoders answer.")},
    {"adapterUnplugged", QT_TRANSLATE_NOOP("codewheel::LineTraining", "Adapter unplugged.")},
    {"adapterPluggedIn", QT_TRANSLATE_NOOP("codewheel::LineTraining", "Adapter plugged in.")},
});
static_assert(lineActRows.size() == static_cast<std::size_t>(LineAct::adapterPluggedIn) + 1);

constexpr auto lineTroubleRows = std::to_array<KeyedText<LineTrouble>>({
    {LineTrouble::powered, "powered", QT_TRANSLATE_NOOP("codewheel::LineTraining", "Power on")},
    {LineTrouble::mute, "mute", QT_TRANSLATE_NOOP("codewheel::LineTraining", "Silent")},
    {LineTrouble::batteryLimit, "batteryLimit",
     QT_TRANSLATE_NOOP("codewheel::LineTraining", "Battery nearly flat")},
    {LineTrouble::batteryFlat, "batteryFlat", QT_TRANSLATE_NOOP("codewheel::LineTraining", "Battery flat")},
    {LineTrouble::temperatureExceeded, "temperatureExceeded",
     QT_TRANSLATE_NOOP("codewheel::LineTraining", "Too hot")},
    {LineTrouble::lightControl, "lightControl",
     QT_TRANSLATE_NOOP("codewheel::LineTraining", "Light control at its end")},
    {LineTrouble::positionError, "positionError",
     QT_TRANSLATE_NOOP("codewheel::LineTraining", "Position error")},
    {LineTrouble::vrHigh, "vrHigh", QT_TRANSLATE_NOOP("codewheel::LineTraining", "VR at +UB")},
    {LineTrouble::stOpen, "stOpen", QT_TRANSLATE_NOOP("codewheel::LineTraining", "ST open")},
});
static_assert(areInOrder(lineTroubleRows, &KeyedText<LineTrouble>::id));

const QString troubleActKey = QStringLiteral("lineTrouble"); // key of the trouble, 1 or 0

} // namespace

TrainingAct lineAct(LineAct what, const std::vector<RefusalArgument> &its)
{
    return actOf(lineActRows, static_cast<std::size_t>(what), its);
}

TrainingAct lineTroubleAct(LineTrouble trouble, bool isThere)
{
    return conditionAct(troubleActKey, rowOf(lineTroubleRows, trouble).key, isThere);
}

QString lineTroubleName(LineTrouble trouble)
{
    return LineTraining::tr(rowOf(lineTroubleRows, trouble).text);
}

std::optional<QString> lineActText(const TrainingAct &act)
{
    if (auto text = conditionText(act, troubleActKey, lineTroubleRows, lineTrainingContext))
        return text;
    return sentenceOf(act, lineActRows, lineTrainingContext);
}

} // namespace codewheel
