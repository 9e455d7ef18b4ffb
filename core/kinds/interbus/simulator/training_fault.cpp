// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/training_fault.h"

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {
namespace {

constexpr auto faultRows = std::to_array<KeyedText<TrainingFault>>({
    {TrainingFault::wireBreak, "wireBreak",
     QT_TRANSLATE_NOOP("codewheel::FaultPlan", "Wire break before it")},
    {TrainingFault::crcErrors, "crcErrors",
     QT_TRANSLATE_NOOP("codewheel::FaultPlan", "CRC errors in the segment")},
    {TrainingFault::noSupply, "noSupply", QT_TRANSLATE_NOOP("codewheel::FaultPlan", "Device without supply")},
    {TrainingFault::wrongDevice, "wrongDevice",
     QT_TRANSLATE_NOOP("codewheel::FaultPlan", "Wrong device in place")},
    {TrainingFault::peripheralFault, "peripheralFault",
     QT_TRANSLATE_NOOP("codewheel::FaultPlan", "Peripheral fault")},
    {TrainingFault::powerOff, "powerOff", QT_TRANSLATE_NOOP("codewheel::FaultPlan", "Encoder switched off")},
    {TrainingFault::slowConfirmation, "slowConfirmation",
     QT_TRANSLATE_NOOP("codewheel::FaultPlan", "Slow confirmation")},
    {TrainingFault::eepromWornOut, "eepromWornOut",
     QT_TRANSLATE_NOOP("codewheel::FaultPlan", "EEPROM worn out")},
    {TrainingFault::parametersLost, "parametersLost",
     QT_TRANSLATE_NOOP("codewheel::FaultPlan", "Parameters lost")},
    {TrainingFault::batteryLow, "batteryLow", QT_TRANSLATE_NOOP("codewheel::FaultPlan", "Battery low")},
    {TrainingFault::codeDiscFault, "codeDiscFault",
     QT_TRANSLATE_NOOP("codewheel::FaultPlan", "Code disc faulty")},
    {TrainingFault::camOutOfRange, "camOutOfRange",
     QT_TRANSLATE_NOOP("codewheel::FaultPlan", "Cam out of range")},
    {TrainingFault::magnetLost, "magnetLost", QT_TRANSLATE_NOOP("codewheel::FaultPlan", "Magnet lost")},
});
static_assert(areInOrder(faultRows, &KeyedText<TrainingFault>::id) && faultRows.size() == trainingFaults);

QString faultText(const char *text)
{
    return QCoreApplication::translate("codewheel::FaultPlan", text);
}

} // namespace

QString trainingFaultName(TrainingFault fault)
{
    return faultText(rowOf(faultRows, fault).text);
}

QString trainingFaultKey(TrainingFault fault)
{
    return QString::fromLatin1(rowOf(faultRows, fault).key);
}

std::optional<TrainingFault> trainingFaultFromKey(const QString &key)
{
    const auto *row = rowByKey(faultRows, key);
    return row != nullptr ? std::optional(row->id) : std::nullopt;
}

QString trainingFaultText(TrainingFault fault, const QString &place, std::int64_t value)
{
    const char *pattern = fault == TrainingFault::crcErrors && value > 0
                              ? QT_TRANSLATE_NOOP("codewheel::FaultPlan", "%1: %2, %3 of 1000 cycles")
                          : value > 0 ? QT_TRANSLATE_NOOP("codewheel::FaultPlan", "%1: %2")
                                      : QT_TRANSLATE_NOOP("codewheel::FaultPlan", "%1: %2 is over");
    return sentence(faultText(pattern), {place, trainingFaultName(fault), QString::number(value)});
}

QString trainingFaultText(TrainingFault fault, NodeId place, int value)
{
    return trainingFaultText(fault, place.toString(), value);
}

} // namespace codewheel
