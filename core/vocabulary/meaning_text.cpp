// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/meaning_text.h"

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr auto meaningRows = std::to_array<KeyedText<MeaningId>>({
    // OUT. "%1 = %2" is a parameter and its value.
    {MeaningId::normalRunning, "normalRunning", QT_TRANSLATE_NOOP("Meaning", "Normal running")},
    {MeaningId::normalRunningData, "normalRunningData",
     QT_TRANSLATE_NOOP("Meaning", "Normal running; the data %1 mean nothing")},
    {MeaningId::run, "run", QT_TRANSLATE_NOOP("Meaning", "Run")},
    {MeaningId::runIgnoresRest, "runIgnoresRest",
     QT_TRANSLATE_NOOP("Meaning", "Run; the other bits (%1) are ignored")},
    {MeaningId::initialisePreset, "initialisePreset", QT_TRANSLATE_NOOP("Meaning", "Initialise the preset")},
    {MeaningId::frabaPreset, "frabaPreset",
     QT_TRANSLATE_NOOP("Meaning", "FRABA preset: activate the preset in every cycle")},
    {MeaningId::parameterRequest, "parameterRequest", QT_TRANSLATE_NOOP("Meaning", "%1 = %2")},
    {MeaningId::parameterRequestInCamMode, "parameterRequestInCamMode",
     QT_TRANSLATE_NOOP("Meaning", "%1 = %2: refused in cam mode")},
    {MeaningId::parameterRequestInvalid, "parameterRequestInvalid", QT_TRANSLATE_NOOP("Meaning", "%1 = %2")},
    {MeaningId::parameterRequestUndefined, "parameterRequestUndefined",
     QT_TRANSLATE_NOOP("Meaning", "%1 = %2")},
    {MeaningId::resetToDefault, "resetToDefault", QT_TRANSLATE_NOOP("Meaning", "Reset to factory settings")},
    {MeaningId::velocityOn, "velocityOn", QT_TRANSLATE_NOOP("Meaning", "Velocity mode on")},
    {MeaningId::velocityOff, "velocityOff", QT_TRANSLATE_NOOP("Meaning", "Velocity mode off")},
    {MeaningId::readOutRequest, "readOutRequest", QT_TRANSLATE_NOOP("Meaning", "Read out %1")},
    {MeaningId::opcRegisterRequest, "opcRegisterRequest",
     QT_TRANSLATE_NOOP("Meaning", "Read out register %1 of the bus chip")},
    {MeaningId::camMode, "camMode", QT_TRANSLATE_NOOP("Meaning", "Cam mode, program %1")},
    {MeaningId::positionMode, "positionMode", QT_TRANSLATE_NOOP("Meaning", "Position mode")},
    {MeaningId::camConfiguration, "camConfiguration", QT_TRANSLATE_NOOP("Meaning", "Active cams: %1")},
    {MeaningId::camStart, "camStart", QT_TRANSLATE_NOOP("Meaning", "Start of cam %1 = %2")},
    {MeaningId::camStop, "camStop", QT_TRANSLATE_NOOP("Meaning", "Stop of cam %1 = %2")},
    {MeaningId::setCamShift, "setCamShift",
     QT_TRANSLATE_NOOP("Meaning", "Position beside the cams shifted by %1")},
    {MeaningId::camConfigurationRequest, "camConfigurationRequest",
     QT_TRANSLATE_NOOP("Meaning", "Read out the active cams")},
    {MeaningId::camStartRequest, "camStartRequest",
     QT_TRANSLATE_NOOP("Meaning", "Read out the start of cam %1")},
    {MeaningId::camStopRequest, "camStopRequest",
     QT_TRANSLATE_NOOP("Meaning", "Read out the stop of cam %1")},
    {MeaningId::camShiftRequest, "camShiftRequest",
     QT_TRANSLATE_NOOP("Meaning", "Read out the shift of the position beside the cams")},
    {MeaningId::manufacturerBitIgnored, "manufacturerBitIgnored",
     QT_TRANSLATE_NOOP("Meaning", "%1 (D29 is ignored)")},
    {MeaningId::manufacturerSpecificOut, "manufacturerSpecificOut",
     QT_TRANSLATE_NOOP("Meaning", "Manufacturer specific (D29), and the make is not known")},
    {MeaningId::serviceRead, "serviceRead", QT_TRANSLATE_NOOP("Meaning", "Service %1: read, service bit %2")},
    {MeaningId::serviceWrite, "serviceWrite",
     QT_TRANSLATE_NOOP("Meaning", "Service %1: write %2, service bit %3")},
    {MeaningId::serviceWriteInvalid, "serviceWriteInvalid",
     QT_TRANSLATE_NOOP("Meaning", "Service %1: write %2, service bit %3; the encoder refuses this value")},
    {MeaningId::noOutWord, "noOutWord",
     QT_TRANSLATE_NOOP("Meaning", "This encoder has no OUT word: it only sends its position")},
    {MeaningId::undescribedOut, "undescribedOut",
     QT_TRANSLATE_NOOP("Meaning", "No source describes the OUT word of a K4 encoder")},
    {MeaningId::undefinedOut, "undefinedOut", QT_TRANSLATE_NOOP("Meaning", "Not defined for this encoder")},

    // IN
    {MeaningId::position, "position", QT_TRANSLATE_NOOP("Meaning", "position %1")},
    {MeaningId::signedPosition, "signedPosition", QT_TRANSLATE_NOOP("Meaning", "position %1 (signed)")},
    {MeaningId::grayPosition, "grayPosition", QT_TRANSLATE_NOOP("Meaning", "position %1 (Gray code %2)")},
    {MeaningId::undescribedPosition, "undescribedPosition",
     QT_TRANSLATE_NOOP(
         "Meaning", "position %1, as long as all four status bits are 0: no source says where they stand")},
    {MeaningId::rawPosition, "rawPosition",
     QT_TRANSLATE_NOOP("Meaning", "position %1 in a coding that is not known")},
    {MeaningId::velocity, "velocity", QT_TRANSLATE_NOOP("Meaning", "speed %1 rpm")},
    {MeaningId::cams, "cams", QT_TRANSLATE_NOOP("Meaning", "cams on: %1, position part %2")},
    {MeaningId::processing, "processing", QT_TRANSLATE_NOOP("Meaning", "Processing, data %1")},
    {MeaningId::confirmed, "confirmed", QT_TRANSLATE_NOOP("Meaning", "%1 = %2 confirmed")},
    {MeaningId::oldConfirmation, "oldConfirmation",
     QT_TRANSLATE_NOOP("Meaning", "Old confirmation: %1 = %2")},
    {MeaningId::camConfirmation, "camConfirmation", QT_TRANSLATE_NOOP("Meaning", "Acknowledged: %1")},
    {MeaningId::selfTestOrReadOut, "selfTestOrReadOut",
     QT_TRANSLATE_NOOP("Meaning", "Self test, or read-out of %1")},
    {MeaningId::readOutValue, "readOutValue", QT_TRANSLATE_NOOP("Meaning", "Read-out: %1 = %2")},
    {MeaningId::opcRegisterValue, "opcRegisterValue",
     QT_TRANSLATE_NOOP("Meaning", "Read-out: register %1 of the bus chip = %2")},
    {MeaningId::camConfigurationValue, "camConfigurationValue",
     QT_TRANSLATE_NOOP("Meaning", "Read-out: active cams %1")},
    {MeaningId::camStartValue, "camStartValue",
     QT_TRANSLATE_NOOP("Meaning", "Read-out: start of cam %1 = %2")},
    {MeaningId::camStopValue, "camStopValue", QT_TRANSLATE_NOOP("Meaning", "Read-out: stop of cam %1 = %2")},
    {MeaningId::camShiftValue, "camShiftValue",
     QT_TRANSLATE_NOOP("Meaning", "Read-out: position beside the cams shifted by %1")},
    {MeaningId::readOutUnknown, "readOutUnknown",
     QT_TRANSLATE_NOOP("Meaning", "The encoder does not know the read-out code %1")},
    {MeaningId::noValidPosition, "noValidPosition", QT_TRANSLATE_NOOP("Meaning", "No valid position")},
    {MeaningId::deviceError, "deviceError", QT_TRANSLATE_NOOP("Meaning", "Error %1: %2")},
    {MeaningId::wrongCamCommand, "wrongCamCommand",
     QT_TRANSLATE_NOOP("Meaning", "Error 2: wrong cam command")},
    {MeaningId::manufacturerError, "manufacturerError",
     QT_TRANSLATE_NOOP("Meaning", "Manufacturer's error %1")},
    {MeaningId::unknownState, "unknownState",
     QT_TRANSLATE_NOOP("Meaning", "D31 D30 = 01: a state that no manual describes")},
    {MeaningId::manufacturerSpecificIn, "manufacturerSpecificIn",
     QT_TRANSLATE_NOOP("Meaning", "Manufacturer specific (D29), and the make is not known")},
    {MeaningId::positionWithError, "positionWithError",
     QT_TRANSLATE_NOOP("Meaning",
                       "Error bit: the magnet is or was outside the measuring range; position %1")},
    {MeaningId::serviceWritten, "serviceWritten", QT_TRANSLATE_NOOP("Meaning", "Service %1: %2 written")},
    {MeaningId::serviceValue, "serviceValue", QT_TRANSLATE_NOOP("Meaning", "Service %1: %2 read")},
    {MeaningId::oldServiceAnswer, "oldServiceAnswer",
     QT_TRANSLATE_NOOP("Meaning", "Old answer: service %1, %2")},
    {MeaningId::serviceRefused, "serviceRefused", QT_TRANSLATE_NOOP("Meaning", "Refused: %1")},
    {MeaningId::unusedBitsSet, "unusedBitsSet",
     QT_TRANSLATE_NOOP("Meaning", "No position: %1 should be 0, since the position has %2 bits")},
    {MeaningId::undefinedIn, "undefinedIn", QT_TRANSLATE_NOOP("Meaning", "Not defined for this encoder")},
});

static_assert(areInOrder(meaningRows, &KeyedText<MeaningId>::id) && meaningRows.size() == meaningCount);

} // namespace

QString meaningKey(MeaningId id)
{
    return QString::fromLatin1(rowOf(meaningRows, id).key);
}

QString meaningSentence(MeaningId id, const QStringList &parts)
{
    return sentence(QCoreApplication::translate("Meaning", rowOf(meaningRows, id).text), parts);
}

bool asksForParameter(MeaningId id)
{
    return id == MeaningId::parameterRequest || id == MeaningId::parameterRequestInvalid ||
           id == MeaningId::parameterRequestUndefined;
}

bool isOfOperation(MeaningId id)
{
    return id >= MeaningId::position && id <= MeaningId::cams;
}

bool isOfOperation(const Explanation &explanation)
{
    return std::ranges::all_of(explanation, [](const Meaning &meaning) { return isOfOperation(meaning.id); });
}

} // namespace codewheel
