// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/simulator/transmit_pdo.h"

#include "kinds/canopen/simulator/encoder_objects.h"

#include <algorithm>

namespace codewheel::canopen {
namespace {

constexpr std::uint32_t pdoOffBit = 1U << 31;
constexpr std::uint32_t noRemoteBit = 1U << 30;
constexpr std::uint32_t extendedBit = 1U << 29;
constexpr std::uint16_t firstCommunication = 0x1800;
constexpr std::uint16_t firstMapping = 0x1A00;
constexpr int lastOfSync = 240;
constexpr int firstRemote = 252;
constexpr int firstEvent = 254;

// An entry is index16 sub8 bits8.
SdoObject mappedObject(std::uint32_t entry)
{
    return {static_cast<std::uint16_t>(entry >> 16), static_cast<std::uint8_t>(entry >> 8)};
}

std::size_t mappedBits(std::uint32_t entry)
{
    return entry & 0xFF;
}

std::optional<AbortCode> entryRefusal(std::uint32_t entry, const ObjectDictionary &objects)
{
    const SimulatedObject *object = objects.find(mappedObject(entry));
    if (entry == 0 || (object != nullptr && object->isMappable && mappedBits(entry) == 8 * object->size()))
        return std::nullopt;
    return AbortCode::notMappable;
}

std::optional<AbortCode> countRefusal(const SimulatedObject &count, const ObjectDictionary &objects)
{
    if (count.value > mostMapped)
        return AbortCode::tooHigh;
    std::size_t bits = 0;
    for (std::uint8_t sub = 1; sub <= count.value; ++sub) {
        const std::uint32_t entry = objects.word(count.index, sub);
        if (entry == 0)
            return AbortCode::notMappable;
        bits += mappedBits(entry);
    }
    return bits > std::size_t{8} * CanFrame::mostBytes ? std::optional(AbortCode::pdoTooLong) : std::nullopt;
}

std::optional<AbortCode> identifierRefusal(const SimulatedObject &with, const ObjectDictionary &objects)
{
    const auto wanted = static_cast<std::uint32_t>(with.value);
    const std::uint32_t present = objects.word(with.index, 1);
    const bool staysOn = ((wanted | present) & pdoOffBit) == 0;
    const std::uint32_t identifier = wanted & largestStandardId;
    const bool isOther = identifier != (present & largestStandardId);
    const bool isRefused = (wanted & extendedBit) != 0 || identifier == 0 || (staysOn && isOther);
    return isRefused ? std::optional(AbortCode::range) : std::nullopt;
}

} // namespace

TransmitPdo::TransmitPdo(int number)
    : m_index(static_cast<std::uint16_t>(firstCommunication + number - 1))
    , m_mapping(static_cast<std::uint16_t>(firstMapping + number - 1))
{}

void TransmitPdo::begin()
{
    m_isWanted = false;
    m_syncs = 0;
    m_sentAt.reset();
    m_sent.clear();
}

bool TransmitPdo::isOff(const ObjectDictionary &objects) const
{
    return (objects.word(m_index, 1) & pdoOffBit) != 0 || objects.number(m_mapping) == 0;
}

bool TransmitPdo::isEventDriven(const ObjectDictionary &objects) const
{
    return objects.number(m_index, 2) >= firstEvent;
}

Instant TransmitPdo::inhibit(const ObjectDictionary &objects) const
{
    constexpr int unit = 100; // us
    return Instant(objects.number(m_index, 3) * unit);
}

Instant TransmitPdo::timer(const ObjectDictionary &objects) const
{
    return std::chrono::milliseconds(objects.number(m_index, 5));
}

std::vector<std::uint8_t> TransmitPdo::data(const ObjectDictionary &objects) const
{
    const auto count = static_cast<std::uint8_t>(objects.number(m_mapping));
    std::vector<std::uint8_t> data;
    for (std::uint8_t sub = 1; sub <= count; ++sub)
        if (const SimulatedObject *object = objects.find(mappedObject(objects.word(m_mapping, sub)))) {
            const auto octets = object->octets();
            data.insert(data.end(), octets.begin(), octets.end());
        }
    return data;
}

void TransmitPdo::sync(const ObjectDictionary &objects)
{
    const std::int64_t type = objects.number(m_index, 2);
    ++m_syncs;
    if (type == 0)
        m_isWanted = data(objects) != m_sent;
    else if (type <= lastOfSync)
        m_isWanted = m_syncs >= type;
}

void TransmitPdo::ask(std::uint32_t identifier, const ObjectDictionary &objects)
{
    const std::uint32_t own = objects.word(m_index, 1);
    if (identifier == (own & largestStandardId) && (own & noRemoteBit) == 0)
        m_isWanted = true;
}

std::optional<CanFrame> TransmitPdo::next(const ObjectDictionary &objects, Instant now)
{
    if (isOff(objects) || (m_sentAt && now < *m_sentAt + inhibit(objects)))
        return std::nullopt;
    auto octets = data(objects);
    const bool isTime = m_sentAt && timer(objects) > Instant{} && now >= *m_sentAt + timer(objects);
    const bool isEvent = isEventDriven(objects) && (isTime || octets != m_sent);
    if (!m_isWanted && !isEvent)
        return std::nullopt;
    CanFrame frame{.id = objects.word(m_index, 1) & largestStandardId,
                   .length = static_cast<std::uint8_t>(octets.size())};
    std::ranges::copy(octets, frame.bytes.begin());
    m_isWanted = false;
    m_syncs = 0;
    m_sentAt = now;
    m_sent = std::move(octets);
    return frame;
}

std::optional<Instant> TransmitPdo::wakesAt(const ObjectDictionary &objects,
                                            std::optional<Instant> changesAt) const
{
    if (isOff(objects))
        return std::nullopt;
    const Instant free = m_sentAt.value_or(Instant{}) + inhibit(objects);
    if (m_isWanted)
        return free;
    if (!isEventDriven(objects))
        return std::nullopt;
    std::optional<Instant> at = changesAt ? std::optional(std::max(*changesAt, free)) : std::nullopt;
    if (data(objects) != m_sent)
        at = free;
    if (m_sentAt && timer(objects) > Instant{})
        at = std::min(at.value_or(Instant::max()), std::max(free, *m_sentAt + timer(objects)));
    return at;
}

std::optional<AbortCode> pdoRefusal(const SimulatedObject &with, const ObjectDictionary &objects,
                                    const NodeQuirks &quirks)
{
    if (with.index >= firstMapping && with.index < firstMapping + transmitPdoCount) {
        if (quirks.hasFixedMapping)
            return AbortCode::readOnly;
        const auto communication = static_cast<std::uint16_t>(with.index - firstMapping + firstCommunication);
        const bool isOn = (objects.word(communication, 1) & pdoOffBit) == 0;
        if (isOn || (with.sub != 0 && objects.number(with.index) != 0))
            return AbortCode::access;
        return with.sub == 0 ? countRefusal(with, objects)
                             : entryRefusal(static_cast<std::uint32_t>(with.value), objects);
    }
    if (with.index >= firstCommunication && with.index < firstCommunication + transmitPdoCount) {
        if (with.sub == 1)
            return identifierRefusal(with, objects);
        if (with.sub == 2 && with.value > lastOfSync && with.value < firstRemote)
            return AbortCode::range;
    }
    return std::nullopt;
}

} // namespace codewheel::canopen
