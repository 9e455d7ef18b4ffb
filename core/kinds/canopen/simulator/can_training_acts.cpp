// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/simulator/can_training_acts.h"

#include <array>

namespace codewheel {
namespace {

class CanTraining
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanTraining)
};

constexpr char canTrainingContext[] = "codewheel::CanTraining";

// By CanAct.
constexpr auto canActRows = std::to_array<TrainingActRow>({
    {"canShaftTurnedTo", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Shaft turned to raw position %1.")},
    {"canShaftTurnedByHand",
     QT_TRANSLATE_NOOP("codewheel::CanTraining", "Shaft turned by hand to raw position %1.")},
    {"canShaftStopped", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Shaft stopped.")},
    {"canShaftTurns", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Shaft turns at %1 rpm.")},
    {"framesLost", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Lost frames: %1 of 1000.")},
    {"framesDamaged", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Destroyed frames: %1 of 1000.")},
    {"framesDoubled", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Doubled frames: %1 of 1000.")},
    {"framesLate", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Late frames: %1 of 1000.")},
    {"canAdapterAlone",
     QT_TRANSLATE_NOOP("codewheel::CanTraining", "The adapter is alone: its cable is broken.")},
    {"canAdapterNotAlone", QT_TRANSLATE_NOOP("codewheel::CanTraining", "The cable of the adapter is whole.")},
    {"canAdapterBusOff", QT_TRANSLATE_NOOP("codewheel::CanTraining", "The adapter went bus off.")},
    {"canAdapterUnplugged", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Adapter unplugged.")},
    {"canAdapterPluggedIn", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Adapter plugged in.")},
    {"canLoadByOthers", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Load by other devices: %1 %.")},
    {"canMasterComes", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Another master is on the bus.")},
    {"canMasterGoes", QT_TRANSLATE_NOOP("codewheel::CanTraining", "The other master is gone.")},
});
static_assert(canActRows.size() == static_cast<std::size_t>(CanAct::masterGoes) + 1);

constexpr auto nodeTroubleRows = std::to_array<KeyedText<NodeTrouble>>({
    {NodeTrouble::powered, "powered", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Power on")},
    {NodeTrouble::positionError, "positionError",
     QT_TRANSLATE_NOOP("codewheel::CanTraining", "Position error")},
    {NodeTrouble::makersAlarm, "makersAlarm",
     QT_TRANSLATE_NOOP("codewheel::CanTraining", "Alarm of the maker")},
    {NodeTrouble::lightReserve, "lightReserve",
     QT_TRANSLATE_NOOP("codewheel::CanTraining", "Light reserve used up")},
    {NodeTrouble::cpuWatchdog, "cpuWatchdog", QT_TRANSLATE_NOOP("codewheel::CanTraining", "CPU watchdog")},
    {NodeTrouble::batteryLow, "batteryLow",
     QT_TRANSLATE_NOOP("codewheel::CanTraining", "Battery charge low")},
    {NodeTrouble::eepromBroken, "eepromBroken",
     QT_TRANSLATE_NOOP("codewheel::CanTraining", "EEPROM worn out")},
});
static_assert(areInOrder(nodeTroubleRows, &KeyedText<NodeTrouble>::id, NodeTrouble::eepromBroken));

struct QuirkName
{
    const char *key;
    const char *text;
};
constexpr auto quirkNameRows = std::to_array<QuirkName>({
    {"autostart", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Starts by itself")},
    {"fixed-mapping", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Mapping of PDOs is fixed")},
    {"highest-range", QT_TRANSLATE_NOOP("codewheel::CanTraining", "6002h is the highest position")},
    {"keeps-identifiers",
     QT_TRANSLATE_NOOP("codewheel::CanTraining", "Identifiers stay those of the old number")},
    {"keeps-preset", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Stores a preset at once")},
    {"lss-forgets", QT_TRANSLATE_NOOP("codewheel::CanTraining", "LSS says stored, but is not")},
    {"lss-stopped", QT_TRANSLATE_NOOP("codewheel::CanTraining", "LSS only while stopped")},
    {"restore-at-once", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Restores without a reset")},
    {"silent-store", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Silent while it stores")},
    {"speed-off", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Speed is switched off")},
    {"switches", QT_TRANSLATE_NOOP("codewheel::CanTraining", "Switches decide about the number")},
    {"writes-pre-operational",
     QT_TRANSLATE_NOOP("codewheel::CanTraining", "Takes values only while pre-operational")},
});

const QString nodeTroubleActKey = QStringLiteral("nodeTrouble"); // key of the trouble, 1 or 0
const QString nodeQuirkActKey = QStringLiteral("nodeQuirk");     // key of the quirk, 1 or 0

} // namespace

TrainingAct canAct(CanAct what, const std::vector<RefusalArgument> &its)
{
    return actOf(canActRows, static_cast<std::size_t>(what), its);
}

TrainingAct nodeTroubleAct(NodeTrouble trouble, bool isThere)
{
    return conditionAct(nodeTroubleActKey, rowOf(nodeTroubleRows, trouble).key, isThere);
}

TrainingAct nodeQuirkAct(const char *key, bool isThere)
{
    return conditionAct(nodeQuirkActKey, key, isThere);
}

QString nodeTroubleName(NodeTrouble trouble)
{
    return CanTraining::tr(rowOf(nodeTroubleRows, trouble).text);
}

QString nodeQuirkName(const char *key)
{
    const auto *row = rowByKey(quirkNameRows, QString::fromLatin1(key));
    return row != nullptr ? CanTraining::tr(row->text) : QString();
}

std::optional<QString> canActText(const TrainingAct &act)
{
    if (auto text = conditionText(act, nodeTroubleActKey, nodeTroubleRows, canTrainingContext))
        return text;
    if (auto text = conditionText(act, nodeQuirkActKey, quirkNameRows, canTrainingContext))
        return text;
    return sentenceOf(act, canActRows, canTrainingContext);
}

} // namespace codewheel
