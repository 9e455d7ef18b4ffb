// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/meaning_text.h"

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

struct MeaningRows
{
    Q_DECLARE_TR_FUNCTIONS(Meaning)

public:
    static constexpr auto all = std::to_array<KeyedText<MeaningId>>({
        // OUT. "%1 = %2" is a parameter and its value.
        {MeaningId::normalRunning, "normalRunning", QT_TR_NOOP("Normal running")},
        {MeaningId::normalRunningData, "normalRunningData",
         QT_TR_NOOP("Normal running; the data %1 mean nothing")},
        {MeaningId::run, "run", QT_TR_NOOP("Run")},
        {MeaningId::runIgnoresRest, "runIgnoresRest", QT_TR_NOOP("Run; the other bits (%1) are ignored")},
        {MeaningId::initialisePreset, "initialisePreset", QT_TR_NOOP("Initialise the preset")},
        {MeaningId::frabaPreset, "frabaPreset",
         QT_TR_NOOP("FRABA preset: activate the preset in every cycle")},
        {MeaningId::parameterRequest, "parameterRequest", QT_TR_NOOP("%1 = %2")},
        {MeaningId::parameterRequestInCamMode, "parameterRequestInCamMode",
         QT_TR_NOOP("%1 = %2: refused in cam mode")},
        {MeaningId::parameterRequestInvalid, "parameterRequestInvalid", QT_TR_NOOP("%1 = %2")},
        {MeaningId::parameterRequestUndefined, "parameterRequestUndefined", QT_TR_NOOP("%1 = %2")},
        {MeaningId::resetToDefault, "resetToDefault", QT_TR_NOOP("Reset to factory settings")},
        {MeaningId::velocityOn, "velocityOn", QT_TR_NOOP("Velocity mode on")},
        {MeaningId::velocityOff, "velocityOff", QT_TR_NOOP("Velocity mode off")},
        {MeaningId::readOutRequest, "readOutRequest", QT_TR_NOOP("Read out %1")},
        {MeaningId::opcRegisterRequest, "opcRegisterRequest",
         QT_TR_NOOP("Read out register %1 of the bus chip")},
        {MeaningId::camMode, "camMode", QT_TR_NOOP("Cam mode, program %1")},
        {MeaningId::positionMode, "positionMode", QT_TR_NOOP("Position mode")},
        {MeaningId::camConfiguration, "camConfiguration", QT_TR_NOOP("Active cams: %1")},
        {MeaningId::camStart, "camStart", QT_TR_NOOP("Start of cam %1 = %2")},
        {MeaningId::camStop, "camStop", QT_TR_NOOP("Stop of cam %1 = %2")},
        {MeaningId::setCamShift, "setCamShift", QT_TR_NOOP("Position beside the cams shifted by %1")},
        {MeaningId::camConfigurationRequest, "camConfigurationRequest",
         QT_TR_NOOP("Read out the active cams")},
        {MeaningId::camStartRequest, "camStartRequest", QT_TR_NOOP("Read out the start of cam %1")},
        {MeaningId::camStopRequest, "camStopRequest", QT_TR_NOOP("Read out the stop of cam %1")},
        {MeaningId::camShiftRequest, "camShiftRequest",
         QT_TR_NOOP("Read out the shift of the position beside the cams")},
        {MeaningId::manufacturerBitIgnored, "manufacturerBitIgnored", QT_TR_NOOP("%1 (D29 is ignored)")},
        {MeaningId::manufacturerSpecificOut, "manufacturerSpecificOut",
         QT_TR_NOOP("Manufacturer specific (D29), and the make is not known")},
        {MeaningId::serviceRead, "serviceRead", QT_TR_NOOP("Service %1: read, service bit %2")},
        {MeaningId::serviceWrite, "serviceWrite", QT_TR_NOOP("Service %1: write %2, service bit %3")},
        {MeaningId::serviceWriteInvalid, "serviceWriteInvalid",
         QT_TR_NOOP("Service %1: write %2, service bit %3; the encoder refuses this value")},
        {MeaningId::noOutWord, "noOutWord",
         QT_TR_NOOP("This encoder has no OUT word: it only sends its position")},
        {MeaningId::undescribedOut, "undescribedOut",
         QT_TR_NOOP("No source describes the OUT word of a K4 encoder")},
        {MeaningId::undefinedOut, "undefinedOut", QT_TR_NOOP("Not defined for this encoder")},

        // IN
        {MeaningId::position, "position", QT_TR_NOOP("position %1")},
        {MeaningId::signedPosition, "signedPosition", QT_TR_NOOP("position %1 (signed)")},
        {MeaningId::grayPosition, "grayPosition", QT_TR_NOOP("position %1 (Gray code %2)")},
        {MeaningId::undescribedPosition, "undescribedPosition",
         QT_TR_NOOP("position %1, as long as all four status bits are 0: no source says where they stand")},
        {MeaningId::rawPosition, "rawPosition", QT_TR_NOOP("position %1 in a coding that is not known")},
        {MeaningId::velocity, "velocity", QT_TR_NOOP("speed %1 rpm")},
        {MeaningId::cams, "cams", QT_TR_NOOP("cams on: %1, position part %2")},
        {MeaningId::processing, "processing", QT_TR_NOOP("Processing, data %1")},
        {MeaningId::confirmed, "confirmed", QT_TR_NOOP("%1 = %2 confirmed")},
        {MeaningId::oldConfirmation, "oldConfirmation", QT_TR_NOOP("Old confirmation: %1 = %2")},
        {MeaningId::camConfirmation, "camConfirmation", QT_TR_NOOP("Acknowledged: %1")},
        {MeaningId::selfTestOrReadOut, "selfTestOrReadOut", QT_TR_NOOP("Self test, or read-out of %1")},
        {MeaningId::readOutValue, "readOutValue", QT_TR_NOOP("Read-out: %1 = %2")},
        {MeaningId::opcRegisterValue, "opcRegisterValue",
         QT_TR_NOOP("Read-out: register %1 of the bus chip = %2")},
        {MeaningId::camConfigurationValue, "camConfigurationValue", QT_TR_NOOP("Read-out: active cams %1")},
        {MeaningId::camStartValue, "camStartValue", QT_TR_NOOP("Read-out: start of cam %1 = %2")},
        {MeaningId::camStopValue, "camStopValue", QT_TR_NOOP("Read-out: stop of cam %1 = %2")},
        {MeaningId::camShiftValue, "camShiftValue",
         QT_TR_NOOP("Read-out: position beside the cams shifted by %1")},
        {MeaningId::readOutUnknown, "readOutUnknown",
         QT_TR_NOOP("The encoder does not know the read-out code %1")},
        {MeaningId::noValidPosition, "noValidPosition", QT_TR_NOOP("No valid position")},
        {MeaningId::deviceError, "deviceError", QT_TR_NOOP("Error %1: %2")},
        {MeaningId::wrongCamCommand, "wrongCamCommand", QT_TR_NOOP("Error 2: wrong cam command")},
        {MeaningId::manufacturerError, "manufacturerError", QT_TR_NOOP("Manufacturer's error %1")},
        {MeaningId::unknownState, "unknownState",
         QT_TR_NOOP("D31 D30 = 01: a state that no manual describes")},
        {MeaningId::manufacturerSpecificIn, "manufacturerSpecificIn",
         QT_TR_NOOP("Manufacturer specific (D29), and the make is not known")},
        {MeaningId::positionWithError, "positionWithError",
         QT_TR_NOOP("Error bit: the magnet is or was outside the measuring range; position %1")},
        {MeaningId::serviceWritten, "serviceWritten", QT_TR_NOOP("Service %1: %2 written")},
        {MeaningId::serviceValue, "serviceValue", QT_TR_NOOP("Service %1: %2 read")},
        {MeaningId::oldServiceAnswer, "oldServiceAnswer", QT_TR_NOOP("Old answer: service %1, %2")},
        {MeaningId::serviceRefused, "serviceRefused", QT_TR_NOOP("Refused: %1")},
        {MeaningId::unusedBitsSet, "unusedBitsSet",
         QT_TR_NOOP("No position: %1 should be 0, since the position has %2 bits")},
        {MeaningId::undefinedIn, "undefinedIn", QT_TR_NOOP("Not defined for this encoder")},
    });
};

static_assert(areInOrder(MeaningRows::all, &KeyedText<MeaningId>::id) &&
              MeaningRows::all.size() == meaningCount);

} // namespace

QString meaningKey(MeaningId id)
{
    return QString::fromLatin1(rowOf(MeaningRows::all, id).key);
}

QString meaningSentence(MeaningId id, const QStringList &parts)
{
    return sentence(QCoreApplication::translate("Meaning", rowOf(MeaningRows::all, id).text), parts);
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
