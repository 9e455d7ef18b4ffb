// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/refusal_text.h"

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/port_text.h"
#include "vocabulary/sentence.h"
#include "vocabulary/texts_of_kinds.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {
namespace {

struct RefusalRows
{
    Q_DECLARE_TR_FUNCTIONS(Refusal)
    using enum RefusalId;

public:
    static constexpr auto all = std::to_array<SentenceRow>({
        // badInput
        {valueOutOfRange, "valueOutOfRange",
         QT_TR_NOOP("%1 = %2 is out of range. Give a value from %3 to %4.")},
        {inputNotUnderstood, "inputNotUnderstood", QT_TR_NOOP("%1: %2 Give a value from %3 to %4.")},
        {valueNotAllowed, "valueNotAllowed", QT_TR_NOOP("%1 cannot be \"%2\". Allowed are: %3.")},
        {parameterGivenTwice, "parameterGivenTwice", QT_TR_NOOP("%1 is given twice. Give it once.")},
        {parameterReadOnly, "parameterReadOnly",
         QT_TR_NOOP("%1 of the %2 can be read but not written. Leave it out.")},
        {nothingToDo, "nothingToDo",
         QT_TR_NOOP("There is nothing to do. Name at least one parameter, value or word.")},
        {unknownDevice, "unknownDevice", QT_TR_NOOP("There is no device at %1. There are devices at: %2.")},
        {totalRangeTooLarge, "totalRangeTooLarge",
         QT_TR_NOOP("The total range would be %1 steps; the largest is %2. Choose fewer steps or more "
                    "revolutions.")},
        {tooManyStepsPerTurn, "tooManyStepsPerTurn",
         QT_TR_NOOP("The resolution would be finer than the encoder's %3 steps per turn (steps: %1, "
                    "revolutions: %2). Choose fewer steps or more revolutions.")},
        {valueAboveTotalRange, "valueAboveTotalRange",
         QT_TR_NOOP("%1 = %2 is outside the total range. Give a value of at most %3.")},
        {presetNeedsValue, "presetNeedsValue",
         QT_TR_NOOP("The %1 needs the position it is to be set to. Give a value.")},
        {camProgramOutOfRange, "camProgramOutOfRange",
         QT_TR_NOOP("There is no cam program %1. Choose a program from 1 to %2.")},
        {camOutOfRange, "camOutOfRange", QT_TR_NOOP("There is no cam %1. Choose a cam from 0 to %2.")},
        {camPositionTooLarge, "camPositionTooLarge",
         QT_TR_NOOP("Cam %1 cannot start or stop at %2. Give a position from 0 to %3.")},
        {camShiftOutOfRange, "camShiftOutOfRange",
         QT_TR_NOOP("The shift cannot be %1. Give a value from 0 to 25.")},
        {camHasNoShift, "camHasNoShift",
         QT_TR_NOOP("The shift cannot be %1: this encoder does not shift its position. Set it to 0.")},
        {camThroughZero, "camThroughZero",
         QT_TR_NOOP("Cam %1 cannot go through zero: the positions of this encoder do not lie in a circle. "
                    "Give a stop that is not below the start.")},
        {camHasMore, "camHasMore",
         QT_TR_NOOP("Cam %1 has a hysteresis or a polarity that this encoder does not know. Set them to 0 "
                    "and off.")},
        {camProgramGivenTwice, "camProgramGivenTwice",
         QT_TR_NOOP("Cam program %1 is given twice. Give it once.")},
        {camFileBroken, "camFileBroken", QT_TR_NOOP("%1, line %2, %3: %4 Nothing was taken from the file."),
         QT_TR_NOOP("%1, line %2: %4 Nothing was taken from the file.")},
        {camFileOfOtherProgram, "camFileOfOtherProgram",
         QT_TR_NOOP("%1 contains cam program %2, not %3. Choose program %2, or another file.")},
        {labelKeyNotUnderstood, "labelKeyNotUnderstood",
         QT_TR_NOOP("\"%2\" in \"%1\" is not understood. Allowed there: %3.")},
        {deviceFileBroken, "deviceFileBroken",
         QT_TR_NOOP("%1: %2 This description was left out; all others were taken.")},
        {deviceOfOtherBus, "deviceOfOtherBus",
         QT_TR_NOOP("The %2 belongs to another kind of bus: it cannot be the device at %1.")},
        {fileNotReadable, "fileNotReadable", QT_TR_NOOP("%1 cannot be read: %2")},
        {fileNotWritten, "fileNotWritten", QT_TR_NOOP("%1 cannot be written: %2 Nothing was changed there.")},
        {fileChanged, "fileChanged",
         QT_TR_NOOP("Another program has changed %1 since it was read here. It was left unchanged; nothing "
                    "was saved. Read it again.")},
        {fileTooLarge, "fileTooLarge",
         QT_TR_NOOP("%1 has %2 MB; the largest file that is read has %3 MB. Is it the right file?")},
        {projectFileBroken, "projectFileBroken",
         QT_TR_NOOP("%1, line %2, %3: %4 The project was not opened."),
         QT_TR_NOOP("%1, line %2: %4 The project was not opened.")},
        {projectFileNewer, "projectFileNewer",
         QT_TR_NOOP("%1 was saved by a newer Codewheel (version %2 of the file; this one reads up to %3). "
                    "Open it with that one. Nothing was changed.")},
        {structureBroken, "structureBroken", QT_TR_NOOP("The bus cannot be built like this: %1")},
        {noSuchProjectDevice, "noSuchProjectDevice",
         QT_TR_NOOP("The project has no device at %1. It has: %2.")},
        {projectEmpty, "projectEmpty",
         QT_TR_NOOP("The project has no devices. Insert one, or read in the ring.")},
        {lineSettingWrong, "lineSettingWrong",
         QT_TR_NOOP("The serial line cannot be set to \"%1\". Allowed are: %2.")},
        {lineAddressTaken, "lineAddressTaken",
         QT_TR_NOOP(
             "Address %1 is taken: %2 answers there. Choose another, or two encoders would answer at once.")},
        {recordingExists, "recordingExists",
         QT_TR_NOOP("There is already a file %1. A recording is never written over another file: choose "
                    "another name, or remove that file.")},
        {serverAddressWrong, "serverAddressWrong", QT_TR_NOOP("The address of the server is wrong. %1")},
        {passwordInAddress, "passwordInAddress",
         QT_TR_NOOP("A password must not be in the address of a server. Put it into ~/.pgpass, into the file "
                    "that PGPASSFILE names, or into PGPASSWORD.")},
        {noSizeOnServer, "noSizeOnServer",
         QT_TR_NOOP("A recording on a server can be kept to its last hours, but not to a size.")},
        {recordingEmpty, "recordingEmpty", QT_TR_NOOP("Nothing is recorded in %1 as yet.")},
        // notSupported
        {parameterNotSupported, "parameterNotSupported",
         QT_TR_NOOP(
             "The %2 does not have the parameter \"%1\". Leave it out, or check which encoder it is.")},
        {readingNotSupported, "readingNotSupported",
         QT_TR_NOOP("The %1 has no read-out: its values cannot be read.")},
        {writingNotSupported, "writingNotSupported",
         QT_TR_NOOP("The %1 cannot be parameterized over the bus.")},
        {presetNotSupported, "presetNotSupported",
         QT_TR_NOOP("The position of the %1 cannot be set over the bus.")},
        {modeNotKnown, "modeNotKnown",
         QT_TR_NOOP("Nothing was sent: the mode of the encoder is not known. In cam mode the word %1 %2. "
                    "Make sure that the encoder is in position mode, and confirm it.")},
        {inCamMode, "inCamMode",
         QT_TR_NOOP("Nothing was sent: the encoder is in cam mode, where the word %1 %2. Switch it to "
                    "position mode first.")},
        {camsNotSupported, "camsNotSupported", QT_TR_NOOP("The %1 has no cams.")},
        {velocityNotSupported, "velocityNotSupported", QT_TR_NOOP("The %1 has no velocity mode.")},
        {manufacturerPresetNotSupported, "manufacturerPresetNotSupported",
         QT_TR_NOOP(
             "The %1 does not know the FRABA preset. Set the position with the preset of the profile.")},
        {linkDoesNotBoundCycles, "linkDoesNotBoundCycles",
         QT_TR_NOOP("Nothing was sent: this link cannot make sure that the word %1 stands on the bus for one "
                    "cycle only. Set the position with the preset of the profile.")},
        {resetNotSupported, "resetNotSupported",
         QT_TR_NOOP("The %1 cannot be reset to factory settings over the bus.")},
        {sendingNotSupported, "sendingNotSupported",
         QT_TR_NOOP("%1 has no OUT word: nothing can be sent to it.")},
        {jobNotSupported, "jobNotSupported", QT_TR_NOOP("The %1 cannot do this.")},
        {onlyRecorded, "onlyRecorded", QT_TR_NOOP("This is a recording: nothing is sent.")},
        {encodersDiffer, "encodersDiffer",
         QT_TR_NOOP("%1 (%2) and %3 (%4) are not the same kind of encoder. Choose encoders of one kind.")},
        // busy
        {jobRunning, "jobRunning", QT_TR_NOOP("A job is running at %1. Wait for its end, or cancel it."),
         QT_TR_NOOP("A job is running at this encoder. Wait for its end, or cancel it.")},
        {wordHeldByJob, "wordHeldByJob",
         QT_TR_NOOP("Nothing was sent to %1: a job holds its OUT word. Wait for its end, or cancel it."),
         QT_TR_NOOP("Nothing was sent: a job holds the OUT word. Wait for its end, or cancel it.")},
        {watchOnly, "watchOnly",
         QT_TR_NOOP("Nothing was sent to %1: the program only watches. Switch to Operate first."),
         QT_TR_NOOP("Nothing was sent: the program only watches. Switch to Operate first.")},
        {notRunning, "notRunning", QT_TR_NOOP("Nothing was sent to %1: the bus is stopped. Start it first."),
         QT_TR_NOOP("Nothing was sent: the bus is stopped. Start it first.")},
        {inParameterization, "inParameterization",
         QT_TR_NOOP("Nothing was written: the encoder is in parameterization already (IN %1). End that "
                    "first, with run.")},
        {eepromBudgetUsed, "eepromBudgetUsed",
         QT_TR_NOOP("%1: this program has written %2 times to its EEPROM; its manual states about %3 writes. "
                    "Confirm that you want to write.")},
        {eepromLimitPassed, "eepromLimitPassed",
         QT_TR_NOOP("%1: this program has written %2 times to its EEPROM; beyond %3 its manual guarantees "
                    "nothing. Type the place to write nevertheless.")},
        // device
        {wrongParameterData, "wrongParameterData",
         QT_TR_NOOP(
             "Error 1: the encoder refused the value of %1 (IN %2). Check the value and write it again."),
         QT_TR_NOOP("Error 1: the encoder refused a value (IN %2). Check the values and write them again.")},
        {unknownParameterNumber, "unknownParameterNumber",
         QT_TR_NOOP(
             "Error 2: the encoder does not know the number of %1 (IN %2). Check which encoder it is."),
         QT_TR_NOOP(
             "Error 2: the encoder does not know a parameter number (IN %2). Check which encoder it is.")},
        {parametersLost, "parametersLost",
         QT_TR_NOOP("Error 3: the encoder has lost its parameters (IN %1). Write parameters 1 to 4 again, or "
                    "reset it to factory settings.")},
        {valuesMissingAfterLoss, "valuesMissingAfterLoss",
         QT_TR_NOOP("The encoder has lost its parameters, and works again only with all of parameters 1 to "
                    "4. Without a value: %1. Give them one; nothing is sent before.")},
        {eepromStoreError, "eepromStoreError",
         QT_TR_NOOP("Error 13: the encoder could not store its parameters (IN %1). Write them again; if the "
                    "error comes back, replace the encoder.")},
        {batteryLow, "batteryLow",
         QT_TR_NOOP("Error 14: the battery of the encoder is low (IN %1). Have it replaced; run brings the "
                    "encoder back to operation.")},
        {codeDiscFault, "codeDiscFault",
         QT_TR_NOOP("Error 15: the encoder reads a faulty value from its code disc (IN %1). Send run; if the "
                    "error comes back, replace the encoder.")},
        {manufacturerError, "manufacturerError",
         QT_TR_NOOP("The encoder reports the manufacturer's error %1 (IN %2). See its manual.")},
        {noValidPosition, "noValidPosition",
         QT_TR_NOOP(
             "The encoder gives no valid position (IN %1). Turn the shaft more slowly, and send run.")},
        {otherDeviceError, "otherDeviceError",
         QT_TR_NOOP(
             "The encoder reports error %1 (IN %2), which its description does not name. See its manual.")},
        {noAnswer, "noAnswer",
         QT_TR_NOOP("The encoder did not answer within %1 s (OUT %2, IN %3). Check which encoder it is, and "
                    "whether it is switched on.")},
        {noAnswerAtGateway, "noAnswerAtGateway",
         QT_TR_NOOP("The encoder did not answer within %1 s (OUT %2, IN %3). Check the first register of OUT "
                    "in the connection: its words may go elsewhere. Then check which encoder it is, and "
                    "whether it is switched on.")},
        {verificationFailed, "verificationFailed",
         QT_TR_NOOP("%1 was written as %2 but read back as %3. Read the encoder before you rely on it, and "
                    "write again.")},
        {takenAsCamWord, "takenAsCamWord",
         QT_TR_NOOP("The encoder is in cam mode: there the word %1 %2 (IN %3). Its cam program was changed, "
                    "and it was left in parameterization: the controller gets no position. Switching the "
                    "encoder off and on drops the change. Run, or another mode, keeps it: then the cam "
                    "program has to be written again.")},
        {modeNotSwitched, "modeNotSwitched",
         QT_TR_NOOP("The encoder does not show the mode: it is in parameterization (IN %1). End that first, "
                    "with run, then try again.")},
        {magnetOutOfRange, "magnetOutOfRange",
         QT_TR_NOOP("The magnet is outside the measuring range (IN %1): the last position is shown. Move the "
                    "magnet back, then read the error status.")},
        {noValuesFromBefore, "noValuesFromBefore",
         QT_TR_NOOP("There is nothing to restore at %1: no values from before a write are kept.")},
        {notSaidWhetherSame, "notSaidWhetherSame",
         QT_TR_NOOP("Say first whether the encoder at %1 is the same as before.")},
        {escNoAnswer, "escNoAnswer",
         QT_TR_NOOP("No answer to %1 (tries: %2). Check address, baud rate, wiring and supply; an RS-422 "
                    "encoder also needs ST (pin 7) at +UB.")},
        {presetNotTaken, "presetNotTaken",
         QT_TR_NOOP("The position was not set: the encoder shows %2, and would show %1. Make sure that its "
                    "OUT word reaches it, then set the position again.")},
        {presetUsedUp, "presetUsedUp",
         QT_TR_NOOP("The position was not set: the encoder shows %2, and would show %1. It had used its "
                    "preset up (preset flag 0): write the preset again, then set the position.")},
        {presetNotKnownWithout, "presetNotKnownWithout",
         QT_TR_NOOP("The preset was sent, but it is not known whether the position was set, since it is not "
                    "known what the encoder has for: %1. It shows %2: compare that with the machine. It can "
                    "be told where that value was written from here before.")},
        {presetNotKnown, "presetNotKnown",
         QT_TR_NOOP("The preset was sent, but it is not known whether the position was set: the encoder "
                    "shows %1, which does not tell. Compare it with the machine before you go on.")},
        {encoderSilent, "encoderSilent",
         QT_TR_NOOP("%1 does not answer. Check address, baud rate, wiring and supply.")},
        // link
        {linkFailed, "linkFailed", QT_TR_NOOP("The link failed: %1")},
        {ringDiffers, "ringDiffers",
         QT_TR_NOOP("%1: configured is %2, found was %3. Compare, and take over what is right.")},
        {databaseFailed, "databaseFailed", QT_TR_NOOP("%1 cannot be used: %2")},
        {recordingGone, "recordingGone",
         QT_TR_NOOP("%1 was moved, replaced or removed while it was being recorded to: the recording has "
                    "ended. Begin another one.")},
        {damagedBlocks, "damagedBlocks",
         QT_TR_NOOP(
             "Some values of %1 cannot be read: the file is damaged (blocks: %2). There are gaps instead.")},
        {diskAlmostFull, "diskAlmostFull",
         QT_TR_NOOP("The disk of %1 is almost full: %2 MB are free, and %3 MB are to stay free. The "
                    "recording waits. Make room.")},
        {serverAway, "serverAway",
         QT_TR_NOOP("%1 does not take the recording: %2 What is recorded waits on this computer, and follows "
                    "(MB that wait: %3).")},
        {notAllSent, "notAllSent",
         QT_TR_NOOP("Not all of the recording is in %1: %2 The rest (MB: %3) waits in %4, and follows with "
                    "the next recording to this server.")},
        {portNotFound, "portNotFound",
         QT_TR_NOOP("There is no serial port %1. Plug the adapter in, and choose a port from the list.")},
        {portInUse, "portInUse",
         QT_TR_NOOP(
             "The serial port %1 is used by another program. Close that program, then connect again.")},
        {portNoRights, "portNoRights",
         QT_TR_NOOP("You may not use the serial port %1: it belongs to the group %2. Run \"%3\". If that "
                    "adds you to a group, log out and in again.")},
        {portLost, "portLost",
         QT_TR_NOOP("The serial port %1 is gone: the adapter was unplugged or has lost its supply. Plug it "
                    "in again.")},
        {portOfOther, "portOfOther",
         QT_TR_NOOP("%1 is another adapter than %2. Choose the port again if you mean this one.")},
        {lineClosed, "lineClosed", QT_TR_NOOP("The serial line is not open. Connect it first.")},
        {hostNotFound, "hostNotFound",
         QT_TR_NOOP("There is no host \"%1\" in this network. Check its name, or give its address.")},
        {connectionRefused, "connectionRefused",
         QT_TR_NOOP(
             "%1 refuses the connection. Check the port, and whether Modbus/TCP is switched on there.")},
        {connectionSilent, "connectionSilent",
         QT_TR_NOOP("%1 cannot be reached: no answer within %2 s. Check address, cable and supply.")},
        {connectionClosed, "connectionClosed", QT_TR_NOOP("%1 has closed the connection.")},
        {serverPortTaken, "serverPortTaken",
         QT_TR_NOOP("Port %1 is used by another program. End it, or take another port.")},
        {serverPortPrivileged, "serverPortPrivileged",
         QT_TR_NOOP("Only an administrator may serve at port %1. Take a higher one, such as 1502.")},
        {serverAddressNotOurs, "serverAddressNotOurs",
         QT_TR_NOOP(
             "This computer does not have the address %1. Take one of its own, or 0.0.0.0 for all it has.")},
        {notConnected, "notConnected",
         QT_TR_NOOP("%1 is not connected. Connect its bus, and look which devices are there.")},
        {deviceDiffers, "deviceDiffers",
         QT_TR_NOOP(
             "%1: planned is %2, connected is %3. Connect what is planned, or plan what is connected.")},
        {serialDiffers, "serialDiffers",
         QT_TR_NOOP("%1: the label in the project has the serial number %2, the encoder reports %3. Replace "
                    "the encoder in the project, or correct the label.")},
        // stopped
        {cancelled, "cancelled", QT_TR_NOOP("The job was cancelled.")},
        {alarmStop, "alarmStop",
         QT_TR_NOOP("ALARM STOP ended the job. Check in which state it left the encoder.")},
        {busStopped, "busStopped",
         QT_TR_NOOP("The job ended because the bus was stopped. Start the bus, and check in which state the "
                    "encoder is.")},
        {computerSlept, "computerSlept",
         QT_TR_NOOP("The job ended because the computer slept. Check in which state the encoder is, and "
                    "change to Operate before you write again.")},
        {stoppedInWrite, "stoppedInWrite",
         QT_TR_NOOP("The job ended after %1 was sent and before it was answered: it is not known whether the "
                    "encoder has the new value. Read it before you go on.")},
    });
};

static_assert(areInOrder(RefusalRows::all, &SentenceRow::id, RefusalId::stoppedInWrite));

// The word, what it does, and what to do instead.
QString wordText(const Refusal &refusal)
{
    return rowText(refusal, textsWithCamEffect(refusal.arguments));
}

// With a second figure, what is shown may be a speed.
QString presetNotKnownText(const Refusal &refusal)
{
    const bool mayBeSpeed = refusal.arguments.size() > 1;
    return sentence(
        refusalPattern(mayBeSpeed ? QT_TRANSLATE_NOOP(
                                        "Refusal",
                                        "The preset was sent, but it is not known whether the position was "
                                        "set: position mode would show %1, but IN is %2, which may be the "
                                        "speed of velocity mode. Compare the position with the machine, in "
                                        "position mode, before you go on.")
                                  : refusal.id.row().text),
        argumentTexts(refusal.arguments));
}

QString labelKeyText(const Refusal &refusal)
{
    const QStringList parts = argumentTexts(refusal.arguments);
    if (parts.value(1).isEmpty())
        return sentence(
            refusalPattern(QT_TRANSLATE_NOOP("Refusal", "\"%1\" ends too early. What may follow: %3.")),
            parts);
    if (parts.value(2).isEmpty())
        return sentence(
            refusalPattern(QT_TRANSLATE_NOOP(
                "Refusal", "\"%2\" in \"%1\" is too much: the key ends before it. Leave it out.")),
            parts);
    return rowText(refusal, parts);
}

// The parameters that may be to blame, and IN. A number stands for a parameter without a name. Before
// IN stands the word that was refused where nobody has seen the mode of the encoder.
QString suspectsText(const Refusal &refusal)
{
    QStringList suspects;
    QStringList words;
    for (const RefusalArgument &argument : refusal.arguments) {
        if (std::holds_alternative<Word>(argument))
            words << argumentText(argument);
        else if (std::holds_alternative<std::int64_t>(argument))
            suspects << sentence(refusalPattern(QT_TRANSLATE_NOOP("Refusal", "parameter %1")),
                                 {argumentText(argument)});
        else
            suspects << argumentText(argument);
    }
    const SentenceRow &row = refusal.id.row();
    if (words.isEmpty() && suspects.size() == 1 && refusal.id == RefusalId::wrongParameterData)
        return sentence(
            refusalPattern(QT_TRANSLATE_NOOP("Refusal", "The encoder refused the value of %1. Check it and "
                                                        "write again.")),
            suspects);
    const QString either = refusalPattern(QT_TRANSLATE_NOOP("Refusal", " or "));
    const QString in = words.isEmpty() ? QStringLiteral("?") : words.last();
    if (words.size() > 1)
        return sentence(
            refusalPattern(QT_TRANSLATE_NOOP(
                "Refusal", "Error 2: the encoder refused %3, the word for %1 (IN %2). Perhaps it is in cam "
                           "mode, where it takes no parameters: switch it to position mode, then try again. "
                           "If it was in position mode, check which encoder it is.")),
            {suspects.join(either), in, words.first()});
    return sentence(refusalPattern(suspects.isEmpty() ? row.textWithoutArguments : row.text),
                    {suspects.join(either), in});
}

// The system's message ends without a full stop.
QString fileText(const Refusal &refusal)
{
    QStringList parts = argumentTexts(refusal.arguments);
    if (parts.size() > 1 && !parts[1].endsWith(u'.'))
        parts[1] += u'.';
    return rowText(refusal, parts);
}

QString lostPortText(const Refusal &refusal)
{
    QStringList parts = argumentTexts(refusal.arguments);
    if (!parts.isEmpty())
        parts.front() = portText(refusal.arguments.front());
    return rowText(refusal, parts);
}

// Without IN it is no K3.
QString lostText(const Refusal &refusal)
{
    return refusal.arguments.empty()
               ? refusalPattern(QT_TRANSLATE_NOOP("Refusal", "The encoder has lost its parameters, and gives "
                                                             "no position. Write them again."))
               : rowText(refusal);
}

// A name rather than a number: not grouped.
QString serverPortText(const Refusal &refusal)
{
    const auto *port =
        refusal.arguments.empty() ? nullptr : std::get_if<std::int64_t>(&refusal.arguments.front());
    return rowText(refusal, {QString::number(port ? *port : 0)});
}

QString commonRefusalText(const Refusal &refusal)
{
    switch (*refusal.id.as<RefusalId>()) {
    case RefusalId::serverPortTaken:
    case RefusalId::serverPortPrivileged:
        return serverPortText(refusal);
    case RefusalId::wrongParameterData:
    case RefusalId::unknownParameterNumber:
        return suspectsText(refusal);
    case RefusalId::parametersLost:
        return lostText(refusal);
    case RefusalId::presetNotKnown:
        return presetNotKnownText(refusal);
    case RefusalId::modeNotKnown:
    case RefusalId::inCamMode:
    case RefusalId::takenAsCamWord:
        return wordText(refusal);
    case RefusalId::camFileBroken:
    case RefusalId::projectFileBroken:
        return brokenFileText(refusal);
    case RefusalId::fileNotReadable:
    case RefusalId::fileNotWritten:
        return fileText(refusal);
    case RefusalId::portLost:
    case RefusalId::portNotFound:
        return lostPortText(refusal);
    case RefusalId::labelKeyNotUnderstood:
        return labelKeyText(refusal);
    default:
        return rowText(refusal);
    }
}

} // namespace

constinit const RefusalFamily commonRefusals{RefusalRows::all, commonRefusalText};

QString refusalPattern(const char *text)
{
    return QCoreApplication::translate("Refusal", text);
}

QString rowText(const Refusal &refusal, const QStringList &parts)
{
    const SentenceRow &row = refusal.id.row();
    const bool bare = refusal.arguments.empty() && row.textWithoutArguments;
    return sentence(refusalPattern(bare ? row.textWithoutArguments : row.text), parts);
}

QString rowText(const Refusal &refusal)
{
    return rowText(refusal, argumentTexts(refusal.arguments));
}

QString brokenFileText(const Refusal &refusal)
{
    const QStringList parts = argumentTexts(refusal.arguments);
    const SentenceRow &row = refusal.id.row();
    return sentence(refusalPattern(parts.value(2).isEmpty() ? row.textWithoutArguments : row.text), parts);
}

QString refusalText(const Refusal &refusal)
{
    const auto textOf = refusal.id.family().textOf;
    return textOf != nullptr ? textOf(refusal) : rowText(refusal);
}

QString refusalKey(RefusalCode code)
{
    return QString::fromLatin1(code.row().key);
}

} // namespace codewheel
