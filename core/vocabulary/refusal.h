// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/parameter.h"
#include "vocabulary/sentence_family.h"
#include "vocabulary/word.h"

#include <QString>

#include <tl/expected.hpp>
#include <variant>
#include <vector>

namespace codewheel {

// Who is to blame, roughly: determines the icon in the window and the exit code at the command line.
enum class RefusalKind : std::uint8_t {
    badInput,     // the user's input (exit 2)
    notSupported, // the encoder cannot do this (exit 1)
    busy,         // another job holds the word (exit 1)
    device,       // the encoder refused, or did not answer (exit 1)
    link,         // bus, link or disk (exit 1)
    stopped,      // the user or ALARM STOP ended it (exit 1)
};

struct Refusal;
using RefusalFamily = SentenceFamily<Refusal>;
using RefusalCode = SentenceCode<Refusal>;

// Why something was refused, as far as several kinds of bus have it or none: what only one refuses is in its
// room. The sentence is made where it is shown (vocabulary/refusal_text.h). The comment beside each lists its
// arguments.
enum class RefusalId : std::uint8_t {
    // badInput
    valueOutOfRange,       // Parameter, value, minimum, maximum
    inputNotUnderstood,    // Parameter, sentence about what was typed, minimum, maximum
    valueNotAllowed,       // Parameter, text, allowed texts
    parameterGivenTwice,   // Parameter
    parameterReadOnly,     // Parameter, device name
    nothingToDo,           //
    unknownDevice,         // place, the places there are
    totalRangeTooLarge,    // total range, largest
    tooManyStepsPerTurn,   // steps, revolutions, physical steps per turn
    valueAboveTotalRange,  // Parameter, value, largest
    presetNeedsValue,      // device name
    camProgramOutOfRange,  // program, last program
    camOutOfRange,         // cam, last cam
    camPositionTooLarge,   // cam, position, largest
    camShiftOutOfRange,    // shift
    camHasNoShift,         // shift
    camThroughZero,        // cam
    camHasMore,            // cam
    camProgramGivenTwice,  // program
    camFileBroken,         // file, line, key, reason
    camFileOfOtherProgram, // file, its program, the program wanted
    labelKeyNotUnderstood, // the key, the part (empty: it ends too early), what may stand there (empty:
                           // nothing)
    deviceFileBroken,      // file with line and key, reason
    deviceOfOtherBus,      // place, device name
    fileNotReadable,       // file, reason of the system
    fileNotWritten,        // file, reason of the system
    fileChanged,           // file
    fileTooLarge,          // file, its size in MB, largest in MB
    projectFileBroken,     // file, line, key, reason
    projectFileNewer,      // file, its version, ours
    structureBroken,       // text of the rule that would be broken
    noSuchProjectDevice,   // place, places there are
    projectEmpty,          //
    lineSettingWrong,      // the text given, what is allowed
    lineAddressTaken,      // address, text of what answers there
    recordingExists,       // file
    serverAddressWrong,    // sentence about what is wrong
    passwordInAddress,     //
    noSizeOnServer,        //
    recordingEmpty,        // file
    // notSupported
    parameterNotSupported,          // Parameter, device name
    readingNotSupported,            // device name
    writingNotSupported,            // device name
    presetNotSupported,             // device name
    modeNotKnown,                   // Word OUT: the text says what it would do in cam mode
    inCamMode,                      // Word OUT: the text says what it does there
    camsNotSupported,               // device name
    velocityNotSupported,           // device name
    manufacturerPresetNotSupported, // device name
    linkDoesNotBoundCycles,         // Word OUT
    resetNotSupported,              // device name
    sendingNotSupported,            // device name: it has no OUT word
    jobNotSupported,                // device name
    onlyRecorded,                   //
    encodersDiffer,                 // place, device name, place, device name
    // busy
    jobRunning,         // place
    wordHeldByJob,      // place
    watchOnly,          // place
    notRunning,         // place: the bus is stopped
    inParameterization, // Word IN: found that way, not caused by this job
    eepromBudgetUsed,   // place, writes by this program, budget
    eepromLimitPassed,  // place, writes by this program, limit
    // device
    wrongParameterData,     // error 1: Parameter or number, Word IN; several where it came late
    unknownParameterNumber, // error 2; Word OUT before IN where the mode of the encoder was not seen
    parametersLost,         // error 3
    valuesMissingAfterLoss, // names of the parameters
    eepromStoreError,       // Baumer 13
    batteryLow,             // Baumer 14
    codeDiscFault,          // Baumer 15
    manufacturerError,      // 980000xx: code, Word IN
    noValidPosition,        // 80000000
    otherDeviceError,       // number, Word IN
    noAnswer,               // seconds, Word OUT, Word IN
    noAnswerAtGateway,      // the same: its registers may be others
    verificationFailed,     // Parameter, wanted, read
    takenAsCamWord,         // Word OUT, Word IN: in cam mode, which nobody knew; the text says what it does
    modeNotSwitched,        // Word IN: of a parameterization
    magnetOutOfRange,       // Word IN
    noValuesFromBefore,     // place
    notSaidWhetherSame,     // place
    escNoAnswer,            // command, tries
    presetNotTaken,         // position by the preset, position shown (or IN)
    presetUsedUp,           // the same: the preset flag of a FRABA was 0
    presetNotKnownWithout,  // Parameter that is not known, position shown (or IN)
    presetNotKnown,         // position shown (or IN); or position by the preset, IN that may be a speed
    encoderSilent,          // place
    // link
    linkFailed,           // text of the link
    ringDiffers,          // place, configured, found
    databaseFailed,       // file, reason
    recordingGone,        // file
    damagedBlocks,        // file, blocks of samples
    diskAlmostFull,       // file, free MB, MB that are to stay free
    serverAway,           // address, reason, MB that wait
    notAllSent,           // address, reason, MB that wait, file
    portNotFound,         // port
    portInUse,            // port
    portNoRights,         // port, group that may use it, command that adds the user to it
    portLost,             // port: the adapter was unplugged
    portOfOther,          // port, the adapter that was expected
    lineClosed,           //
    hostNotFound,         // host
    connectionRefused,    // address
    connectionSilent,     // address, seconds
    connectionClosed,     // address
    serverPortTaken,      // port
    serverPortPrivileged, // port
    serverAddressNotOurs, // address
    notConnected,         // place
    deviceDiffers,        // place, planned, connected
    serialDiffers,        // place, serial number on the label, serial number reported by the encoder
    // stopped
    cancelled,      //
    alarmStop,      //
    busStopped,     //
    computerSlept,  //
    stoppedInWrite, // command: whether it was carried out is not known
};
extern const RefusalFamily commonRefusals;
constexpr const RefusalFamily &familyOf(RefusalId)
{
    return commonRefusals;
}

using RefusalArgument =
    std::variant<std::int64_t, double, Word, Parameter, QString>; // a Word is shown as hex

inline RefusalArgument argumentOf(const Value &value)
{
    return value.isText() ? RefusalArgument(value.toString()) : RefusalArgument(value.number());
}

struct Refusal
{
    RefusalKind kind = RefusalKind::badInput;
    RefusalCode id = RefusalId::nothingToDo;
    std::vector<RefusalArgument> arguments;

    friend bool operator==(const Refusal &, const Refusal &) = default;
};

template <typename T>
using Result = tl::expected<T, Refusal>;

inline tl::unexpected<Refusal> refuse(RefusalKind kind, RefusalCode id,
                                      std::vector<RefusalArgument> arguments = {})
{
    return tl::unexpected(Refusal{kind, id, std::move(arguments)});
}

} // namespace codewheel
