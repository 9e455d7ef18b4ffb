// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/trend_tracks.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr QLatin1String sharing("shared");
constexpr QLatin1String travelling("mm-per-turn");
constexpr QLatin1String passing("recorded");
constexpr double longestTravel = 1e6; // mm per turn

// "1.0/position turns shared"
std::optional<TrendTracks::Shown> shownOf(const QStringList &words)
{
    const auto track = Track::parse(words.value(0));
    const auto unit = trackUnit(words.value(1));
    if (!track || !unit)
        return {};
    return TrendTracks::Shown{*track, *unit, words.contains(sharing)};
}

bool isNumber(const Track &track)
{
    return track.channel == Channel::position || track.channel == Channel::speed;
}

} // namespace

bool canShareAxis(const TrendTracks::Shown &one, const TrendTracks::Shown &other)
{
    return one.track.channel == other.track.channel && !one.track.bit && !other.track.bit &&
           (!isNumber(one.track) || one.unit == other.unit);
}

std::optional<std::size_t> TrendTracks::find(const Track &track) const
{
    const auto found = std::ranges::find(m_shown, track, &Shown::track);
    return found == m_shown.end() ? std::nullopt
                                  : std::optional(static_cast<std::size_t>(found - m_shown.begin()));
}

bool TrendTracks::add(const Track &track)
{
    if (find(track))
        return true;
    if (m_shown.size() >= most)
        return false;
    TrackUnit unit = track.channel == Channel::speed ? TrackUnit::turns : TrackUnit::steps;
    for (const Shown &other : m_shown)
        if (other.track.place == track.place && other.track.channel == track.channel)
            unit = other.unit;
    m_shown.push_back({track, unit, false});
    Q_EMIT changed();
    return true;
}

void TrendTracks::remove(std::size_t index)
{
    m_shown.erase(m_shown.begin() + static_cast<std::ptrdiff_t>(index));
    Q_EMIT changed();
}

void TrendTracks::move(std::size_t index, std::size_t to)
{
    const Shown moved = m_shown.at(index);
    m_shown.erase(m_shown.begin() + static_cast<std::ptrdiff_t>(index));
    m_shown.insert(m_shown.begin() + static_cast<std::ptrdiff_t>(std::min(to, m_shown.size())), moved);
    Q_EMIT changed();
}

void TrendTracks::encoderMoved(Place from, Place to)
{
    std::erase_if(m_shown, [to](const Shown &shown) { return shown.track.place == to; });
    for (Shown &shown : m_shown)
        if (shown.track.place == from)
            shown.track.place = to;
    if (auto travel = m_travel.extract(from))
        m_travel[to] = travel.mapped();
    Q_EMIT changed();
}

void TrendTracks::setUnit(std::size_t index, TrackUnit unit)
{
    if (std::exchange(m_shown.at(index).unit, unit) != unit)
        Q_EMIT changed();
}

void TrendTracks::shareAxis(std::size_t index, bool shares)
{
    if (std::exchange(m_shown.at(index).sharesAxis, shares) != shares)
        Q_EMIT changed();
}

std::optional<double> TrendTracks::travel(Place place) const
{
    const auto found = m_travel.find(place);
    return found == m_travel.end() ? std::nullopt : std::optional(found->second);
}

void TrendTracks::setTravel(Place place, double millimetres)
{
    if (std::exchange(m_travel[place], millimetres) != millimetres)
        Q_EMIT changed();
}

void TrendTracks::setPassing(const std::set<BusId> &buses)
{
    const std::set<BusId> before = std::exchange(m_passing, buses);
    const auto isGone = [&](Place place) { return before.contains(place.bus) && !buses.contains(place.bus); };
    std::erase_if(m_travel, [&](const auto &travel) { return isGone(travel.first); });
    if (std::erase_if(m_shown, [&](const Shown &shown) { return isGone(shown.track.place); }) > 0)
        Q_EMIT changed();
}

QStringList TrendTracks::state() const
{
    QStringList state;
    for (const Shown &shown : m_shown) {
        QStringList words{shown.track.key(), unitKey(shown.unit)};
        if (shown.sharesAxis)
            words << sharing;
        if (m_passing.contains(shown.track.place.bus))
            words << passing;
        state << words.join(u' ');
    }
    for (const auto &[place, millimetres] : m_travel)
        if (!m_passing.contains(place.bus))
            state << QStringLiteral("%1 %2 %3").arg(travelling, place.key()).arg(millimetres, 0, 'g', 12);
    return state;
}

void TrendTracks::restore(const QStringList &state)
{
    m_shown.clear();
    m_travel.clear();
    for (const QString &line : state) {
        const QStringList words = line.split(u' ');
        const auto place = Place::parse(words.value(1));
        const auto isGone = [&](Place its) {
            return words.contains(passing) && !m_passing.contains(its.bus);
        };
        const double millimetres = words.value(2).toDouble();
        if (words.front() == travelling && place && millimetres > 0 && millimetres <= longestTravel)
            m_travel[*place] = millimetres;
        else if (const auto shown = shownOf(words);
                 shown && !isGone(shown->track.place) && !find(shown->track) && m_shown.size() < most)
            m_shown.push_back(*shown);
    }
    Q_EMIT changed();
}

} // namespace codewheel
