// SPDX-License-Identifier: GPL-3.0-or-later
#include "trend/trend_extract.h"

#include "encoder/shown_text.h"
#include "history/histories.h"

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

} // namespace

// A name of several lines would end the row of titles for programs that read line by line.
QString TrendColumn::title() const
{
    QString title = track.place.key() + u' ';
    if (const QString inLine = shownInLine(name.simplified()); !inLine.isEmpty())
        title += inLine + QStringLiteral(": ");
    title += whatIsIn(track);
    if (const QLatin1String unit = scale.symbol(track.channel); !unit.isEmpty())
        title += QStringLiteral(" [") + unit + u']';
    return title;
}

HistoryOf historyOf(const Histories &histories)
{
    return [&histories](const Track &track) { return histories.of(track.place, track.channel); };
}

} // namespace codewheel
