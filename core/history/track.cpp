// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/track.h"

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

constexpr double secondsPerMinute = 60;

struct KnownChannel
{
    Channel channel;
    QLatin1String key;
    unsigned bits;
};

constexpr std::array knownChannels{
    KnownChannel{Channel::position, QLatin1String("position"), 0},
    KnownChannel{Channel::speed, QLatin1String("speed"), 0},
    KnownChannel{Channel::in, QLatin1String("in"), 32},
    KnownChannel{Channel::out, QLatin1String("out"), 32},
    KnownChannel{Channel::cams, QLatin1String("cams"), 8},
};
static_assert(knownChannels.size() == channelCount);

const KnownChannel &rowOf(Channel channel)
{
    return *std::ranges::find(knownChannels, channel, &KnownChannel::channel);
}

struct KnownUnit
{
    TrackUnit unit;
    QLatin1String key;
    QLatin1String symbol;
    QLatin1String ofSpeed;
};

constexpr std::array knownUnits{
    KnownUnit{TrackUnit::steps, QLatin1String("steps"), QLatin1String("steps"), QLatin1String("steps/s")},
    KnownUnit{TrackUnit::turns, QLatin1String("turns"), QLatin1String("turns"), QLatin1String("rpm")},
    KnownUnit{TrackUnit::degrees, QLatin1String("degrees"), QLatin1String("deg"), QLatin1String("deg/s")},
    KnownUnit{TrackUnit::millimetres, QLatin1String("millimetres"), QLatin1String("mm"),
              QLatin1String("mm/s")},
};
static_assert(knownUnits.size() == trackUnits.size());

const KnownUnit &rowOf(TrackUnit unit)
{
    return *std::ranges::find(knownUnits, unit, &KnownUnit::unit);
}

// A bit as a key writes it, without sign or leading zero.
std::optional<unsigned> bitOf(QStringView text, unsigned count)
{
    for (unsigned bit = 0; bit < count; ++bit)
        if (text == QString::number(bit))
            return bit;
    return {};
}

} // namespace

QLatin1String channelKey(Channel channel)
{
    return rowOf(channel).key;
}

std::optional<Channel> channelFromKey(QStringView key)
{
    const auto *const row =
        std::ranges::find_if(knownChannels, [key](const KnownChannel &one) { return key == one.key; });
    return row == knownChannels.end() ? std::nullopt : std::optional(row->channel);
}

unsigned bitCount(Channel channel)
{
    return rowOf(channel).bits;
}

QLatin1String unitKey(TrackUnit unit)
{
    return rowOf(unit).key;
}

std::optional<TrackUnit> trackUnit(QStringView key)
{
    const auto *const row =
        std::ranges::find_if(knownUnits, [key](const KnownUnit &unit) { return key == unit.key; });
    return row == knownUnits.end() ? std::nullopt : std::optional(row->unit);
}

QString Track::key() const
{
    QString key = place.key() + u'/' + channelKey(channel);
    if (bit)
        key += u'.' + QString::number(*bit);
    return key;
}

std::optional<Track> Track::parse(QStringView text)
{
    const qsizetype slash = text.lastIndexOf(u'/');
    if (slash < 0)
        return {};
    const auto place = Place::parse(text.first(slash));
    const QStringView what = text.sliced(slash + 1);
    const qsizetype dot = what.indexOf(u'.');
    const QStringView name = dot < 0 ? what : what.first(dot);
    const auto channel = channelFromKey(name);
    if (!place || !channel)
        return {};
    if (dot < 0)
        return Track{*place, *channel, {}};
    const auto bit = bitOf(what.sliced(dot + 1), bitCount(*channel));
    return bit ? std::optional(Track{*place, *channel, bit}) : std::nullopt;
}

TrackScale TrackScale::at(Instant at) const
{
    const auto then = std::ranges::upper_bound(earlier, at, {}, &Earlier::until);
    return {unit, then == earlier.end() ? perStep : then->perStep};
}

bool TrackScale::changesIn(const TimeSpan &span) const
{
    return std::ranges::any_of(
        earlier, [&](const Earlier &one) { return one.until > span.from && one.until < span.to; });
}

std::vector<ScaledSpan> scaledSpans(const TrackScale &scale, const TimeSpan &span)
{
    std::vector<ScaledSpan> parts;
    Instant from = span.from;
    for (const TrackScale::Earlier &one : scale.earlier)
        if (one.until > from && one.until < span.to)
            parts.push_back({{std::exchange(from, one.until), one.until}, scale.at(one.until - Instant(1))});
    parts.push_back({{from, span.to}, scale.at(from)});
    return parts;
}

double TrackScale::factor(Channel channel, Instant then) const
{
    return earlier.empty() ? factor(channel) : at(then).factor(channel);
}

double TrackScale::factor(Channel channel) const
{
    if (channel == Channel::position)
        return perStep;
    if (channel == Channel::speed)
        return perStep * (unit == TrackUnit::turns ? secondsPerMinute : 1) / speedUnits;
    return 1;
}

QLatin1String TrackScale::symbol(Channel channel) const
{
    if (channel == Channel::position)
        return rowOf(unit).symbol;
    return channel == Channel::speed ? rowOf(unit).ofSpeed : QLatin1String();
}

} // namespace codewheel
