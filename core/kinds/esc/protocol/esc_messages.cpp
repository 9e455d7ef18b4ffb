// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_messages.h"

#include "kinds/esc/protocol/esc_explain.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/port_text.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QtGlobal>

#include <array>

namespace codewheel {
namespace {

constexpr auto escMessageRows = std::to_array<SentenceRow>({
    {EscMessageId::typedWritten, "typedWritten",
     QT_TRANSLATE_NOOP("Message", "Written by hand: %1. EEPROM writes: 1.")},
    {EscMessageId::lineOpened, "lineOpened",
     QT_TRANSLATE_NOOP("Message", "The serial line %1 is open at %2 Bd.")},
    {EscMessageId::lineClosed, "lineClosed", QT_TRANSLATE_NOOP("Message", "The serial line %1 was closed.")},
    {EscMessageId::portLost, "portLost",
     QT_TRANSLATE_NOOP("Message",
                       "The serial port %1 is gone: the adapter was unplugged or has lost its supply.")},
    {EscMessageId::portBack, "portBack",
     QT_TRANSLATE_NOOP("Message", "The adapter is back: the serial line %1 is open again.")},
    {EscMessageId::lowLatencyRefused, "lowLatencyRefused",
     QT_TRANSLATE_NOOP("Message",
                       "The adapter at %1 does not take low latency: answers may come up to 16 ms later.")},
    {EscMessageId::suspectPosition, "suspectPosition",
     QT_TRANSLATE_NOOP("Message", "The position %1 is suspect: %2 came before it, and the encoder cannot "
                                  "turn that fast. It is asked for again.")},
    {EscMessageId::lineAddressChanged, "lineAddressChanged",
     QT_TRANSLATE_NOOP("Message", "The encoder at %1 has the address %2 now.")},
    {EscMessageId::baudRateChanged, "baudRateChanged",
     QT_TRANSLATE_NOOP("Message", "The encoder answers at %2 baud now (before: %1).")},
    {EscMessageId::encodersFound, "encodersFound",
     QT_TRANSLATE_NOOP("Message", "Encoders found on the serial line: %1 (requests: %2).")},
});

static_assert(areInOrder(escMessageRows, &SentenceRow::id, EscMessageId::encodersFound));

QStringList partsWithPort(const Message &message)
{
    QStringList parts = argumentTexts(message.arguments);
    parts.front() = portText(message.arguments.front());
    return parts;
}

QString escMessageText(const Message &message)
{
    if (message.arguments.empty())
        return rowText(message);
    switch (*message.id.as<EscMessageId>()) {
    case EscMessageId::typedWritten:
        return rowText(message, {esc::typedText(message.arguments)});
    case EscMessageId::lineOpened:
    case EscMessageId::lineClosed:
    case EscMessageId::portLost:
    case EscMessageId::portBack:
    case EscMessageId::lowLatencyRefused:
        return rowText(message, partsWithPort(message));
    default:
        return rowText(message);
    }
}

} // namespace

constinit const MessageFamily escMessages{escMessageRows, escMessageText};

} // namespace codewheel
