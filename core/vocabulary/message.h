// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"
#include "vocabulary/place.h"
#include "vocabulary/refusal.h"

#include <optional>

namespace codewheel {

enum class Severity : std::uint8_t { information, attention, fault };

struct Message;
using MessageFamily = SentenceFamily<Message>;
using MessageCode = SentenceCode<Message>;

// What the user is told as it happens, as far as several kinds of bus have it or none. Kept as a code and
// arguments, so that the language can change; the sentence is made by vocabulary/refusal_text.h. The comment
// beside each lists its arguments.
enum class MessageId : std::uint8_t {
    refused,           // see Message::refusal
    busStarted,        //
    busStopped,        //
    operateOn,         // writing is allowed
    watchOn,           // nothing is sent any more
    computerSlept,     // seconds; writing is no longer allowed
    wordWritten,       // Word
    parametersWritten, // number of parameters, EEPROM writes, MessageItems; so for the next four
    parametersStored,  // which were in force before
    writtenUnscaled,   // some of them act only while the encoder scales its position
    restoredReadBack,  // previous values and cam programs
    restoredConfirmed, // likewise, where nothing can be read
    parametersRead,    // number of parameters
    presetDone,        // position before, position after (either may be missing: QString())
    wordsSent,         // number of words
    broughtBack,       // the encoder is in operation again
    inDoubt,           // number of items, EEPROM writes it may have cost, MessageItems that were not answered
    inDoubtForGood,    // likewise, of what cannot be read
    writesInDoubt,     // EEPROM writes that this may have cost, beside those counted
    outLeft,           // the words of which OUT may still hold one, as texts
    leftInParameterization,
    stillInParameterization, // as it was before the job
    leftInService,           // LA-66: IN still holds the answer to a service
    leftInMode,              // the mode: vocabulary/mode_text.h; it gives no position
    leftInUnknownMode,       //
    onlyZeroSinceRun,        // success that would look the same from an encoder without power
    deviceFault,             // error number, Word IN; Message::refusal names it where the device is known
    deviceFaultGone,         //
    valuesForgotten,         // the encoder lost its parameters: what was known no longer holds
    lateCycles,              // number since the last message; from earlier versions, today only a figure
    modeSwitched,            // the mode: vocabulary/mode_text.h
    modeSentToZero,          // the same: IN is 00000000, so it may have no supply
    resetWaitsForRun,        // the reset was confirmed, and run was not sent
    resetDone,               // EEPROM writes
    camsRead,                // number of programs
    camsWritten,             // texts of the programs joined, EEPROM writes
    deviceNamed,             // name of the device
    serialNumberDiffers,     // the one in the project, the one that was read
    connected,               // link
    disconnected,            //
    crcErrors,               // segment, errors since the last message, errors since the start
    projectOpened,           // file
    projectSaved,            // file
    projectRecovered,        // file
    eepromThreeQuarters,     // writes by this program, budget
    eepromBudgetUsed,        // writes by this program, budget
    valuesStored,            // encoders, values
    transferDone,            // encoders, values written, values that were already there, EEPROM writes
    transferCancelled,       // likewise
    transferCancelledSet,    // likewise, then the position that was set all the same
    encoderReplaced,         // serial number before, serial number now (either may be empty)
    valuesRestored,          // the time they date from (ISO 8601, UTC), values
    reportSaved,             // file
    oldMessagesDropped,      // messages
    notKept,                 // file, reason
    keptBeside,              // ledger, reason, the file kept beside it
    databasePutAside,        // file, its new name
    encoderSilent,           // tries without an answer
    encoderAnswers,          //
    recordingBegun,          // file
    recordingWaits,          // file
    recordingTriggered,      // file
    recordingGoesOn,         // file, values lost meanwhile
    recordingEnded,          // file, its size in bytes
    training,                // what the trainer did: a TrainingAct
};
extern const MessageFamily commonMessages;
constexpr const MessageFamily &familyOf(MessageId)
{
    return commonMessages;
}

struct Message
{
    Instant at{};
    std::optional<Place> place{}; // whom it concerns, a device or the bus itself; empty: the program
    Severity severity = Severity::information;
    MessageCode id = MessageId::refused;
    std::vector<RefusalArgument> arguments{};
    std::optional<Refusal> refusal{}; // with MessageId::refused and deviceFault

    friend bool operator==(const Message &, const Message &) = default;
};

} // namespace codewheel
