// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/canopen_messages.h"

#include "kinds/canopen/protocol/emcy.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QtGlobal>

#include <array>

namespace codewheel {
namespace {

constexpr auto canopenMessageRows = std::to_array<SentenceRow>({
    {CanopenMessageId::emergency, "emergency",
     QT_TRANSLATE_NOOP("Message", "The encoder reports an error: %1.")},
    {CanopenMessageId::emergencyGone, "emergencyGone",
     QT_TRANSLATE_NOOP("Message", "The encoder reports that its error is gone.")},
    {CanopenMessageId::nodeBooted, "nodeBooted",
     QT_TRANSLATE_NOOP(
         "Message",
         "The encoder has started anew: it had no supply, or was reset. What was not stored is lost.")},
    {CanopenMessageId::speedStandsStill, "speedStandsStill",
     QT_TRANSLATE_NOOP("Message", "%1 stays 0 while the position moves: the encoder may not tell its speed "
                                  "until an object of its maker switches that on.")},
    {CanopenMessageId::speedIsOpposite, "speedIsOpposite",
     QT_TRANSLATE_NOOP("Message", "%1 has another sign than the movement of the position: the description "
                                  "may have the wrong type for it.")},
    {CanopenMessageId::identifierKept, "identifierKept",
     QT_TRANSLATE_NOOP(
         "Message", "%1 has the identifier %2, and %3 is predefined for the number of this node: it may be "
                    "that of the number it had before. Write %3 to it, store, and reset the node; if it "
                    "cannot be written, restore the factory values.")},
});

static_assert(areInOrder(canopenMessageRows, &SentenceRow::id, CanopenMessageId::identifierKept));

QString canopenMessageText(const Message &message)
{
    const auto word = [&](std::size_t index) {
        const auto *value = std::get_if<Word>(&message.arguments[index]);
        return value != nullptr ? *value : 0;
    };
    if (message.id == CanopenMessageId::identifierKept && message.arguments.size() == 3)
        return rowText(message, {argumentTexts(message.arguments).front(), hexNumber(word(1), 3),
                                 hexNumber(word(2), 3)});
    const bool isEmergency = message.id == CanopenMessageId::emergency && message.arguments.size() == 2;
    if (!isEmergency)
        return rowText(message);
    const canopen::Emcy emcy{static_cast<std::uint16_t>(word(0)), static_cast<std::uint8_t>(word(1))};
    return rowText(message, {(QStringList{emcy.text()} + emcy.registerTexts()).join(QStringLiteral(", "))});
}

} // namespace

constinit const MessageFamily canopenMessages{canopenMessageRows, canopenMessageText};

} // namespace codewheel
