// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/message_items.h"
#include "vocabulary/mode_text.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "vocabulary/training_act.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>

#include <algorithm>
#include <array>
#include <span>

namespace codewheel {
namespace {

struct CommonMessageRows
{
    Q_DECLARE_TR_FUNCTIONS(Message)
    using enum MessageId;

public:
    static constexpr auto all = std::to_array<SentenceRow>({
        {refused, "refused", QT_TR_NOOP("Refused.")},
        {busStarted, "busStarted", QT_TR_NOOP("The bus runs.")},
        {busStopped, "busStopped", QT_TR_NOOP("The bus is stopped.")},
        {operateOn, "operateOn", QT_TR_NOOP("Operate: writing is allowed.")},
        {watchOn, "watchOn", QT_TR_NOOP("Watch: nothing is sent any more.")},
        {computerSlept, "computerSlept",
         QT_TR_NOOP("The computer slept for %1 s: the bus is in Watch, and what was shown before is old.")},
        {wordWritten, "wordWritten", QT_TR_NOOP("OUT %1 written.")},
        {parametersWritten, "parametersWritten",
         QT_TR_NOOP("Written and activated: %3 (parameters: %1, EEPROM writes: %2).")},
        {parametersStored, "parametersStored",
         QT_TR_NOOP("Stored, in force before: %3 (parameters: %1, EEPROM writes: %2).")},
        {writtenUnscaled, "writtenUnscaled",
         QT_TR_NOOP("Written: %3 (parameters: %1, EEPROM writes: %2). What scales the position acts only "
                    "while scaling is on.")},
        {restoredReadBack, "restoredReadBack",
         QT_TR_NOOP("The earlier values were written again and read back: %1 (EEPROM writes: %2).")},
        {restoredConfirmed, "restoredConfirmed",
         QT_TR_NOOP("The earlier values were written again, confirmed and activated, but cannot be read: %1 "
                    "(EEPROM writes: %2).")},
        {parametersRead, "parametersRead", QT_TR_NOOP("Values read: %1.")},
        {presetDone, "presetDone", QT_TR_NOOP("Preset initialised: position %1 before, %2 after.")},
        {wordsSent, "wordsSent", QT_TR_NOOP("Words sent: %1.")},
        {broughtBack, "broughtBack", QT_TR_NOOP("The encoder is in operation again.")},
        {inDoubt, "inDoubt",
         QT_TR_NOOP("It is not known whether the encoder has this: %1. Read it to know.")},
        {inDoubtForGood, "inDoubtForGood",
         QT_TR_NOOP("It is not known whether the encoder has this: %1. It cannot be read: compare the "
                    "position with the machine, or write it again.")},
        {writesInDoubt, "writesInDoubt", QT_TR_NOOP("EEPROM writes that this perhaps cost: %1.")},
        {outLeft, "outLeft",
         QT_TR_NOOP("OUT may still hold %1: the encoder may give no position. Bring it back once the bus "
                    "runs again.")},
        {leftInParameterization, "leftInParameterization",
         QT_TR_NOOP("The encoder was left in parameterization. Send run to bring it back to operation.")},
        {stillInParameterization, "stillInParameterization",
         QT_TR_NOOP("The encoder is still in parameterization, as it was before: it gives no position until "
                    "run is sent.")},
        {leftInService, "leftInService",
         QT_TR_NOOP("The encoder was left in service mode: it shows no position. Set OUT to 0 to bring it "
                    "back to normal mode.")},
        {leftInMode, "leftInMode",
         QT_TR_NOOP("The encoder was left in %1: the controller gets no position. Switch it back to position "
                    "mode.")},
        {leftInUnknownMode, "leftInUnknownMode",
         QT_TR_NOOP("It is not known in which mode the encoder was left: the controller may get no position. "
                    "Switch it to position mode.")},
        {onlyZeroSinceRun, "onlyZeroSinceRun",
         QT_TR_NOOP("IN has been 00000000 since run: position 0, or an encoder without power. Turn the shaft "
                    "to be sure.")},
        {deviceFault, "deviceFault", QT_TR_NOOP("The encoder reports error %1 (IN %2).")},
        {deviceFaultGone, "deviceFaultGone", QT_TR_NOOP("The encoder reports no error any more.")},
        {valuesForgotten, "valuesForgotten",
         QT_TR_NOOP("What was known of the encoder may not hold any more: read it again.")},
        {lateCycles, "lateCycles", QT_TR_NOOP("Bus cycles that came late: %1.")},
        {modeSwitched, "modeSwitched", QT_TR_NOOP("The encoder was switched: %1.")},
        {modeSentToZero, "modeSentToZero",
         QT_TR_NOOP("The word for %1 was sent, and IN is 00000000: the encoder has no supply, or is at "
                    "position 0.")},
        {resetWaitsForRun, "resetWaitsForRun",
         QT_TR_NOOP("The reset to factory settings waits for run. Run carries it out; switching the encoder "
                    "off drops it.")},
        {resetDone, "resetDone",
         QT_TR_NOOP("The encoder was reset to factory settings (EEPROM writes: %1).")},
        {camsRead, "camsRead", QT_TR_NOOP("Cam programs read: %1.")},
        {camsWritten, "camsWritten", QT_TR_NOOP("Cam programs written: %1 (EEPROM writes so far: %2).")},
        {deviceNamed, "deviceNamed",
         QT_TR_NOOP("This encoder is now treated as: %1. What was known of it is forgotten.")},
        {serialNumberDiffers, "serialNumberDiffers",
         QT_TR_NOOP("The project has the serial number %1, and the encoder reports %2: check which encoder "
                    "it is, and correct the project.")},
        {connected, "connected", QT_TR_NOOP("Connected: %1.")},
        {disconnected, "disconnected", QT_TR_NOOP("Disconnected.")},
        {crcErrors, "crcErrors",
         QT_TR_NOOP("CRC errors in segment %1: %2 since the last message, %3 since the start.")},
        {projectOpened, "projectOpened", QT_TR_NOOP("Project opened: %1.")},
        {projectSaved, "projectSaved", QT_TR_NOOP("Project saved: %1.")},
        {projectRecovered, "projectRecovered", QT_TR_NOOP("Unsaved changes of %1 were recovered.")},
        {eepromThreeQuarters, "eepromThreeQuarters",
         QT_TR_NOOP("This program has written %1 times to the EEPROM; its manual states about %2 writes. "
                    "Each further write is asked about.")},
        {eepromBudgetUsed, "eepromBudgetUsed",
         QT_TR_NOOP("This program has written %1 times to the EEPROM, as often as its manual states (%2). It "
                    "may lose its values.")},
        {valuesStored, "valuesStored", QT_TR_NOOP("Stored in the project: %2 values of %1 encoders.")},
        {transferDone, "transferDone",
         QT_TR_NOOP("Transferred to %1 encoders: %2 values written, %3 already there, %4 EEPROM writes.")},
        {transferCancelled, "transferCancelled",
         QT_TR_NOOP("The transfer was cancelled (encoders that have all of it: %1, values written: %2, "
                    "already there: %3, EEPROM writes: %4).")},
        {transferCancelledSet, "transferCancelledSet",
         QT_TR_NOOP("The transfer was cancelled, but the position was set to %5 (encoders that have all of "
                    "it: %1, values written: %2, already there: %3, EEPROM writes: %4).")},
        {encoderReplaced, "encoderReplaced",
         QT_TR_NOOP("The encoder was replaced (serial number before: %1, now: %2).")},
        {valuesRestored, "valuesRestored", QT_TR_NOOP("Values of %1 were restored: %2.")},
        {reportSaved, "reportSaved", QT_TR_NOOP("Report saved: %1.")},
        {oldMessagesDropped, "oldMessagesDropped",
         QT_TR_NOOP("The message file had reached its size limit: the oldest %1 messages were dropped.")},
        {notKept, "notKept",
         QT_TR_NOOP("%1 cannot be used: %2 What belongs there is kept only until the program ends.")},
        {keptBeside, "keptBeside",
         QT_TR_NOOP("EEPROM writes cannot be entered in %1: %2 They are kept in %3, and entered when the "
                    "program can open it again.")},
        {databasePutAside, "databasePutAside",
         QT_TR_NOOP("%1 was damaged. It was put aside as %2, and a new one was begun.")},
        {encoderSilent, "encoderSilent", QT_TR_NOOP("The encoder does not answer any more (%1 tries).")},
        {encoderAnswers, "encoderAnswers", QT_TR_NOOP("The encoder answers again.")},
        {recordingBegun, "recordingBegun", QT_TR_NOOP("Recording to %1.")},
        {recordingWaits, "recordingWaits", QT_TR_NOOP("The recording %1 waits for its trigger.")},
        {recordingTriggered, "recordingTriggered", QT_TR_NOOP("The trigger fired: recording to %1.")},
        {recordingGoesOn, "recordingGoesOn",
         QT_TR_NOOP("The recording %1 goes on (values lost so far: %2).")},
        {recordingEnded, "recordingEnded", QT_TR_NOOP("The recording has ended: %1, %2.")},
        {training, "training", "%1"},
    });
};

static_assert(areInOrder(CommonMessageRows::all, &SentenceRow::id, MessageId::training));

// Either position may be missing.
QString presetText(const Message &message)
{
    const QStringList parts = argumentTexts(message.arguments);
    const QString before = parts.value(0);
    const QString after = parts.value(1);
    if (before.isEmpty() && after.isEmpty())
        return messagePattern(QT_TRANSLATE_NOOP("Message", "Preset initialised."));
    if (before.isEmpty())
        return sentence(
            messagePattern(QT_TRANSLATE_NOOP("Message", "Preset initialised: position %1 after.")), {after});
    if (after.isEmpty())
        return sentence(
            messagePattern(QT_TRANSLATE_NOOP("Message", "Preset initialised: position %1 before.")),
            {before});
    return rowText(message, {before, after});
}

std::span<const RefusalArgument> argumentsFrom(const Message &message, std::size_t first)
{
    return std::span(message.arguments).subspan(std::min(first, message.arguments.size()));
}

QStringList partsOfWritten(const Message &message)
{
    QStringList parts =
        argumentTexts(message.arguments).first(std::min<qsizetype>(2, std::ssize(message.arguments)));
    if (message.arguments.size() > 2)
        parts << itemsText(argumentsFrom(message, 2));
    return parts;
}

// In files of before, the text of the items came first.
QStringList partsOfItems(const Message &message)
{
    if (std::holds_alternative<QString>(message.arguments.front()) || message.arguments.size() < 2)
        return argumentTexts(message.arguments);
    return {itemsText(argumentsFrom(message, 2)), argumentText(message.arguments[1])};
}

// A size in bytes as "614.4 kB".
QString dataSizeText(const RefusalArgument &size)
{
    const auto *bytes = std::get_if<std::int64_t>(&size);
    return bytes != nullptr ? QLocale().formattedDataSize(*bytes, 1, QLocale::DataSizeSIFormat)
                            : argumentText(size);
}

// In files of before it was a text in some language.
QString storedTimeText(const RefusalArgument &time)
{
    const QString text = argumentText(time);
    const QDateTime at = QDateTime::fromString(text, Qt::ISODate);
    return at.isValid() ? QLocale().toString(at.toLocalTime(), QLocale::ShortFormat) : text;
}

QStringList partsWith(const Message &message, std::size_t index, QString (*textOf)(const RefusalArgument &))
{
    QStringList parts = argumentTexts(message.arguments);
    if (index < message.arguments.size())
        parts[static_cast<qsizetype>(index)] = textOf(message.arguments[index]);
    return parts;
}

// Some are kept as a key with what belongs to it.
QStringList messageParts(const Message &message)
{
    if (message.arguments.empty())
        return {};
    switch (*message.id.as<MessageId>()) {
    case MessageId::modeSwitched:
    case MessageId::modeSentToZero:
    case MessageId::leftInMode:
        return {modeText(message.arguments)};
    case MessageId::training:
        return {trainingActText(message.arguments)};
    case MessageId::parametersWritten:
    case MessageId::parametersStored:
    case MessageId::writtenUnscaled:
        return partsOfWritten(message);
    case MessageId::restoredReadBack:
    case MessageId::restoredConfirmed:
    case MessageId::inDoubt:
    case MessageId::inDoubtForGood:
        return partsOfItems(message);
    case MessageId::outLeft:
        return {argumentTexts(message.arguments).join(QCoreApplication::translate("JobReport", " or "))};
    case MessageId::recordingEnded:
        return partsWith(message, 1, dataSizeText);
    case MessageId::valuesRestored:
        return partsWith(message, 0, storedTimeText);
    default:
        return argumentTexts(message.arguments);
    }
}

QString commonMessageText(const Message &message)
{
    if (message.id == MessageId::refused && message.refusal)
        return refusalText(*message.refusal);
    const QStringList parts = messageParts(message);
    if (message.id == MessageId::presetDone)
        return presetText(message);
    if (message.id == MessageId::deviceFault && message.refusal)
        return sentence(
            messagePattern(QT_TRANSLATE_NOOP("Message", "The encoder reports error %1, %3 (IN %2).")),
            parts + QStringList{deviceErrorName(message.refusal->id)});
    return rowText(message, parts);
}

} // namespace

constinit const MessageFamily commonMessages{CommonMessageRows::all, commonMessageText};

QString messagePattern(const char *text)
{
    return QCoreApplication::translate("Message", text);
}

QString rowText(const Message &message, const QStringList &parts)
{
    return sentence(messagePattern(message.id.row().text), parts);
}

QString rowText(const Message &message)
{
    return rowText(message, argumentTexts(message.arguments));
}

QString messageText(const Message &message)
{
    const auto textOf = message.id.family().textOf;
    return textOf != nullptr ? textOf(message) : rowText(message);
}

QString messageKey(MessageCode code)
{
    return QString::fromLatin1(code.row().key);
}

} // namespace codewheel
