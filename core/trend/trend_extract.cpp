// SPDX-License-Identifier: GPL-3.0-or-later
#include "trend/trend_extract.h"

#include "history/histories.h"
#include "vocabulary/shown_text.h"

#include <algorithm>

namespace codewheel {
namespace {

QString whatIsIn(const Track &track)
{
    const QString bit = track.bit ? QString::number(*track.bit) : QString();
    switch (track.channel) {
    case Channel::position:
    case Channel::speed:
        return channelKey(track.channel);
    case Channel::cams:
        return bit.isEmpty() ? QStringLiteral("cams") : QStringLiteral("cam ") + bit;
    case Channel::in:
    case Channel::out:
        break;
    }
    const QString word = track.channel == Channel::in ? QStringLiteral("IN") : QStringLiteral("OUT");
    return bit.isEmpty() ? word : word + u'.' + bit;
}

QString placeIn(const TrendColumn &column)
{
    const QString bus = shownInLine(column.busName.simplified());
    return bus.isEmpty() ? column.track.place.key() : bus + u'/' + column.track.place.toString();
}

} // namespace

// A name of several lines would end the row of titles for programs that read line by line.
QString TrendColumn::title() const
{
    QString title = placeIn(*this) + u' ';
    if (const QString inLine = shownInLine(name.simplified()); !inLine.isEmpty())
        title += inLine + QStringLiteral(": ");
    title += whatIsIn(track);
    if (const QLatin1String unit = scale.symbol(track.channel); !unit.isEmpty())
        title += QStringLiteral(" [") + unit + u']';
    return title;
}

Instant TrendExtract::commonShift() const
{
    const auto isOther = [this](const TrendColumn &column) { return column.shift != columns.front().shift; };
    return columns.empty() || std::ranges::any_of(columns, isOther) ? Instant() : columns.front().shift;
}

QString TrendExtract::title(const TrendColumn &column) const
{
    constexpr int decimals = 3;
    const double seconds = std::chrono::duration<double>(remainingShift(column)).count();
    if (seconds == 0)
        return column.title();
    return column.title() + QStringLiteral(" shifted ") + (seconds > 0 ? QStringLiteral("+") : QString()) +
           QString::number(seconds, 'f', decimals) + QStringLiteral(" s");
}

HistoryOf historyOf(const Histories &histories)
{
    return [&histories](const Track &track) { return histories.of(track.place, track.channel); };
}

} // namespace codewheel
