// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_messages.h"

#include "kinds/interbus/words/bus_fault.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "vocabulary/training_act.h"

#include <QCoreApplication>

#include <array>

namespace codewheel {
namespace {

struct RingMessageRows
{
    Q_DECLARE_TR_FUNCTIONS(Message)
    using enum RingMessageId;

public:
    static constexpr auto all = std::to_array<SentenceRow>({
        {alarmStop, "alarmStop", QT_TR_NOOP("ALARM STOP: all OUT words of the ring are set to 0.")},
        {zerosAsked, "zerosAsked", QT_TR_NOOP("ALARM STOP: 00000000 is sent to all devices of the ring.")},
        {zerosReadBack, "zerosReadBack",
         QT_TR_NOOP("The zeros of the ALARM STOP have arrived: all OUT words were read back as 00000000.")},
        {zerosOverwritten, "zerosOverwritten",
         QT_TR_NOOP("The zeros of the ALARM STOP were sent, but OUT was read back as something else: %1. "
                    "Somebody else may write to it: stop the machine by its own means.")},
        {zerosSent, "zerosSent",
         QT_TR_NOOP("The zeros of the ALARM STOP were sent and acknowledged. OUT cannot be read back on this "
                    "link.")},
        {zerosWait, "zerosWait",
         QT_TR_NOOP("The link is lost, and nothing says whether the zeros of the ALARM STOP have arrived: "
                    "they are sent "
                    "again and again, and once it is back. Stop the machine by its own means.")},
        {zerosLate, "zerosLate",
         QT_TR_NOOP("The zeros of the ALARM STOP have not arrived yet, or something else is still in OUT. "
                    "The program "
                    "goes on trying. Stop the machine by its own means. In OUT when it was last seen: %1.")},
        {zerosUnheard, "zerosUnheard",
         QT_TR_NOOP("The zeros of the ALARM STOP were sent over the lost link, but nothing acknowledges "
                    "them: it is not known whether they arrived. Stop the machine by its own means.")},
        {zerosBeforeRing, "zerosBeforeRing",
         QT_TR_NOOP("The zeros of the ALARM STOP are in the gateway, but its ring stands still: the "
                    "devices may not have got them. Stop the machine by its own means.")},
        {zerosGivenUp, "zerosGivenUp",
         QT_TR_NOOP("Disconnected before the zeros of the ALARM STOP had arrived: they are not "
                    "sent any more. OUT may be as it was. Stop the machine by its own means.")},
        {busFault, "busFault", QT_TR_NOOP("Bus fault: %1.")},
        {busFaultGone, "busFaultGone", QT_TR_NOOP("The bus fault is cleared. Start the bus again.")},
        {peripheralFault, "peripheralFault", QT_TR_NOOP("Fault: %1. Confirm it when its cause is gone.")},
        {peripheralFaultConfirmed, "peripheralFaultConfirmed",
         QT_TR_NOOP("The peripheral fault was confirmed.")},
        {segmentOff, "segmentOff", QT_TR_NOOP("Segment %1 was switched off.")},
        {segmentOn, "segmentOn", QT_TR_NOOP("Segment %1 was switched on.")},
        {diagnosticsConfirmed, "diagnosticsConfirmed", QT_TR_NOOP("The diagnostics were confirmed.")},
        {ringRead, "ringRead", QT_TR_NOOP("The ring was read in: %1 devices.")},
        {configurationActivated, "configurationActivated",
         QT_TR_NOOP("The master activated its configuration %1.")},
        {configurationKept, "configurationKept",
         QT_TR_NOOP("The master keeps the configuration %1 now (%2 devices).")},
        {configurationFound, "configurationFound",
         QT_TR_NOOP("The master keeps the configuration %1 (%2 devices).")},
        {configurationNone, "configurationNone", QT_TR_NOOP("The master keeps no configuration.")},
        {ringAsConfigured, "ringAsConfigured", QT_TR_NOOP("The ring is as the project says: %1 devices.")},
        {ringDiffers, "ringDiffers",
         QT_TR_NOOP("The ring differs from the project (lines: %1). Compare them.")},
        {faultPlan, "faultPlan", QT_TR_NOOP("Fault plan: %1")},
        {linkBack, "linkBack", QT_TR_NOOP("The link to the ring is back. The bus is in Watch.")},
        {ringRunsAgain, "ringRunsAgain", QT_TR_NOOP("The gateway says that its ring runs again.")},
        {watchdogAcknowledged, "watchdogAcknowledged",
         QT_TR_NOOP("The watchdog of the gateway was acknowledged.")},
    });
};

static_assert(areInOrder(RingMessageRows::all, &SentenceRow::id, RingMessageId::watchdogAcknowledged));

// When it was switched off, the place of a bus fault went with it.
QString segmentWithFaultText(const Message &message)
{
    const std::vector<RefusalArgument> fault(message.arguments.begin() + 1, message.arguments.end());
    return sentence(messagePattern(QT_TRANSLATE_NOOP(
                        "Message", "Segment %1 is switched off, and the place of the bus fault with "
                                   "it: %2. The fault may still be there. Start the bus again.")),
                    {argumentText(message.arguments.front()), busFaultText(fault)});
}

QString ringReadText(const Message &message)
{
    if (message.arguments != std::vector<RefusalArgument>{std::int64_t{0}})
        return rowText(message);
    return messagePattern(
        QT_TRANSLATE_NOOP("Message", "No device answered when the ring was read in. Check the cable to "
                                     "the first device, and its supply."));
}

QString ringMessageText(const Message &message)
{
    switch (*message.id.as<RingMessageId>()) {
    case RingMessageId::busFault:
    case RingMessageId::peripheralFault:
        return rowText(message, {busFaultText(message.arguments)});
    case RingMessageId::segmentOff:
        return message.arguments.size() > 1 ? segmentWithFaultText(message) : rowText(message);
    case RingMessageId::ringRead:
        return ringReadText(message);
    case RingMessageId::faultPlan:
        return message.arguments.empty() ? rowText(message)
                                         : rowText(message, {trainingActText(message.arguments)});
    default:
        return rowText(message);
    }
}

} // namespace

constinit const MessageFamily ringMessages{RingMessageRows::all, ringMessageText};

} // namespace codewheel
