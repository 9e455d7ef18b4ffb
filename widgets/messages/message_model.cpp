// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/message_model.h"

#include "bus/encoder_bus.h"
#include "journal/message_fields.h"
#include "widgets/look/fonts.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <QLocale>

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr auto refreshPeriod = 100ms;
constexpr int cached = 2'000;         // messages
constexpr int fetched = 64;           // rows together
constexpr qint64 takenAtOnce = 2'000; // new messages a refresh
constexpr qint64 listedAtOnce = 200;  // messages; older ones follow in the background

QDateTime localTime(qint64 at)
{
    return QDateTime::fromMSecsSinceEpoch(at);
}

QString timeText(const StoredMessage &message)
{
    return localTime(message.at).time().toString(QStringLiteral("HH:mm:ss"));
}

// How many new rows these make on their own, with or without a row for their first day.
int rowsFor(std::span<const SightedMessage> messages, bool withDay)
{
    MessageRows own;
    for (const SightedMessage &message : messages)
        own.append(message);
    return static_cast<int>(own.size()) - (withDay ? 0 : 1);
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
    if (message.place)
        m_busNames.note(message.place->bus, at.toMSecsSinceEpoch());
    m_store.add(message, at);
    Q_EMIT added(message);
    if (message.severity == Severity::information)
        return;
    ++m_unseen;
    Q_EMIT unseenChanged();
}

void MessageModel::see()
{
    if (std::exchange(m_unseen, 0) != 0)
        Q_EMIT unseenChanged();
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
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int MessageModel::columnCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : columnTotal;
}

// The store opens the file in its own thread, and gives it up on failure.
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

// Builds all rows again: the newest at once, older ones as they are found.
void MessageModel::list()
{
    m_search.cancel();
    beginResetModel();
    m_ids.clear();
    m_rows.clear();
    m_cache.clear();
    endResetModel();
    m_searched = 0;
    m_lookedUpTo = std::max(firstShown() - 1, m_span.last - listedAtOnce);
    const qint64 last = m_lookedUpTo;
    if (m_table && !isEmpty()) {
        takeNew();
        if (last >= firstShown())
            m_search.start(m_place, m_filter, firstShown(), last);
    }
    Q_EMIT searchChanged();
}

void MessageModel::takeNew()
{
    if (m_lookedUpTo >= m_span.last)
        return;
    const qint64 first = std::max(m_lookedUpTo + 1, firstShown());
    m_lookedUpTo = std::min(m_span.last, first + takenAtOnce - 1);
    const auto messages = fittingMessages(*m_table, m_filter, m_matcher, first, m_lookedUpTo);
    if (!messages)
        failed(messages.error());
    else
        append(*messages);
}

void MessageModel::append(std::span<const SightedMessage> messages)
{
    std::size_t joined = 0;
    for (; joined < messages.size() && m_rows.joinsLast(messages[joined]); ++joined) {
        m_rows.append(messages[joined]);
        m_ids.append(messages[joined].id, messages[joined].id);
    }
    if (joined > 0)
        tellChanged(rowCount() - 1);
    messages = messages.subspan(joined);
    if (messages.empty())
        return;
    const bool isNewDay = m_rows.isEmpty() || messages.front().day != m_rows.lastDay();
    const int before = rowCount();
    beginInsertRows({}, before, before + rowsFor(messages, isNewDay) - 1);
    for (const SightedMessage &message : messages) {
        m_rows.append(message);
        m_ids.append(message.id, message.id);
    }
    endInsertRows();
}

// Some may join the first row, others go below the row of its day, and those of earlier days before it.
void MessageModel::prepend(std::span<const SightedMessage> messages)
{
    if (m_rows.isEmpty()) {
        append(messages);
        return;
    }
    std::size_t left = messages.size();
    for (; left > 0 && m_rows.joinsFirst(messages[left - 1]); --left) {
        m_rows.prepend(messages[left - 1]);
        m_ids.prepend({messages[left - 1].id});
    }
    if (left < messages.size())
        tellChanged(1);
    std::size_t ofDaysBefore = left;
    while (ofDaysBefore > 0 && messages[ofDaysBefore - 1].day == m_rows.firstDay())
        --ofDaysBefore;
    insertBefore(1, messages.subspan(ofDaysBefore, left - ofDaysBefore));
    insertBefore(0, messages.first(ofDaysBefore));
}

// Before all messages; at row 1: below the row of their day.
void MessageModel::insertBefore(int row, std::span<const SightedMessage> messages)
{
    if (messages.empty())
        return;
    beginInsertRows({}, row, row + rowsFor(messages, row == 0) - 1);
    for (auto message = messages.rbegin(); message != messages.rend(); ++message) {
        m_rows.prepend(*message);
        m_ids.prepend({message->id});
    }
    endInsertRows();
}

void MessageModel::tellChanged(int row)
{
    Q_EMIT dataChanged(index(row, 0), index(row, columnTotal - 1));
}

void MessageModel::takeFound()
{
    if (!m_search.isRunning())
        return;
    MessageSearch::Found found = m_search.take();
    m_searched = found.part;
    std::erase_if(found.messages, [this](const SightedMessage &each) { return each.id < firstShown(); });
    prepend(found.messages);
    Q_EMIT searchChanged();
}

// The first remaining row is again that of a day: the present one if something of that day remains.
void MessageModel::dropBelow(qint64 first)
{
    IdRuns ids = m_ids;
    const qint64 gone = ids.dropBelow(first);
    if (gone == 0)
        return;
    MessageRows rows = m_rows;
    rows.dropFirst(gone);
    const int rowsGone = rowCount() - static_cast<int>(rows.size());
    const int from = rows.isEmpty() || m_rows.at(rowsGone).isDay() ? 0 : 1;
    if (rowsGone > 0)
        beginRemoveRows({}, from, from + rowsGone - 1);
    m_ids = std::move(ids);
    m_rows = std::move(rows);
    if (rowsGone > 0)
        endRemoveRows();
    if (rowCount() > 0)
        tellChanged(1); // if it stands for several, some may be gone
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
    std::vector<qint64> ids;
    const int first = row - row % fetched;
    for (int near = first; near < std::min(first + fetched, rowCount()); ++near)
        if (const MessageRows::Row its = m_rows.at(near); !its.isDay())
            ids.push_back(m_ids.at(its.last()));
    const MessageRows::Row its = m_rows.at(row);
    return stored(m_ids.at(its.isDay() ? its.first : its.last()), ids);
}

int MessageModel::rowBefore(qint64 id) const
{
    int row = 0; // the first that is not older, found by halving
    for (int left = rowCount(); left > 0;) {
        const int half = left / 2;
        const bool isOlder = m_ids.at(m_rows.at(row + half).first) < id;
        row += isOlder ? half + 1 : 0;
        left = isOlder ? left - half - 1 : half;
    }
    --row;
    while (row >= 0 && (isDay(row) || m_ids.at(m_rows.at(row).last()) >= id))
        --row;
    return row;
}

int MessageModel::rowOf(qint64 id) const
{
    const int row = rowBefore(id) + 1;
    for (int each = row; each < std::min(row + 2, rowCount()); ++each) // the first may be a day
        if (const MessageRows::Row its = m_rows.at(each);
            !its.isDay() && m_ids.at(its.first) <= id && id <= m_ids.at(its.last()))
            return each;
    return -1;
}

QIcon MessageModel::icon(Severity severity)
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

StoredMessage MessageModel::oldestMessage(int row) const
{
    return stored(m_ids.at(m_rows.at(row).first), {});
}

std::vector<qint64> MessageModel::idsOf(int row) const
{
    const MessageRows::Row its = m_rows.at(row);
    std::vector<qint64> ids;
    for (qint64 each = its.first; each < its.first + its.count; ++each)
        ids.push_back(m_ids.at(each));
    return ids;
}

// Without a filter there is nothing to search: all messages.
IdRuns MessageModel::ids() const
{
    if (!m_filter.isEmpty() || isEmpty())
        return m_ids;
    IdRuns all;
    all.append(firstShown(), m_span.last);
    return all;
}

// Read together with its neighbours, which are shown as well.
StoredMessage MessageModel::stored(qint64 id, const std::vector<qint64> &near) const
{
    if (const StoredMessage *known = m_cache.object(id))
        return *known;
    std::vector<qint64> ids = near;
    if (std::ranges::find(ids, id) == ids.end())
        ids.push_back(id);
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

std::vector<StoredMessage> MessageModel::newest(qint64 most) const
{
    std::vector<qint64> ids;
    for (qint64 id = std::max(m_span.first, m_span.last - most + 1); id <= m_span.last; ++id)
        ids.push_back(id);
    std::vector<StoredMessage> messages = read(ids);
    std::erase_if(messages, [](const StoredMessage &message) { return message.id == 0; }); // dropped since
    return messages;
}

QString MessageModel::text(const StoredMessage &message, int column) const
{
    switch (column) {
    case timeColumn:
        return messageTime(message.at);
    case severityColumn:
        return severityName(message.severity);
    case placeColumn:
        return m_busNames.placeName(message.place, message.at);
    case textColumn:
        return messageText(message);
    default:
        return {};
    }
}

QVariant MessageModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    static constexpr const char *titles[] = {QT_TR_NOOP("Time"), QT_TR_NOOP("Severity"), QT_TR_NOOP("Place"),
                                             QT_TR_NOOP("Message")};
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::AlignLeft | Qt::AlignVCenter);
    const bool isTitle = role == Qt::DisplayRole && section >= 0 && section < columnCount();
    return isTitle ? tr(titles[section]) : QVariant();
}

Qt::ItemFlags MessageModel::flags(const QModelIndex &index) const
{
    const bool isOfDay = index.isValid() && isDay(index.row());
    return isOfDay ? Qt::ItemIsEnabled : QAbstractTableModel::flags(index);
}

QVariant MessageModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid | CheckIndexOption::ParentIsInvalid))
        return {};
    const int column = index.column();
    if (isDay(index.row()))
        return dayData(index.row(), column, role);
    if (role == Qt::FontRole)
        return column == timeColumn || column == placeColumn ? numberFont() : QVariant();
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole &&
        (role != Qt::DecorationRole || column != severityColumn))
        return {};
    const StoredMessage shown = message(index.row());
    if (shown.id == 0)
        return {};
    if (role == Qt::DecorationRole)
        return icon(shown.severity);
    return role == Qt::DisplayRole ? rowText(index.row(), shown, column)
                                   : toolTip(index.row(), shown, column);
}

QVariant MessageModel::dayData(int row, int column, int role) const
{
    if (column != 0)
        return {};
    if (role == Qt::FontRole) {
        QFont bold = textFont();
        bold.setBold(true);
        return bold;
    }
    if (role != Qt::DisplayRole)
        return {};
    return QLocale().toString(localTime(message(row).at).date(), QLocale::LongFormat);
}

// The date is in the row above; a row for several messages shows the newest, how many they are and since
// when.
QString MessageModel::rowText(int row, const StoredMessage &newest, int column) const
{
    if (column == timeColumn)
        return timeText(newest);
    if (column != textColumn || countOf(row) < 2)
        return text(newest, column);
    return tr("%1 (%2 times since %3)", "message, count, time")
        .arg(text(newest, column), QLocale().toString(countOf(row)), timeText(oldestMessage(row)));
}

QString MessageModel::toolTip(int row, const StoredMessage &newest, int column) const
{
    if (column != timeColumn || countOf(row) < 2)
        return text(newest, column);
    return tr("%1 to %2", "date and time")
        .arg(text(oldestMessage(row), timeColumn), text(newest, timeColumn));
}

} // namespace codewheel
