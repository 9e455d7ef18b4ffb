// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_messages.h"

#include "kinds/interbus/words/bus_fault.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "vocabulary/training_act.h"

#include <QtGlobal>

#include <array>

namespace codewheel {
namespace {

constexpr auto ringMessageRows = std::to_array<SentenceRow>({
    {RingMessageId::alarmStop, "alarmStop",
     QT_TRANSLATE_NOOP("Message", "ALARM STOP: all OUT words of the ring are set to 0.")},
    {RingMessageId::zerosAsked, "zerosAsked",
     QT_TRANSLATE_NOOP("Message", "ALARM STOP: 00000000 is sent to all devices of the ring.")},
    {RingMessageId::zerosReadBack, "zerosReadBack",
     QT_TRANSLATE_NOOP(
         "Message", "The zeros of the ALARM STOP have arrived: all OUT words were read back as 00000000.")},
    {RingMessageId::zerosOverwritten, "zerosOverwritten",
     QT_TRANSLATE_NOOP("Message",
                       "The zeros of the ALARM STOP were sent, but OUT was read back as something else: %1. "
                       "Somebody else may write to it: stop the machine by its own means.")},
    {RingMessageId::zerosSent, "zerosSent",
     QT_TRANSLATE_NOOP(
         "Message",
         "The zeros of the ALARM STOP were sent and acknowledged. OUT cannot be read back on this link.")},
    {RingMessageId::zerosWait, "zerosWait",
     QT_TRANSLATE_NOOP(
         "Message",
         "The link is lost, and nothing says whether the zeros of the ALARM STOP have arrived: they are sent "
         "again and again, and once it is back. Stop the machine by its own means.")},
    {RingMessageId::zerosLate, "zerosLate",
     QT_TRANSLATE_NOOP(
         "Message",
         "The zeros of the ALARM STOP have not arrived yet, or something else is still in OUT. The program "
         "goes on trying. Stop the machine by its own means. In OUT when it was last seen: %1.")},
    {RingMessageId::zerosUnheard, "zerosUnheard",
     QT_TRANSLATE_NOOP("Message",
                       "The zeros of the ALARM STOP were sent over the lost link, but nothing acknowledges "
                       "them: it is not known whether they arrived. Stop the machine by its own means.")},
    {RingMessageId::zerosBeforeRing, "zerosBeforeRing",
     QT_TRANSLATE_NOOP("Message",
                       "The zeros of the ALARM STOP are in the gateway, but its ring stands still: the "
                       "devices may not have got them. Stop the machine by its own means.")},
    {RingMessageId::zerosGivenUp, "zerosGivenUp",
     QT_TRANSLATE_NOOP("Message", "Disconnected before the zeros of the ALARM STOP had arrived: they are not "
                                  "sent any more. OUT may be as it was. Stop the machine by its own means.")},
    {RingMessageId::busFault, "busFault", QT_TRANSLATE_NOOP("Message", "Bus fault: %1.")},
    {RingMessageId::busFaultGone, "busFaultGone",
     QT_TRANSLATE_NOOP("Message", "The bus fault is cleared. Start the bus again.")},
    {RingMessageId::peripheralFault, "peripheralFault",
     QT_TRANSLATE_NOOP("Message", "Fault: %1. Confirm it when its cause is gone.")},
    {RingMessageId::peripheralFaultConfirmed, "peripheralFaultConfirmed",
     QT_TRANSLATE_NOOP("Message", "The peripheral fault was confirmed.")},
    {RingMessageId::segmentOff, "segmentOff", QT_TRANSLATE_NOOP("Message", "Segment %1 was switched off.")},
    {RingMessageId::segmentOn, "segmentOn", QT_TRANSLATE_NOOP("Message", "Segment %1 was switched on.")},
    {RingMessageId::diagnosticsConfirmed, "diagnosticsConfirmed",
     QT_TRANSLATE_NOOP("Message", "The diagnostics were confirmed.")},
    {RingMessageId::ringRead, "ringRead", QT_TRANSLATE_NOOP("Message", "The ring was read in: %1 devices.")},
    {RingMessageId::configurationActivated, "configurationActivated",
     QT_TRANSLATE_NOOP("Message", "The master activated its configuration %1.")},
    {RingMessageId::configurationKept, "configurationKept",
     QT_TRANSLATE_NOOP("Message", "The master keeps the configuration %1 now (%2 devices).")},
    {RingMessageId::configurationFound, "configurationFound",
     QT_TRANSLATE_NOOP("Message", "The master keeps the configuration %1 (%2 devices).")},
    {RingMessageId::configurationNone, "configurationNone",
     QT_TRANSLATE_NOOP("Message", "The master keeps no configuration.")},
    {RingMessageId::ringAsConfigured, "ringAsConfigured",
     QT_TRANSLATE_NOOP("Message", "The ring is as the project says: %1 devices.")},
    {RingMessageId::ringDiffers, "ringDiffers",
     QT_TRANSLATE_NOOP("Message", "The ring differs from the project (lines: %1). Compare them.")},
    {RingMessageId::faultPlan, "faultPlan", QT_TRANSLATE_NOOP("Message", "Fault plan: %1")},
    {RingMessageId::linkBack, "linkBack",
     QT_TRANSLATE_NOOP("Message", "The link to the ring is back. The bus is in Watch.")},
    {RingMessageId::ringRunsAgain, "ringRunsAgain",
     QT_TRANSLATE_NOOP("Message", "The gateway says that its ring runs again.")},
    {RingMessageId::watchdogAcknowledged, "watchdogAcknowledged",
     QT_TRANSLATE_NOOP("Message", "The watchdog of the gateway was acknowledged.")},
});

static_assert(areInOrder(ringMessageRows, &SentenceRow::id, RingMessageId::watchdogAcknowledged));

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

constinit const MessageFamily ringMessages{ringMessageRows, ringMessageText};

} // namespace codewheel
