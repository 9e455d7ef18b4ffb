// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/simulator/can_training_acts.h"

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>
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
});
static_assert(canActRows.size() == static_cast<std::size_t>(CanAct::adapterPluggedIn) + 1);

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

// Empty: no row has this key.
template <typename Rows>
QString nameByKey(const Rows &rows, const QString &key)
{
    const auto row =
        std::ranges::find_if(rows, [&](const auto &one) { return key == QLatin1String(one.key); });
    return row == rows.end() ? QString() : CanTraining::tr(row->text);
}

std::optional<QString> conditionText(const TrainingAct &act)
{
    constexpr std::size_t parts = 3;
    const QString what = keyOf(act);
    if (act.size() != parts || (what != nodeTroubleActKey && what != nodeQuirkActKey))
        return std::nullopt;
    const QString key = argumentText(act[1]);
    const QString name =
        what == nodeTroubleActKey ? nameByKey(nodeTroubleRows, key) : nameByKey(quirkNameRows, key);
    if (name.isEmpty())
        return std::nullopt;
    return sentence(act[2] == RefusalArgument(std::int64_t{1}) ? CanTraining::tr("%1: yes.")
                                                               : CanTraining::tr("%1: no."),
                    {name});
}

} // namespace

TrainingAct canAct(CanAct what, const std::vector<RefusalArgument> &its)
{
    TrainingAct act{QString::fromLatin1(canActRows.at(static_cast<std::size_t>(what)).key)};
    act.insert(act.end(), its.begin(), its.end());
    return act;
}

TrainingAct nodeTroubleAct(NodeTrouble trouble, bool isThere)
{
    return {nodeTroubleActKey, QString::fromLatin1(rowOf(nodeTroubleRows, trouble).key),
            std::int64_t{isThere ? 1 : 0}};
}

TrainingAct nodeQuirkAct(const char *key, bool isThere)
{
    return {nodeQuirkActKey, QString::fromLatin1(key), std::int64_t{isThere ? 1 : 0}};
}

QString nodeTroubleName(NodeTrouble trouble)
{
    return CanTraining::tr(rowOf(nodeTroubleRows, trouble).text);
}

QString nodeQuirkName(const char *key)
{
    return nameByKey(quirkNameRows, QString::fromLatin1(key));
}

std::optional<QString> canActText(const TrainingAct &act)
{
    if (auto text = conditionText(act))
        return text;
    return sentenceOf(act, canActRows, canTrainingContext);
}

} // namespace codewheel
