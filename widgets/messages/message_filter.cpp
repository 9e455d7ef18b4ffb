// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/message_filter.h"

#include "widgets/messages/message_model.h"

namespace codewheel {

MessageFilter::MessageFilter(MessageModel &messages, QObject *parent)
    : QSortFilterProxyModel(parent)
    , m_messages(messages)
{
    setSourceModel(&messages);
}

void MessageFilter::setSeverity(Severity least)
{
    m_least = least;
    invalidateFilter();
}

void MessageFilter::setPlace(const Place &place)
{
    m_place = place;
    invalidateFilter();
}

void MessageFilter::setText(const QString &text)
{
    m_text = text.trimmed();
    invalidateFilter();
}

bool MessageFilter::filterAcceptsRow(int row, const QModelIndex & /*parent*/) const
{
    const MessageRow &candidate = m_messages.rowAt(row);
    if (candidate.message.severity < m_least)
        return false;
    if (!m_place.all && candidate.message.place != m_place.number)
        return false;
    if (m_text.isEmpty())
        return true;
    for (int column = 0; column < MessageModel::columnTotal; ++column)
        if (MessageModel::text(candidate, column).contains(m_text, Qt::CaseInsensitive))
            return true;
    return false;
}

} // namespace codewheel
