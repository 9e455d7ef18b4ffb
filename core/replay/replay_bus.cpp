// SPDX-License-Identifier: GPL-3.0-or-later
#include "replay/replay_bus.h"

#include "catalog/catalog.h"
#include "journal/stored_message.h"
#include "vocabulary/find_by.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr Instant longestPassed = std::chrono::seconds(2); // of which the traffic is told at once
constexpr int mostRowsRead = 20'000;                       // rows
constexpr int mostMessages = 100;                          // at once

// What a device is, whatever its values.
RecordedDevice withoutValues(RecordedDevice device)
{
    device.known.clear();
    return device;
}

std::unique_ptr<RecordedRows> rowsOf(Playback &playback, BusId bus, const Catalog &catalog)
{
    std::vector<Profile> profiles;
    bool hasWords = false;
    for (const RecordedEncoder &encoder : playback.encoders()) {
        if (encoder.place().bus != bus)
            continue;
        hasWords = hasWords || encoder.hasWords();
        for (const RecordedEncoder::Described &one : encoder.described())
            if (const DeviceDescription *device = catalog.find(one.device.key))
                profiles.push_back(device->profile);
    }
    return recordedRows(profiles, hasWords);
}

} // namespace

Refusal onlyRecorded()
{
    return {RefusalKind::notSupported, RefusalId::onlyRecorded, {}};
}

ReplayBus::ReplayBus(std::shared_ptr<Playback> playback, BusId recorded, BusId id, QString name,
                     const Catalog &catalog, QObject *parent)
    : EncoderBus(id, QDateTime::fromMSecsSinceEpoch(0), rowsOf(*playback, recorded, catalog)->columns(),
                 parent)
    , m_playback(std::move(playback))
    , m_recorded(recorded)
    , m_name(std::move(name))
    , m_catalog(catalog)
    , m_rows(rowsOf(*m_playback, recorded, catalog))
    , m_outline(*this)
{
    const auto &encoders = m_playback->encoders();
    for (std::size_t i = 0; i < encoders.size(); ++i)
        if (encoders[i].place().bus == recorded && !encoders[i].place().isEmpty())
            m_devices.push_back({i, placeOf(encoders[i].place().node)});
    std::ranges::sort(m_devices, {}, &Device::place);
    pump();
}

ReplayBus::~ReplayBus() = default;

std::vector<Place> ReplayBus::places() const
{
    std::vector<Place> places;
    for (const Device &device : m_devices)
        places.push_back(device.place);
    return places;
}

const ReplayBus::Device *ReplayBus::find(NodeId node) const
{
    return findBy(m_devices, node, [](const Device &device) { return device.place.node; });
}

EncoderSession *ReplayBus::encoderAt(NodeId node) const
{
    const Device *device = find(node);
    return device != nullptr ? device->session.get() : nullptr;
}

WordChannel *ReplayBus::channelAt(NodeId node) const
{
    const Device *device = find(node);
    return device != nullptr ? device->words.get() : nullptr;
}

std::optional<Participant> ReplayBus::found(Place place) const
{
    const Device *device = place.bus == id() ? find(place.node) : nullptr;
    if (device == nullptr)
        return {};
    Participant participant{.number = place.node, .deviceKey = device->described.key};
    if (device->session)
        participant.deviceCode = device->session->device().deviceCode;
    return participant;
}

Result<void> ReplayBus::canBe(Place, const DeviceDescription &) const
{
    return tl::unexpected(onlyRecorded());
}

Result<void> ReplayBus::name(Place, const QString &, int, int)
{
    return tl::unexpected(onlyRecorded());
}

void ReplayBus::setOperate(bool on)
{
    if (on)
        tell({.at = now(), .severity = Severity::attention, .refusal = onlyRecorded()});
}

void ReplayBus::close()
{
    if (!std::exchange(m_isOpen, false))
        return;
    m_playback->pause();
    tellState();
}

void ReplayBus::advance(Instant duration)
{
    const auto &buses = m_playback->buses();
    if (buses.empty() || buses.front().bus == m_recorded)
        m_playback->advance(duration);
    pump();
}

// A session that is told of views until they have been told of the new one.
bool ReplayBus::describe(Device &device)
{
    const RecordedEncoder::Described *described = recordedOf(device).describedAt(m_shownAt);
    const RecordedDevice what = described != nullptr ? withoutValues(described->device) : RecordedDevice();
    const bool isFirst = m_jumps < 0;
    if (!isFirst && what == device.described)
        return false;
    device.described = what;
    const DeviceDescription *known = m_catalog.find(what.key);
    m_retired.push_back(std::move(device.session));
    m_retired.push_back(std::move(device.words));
    if (known != nullptr)
        device.session = std::make_unique<ReplayEncoderSession>(
            *this, device.place, known->labelled(what.turns, what.stepsPerTurn));
    if (recordedOf(device).hasWords())
        device.words = std::make_unique<WordChannel>(
            *this, device.place, known != nullptr ? known->inWords : 2,
            known != nullptr ? known->outWords : 2,
            [](const WordChannel &, Word) -> Result<void> { return tl::unexpected(onlyRecorded()); });
    return true;
}

void ReplayBus::describeAll()
{
    bool isOther = false;
    for (Device &device : m_devices)
        isOther = describe(device) || isOther;
    if (isOther)
        Q_EMIT nodesChanged();
    m_retired.clear();
}

void ReplayBus::pump()
{
    if (!m_isOpen || (m_shownAt == m_playback->position() && m_jumps == m_playback->jumps()))
        return;
    const Instant before = std::exchange(m_shownAt, m_playback->position());
    const bool isOnward = m_jumps == m_playback->jumps();
    describeAll();
    m_jumps = m_playback->jumps();
    for (const Device &device : m_devices)
        show(device, isOnward ? before : m_shownAt);
    const Instant behind = m_shownAt + Instant(1);
    const bool goesOn = isOnward && m_shownAt - before <= longestPassed;
    if (!goesOn) {
        m_rows->restart();
        Q_EMIT trafficRestarted();
    }
    tellTrafficOf({goesOn ? before + Instant(1) : behind - longestPassed, behind},
                  goesOn ? mostRowsAtOnce : mostRowsBefore);
    if (isOnward)
        tellMessagesOf({before + Instant(1), behind});
    Q_EMIT updated();
}

void ReplayBus::show(const Device &device, Instant from)
{
    RecordedEncoder &recorded = recordedOf(device);
    const RecordedEncoder::Moment moment = recorded.at(m_shownAt);
    const RecordedEncoder::Described *described = recorded.describedAt(m_shownAt);
    if (device.session && described != nullptr)
        device.session->show(moment, m_shownAt, *described);
    if (!device.words)
        return;
    const auto &in = moment.of(Channel::in);
    const auto &out = moment.of(Channel::out);
    device.words->show({.in = static_cast<Word>(in.value_or(0)),
                        .out = static_cast<Word>(out.value_or(0)),
                        .inEdges = in ? recorded.changedBits(Channel::in, from, m_shownAt) : 0,
                        .outEdges = out ? recorded.changedBits(Channel::out, from, m_shownAt) : 0},
                       Freshness::ofRecording(in || out ? std::optional(m_shownAt) : std::nullopt),
                       m_shownAt);
}

void ReplayBus::tellTrafficOf(const TimeSpan &span, std::size_t most)
{
    auto rows = m_playback->reader().traffic(span, mostRowsRead);
    if (!rows)
        return;
    std::erase_if(*rows, [this](const RecordedTraffic &row) { return row.bus != m_recorded; });
    const auto its = [this](Place place) -> const EncoderSession * { return encoder(place); };
    for (std::size_t i = rows->size() - std::min(most, rows->size()); i < rows->size(); ++i) {
        TrafficRow row = (*rows)[i].row;
        row.at = (*rows)[i].at;
        if (row.place)
            row.place = placeOf(row.place->node);
        tellTraffic(m_rows->explained(std::move(row), its));
    }
}

// What the program said then that concerns no bus is told by the first one.
void ReplayBus::tellMessagesOf(const TimeSpan &span)
{
    const auto stored = m_playback->reader().messages(span, mostMessages);
    if (!stored)
        return;
    const bool isFirst = m_playback->buses().empty() || m_playback->buses().front().bus == m_recorded;
    for (const RecordingReader::StoredAt &one : *stored) {
        const auto &place = one.message.place;
        if (place ? place->bus != m_recorded : !isFirst)
            continue;
        if (auto message = messageOf(one.message)) {
            message->at = one.at;
            tell(std::move(*message));
        }
    }
}

} // namespace codewheel
