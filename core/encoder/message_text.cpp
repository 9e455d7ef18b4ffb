// SPDX-License-Identifier: GPL-3.0-or-later
#include "encoder/bus_fault.h"
#include "encoder/device_error_name.h"
#include "encoder/enumeration_rows.h"
#include "encoder/refusal_text.h"
#include "encoder/sentence.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {
namespace {

// %1, %2, ... are the arguments in the order told in encoder/message.h.
struct Row
{
    MessageId id;
    const char *key;
    const char *text;
};

constexpr std::array rows{
    Row{MessageId::refused, "refused", QT_TRANSLATE_NOOP("Message", "Refused.")},
    Row{MessageId::busStarted, "busStarted", QT_TRANSLATE_NOOP("Message", "The bus runs.")},
    Row{MessageId::busStopped, "busStopped", QT_TRANSLATE_NOOP("Message", "The bus is stopped.")},
    Row{MessageId::alarmStop, "alarmStop",
        QT_TRANSLATE_NOOP("Message", "ALARM STOP: all OUT words of the ring were set to 0.")},
    Row{MessageId::operateOn, "operateOn", QT_TRANSLATE_NOOP("Message", "Operate: writing is allowed.")},
    Row{MessageId::watchOn, "watchOn", QT_TRANSLATE_NOOP("Message", "Watch: nothing is sent any more.")},
    Row{MessageId::wordWritten, "wordWritten", QT_TRANSLATE_NOOP("Message", "OUT %1 written.")},
    Row{MessageId::parametersWritten, "parametersWritten",
        QT_TRANSLATE_NOOP("Message", "Written and activated: %3 (parameters: %1, EEPROM writes: %2).")},
    Row{MessageId::restoredReadBack, "restoredReadBack",
        QT_TRANSLATE_NOOP(
            "Message", "The values from before were written again, and read back: %1 (EEPROM writes: %2).")},
    Row{MessageId::restoredConfirmed, "restoredConfirmed",
        QT_TRANSLATE_NOOP("Message", "The values from before were written again, confirmed and activated, "
                                     "but cannot be read: %1 (EEPROM writes: %2).")},
    Row{MessageId::parametersRead, "parametersRead", QT_TRANSLATE_NOOP("Message", "Values read: %1.")},
    Row{MessageId::presetDone, "presetDone",
        QT_TRANSLATE_NOOP("Message", "Preset initialised: position %1 before, %2 after.")},
    Row{MessageId::wordsSent, "wordsSent", QT_TRANSLATE_NOOP("Message", "Words sent: %1.")},
    Row{MessageId::broughtBack, "broughtBack",
        QT_TRANSLATE_NOOP("Message", "The encoder is in operation again.")},
    Row{MessageId::leftInParameterization, "leftInParameterization",
        QT_TRANSLATE_NOOP("Message", "The encoder was left in parameterization. Send run to bring it back to "
                                     "operation.")},
    Row{MessageId::leftInService, "leftInService",
        QT_TRANSLATE_NOOP("Message", "The encoder was left in service mode: it shows no position. Set OUT to "
                                     "0 to bring it back to normal mode.")},
    Row{MessageId::onlyZeroSinceRun, "onlyZeroSinceRun",
        QT_TRANSLATE_NOOP("Message",
                          "IN has been 00000000 since run: position 0, or an encoder without power. "
                          "Turn the shaft to be sure.")},
    Row{MessageId::deviceFault, "deviceFault",
        QT_TRANSLATE_NOOP("Message", "The encoder reports error %1 (IN %2).")},
    Row{MessageId::deviceFaultGone, "deviceFaultGone",
        QT_TRANSLATE_NOOP("Message", "The encoder reports no error any more.")},
    Row{MessageId::valuesForgotten, "valuesForgotten",
        QT_TRANSLATE_NOOP("Message", "What was known of the encoder may not hold any more: read it again.")},
    Row{MessageId::lateCycles, "lateCycles", QT_TRANSLATE_NOOP("Message", "Bus cycles that came late: %1.")},
    Row{MessageId::modeSwitched, "modeSwitched",
        QT_TRANSLATE_NOOP("Message", "The encoder was switched: %1.")},
    Row{MessageId::resetWaitsForRun, "resetWaitsForRun",
        QT_TRANSLATE_NOOP("Message",
                          "The reset to factory settings waits for run. Run carries it out; switching the "
                          "encoder off drops it.")},
    Row{MessageId::resetDone, "resetDone",
        QT_TRANSLATE_NOOP("Message", "The encoder was reset to factory settings (EEPROM writes: %1).")},
    Row{MessageId::camsRead, "camsRead", QT_TRANSLATE_NOOP("Message", "Cam programs read: %1.")},
    Row{MessageId::camsWritten, "camsWritten",
        QT_TRANSLATE_NOOP("Message", "Cam programs written: %1 (EEPROM writes so far: %2).")},
    Row{MessageId::deviceNamed, "deviceNamed",
        QT_TRANSLATE_NOOP("Message",
                          "This encoder is now taken for: %1. What was known of it is forgotten.")},
    Row{MessageId::connected, "connected", QT_TRANSLATE_NOOP("Message", "Connected: %1.")},
    Row{MessageId::disconnected, "disconnected", QT_TRANSLATE_NOOP("Message", "Disconnected.")},
    Row{MessageId::busFault, "busFault", QT_TRANSLATE_NOOP("Message", "Bus fault: %1.")},
    Row{MessageId::busFaultGone, "busFaultGone",
        QT_TRANSLATE_NOOP("Message", "The bus fault is gone. Start the bus again.")},
    Row{MessageId::peripheralFault, "peripheralFault",
        QT_TRANSLATE_NOOP("Message", "Fault: %1. Confirm it when its cause is gone.")},
    Row{MessageId::peripheralFaultConfirmed, "peripheralFaultConfirmed",
        QT_TRANSLATE_NOOP("Message", "The peripheral fault was confirmed.")},
    Row{MessageId::crcErrors, "crcErrors",
        QT_TRANSLATE_NOOP("Message",
                          "CRC errors in segment %1: %2 since the last message, %3 since the start.")},
    Row{MessageId::segmentOff, "segmentOff", QT_TRANSLATE_NOOP("Message", "Segment %1 was switched off.")},
    Row{MessageId::segmentOn, "segmentOn", QT_TRANSLATE_NOOP("Message", "Segment %1 was switched on.")},
    Row{MessageId::diagnosticsConfirmed, "diagnosticsConfirmed",
        QT_TRANSLATE_NOOP("Message", "The diagnostics were confirmed.")},
    Row{MessageId::ringRead, "ringRead", QT_TRANSLATE_NOOP("Message", "The ring was read in: %1 devices.")},
    Row{MessageId::configurationActivated, "configurationActivated",
        QT_TRANSLATE_NOOP("Message", "The master activated its configuration %1.")},
    Row{MessageId::configurationKept, "configurationKept",
        QT_TRANSLATE_NOOP("Message", "The master keeps the configuration %1 now (%2 devices).")},
    Row{MessageId::configurationFound, "configurationFound",
        QT_TRANSLATE_NOOP("Message", "The master keeps the configuration %1 (%2 devices).")},
    Row{MessageId::configurationNone, "configurationNone",
        QT_TRANSLATE_NOOP("Message", "The master keeps no configuration.")},
    Row{MessageId::ringAsConfigured, "ringAsConfigured",
        QT_TRANSLATE_NOOP("Message", "The ring is as the project says: %1 devices.")},
    Row{MessageId::ringDiffers, "ringDiffers",
        QT_TRANSLATE_NOOP("Message", "The ring differs from the project (lines: %1). Compare them.")},
    Row{MessageId::faultPlan, "faultPlan", QT_TRANSLATE_NOOP("Message", "Fault plan: %1")},
    Row{MessageId::projectOpened, "projectOpened", QT_TRANSLATE_NOOP("Message", "Project opened: %1.")},
    Row{MessageId::projectSaved, "projectSaved", QT_TRANSLATE_NOOP("Message", "Project saved: %1.")},
    Row{MessageId::projectRecovered, "projectRecovered",
        QT_TRANSLATE_NOOP("Message", "Unsaved changes of %1 were brought back.")},
    Row{MessageId::eepromThreeQuarters, "eepromThreeQuarters",
        QT_TRANSLATE_NOOP("Message",
                          "This program has written %1 times to the EEPROM; its manual speaks of about %2. "
                          "Each further write is asked for.")},
    Row{MessageId::eepromBudgetUsed, "eepromBudgetUsed",
        QT_TRANSLATE_NOOP("Message", "This program has written %1 times to the EEPROM, as often as its "
                                     "manual speaks of (%2). It may lose its values.")},
    Row{MessageId::valuesStored, "valuesStored",
        QT_TRANSLATE_NOOP("Message", "Stored in the project: %2 values of %1 encoders.")},
    Row{MessageId::transferDone, "transferDone",
        QT_TRANSLATE_NOOP(
            "Message", "Transferred to %1 encoders: %2 values written, %3 already there, %4 EEPROM writes.")},
    Row{MessageId::encoderReplaced, "encoderReplaced",
        QT_TRANSLATE_NOOP("Message", "The encoder was replaced (serial number before: %1, now: %2).")},
    Row{MessageId::valuesRestored, "valuesRestored",
        QT_TRANSLATE_NOOP("Message", "Values of %1 were restored: %2.")},
    Row{MessageId::reportSaved, "reportSaved", QT_TRANSLATE_NOOP("Message", "Report saved: %1.")},
    Row{MessageId::oldMessagesDropped, "oldMessagesDropped",
        QT_TRANSLATE_NOOP("Message",
                          "The message file had reached its size: the oldest %1 messages were dropped.")},
    Row{MessageId::notKept, "notKept",
        QT_TRANSLATE_NOOP("Message",
                          "%1 cannot be used: %2 What belongs there is kept only until the program "
                          "ends.")},
    Row{MessageId::databasePutAside, "databasePutAside",
        QT_TRANSLATE_NOOP("Message", "%1 was damaged. It was put aside as %2, and a new one was begun.")},
    Row{MessageId::lineOpened, "lineOpened",
        QT_TRANSLATE_NOOP("Message", "The serial line %1 is open at %2 baud.")},
    Row{MessageId::lineClosed, "lineClosed", QT_TRANSLATE_NOOP("Message", "The serial line %1 was closed.")},
    Row{MessageId::portLost, "portLost",
        QT_TRANSLATE_NOOP("Message",
                          "The serial port %1 is gone: the adapter was unplugged or has lost its supply.")},
    Row{MessageId::portBack, "portBack",
        QT_TRANSLATE_NOOP("Message", "The adapter is back: the serial line %1 is open again.")},
    Row{MessageId::lowLatencyRefused, "lowLatencyRefused",
        QT_TRANSLATE_NOOP(
            "Message", "The adapter at %1 does not take low latency: answers may come up to 16 ms later.")},
    Row{MessageId::encoderSilent, "encoderSilent",
        QT_TRANSLATE_NOOP("Message", "The encoder does not answer any more (%1 tries).")},
    Row{MessageId::encoderAnswers, "encoderAnswers",
        QT_TRANSLATE_NOOP("Message", "The encoder answers again.")},
    Row{MessageId::suspectPosition, "suspectPosition",
        QT_TRANSLATE_NOOP("Message", "The position %1 is suspect: %2 came before it, and the encoder cannot "
                                     "turn that fast. It is asked for again.")},
    Row{MessageId::lineAddressChanged, "lineAddressChanged",
        QT_TRANSLATE_NOOP("Message", "The encoder at %1 has the address %2 now.")},
    Row{MessageId::baudRateChanged, "baudRateChanged",
        QT_TRANSLATE_NOOP("Message", "The encoder speaks at %2 baud now (before: %1).")},
    Row{MessageId::encodersFound, "encodersFound",
        QT_TRANSLATE_NOOP("Message", "Encoders found on the serial line: %1 (requests: %2).")},
    Row{MessageId::training, "training", "%1"},
};

static_assert(areInOrder(rows, &Row::id) && rows.size() == messageCount);

const Row &rowOf(MessageId id)
{
    return rows.at(static_cast<std::size_t>(id));
}

QString pattern(const char *text)
{
    return QCoreApplication::translate("Message", text);
}

// Either position may be missing.
QString presetText(const QStringList &parts)
{
    const QString before = parts.value(0);
    const QString after = parts.value(1);
    if (before.isEmpty() && after.isEmpty())
        return pattern(QT_TRANSLATE_NOOP("Message", "Preset initialised."));
    if (before.isEmpty())
        return sentence(pattern(QT_TRANSLATE_NOOP("Message", "Preset initialised: position %1 after.")),
                        {after});
    if (after.isEmpty())
        return sentence(pattern(QT_TRANSLATE_NOOP("Message", "Preset initialised: position %1 before.")),
                        {before});
    return sentence(pattern(rowOf(MessageId::presetDone).text), {before, after});
}

// Switched off, it took the place of a bus fault along.
QString segmentWithFaultText(const Message &message)
{
    const std::vector<RefusalArgument> fault(message.arguments.begin() + 1, message.arguments.end());
    return sentence(pattern(QT_TRANSLATE_NOOP(
                        "Message", "Segment %1 is switched off, and the place of the bus fault with "
                                   "it: %2. The fault may still be there. Start the bus again.")),
                    {argumentText(message.arguments.front()), busFaultText(fault)});
}

} // namespace

QString messageText(const Message &message)
{
    if (message.id == MessageId::refused && message.refusal)
        return refusalText(*message.refusal);
    const QStringList parts = argumentTexts(message.arguments);
    if (message.id == MessageId::presetDone)
        return presetText(parts);
    if (message.id == MessageId::busFault || message.id == MessageId::peripheralFault)
        return sentence(pattern(rowOf(message.id).text), {busFaultText(message.arguments)});
    if (message.id == MessageId::segmentOff && parts.size() > 1)
        return segmentWithFaultText(message);
    if (message.id == MessageId::ringRead &&
        message.arguments == std::vector<RefusalArgument>{std::int64_t{0}})
        return pattern(QT_TRANSLATE_NOOP("Message",
                                         "No device answered when the ring was read in. Check the cable to "
                                         "the first device, and its supply."));
    if (message.id == MessageId::deviceFault && message.refusal)
        return sentence(pattern(QT_TRANSLATE_NOOP("Message", "The encoder reports error %1, %3 (IN %2).")),
                        parts + QStringList{deviceErrorName(message.refusal->id)});
    return sentence(pattern(rowOf(message.id).text), parts);
}

QString messageKey(MessageId id)
{
    return QString::fromLatin1(rowOf(id).key);
}

} // namespace codewheel
