// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/message_filter.h"

#include "journal/message_fields.h"
#include "vocabulary/local_time.h"

#include <QLocale>

namespace codewheel {
namespace {

constexpr qint64 hour = 3'600'000;   // ms
constexpr qint64 quarter = hour / 4; // time zones differ by multiples of a quarter of an hour
constexpr qsizetype remembered = 100'000;

bool contains(const QString &text, const QString &part)
{
    return text.contains(part, Qt::CaseInsensitive);
}

} // namespace

MessageTextMatcher::MessageTextMatcher(QString text)
    : m_text(std::move(text))
{}

bool MessageTextMatcher::fits(const StoredMessage &message)
{
    return m_text.isEmpty() || fitsText(message) || contains(severityName(message.severity), m_text) ||
           contains(placeName(message.place), m_text) || fitsTime(message.at);
}

bool MessageTextMatcher::fitsText(const StoredMessage &message)
{
    const QString key = message.code + message.arguments + message.refusal;
    const auto known = m_texts.constFind(key);
    if (known != m_texts.constEnd())
        return *known;
    if (m_texts.size() >= remembered)
        m_texts.clear();
    return *m_texts.insert(key, contains(messageText(message), m_text));
}

// Making the text of each date costs more than everything else, and it stays the same for a while.
bool MessageTextMatcher::fitsTime(qint64 at)
{
    if (at / quarter != m_quarter || m_date.isNull()) {
        m_quarter = at / quarter;
        const auto local = QDateTime::fromMSecsSinceEpoch(at);
        m_offset = qint64{local.offsetFromUtc()} * 1000;
        m_date = QLocale().toString(local.date(), QLocale::ShortFormat) + u' ';
        m_whichHour = offsetIfTwice(local);
    }
    const auto inDay = static_cast<int>(((at + m_offset) % (24 * hour) + 24 * hour) % (24 * hour));
    const QString time = QTime::fromMSecsSinceStartOfDay(inDay).toString(QStringLiteral("HH:mm:ss.zzz"));
    return contains(m_date + time + m_whichHour, m_text);
}

} // namespace codewheel
