// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

#include <span>

namespace codewheel {

// What a message lists: values ("Steps = 7,200"), cam programs and the like. Messages store them at the end
// of their arguments, and they are told in the language of whoever reads them. A value is its parameter and
// the number or text; anything else is a key and what belongs to it.
using MessageItems = std::vector<RefusalArgument>;

enum class MessageItem : std::uint8_t {
    factorySettings,
    position,
    camProgram, // its number
    typed,      // what was typed: see textOfTyped() (vocabulary/texts_of_kinds.h)
};

void addItem(MessageItems &items, Parameter parameter, const RefusalArgument &value);
void addItem(MessageItems &items, MessageItem item, const std::vector<RefusalArgument> &more = {});

std::int64_t countOf(const MessageItems &items);
// "Steps = 7,200, cam program 1", in the user's language. Texts of an earlier version are shown as they are.
QString itemsText(std::span<const RefusalArgument> items);

} // namespace codewheel
