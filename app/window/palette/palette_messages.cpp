// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/palette/palette_messages.h"

#include "widgets/messages/message_model.h"

#include <limits>
#include <utility>

namespace codewheel {
namespace {

constexpr int mostMessages = 10'000; // rows
constexpr int messagesInPart = 64;

} // namespace

PaletteMessages::PaletteMessages(const MessageModel &messages, std::function<void(qint64)> show)
    : m_messages(messages)
    , m_show(std::move(show))
{}

void PaletteMessages::begin()
{
    m_before = std::numeric_limits<qint64>::max();
    m_left = mostMessages;
}

// Rows may come and go between two parts.
std::vector<PaletteEntry> PaletteMessages::next()
{
    std::vector<PaletteEntry> entries;
    for (int row = m_messages.rowBefore(m_before); row >= 0 && m_left > 0; --row) {
        if (m_messages.isDay(row))
            continue;
        if (entries.size() == messagesInPart)
            break;
        const auto text = [&](int column) { return m_messages.index(row, column).data().toString(); };
        const StoredMessage message = m_messages.message(row);
        const QString place = text(MessageModel::placeColumn);
        const QString time = m_messages.text(message, MessageModel::timeColumn);
        entries.push_back(
            {.kind = PaletteEntry::Kind::message,
             .title = text(MessageModel::textColumn),
             .context = place.isEmpty() ? time : QStringLiteral("%1 \u00B7 %2").arg(place, time),
             .words = text(MessageModel::severityColumn),
             .icon = MessageModel::icon(message.severity),
             .run = [show = m_show, id = message.id] { show(id); }});
        m_before = message.id;
        --m_left;
    }
    return entries;
}

} // namespace codewheel
