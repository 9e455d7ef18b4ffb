// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/message_model.h"

#include "encoder/refusal_text.h"
#include "ring/bus_session.h"
#include "widgets/look/fonts.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <QLocale>

namespace codewheel {
namespace {

// Dropped together, so that a full list does not move all its rows with every message.
constexpr int droppedAtOnce = MessageModel::capacity / 100;

QIcon severityIcon(Severity severity)
{
    switch (severity) {
    case Severity::fault:
        return lineIcon(roleIcon(Role::fault), Role::fault);
    case Severity::attention:
        return lineIcon(roleIcon(Role::attention), Role::attention);
    case Severity::information:
        break;
    }
    return lineIcon(Icon::information, Role::inactive);
}

QString timeText(const QDateTime &at)
{
    const QLocale locale;
    return QStringLiteral("%1 %2").arg(locale.toString(at.date(), QLocale::ShortFormat),
                                       locale.toString(at.time(), QStringLiteral("HH:mm:ss.zzz")));
}

} // namespace

QString severityName(Severity severity)
{
    switch (severity) {
    case Severity::fault:
        return MessageModel::tr("Fault");
    case Severity::attention:
        return MessageModel::tr("Attention");
    case Severity::information:
        break;
    }
    return MessageModel::tr("Information");
}

MessageModel::MessageModel(QObject *parent)
    : TableModelBase(parent)
{}

void MessageModel::setBus(BusSession &bus)
{
    if (m_bus)
        m_bus->disconnect(this);
    m_bus = &bus;
    connect(&bus, &BusSession::messaged, this,
            [this](const Message &message) { add(message, m_bus->dateTime(message.at)); });
}

void MessageModel::add(const Message &message, QDateTime at)
{
    if (rowCount() >= capacity)
        removeFirst(droppedAtOnce);
    std::vector<MessageRow> rows;
    rows.push_back({std::move(at), message});
    append(std::move(rows));
}

void MessageModel::addNow(Message message)
{
    if (m_bus)
        message.at = m_bus->latest().at;
    add(message, m_bus ? m_bus->dateTime(message.at) : QDateTime::currentDateTime());
}

QString MessageModel::text(const MessageRow &row, int column)
{
    switch (column) {
    case timeColumn:
        return timeText(row.at);
    case severityColumn:
        return severityName(row.message.severity);
    case placeColumn:
        return row.message.place ? row.message.place->toString() : tr("Bus");
    case textColumn:
        return messageText(row.message);
    default:
        return {};
    }
}

QVariant MessageModel::headerCell(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case timeColumn:
        return tr("Date and time");
    case severityColumn:
        return tr("Severity");
    case placeColumn:
        return tr("Place");
    case textColumn:
        return tr("Message");
    default:
        return {};
    }
}

QVariant MessageModel::cell(const MessageRow &row, int column, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
        return text(row, column);
    case Qt::ToolTipRole:
        return column == textColumn ? text(row, column) : QVariant();
    case Qt::DecorationRole:
        return column == severityColumn ? severityIcon(row.message.severity) : QVariant();
    case Qt::FontRole:
        return column == timeColumn || column == placeColumn ? numberFont() : QVariant();
    default:
        return {};
    }
}

} // namespace codewheel
