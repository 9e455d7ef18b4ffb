// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/message_items.h"

#include "vocabulary/enumeration_rows.h"
#include "vocabulary/sentence.h"
#include "vocabulary/texts_of_kinds.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

struct MessageItemRow
{
    MessageItem item;
    const char *key;
    std::size_t arguments; // that belong to it
};
constexpr std::array messageItemRows{
    MessageItemRow{MessageItem::factorySettings, "factorySettings", 0},
    MessageItemRow{MessageItem::position, "position", 0},
    MessageItemRow{MessageItem::camProgram, "camProgram", 1},
    MessageItemRow{MessageItem::typed, "typed", 2},
};
static_assert(areInOrder(messageItemRows, &MessageItemRow::item));

const MessageItemRow *itemRowOf(const RefusalArgument &argument)
{
    const auto *key = std::get_if<QString>(&argument);
    return key != nullptr ? rowByKey(messageItemRows, *key) : nullptr;
}

std::size_t lengthOf(std::span<const RefusalArgument> items)
{
    const MessageItemRow *row = itemRowOf(items.front());
    const std::size_t more = std::holds_alternative<Parameter>(items.front()) ? 1
                             : row != nullptr                                 ? row->arguments
                                                                              : 0;
    return std::min(items.size(), 1 + more);
}

QString keyedItemText(MessageItem item, std::span<const RefusalArgument> more)
{
    switch (item) {
    case MessageItem::factorySettings:
        return QCoreApplication::translate("JobReport", "factory settings");
    case MessageItem::position:
        return QCoreApplication::translate("JobReport", "position");
    case MessageItem::camProgram:
        return sentence(QCoreApplication::translate("JobReport", "cam program %1"),
                        argumentTexts({more.begin(), more.end()}));
    case MessageItem::typed:
        return textOfTyped({more.begin(), more.end()});
    }
    return {};
}

QString itemText(std::span<const RefusalArgument> item)
{
    if (std::holds_alternative<Parameter>(item.front()) && item.size() > 1)
        return argumentText(item[0]) + QStringLiteral(" = ") + argumentText(item[1]);
    const MessageItemRow *row = itemRowOf(item.front());
    return row != nullptr ? keyedItemText(row->item, item.subspan(1)) : argumentText(item.front());
}

std::vector<std::span<const RefusalArgument>> itemsOf(std::span<const RefusalArgument> arguments)
{
    std::vector<std::span<const RefusalArgument>> items;
    while (!arguments.empty()) {
        items.push_back(arguments.first(lengthOf(arguments)));
        arguments = arguments.subspan(items.back().size());
    }
    return items;
}

} // namespace

void addItem(MessageItems &items, Parameter parameter, const RefusalArgument &value)
{
    items.emplace_back(parameter);
    items.push_back(value);
}

void addItem(MessageItems &items, MessageItem item, const std::vector<RefusalArgument> &more)
{
    items.emplace_back(QString::fromLatin1(messageItemRows.at(static_cast<std::size_t>(item)).key));
    items.insert(items.end(), more.begin(), more.end());
}

std::int64_t countOf(const MessageItems &items)
{
    return std::ssize(itemsOf(items));
}

QString itemsText(std::span<const RefusalArgument> items)
{
    QStringList texts;
    for (const auto &item : itemsOf(items))
        texts << itemText(item);
    return texts.join(QStringLiteral(", "));
}

} // namespace codewheel
