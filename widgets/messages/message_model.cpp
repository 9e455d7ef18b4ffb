// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/message_model.h"

#include "bus/encoder_bus.h"
#include "journal/message_fields.h"
#include "widgets/look/fonts.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <algorithm>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr auto refreshPeriod = 100ms;
constexpr int cached = 2'000;         // messages
constexpr int fetched = 64;           // rows together
constexpr qint64 takenAtOnce = 2'000; // new messages a refresh, where each is looked at

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

} // namespace

MessageModel::MessageModel(MessageStore &store, QObject *parent)
    : QAbstractTableModel(parent)
    , m_store(store)
    , m_cache(cached)
{
    connect(&m_timer, &QTimer::timeout, this, &MessageModel::refresh);
    m_timer.start(refreshPeriod);
}

void MessageModel::setClock(EncoderBus &bus)
{
    m_clock = &bus;
}

void MessageModel::add(const Message &message, const QDateTime &at)
{
    m_store.add(message, at);
}

void MessageModel::addNow(Message message)
{
    if (m_clock)
        message.at = m_clock->now();
    add(message, m_clock ? m_clock->dateTime(message.at) : QDateTime::currentDateTime());
}

void MessageModel::setFilter(const MessageFilter &filter)
{
    if (filter == m_filter)
        return;
    m_filter = filter;
    m_matcher = MessageTextMatcher(filter.text);
    list();
}

std::optional<double> MessageModel::searched() const
{
    return m_search.isRunning() ? std::optional(m_searched) : std::nullopt;
}

void MessageModel::clear()
{
    m_clearedUpTo = m_span.last;
    list();
}

void MessageModel::bringBack()
{
    m_clearedUpTo = 0;
    list();
}

bool MessageModel::isEmpty() const
{
    return m_span.last < firstShown() || m_span.last == 0;
}

std::vector<Place> MessageModel::places() const
{
    return m_table ? m_table->places() : std::vector<Place>();
}

qint64 MessageModel::firstShown() const
{
    return std::max(m_span.first, m_clearedUpTo + 1);
}

int MessageModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_ids.size());
}

int MessageModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : columnTotal;
}

// The store opens the file in its own thread, and leaves it when it fails.
bool MessageModel::openTable()
{
    const auto place = m_store.place();
    if (!place)
        return false;
    if (m_table && *place == m_place)
        return true;
    m_table.reset();
    auto table = MessageTable::open(*place);
    m_place = *place;
    if (!table) {
        failed(table.error());
        return false;
    }
    m_table = std::move(*table);
    m_clearedUpTo = 0;
    m_changes = m_table->changes();
    m_span = m_table->span().value_or(MessageTable::Span());
    list();
    return true;
}

void MessageModel::failed(const DatabaseError &error) const
{
    if (error.kind == DatabaseError::Kind::broken)
        m_store.reportBroken(m_place, error);
}

void MessageModel::refresh()
{
    if (!openTable())
        return;
    if (const qint64 changes = m_table->changes(); changes != m_changes) {
        m_changes = changes;
        const auto span = m_table->span();
        if (!span) {
            failed(span.error());
            return;
        }
        m_span = *span;
        dropBelow(firstShown());
    }
    takeNew();
    takeFound();
}

// All rows anew: those of the filter come with the search.
void MessageModel::list()
{
    m_search.cancel();
    beginResetModel();
    m_ids.clear();
    m_cache.clear();
    m_lookedUpTo = m_span.last;
    if (m_filter.isEmpty() && !isEmpty())
        m_ids.append(firstShown(), m_span.last);
    endResetModel();
    m_searched = 0;
    if (m_table && !m_filter.isEmpty() && !isEmpty())
        m_search.start(m_place, m_filter, firstShown(), m_span.last);
    Q_EMIT searchChanged();
}

void MessageModel::takeNew()
{
    if (m_lookedUpTo >= m_span.last)
        return;
    const qint64 first = std::max(m_lookedUpTo + 1, firstShown());
    const int row = rowCount();
    if (m_filter.isEmpty()) {
        beginInsertRows({}, row, row + static_cast<int>(m_span.last - first));
        m_ids.append(first, m_span.last);
        m_lookedUpTo = m_span.last;
        endInsertRows();
        return;
    }
    m_lookedUpTo = std::min(m_span.last, first + takenAtOnce - 1);
    const auto ids = fittingIds(*m_table, m_filter, m_matcher, first, m_lookedUpTo);
    if (!ids)
        failed(ids.error());
    if (!ids || ids->empty())
        return;
    beginInsertRows({}, row, row + static_cast<int>(ids->size()) - 1);
    m_ids.append(*ids);
    endInsertRows();
}

void MessageModel::takeFound()
{
    if (!m_search.isRunning())
        return;
    MessageSearch::Found found = m_search.take();
    m_searched = found.part;
    std::erase_if(found.ids, [this](qint64 id) { return id < firstShown(); });
    if (!found.ids.empty()) {
        beginInsertRows({}, 0, static_cast<int>(found.ids.size()) - 1);
        m_ids.prepend(found.ids);
        endInsertRows();
    }
    Q_EMIT searchChanged();
}

void MessageModel::dropBelow(qint64 first)
{
    IdRuns left = m_ids;
    const qint64 gone = left.dropBelow(first);
    if (gone == 0)
        return;
    beginRemoveRows({}, 0, static_cast<int>(gone) - 1);
    m_ids = std::move(left);
    endRemoveRows();
}

void MessageModel::catchUp()
{
    m_store.flush();
    refresh();
    while (m_lookedUpTo < m_span.last)
        takeNew();
    m_search.wait();
    takeFound();
}

StoredMessage MessageModel::message(int row) const
{
    const qint64 id = m_ids.at(row);
    if (const StoredMessage *known = m_cache.object(id))
        return *known;
    std::vector<qint64> ids;
    const int first = row - row % fetched;
    for (int near = first; near < std::min(first + fetched, rowCount()); ++near)
        ids.push_back(m_ids.at(near));
    for (const StoredMessage &message : read(ids))
        if (message.id != 0)
            m_cache.insert(message.id, new StoredMessage(message));
    const StoredMessage *found = m_cache.object(id);
    return found == nullptr ? StoredMessage() : *found;
}

std::vector<StoredMessage> MessageModel::read(const std::vector<qint64> &ids) const
{
    if (!m_table)
        return {};
    auto messages = m_table->read(ids);
    if (!messages)
        failed(messages.error());
    return messages.value_or(std::vector<StoredMessage>());
}

QString MessageModel::text(const StoredMessage &message, int column)
{
    switch (column) {
    case timeColumn:
        return messageTime(message.at);
    case severityColumn:
        return severityName(message.severity);
    case placeColumn:
        return placeName(message.place);
    case textColumn:
        return messageText(message);
    default:
        return {};
    }
}

QVariant MessageModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    static constexpr const char *titles[] = {QT_TR_NOOP("Date and time"), QT_TR_NOOP("Severity"),
                                             QT_TR_NOOP("Place"), QT_TR_NOOP("Message")};
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::AlignLeft | Qt::AlignVCenter);
    const bool isTitle = role == Qt::DisplayRole && section >= 0 && section < columnCount();
    return isTitle ? tr(titles[section]) : QVariant();
}

QVariant MessageModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const int column = index.column();
    if (role == Qt::FontRole)
        return column == timeColumn || column == placeColumn ? numberFont() : QVariant();
    const bool isText = role == Qt::DisplayRole || (role == Qt::ToolTipRole && column == textColumn);
    if (!isText && (role != Qt::DecorationRole || column != severityColumn))
        return {};
    const StoredMessage shown = message(index.row());
    if (shown.id == 0)
        return {};
    return isText ? QVariant(text(shown, column)) : severityIcon(shown.severity);
}

} // namespace codewheel
