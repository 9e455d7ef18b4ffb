// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/ring_training_acts.h"

#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {
namespace {

class RingTraining
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::RingTraining)
};

constexpr char ringTrainingContext[] = "codewheel::RingTraining";
constexpr int magnetDecimals = 2;

// By RingAct.
constexpr auto ringActRows = std::to_array<TrainingActRow>({
    {"shaftTurnedTo", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Shaft turned to raw position %1.")},
    {"shaftTurnedByHand",
     QT_TRANSLATE_NOOP("codewheel::RingTraining", "Shaft turned by hand to raw position %1.")},
    {"shaftStopped", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Shaft stopped.")},
    {"shaftTurns", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Shaft turns at %1 rpm.")},
    {"magnetMovedTo", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Magnet moved to %1 mm."), magnetDecimals},
    {"magnetMovedByHand", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Magnet moved by hand to %1 mm."),
     magnetDecimals},
    {"magnetStopped", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Magnet stopped.")},
    {"magnetMoves", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Magnet moves at %1 mm/s.")},
    {"magnetInRange", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Magnet back in the measuring range.")},
    {"magnetOutOfRange", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Magnet outside the measuring range.")},
    {"poweredOn", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Power on.")},
    {"poweredOff", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Power off.")},
    {"powerCycled", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Power off and on.")},
    {"slowConfirmationOn", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Slow confirmation on.")},
    {"slowConfirmationOff", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Slow confirmation off.")},
    {"batteryIsLow", QT_TRANSLATE_NOOP("codewheel::RingTraining",
                                       "Battery low; the encoder finds it when it is switched on.")},
    {"batteryIsFull", QT_TRANSLATE_NOOP("codewheel::RingTraining",
                                        "Battery full; the encoder finds it when it is switched on.")},
    {"eepromIsWornOut", QT_TRANSLATE_NOOP("codewheel::RingTraining", "EEPROM worn out.")},
    {"eepromIsInOrder", QT_TRANSLATE_NOOP("codewheel::RingTraining", "EEPROM in order.")},
    {"codeDiscIsFaulty", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Code disc faulty.")},
    {"codeDiscIsInOrder",
     QT_TRANSLATE_NOOP("codewheel::RingTraining", "Code disc in order; run ends the error.")},
    {"parametersAreLost", QT_TRANSLATE_NOOP("codewheel::RingTraining", "Parameters lost.")},
});
static_assert(ringActRows.size() == static_cast<std::size_t>(RingAct::parametersAreLost) + 1);

const QString faultActKey = QStringLiteral("fault"); // key of the fault, place, value
const QString seatActKey = QStringLiteral("seat");   // unit, place, the act
constexpr std::size_t seatActAt = 3;

std::optional<QString> faultActText(const TrainingAct &act)
{
    constexpr std::size_t parts = 4;
    if (act.size() != parts || keyOf(act) != faultActKey)
        return std::nullopt;
    const auto fault = trainingFaultFromKey(argumentText(act[1]));
    const auto *value = std::get_if<std::int64_t>(&act[3]);
    if (!fault || value == nullptr)
        return std::nullopt;
    return trainingFaultText(*fault, argumentText(act[2]), *value);
}

// A fault names its place itself.
std::optional<QString> seatActText(const TrainingAct &act)
{
    if (act.size() <= seatActAt || keyOf(act) != seatActKey)
        return std::nullopt;
    const TrainingAct its(act.begin() + seatActAt, act.end());
    const QString unit = argumentText(act[1]);
    const QString place = argumentText(act[2]);
    const QString what = trainingActText(its);
    return place.isEmpty() || keyOf(its) == faultActKey
               ? sentence(RingTraining::tr("Seat %1: %2"), {unit, what})
               : sentence(RingTraining::tr("Seat %1, %2: %3"), {unit, place, what});
}

} // namespace

TrainingAct ringAct(RingAct what, const std::vector<RefusalArgument> &its)
{
    return actOf(ringActRows, static_cast<std::size_t>(what), its);
}

TrainingAct faultAct(TrainingFault fault, NodeId place, int value)
{
    return {faultActKey, trainingFaultKey(fault), place.toString(), std::int64_t{value}};
}

TrainingAct actAtSeat(int unit, NodeId node, const TrainingAct &act)
{
    TrainingAct atSeat{seatActKey, std::int64_t{unit}, node.toString()};
    atSeat.insert(atSeat.end(), act.begin(), act.end());
    return atSeat;
}

std::optional<QString> ringActText(const TrainingAct &act)
{
    if (auto text = faultActText(act))
        return text;
    if (auto text = seatActText(act))
        return text;
    return sentenceOf(act, ringActRows, ringTrainingContext);
}

} // namespace codewheel
