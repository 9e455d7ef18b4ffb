// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/recording/recordings.h"

#include "app/window/buses/plant.h"

#include <QFileInfo>

#include <algorithm>
#include <chrono>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

// Above all that projects use.
constexpr int firstNumber = 100'001;
constexpr std::chrono::milliseconds longestFrame = 1s; // after which the window stood still
constexpr std::chrono::milliseconds leastBetweenLooks = 1s;
constexpr int shareOfLooks = 20; // a look may take so much of the time

// Recorded places without a row in `bus` belong to one as well.
std::vector<RecordedBus> busesOf(Playback &playback)
{
    std::vector<RecordedBus> buses = playback.buses();
    for (const RecordedEncoder &encoder : playback.encoders())
        if (std::ranges::find(buses, encoder.place().bus, &RecordedBus::bus) == buses.end())
            buses.push_back({encoder.place().bus, {}});
    return buses;
}

QString nameOf(const QString &file, const RecordedBus &bus, bool isOneOfSeveral)
{
    QString name = QFileInfo(file).completeBaseName();
    if (!isOneOfSeveral)
        return name;
    return bus.name.isEmpty() ? QStringLiteral("%1 %2").arg(name).arg(bus.bus.number)
                              : QStringLiteral("%1 %2").arg(name, bus.name);
}

} // namespace

std::optional<Place> Recordings::Open::shown(Place recorded) const
{
    const auto found = std::ranges::find(buses, recorded.bus, &std::pair<BusId, BusId>::first);
    return found == buses.end() ? std::nullopt : std::optional(Place{found->second, recorded.node});
}

Recordings::Recordings(Plant &plant, BusAtWork::Surroundings surroundings)
    : QObject(&plant)
    , m_plant(plant)
    , m_surroundings(std::move(surroundings))
    , m_betweenLooks(leastBetweenLooks)
{
    m_sincePassed.start();
    m_sinceLook.start();
}

// From there on all are.
BusId Recordings::freeId() const
{
    BusId id{firstNumber};
    for (const BusAtWork *bus : m_plant.all())
        if (bus->id().number >= id.number)
            id.number = bus->id().number + 1;
    return id;
}

void Recordings::showInTrend(const Open &open)
{
    Playback &playback = *open.playback;
    RecordingArchive *archive = open.archive.get();
    const auto follow = [&playback, archive] { archive->setPlayed(playback.position()); };
    connect(&playback, &Playback::positionChanged, archive, follow);
    connect(archive, &Archive::asked, &playback, [&playback](Instant moment) {
        playback.pause();
        playback.jumpTo(std::clamp(moment, playback.span().from, playback.span().to));
    });
    follow();
    m_plant.histories().add(*archive);
}

Result<BusId> Recordings::open(const QString &file)
{
    const QString path = QFileInfo(file).canonicalFilePath();
    const auto isSame = [&path](const Open &open) { return open.file == path; };
    if (const auto there = std::ranges::find_if(m_open, isSame); there != m_open.end())
        return there->buses.front().second;
    auto playback = Playback::open(path.isEmpty() ? file : path);
    if (!playback)
        return tl::unexpected(playback.error());
    Open opened{path, std::move(*playback)};
    const std::vector<RecordedBus> buses = busesOf(*opened.playback);
    if (buses.empty())
        return refuse(RefusalKind::badInput, RefusalId::recordingEmpty, {file});
    RecordingArchive::BusesHere here;
    for (BusId id = freeId(); const RecordedBus &bus : buses)
        here[bus.bus] = {id.number++};
    auto archive = RecordingArchive::open(opened.playback->file(), here);
    if (!archive)
        return tl::unexpected(archive.error());
    opened.archive = std::move(*archive);
    for (const RecordedBus &bus : buses) {
        const BusId id = here.at(bus.bus);
        opened.buses.emplace_back(bus.bus, id);
        m_plant.add(std::make_unique<ReplayAtWork>(
            m_surroundings,
            std::make_unique<ReplayBus>(opened.playback, bus.bus, id, nameOf(file, bus, buses.size() > 1),
                                        m_surroundings.catalog)));
    }
    showInTrend(opened);
    m_open.push_back(std::move(opened));
    Q_EMIT changed();
    return m_open.back().buses.front().second;
}

void Recordings::close(BusId bus)
{
    const auto has = [bus](const Open &open) {
        return std::ranges::find(open.buses, bus, &std::pair<BusId, BusId>::second) != open.buses.end();
    };
    const auto found = std::ranges::find_if(m_open, has);
    if (found == m_open.end())
        return;
    const Open closed = std::move(*found);
    m_open.erase(found);
    for (const auto &[recorded, shown] : closed.buses)
        if (BusAtWork *its = m_plant.find(shown))
            its->bus()->close();
    m_plant.removeUnneeded();
    Q_EMIT changed();
}

void Recordings::passTime()
{
    const std::chrono::milliseconds passed(m_sincePassed.restart());
    if (!m_surroundings.byThread)
        return;
    for (const Open &open : m_open)
        open.playback->advance(std::min(passed, longestFrame));
    lookAgain();
}

void Recordings::lookAgain()
{
    if (m_sinceLook.elapsed() < m_betweenLooks.count())
        return;
    m_sinceLook.start();
    for (const Open &open : m_open)
        if (!open.playback->head().hasEnded &&
            QFileInfo(open.file).lastModified() > open.playback->lookedAt()) {
            open.playback->lookAgain();
            open.archive->lookAgain();
        }
    m_betweenLooks =
        std::max(leastBetweenLooks, std::chrono::milliseconds(m_sinceLook.elapsed()) * shareOfLooks);
}

} // namespace codewheel
