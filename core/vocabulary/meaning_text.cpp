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
    using enum MeaningId;

public:
    static constexpr auto all = std::to_array<KeyedText<MeaningId>>({
        // OUT. "%1 = %2" is a parameter and its value.
        {normalRunning, "normalRunning", QT_TR_NOOP("Normal running")},
        {normalRunningData, "normalRunningData", QT_TR_NOOP("Normal running; the data %1 mean nothing")},
        {run, "run", QT_TR_NOOP("Run")},
        {runIgnoresRest, "runIgnoresRest", QT_TR_NOOP("Run; the other bits (%1) are ignored")},
        {initialisePreset, "initialisePreset", QT_TR_NOOP("Initialise the preset")},
        {frabaPreset, "frabaPreset", QT_TR_NOOP("FRABA preset: activate the preset in every cycle")},
        {parameterRequest, "parameterRequest", QT_TR_NOOP("%1 = %2")},
        {parameterRequestInCamMode, "parameterRequestInCamMode", QT_TR_NOOP("%1 = %2: refused in cam mode")},
        {parameterRequestInvalid, "parameterRequestInvalid", QT_TR_NOOP("%1 = %2")},
        {parameterRequestUndefined, "parameterRequestUndefined", QT_TR_NOOP("%1 = %2")},
        {resetToDefault, "resetToDefault", QT_TR_NOOP("Reset to factory settings")},
        {velocityOn, "velocityOn", QT_TR_NOOP("Velocity mode on")},
        {velocityOff, "velocityOff", QT_TR_NOOP("Velocity mode off")},
        {readOutRequest, "readOutRequest", QT_TR_NOOP("Read out %1")},
        {opcRegisterRequest, "opcRegisterRequest", QT_TR_NOOP("Read out register %1 of the bus chip")},
        {camMode, "camMode", QT_TR_NOOP("Cam mode, program %1")},
        {positionMode, "positionMode", QT_TR_NOOP("Position mode")},
        {camConfiguration, "camConfiguration", QT_TR_NOOP("Active cams: %1")},
        {camStart, "camStart", QT_TR_NOOP("Start of cam %1 = %2")},
        {camStop, "camStop", QT_TR_NOOP("Stop of cam %1 = %2")},
        {setCamShift, "setCamShift", QT_TR_NOOP("Position beside the cams shifted by %1")},
        {camConfigurationRequest, "camConfigurationRequest", QT_TR_NOOP("Read out the active cams")},
        {camStartRequest, "camStartRequest", QT_TR_NOOP("Read out the start of cam %1")},
        {camStopRequest, "camStopRequest", QT_TR_NOOP("Read out the stop of cam %1")},
        {camShiftRequest, "camShiftRequest",
         QT_TR_NOOP("Read out the shift of the position beside the cams")},
        {manufacturerBitIgnored, "manufacturerBitIgnored", QT_TR_NOOP("%1 (D29 is ignored)")},
        {manufacturerSpecificOut, "manufacturerSpecificOut",
         QT_TR_NOOP("Manufacturer specific (D29), and the make is not known")},
        {serviceRead, "serviceRead", QT_TR_NOOP("Service %1: read, service bit %2")},
        {serviceWrite, "serviceWrite", QT_TR_NOOP("Service %1: write %2, service bit %3")},
        {serviceWriteInvalid, "serviceWriteInvalid",
         QT_TR_NOOP("Service %1: write %2, service bit %3; the encoder refuses this value")},
        {noOutWord, "noOutWord", QT_TR_NOOP("This encoder has no OUT word: it only sends its position")},
        {undescribedOut, "undescribedOut", QT_TR_NOOP("No source describes the OUT word of a K4 encoder")},
        {undefinedOut, "undefinedOut", QT_TR_NOOP("Not defined for this encoder")},

        // IN
        {position, "position", QT_TR_NOOP("position %1")},
        {signedPosition, "signedPosition", QT_TR_NOOP("position %1 (signed)")},
        {grayPosition, "grayPosition", QT_TR_NOOP("position %1 (Gray code %2)")},
        {undescribedPosition, "undescribedPosition",
         QT_TR_NOOP("position %1, as long as all four status bits are 0: no source says where they stand")},
        {rawPosition, "rawPosition", QT_TR_NOOP("position %1 in a coding that is not known")},
        {velocity, "velocity", QT_TR_NOOP("speed %1 rpm")},
        {cams, "cams", QT_TR_NOOP("cams on: %1, position part %2")},
        {processing, "processing", QT_TR_NOOP("Processing, data %1")},
        {confirmed, "confirmed", QT_TR_NOOP("%1 = %2 confirmed")},
        {oldConfirmation, "oldConfirmation", QT_TR_NOOP("Old confirmation: %1 = %2")},
        {camConfirmation, "camConfirmation", QT_TR_NOOP("Acknowledged: %1")},
        {selfTestOrReadOut, "selfTestOrReadOut", QT_TR_NOOP("Self test, or read-out of %1")},
        {readOutValue, "readOutValue", QT_TR_NOOP("Read-out: %1 = %2")},
        {opcRegisterValue, "opcRegisterValue", QT_TR_NOOP("Read-out: register %1 of the bus chip = %2")},
        {camConfigurationValue, "camConfigurationValue", QT_TR_NOOP("Read-out: active cams %1")},
        {camStartValue, "camStartValue", QT_TR_NOOP("Read-out: start of cam %1 = %2")},
        {camStopValue, "camStopValue", QT_TR_NOOP("Read-out: stop of cam %1 = %2")},
        {camShiftValue, "camShiftValue", QT_TR_NOOP("Read-out: position beside the cams shifted by %1")},
        {readOutUnknown, "readOutUnknown", QT_TR_NOOP("The encoder does not know the read-out code %1")},
        {noValidPosition, "noValidPosition", QT_TR_NOOP("No valid position")},
        {deviceError, "deviceError", QT_TR_NOOP("Error %1: %2")},
        {wrongCamCommand, "wrongCamCommand", QT_TR_NOOP("Error 2: wrong cam command")},
        {manufacturerError, "manufacturerError", QT_TR_NOOP("Manufacturer's error %1")},
        {unknownState, "unknownState", QT_TR_NOOP("D31 D30 = 01: a state that no manual describes")},
        {manufacturerSpecificIn, "manufacturerSpecificIn",
         QT_TR_NOOP("Manufacturer specific (D29), and the make is not known")},
        {positionWithError, "positionWithError",
         QT_TR_NOOP("Error bit: the magnet is or was outside the measuring range; position %1")},
        {serviceWritten, "serviceWritten", QT_TR_NOOP("Service %1: %2 written")},
        {serviceValue, "serviceValue", QT_TR_NOOP("Service %1: %2 read")},
        {oldServiceAnswer, "oldServiceAnswer", QT_TR_NOOP("Old answer: service %1, %2")},
        {serviceRefused, "serviceRefused", QT_TR_NOOP("Refused: %1")},
        {unusedBitsSet, "unusedBitsSet",
         QT_TR_NOOP("No position: %1 should be 0, since the position has %2 bits")},
        {undefinedIn, "undefinedIn", QT_TR_NOOP("Not defined for this encoder")},
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
