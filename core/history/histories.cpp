// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/histories.h"

#include <queue>

#include <iterator>
#include <numeric>
#include <utility>

namespace codewheel {
namespace {

constexpr Instant lately = std::chrono::seconds(60);

} // namespace

Histories::Histories(Buses &buses, QObject *parent)
    : QObject(parent)
    , m_buses(buses)
{
    connect(&buses, &Buses::changed, this, &Histories::watchAll);
    connect(&buses, &Buses::updated, this, &Histories::keepLimit);
    watchAll();
}

void Histories::watchAll()
{
    const std::size_t before = m_watched.size();
    for (EncoderBus *bus : m_buses.connected()) {
        watch(*bus);
        for (const Place place : bus->places())
            if (EncoderSession *encoder = bus->encoder(place))
                watch(place, *encoder);
    }
    if (m_watched.size() != before)
        Q_EMIT placesChanged();
}

void Histories::watch(EncoderBus &bus)
{
    connect(&bus, &EncoderBus::moved, this, &Histories::watchAll, Qt::UniqueConnection);
    connect(&bus, &EncoderBus::messaged, this, &Histories::addMessage, Qt::UniqueConnection);
    connect(&bus, &EncoderBus::valuesDropped, this, &Histories::addDropped, Qt::UniqueConnection);
}

// An encoder that was given another address takes its history along; another one at its place goes on in the
// same history, after a gap.
void Histories::watch(Place place, EncoderSession &encoder)
{
    const auto known = m_watched.find(place);
    if (known != m_watched.end() && known->second.encoder == &encoder)
        return;
    const auto elsewhere = std::ranges::find_if(
        m_watched, [&](const auto &watched) { return watched.second.encoder == &encoder; });
    if (elsewhere != m_watched.end()) {
        auto node = m_watched.extract(elsewhere);
        const Place before = std::exchange(node.key(), place);
        m_watched.insert_or_assign(place, std::move(node.mapped()));
        Q_EMIT moved(before, place);
        return;
    }
    Watched &its = m_watched[place];
    its.encoder = &encoder;
    if (const auto before = its.history.span())
        its.scales.beginAnew(before->to);
    connect(&encoder, &EncoderSession::shown, this,
            [this, &encoder](const ShownSeries &shown) { add(encoder, shown); });
    connect(&encoder, &EncoderSession::knownChanged, this, [this, &encoder] { takeScale(encoder); });
    takeScale(encoder);
}

Histories::Watched *Histories::watched(const EncoderSession &encoder)
{
    const auto found = m_watched.find(encoder.place());
    return found == m_watched.end() || found->second.encoder != &encoder ? nullptr : &found->second;
}

void Histories::takeScale(const EncoderSession &encoder)
{
    const EncoderBus *bus = m_buses.open(encoder.place().bus);
    Watched *its = watched(encoder);
    if (bus != nullptr && its != nullptr)
        its->scales.take(encoder, [bus](Instant at) { return bus->sinceEpoch(at); });
}

void Histories::add(const EncoderSession &encoder, const ShownSeries &shown)
{
    const EncoderBus *bus = m_buses.open(encoder.place().bus);
    Watched *its = watched(encoder);
    if (bus == nullptr || its == nullptr)
        return;
    for (ShownValues values : shown) {
        values.at = bus->sinceEpoch(values.at);
        its->history.add(values);
    }
}

void Histories::addMessage(const Message &message)
{
    if (!message.place)
        return;
    if (const EncoderBus *bus = m_buses.open(message.place->bus))
        insert({bus->sinceEpoch(message.at), message.place, message});
}

void Histories::note(Instant at, const QString &text)
{
    std::erase_if(m_ownMarks, [at](const Mark &mark) { return mark.isNote() && mark.at == at; });
    mixMarks();
    if (text.isEmpty())
        tellMarks();
    else
        insert({at, {}, text});
    Q_EMIT noted(at, text);
}

// Once for all that came in one go: a burst of messages is drawn once.
void Histories::tellMarks()
{
    if (std::exchange(m_marksAreToTell, true))
        return;
    QMetaObject::invokeMethod(
        this,
        [this] {
            m_marksAreToTell = false;
            Q_EMIT marksChanged();
        },
        Qt::QueuedConnection);
}

void Histories::insert(const Mark &mark)
{
    const auto insertInto = [&mark](std::deque<Mark> &marks) {
        marks.insert(std::ranges::upper_bound(marks, mark.at, {}, &Mark::at), mark);
    };
    insertInto(m_ownMarks);
    if (!m_archives.empty())
        insertInto(m_mixedMarks);
    if (m_ownMarks.size() > mostMarks) {
        if (!m_archives.empty())
            m_mixedMarks.erase(std::ranges::find(m_mixedMarks, m_ownMarks.front()));
        m_ownMarks.pop_front();
    }
    tellMarks();
}

void Histories::mixMarks()
{
    m_mixedMarks.clear();
    if (m_archives.empty())
        return;
    m_mixedMarks = m_ownMarks;
    for (const Archive *archive : m_archives) {
        const std::vector<Mark> its = archive->marks();
        const auto own = static_cast<std::ptrdiff_t>(m_mixedMarks.size());
        m_mixedMarks.insert(m_mixedMarks.end(), its.begin(), its.end());
        std::ranges::inplace_merge(m_mixedMarks, m_mixedMarks.begin() + own, {}, &Mark::at);
    }
}

void Histories::takeArchives()
{
    mixMarks();
    tellMarks();
    Q_EMIT archivesChanged();
}

void Histories::add(Archive &archive)
{
    m_archives.push_back(&archive);
    connect(&archive, &Archive::changed, this, &Histories::takeArchives);
    connect(&archive, &Archive::statisticsReady, this, &Histories::statisticsReady);
    connect(&archive, &Archive::troubled, this, &Histories::archiveTroubled);
    connect(&archive, &QObject::destroyed, this, &Histories::remove);
    takeArchives();
    Q_EMIT placesChanged();
}

// Only its address is known by then.
void Histories::remove(const QObject *archive)
{
    std::erase_if(m_archives, [archive](const QObject *one) { return one == archive; });
    takeArchives();
    Q_EMIT placesChanged();
}

Archive *Histories::archiveOf(Place place) const
{
    const auto found = std::ranges::find_if(m_archives, [place](const Archive *archive) {
        return std::ranges::count(archive->places(), place) > 0;
    });
    return found == m_archives.end() ? nullptr : *found;
}

std::vector<Place> Histories::places() const
{
    std::vector<Place> places;
    for (const auto &[place, watched] : m_watched)
        places.push_back(place);
    for (const Archive *archive : m_archives)
        std::ranges::copy(archive->places(), std::back_inserter(places));
    return places;
}

const EncoderHistory *Histories::of(Place place) const
{
    const auto found = m_watched.find(place);
    return found == m_watched.end() ? nullptr : &found->second.history;
}

const History *Histories::of(Place place, Channel channel) const
{
    if (const EncoderHistory *history = of(place))
        return &history->of(channel);
    const Archive *archive = archiveOf(place);
    return archive == nullptr ? nullptr : archive->of(place, channel);
}

std::vector<ScaleSince> Histories::scales(Place place) const
{
    if (const auto found = m_watched.find(place); found != m_watched.end())
        return found->second.scales.all();
    const Archive *archive = archiveOf(place);
    const EncoderSession *encoder = m_buses.encoder(place);
    if (archive == nullptr || encoder == nullptr)
        return {};
    std::vector<ScaleSince> scales;
    for (const ValuesSince &since : archive->known(place)) {
        const StepScale scale = stepScale(
            encoder->device(), [&since](Parameter parameter) { return valueOf(since.values, parameter); });
        if (scale.isKnown() && (scales.empty() || scales.back().scale != scale))
            scales.push_back({since.from + archive->shift(), scale});
    }
    return scales;
}

std::vector<ValuesSince> Histories::known(Place place) const
{
    if (const auto found = m_watched.find(place); found != m_watched.end())
        return found->second.scales.known();
    const Archive *archive = archiveOf(place);
    return archive == nullptr ? std::vector<ValuesSince>() : archive->known(place);
}

std::optional<TimeSpan> Histories::span() const
{
    std::optional<TimeSpan> all;
    for (const auto &[place, watched] : m_watched)
        if (const auto its = watched.history.span())
            all = all ? TimeSpan{std::min(all->from, its->from), std::max(all->to, its->to)} : *its;
    return all;
}

std::size_t Histories::bytes() const
{
    return std::accumulate(
        m_watched.begin(), m_watched.end(), std::size_t{0},
        [](std::size_t sum, const auto &watched) { return sum + watched.second.history.bytes(); });
}

void Histories::setLimit(std::size_t bytes)
{
    m_limit = bytes;
    keepLimit();
}

// What ends earliest goes first, so that all reach back equally far. Histories that began together have their
// blocks full together, so that many may have to go at once.
void Histories::keepLimit()
{
    std::size_t used = bytes();
    if (used <= m_limit)
        return;
    using Next = std::pair<Instant, EncoderHistory *>; // where its oldest block ends
    std::priority_queue<Next, std::vector<Next>, std::greater<>> toGo;
    const auto queue = [&toGo](EncoderHistory &history) {
        if (const auto end = history.oldestBlockEnd())
            toGo.emplace(*end, &history);
    };
    for (auto &[place, watched] : m_watched)
        queue(watched.history);
    while (used > m_limit && !toGo.empty()) {
        EncoderHistory &history = *toGo.top().second;
        toGo.pop();
        used -= history.bytes();
        history.forgetOldest();
        used += history.bytes();
        queue(history);
    }
}

std::optional<Instant> Histories::reach() const
{
    double bytesPerSecond = 0;
    for (const auto &[place, watched] : m_watched)
        bytesPerSecond += watched.history.samplesPerSecond(lately) * SampleBlock::bytesPerSample;
    if (bytesPerSecond == 0)
        return {};
    return std::chrono::duration_cast<Instant>(
        std::chrono::duration<double>(static_cast<double>(m_limit) / bytesPerSecond));
}

} // namespace codewheel
