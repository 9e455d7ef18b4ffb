// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/message_rows.h"

#include "journal/argument_json.h"
#include "vocabulary/refusal_text.h"

#include <QHash>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>

namespace codewheel {
namespace {

// For messages whose last arguments merely count, how many of the first ones say what it is about. By code.
const QHash<QString, qsizetype> &countingMessages()
{
    static const QHash<QString, qsizetype> telling{
        {messageKey(MessageId::lateCycles), 0},
        {messageKey(MessageId::crcErrors), 1},
        {messageKey(MessageId::encoderSilent), 0},
        {messageKey(MessageId::oldMessagesDropped), 0},
    };
    return telling;
}

QString tellingArguments(const StoredMessage &message)
{
    const auto telling = countingMessages().constFind(message.code);
    if (telling == countingMessages().constEnd())
        return message.arguments;
    QJsonArray all = QJsonDocument::fromJson(message.arguments.toUtf8()).array();
    while (all.size() > *telling)
        all.removeLast();
    return jsonLine(all);
}

} // namespace

quint64 likeness(const StoredMessage &message)
{
    const QString place = message.place ? message.place->key() : QString();
    return qHashMulti(0, static_cast<int>(message.severity), place, message.code, tellingArguments(message),
                      message.refusal);
}

SightedMessage sighted(const StoredMessage &message)
{
    return {message.id, QDateTime::fromMSecsSinceEpoch(message.at).date().toJulianDay(), likeness(message)};
}

MessageRows::Row MessageRows::at(qint64 row) const
{
    const qint64 wanted = row + m_runs.front().row;
    const Run &run = *std::prev(std::ranges::upper_bound(m_runs, wanted, {}, &Run::row));
    const qint64 first = run.message - m_runs.front().message;
    return run.kind == Kind::single ? Row{first + wanted - run.row, 1} : Row{first, run.count};
}

void MessageRows::append(const SightedMessage &message)
{
    const bool isFirst = isEmpty();
    const bool isNewDay = isFirst || message.day != m_newest.day;
    if (isFirst)
        m_oldest = message;
    if (isNewDay)
        addToLast({.count = 0, .kind = Kind::day});
    if (isNewDay || message.likeness != m_newest.likeness) {
        if (m_runs.back().kind == Kind::single)
            ++m_runs.back().count;
        else
            addToLast({.count = 1, .kind = Kind::single});
    } else if (m_runs.back().kind == Kind::alike) {
        ++m_runs.back().count;
    } else {
        if (--m_runs.back().count == 0) {
            m_runs.back().count = 2;
            m_runs.back().kind = Kind::alike;
        } else {
            addToLast({.count = 2, .kind = Kind::alike});
        }
    }
    m_newest = message;
}

void MessageRows::addToLast(Run run)
{
    if (!isEmpty()) {
        run.row = m_runs.back().endRow();
        run.message = m_runs.back().endMessage();
    }
    m_runs.push_back(run);
}

void MessageRows::prepend(const SightedMessage &message)
{
    if (isEmpty()) {
        append(message);
        return;
    }
    const bool isSameDay = message.day == m_oldest.day;
    if (isSameDay)
        m_runs.pop_front();
    Run &first = m_runs.front();
    if (!isSameDay || message.likeness != m_oldest.likeness) {
        if (first.kind == Kind::single)
            first = {first.row - 1, first.message - 1, first.count + 1, Kind::single};
        else
            m_runs.push_front({first.row - 1, first.message - 1, 1, Kind::single});
    } else if (first.kind == Kind::alike) {
        first = {first.row, first.message - 1, first.count + 1, Kind::alike};
    } else if (first.count == 1) {
        first = {first.row, first.message - 1, 2, Kind::alike};
    } else {
        const Run alike{first.row, first.message - 1, 2, Kind::alike};
        first = {first.row + 1, first.message + 1, first.count - 1, Kind::single};
        m_runs.push_front(alike);
    }
    putDayBefore();
    m_oldest = message;
}

void MessageRows::putDayBefore()
{
    const Run &first = m_runs.front();
    m_runs.push_front({first.row - 1, first.message, 0, Kind::day});
}

void MessageRows::dropFirst(qint64 messages)
{
    if (isEmpty() || messages <= 0)
        return;
    const qint64 until = m_runs.front().message + messages;
    const auto isGone = [until](const Run &run) {
        return run.kind == Kind::day ? run.message < until : run.endMessage() <= until;
    };
    while (!m_runs.empty() && isGone(m_runs.front()))
        m_runs.pop_front();
    if (m_runs.empty() || m_runs.front().kind == Kind::day)
        return;
    Run &first = m_runs.front();
    const qint64 gone = std::max<qint64>(0, until - first.message);
    const qint64 rowsGone = first.kind == Kind::single ? gone : 0;
    first = {first.row + rowsGone, first.message + gone, first.count - gone, first.kind};
    putDayBefore();
}

} // namespace codewheel
