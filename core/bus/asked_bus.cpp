// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/asked_bus.h"

#include "catalog/catalog.h"
#include "vocabulary/serial_number_text.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace codewheel {
namespace {

// Whether this may be on the label of an encoder that reports `told`, which is printed in decimal or in
// hexadecimal digits. Text that is no number, or empty, always may: on labels there is often more.
bool mayBeOnLabel(const QString &text, std::int64_t told)
{
    bool isDecimal = false;
    bool isHexadecimal = false;
    const auto decimal = text.toLongLong(&isDecimal);
    const auto hexadecimal = text.toLongLong(&isHexadecimal, 16);
    return !isHexadecimal || (isDecimal && decimal == told) || hexadecimal == told;
}

tl::unexpected<Refusal> nobodyAt(Place place)
{
    return refuse(RefusalKind::badInput, RefusalId::unknownDevice, {place.shown(), QString()});
}

} // namespace

AskedEncoder::AskedEncoder(AskedBus &bus, std::size_t device, NodeId node,
                           const DeviceDescription &description)
    : EncoderOnBus(bus, device, bus.placeOf(node), description)
    , m_bus(bus)
{}

Result<void> AskedEncoder::mayStart(const Job &job) const
{
    return m_bus.isOpen() ? m_bus.mayStart(job, place().shown()) : tl::unexpected(m_bus.closedRefusal());
}

void AskedEncoder::post(JobCommand command)
{
    m_bus.postJob(std::move(command));
}

AskedBus::AskedBus(BusId id, const QDateTime &begin, const Traits &traits, const Catalog &catalog,
                   QObject *parent)
    : EncoderBus(id, begin, traits.columns, parent)
    , m_traits(traits)
    , m_catalog(catalog)
{}

AskedBus::~AskedBus() = default;

Result<void> AskedBus::add(NodeId node, const QString &deviceKey)
{
    if (!isBegun())
        return tl::unexpected(closedRefusal());
    if (const EncoderSession *there = encoderAt(node))
        return refuse(RefusalKind::badInput, RefusalId::lineAddressTaken,
                      {m_traits.words.address(node), there->device().fullName()});
    if (auto may = mayAdd(node); !may)
        return may;
    const DeviceDescription *described = m_catalog.find(deviceKey);
    if (described == nullptr || described->profile != m_traits.words.profile)
        return refuse(RefusalKind::badInput, RefusalId::unknownDevice,
                      {deviceKey, QString::fromLatin1(m_traits.name)});
    take(node, *described);
    Q_EMIT nodesChanged();
    return {};
}

AskedEncoder &AskedBus::take(NodeId node, const DeviceDescription &device)
{
    auto description = std::make_unique<const DeviceDescription>(device);
    auto session = makeEncoder(m_encoders.size(), node, *description);
    const Encoder &its = m_encoders.emplace_back(Encoder{std::move(description), std::move(session)});
    startAsking(node, *its.description);
    return *its.session;
}

std::unique_ptr<AskedEncoder> AskedBus::makeEncoder(std::size_t device, NodeId node,
                                                    const DeviceDescription &description)
{
    return std::make_unique<AskedEncoder>(*this, device, node, description);
}

Result<void> AskedBus::remove(Place place)
{
    AskedEncoder *encoder = encoderAt(place.node);
    if (encoder == nullptr)
        return nobodyAt(place);
    if (encoder->runningJob())
        return refuse(RefusalKind::busy, RefusalId::jobRunning, {place.shown()});
    const auto ended = leave(*encoder); // whoever is told no longer finds it
    Q_EMIT nodesChanged();
    return {};
}

Result<void> AskedBus::renumber(Place from, NodeId to)
{
    AskedEncoder *before = encoderAt(from.node);
    if (before == nullptr)
        return nobodyAt(from);
    if (before->runningJob())
        return refuse(RefusalKind::busy, RefusalId::jobRunning, {from.shown()});
    if (const EncoderSession *there = encoderAt(to))
        return refuse(RefusalKind::badInput, RefusalId::lineAddressTaken,
                      {m_traits.words.address(to), there->device().fullName()});
    if (auto may = mayAdd(to); !may)
        return may;
    const DeviceDescription device = before->device();
    const auto ended = leave(*before);
    take(to, device).countEepromWrites(ended->eepromWrites());
    carryOver(*ended);
    Q_EMIT moved(from, placeOf(to));
    Q_EMIT nodesChanged();
    return {};
}

std::unique_ptr<AskedEncoder> AskedBus::leave(AskedEncoder &encoder)
{
    stopAsking(encoder.index());
    return std::move(m_encoders[encoder.index()].session);
}

void AskedBus::retireAll()
{
    std::ranges::move(std::exchange(m_encoders, {}), std::back_inserter(m_retired));
    endRetired();
}

void AskedBus::endRetired()
{
    if (!isPumping())
        m_retired.clear();
}

std::vector<Place> AskedBus::places() const
{
    std::vector<Place> places;
    for (const Encoder &encoder : m_encoders)
        if (encoder.session)
            places.push_back(encoder.session->place());
    std::ranges::sort(places);
    return places;
}

AskedEncoder *AskedBus::encoderAt(NodeId node) const
{
    for (const Encoder &encoder : m_encoders)
        if (encoder.session && encoder.session->place().node == node)
            return encoder.session.get();
    return nullptr;
}

AskedEncoder *AskedBus::encoderOf(std::size_t device) const
{
    return device < m_encoders.size() ? m_encoders[device].session.get() : nullptr;
}

Result<void> AskedBus::canBe(Place place, const DeviceDescription &device) const
{
    if (device.profile == m_traits.words.profile)
        return {};
    return refuse(RefusalKind::badInput, RefusalId::deviceOfOtherBus, {place.shown(), device.fullName()});
}

Result<void> AskedBus::name(Place place, const QString &deviceKey, int turns, int stepsPerTurn)
{
    AskedEncoder *before = encoderAt(place.node);
    const DeviceDescription *described = m_catalog.find(deviceKey);
    if (before == nullptr || described == nullptr)
        return nobodyAt(place);
    if (auto may = mayName(place, described); !may)
        return may;
    const auto ended = leave(*before);
    take(place.node, described->labelled(turns, stepsPerTurn)).countEepromWrites(ended->eepromWrites());
    carryOver(*ended);
    Q_EMIT named(place);
    Q_EMIT nodesChanged();
    return {};
}

std::optional<Participant> AskedBus::found(Place place) const
{
    const EncoderSession *there = encoder(place);
    return there != nullptr
               ? std::optional(Participant{.number = place.node, .deviceKey = there->device().key})
               : std::nullopt;
}

std::map<NodeId, Refusal> AskedBus::strangers(const std::vector<Participant> &planned) const
{
    std::map<NodeId, Refusal> strangers;
    for (const Participant &device : planned)
        if (encoderAt(device.number) == nullptr)
            strangers.emplace(device.number, whyNotThere(placeOf(device.number)));
    return strangers;
}

std::optional<Refusal> AskedBus::isOther(Place place, const QString &deviceKey,
                                         const QString &serialNumber) const
{
    const EncoderSession *there = encoder(place);
    if (there == nullptr)
        return std::nullopt;
    const DeviceDescription *planned = m_catalog.find(deviceKey);
    if (planned != nullptr && planned->key != there->device().key)
        return Refusal{RefusalKind::link,
                       RefusalId::deviceDiffers,
                       {place.shown(), planned->fullName(), there->device().fullName()}};
    const auto told = there->known(Parameter::serialNumber);
    if (!told || told->evidence != Evidence::read || mayBeOnLabel(serialNumber, told->value.number()))
        return std::nullopt;
    return Refusal{RefusalKind::link,
                   RefusalId::serialDiffers,
                   {place.shown(), serialNumber, serialNumberText(told->value.number())}};
}

} // namespace codewheel
