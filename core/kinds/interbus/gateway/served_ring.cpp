// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/served_ring.h"

#include "kinds/interbus/ring/master_status.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

using namespace served_registers;

constexpr std::chrono::seconds longestWait{2}; // for a cycle, while the computer is busy

// The registers from the beginning of an image to its end. Between devices, and behind the 32nd bit of one,
// they are 0.
std::vector<Register> registersOf(const GatewayMap &map, const std::vector<Word> &words,
                                  const RegisterBlock &(GatewayMap::*blockOf)(std::size_t) const, int size)
{
    std::vector<Register> registers(static_cast<std::size_t>(size));
    for (std::size_t i = 0; i < words.size(); ++i) {
        const RegisterBlock &block = (map.*blockOf)(i);
        map.put(words[i], std::span(registers).subspan(static_cast<std::size_t>(block.first),
                                                       static_cast<std::size_t>(block.count)));
    }
    return registers;
}

int sizeOf(const RingStructure &ring, int RingDevice::*words)
{
    int size = 0;
    for (const RingDevice &device : ring)
        size += device.*words;
    return size;
}

// An area of the map that holds all of these registers.
struct Area
{
    int first;
    int size;

    bool holds(int from, int count) const { return from >= first && from + count <= first + size; }
};

// What of a device is within the changes, as a word and its bits; empty: nothing.
std::optional<GuestWord> changeOf(const GatewayMap &map, std::size_t device, int first,
                                  const std::vector<ModbusRequest::Change> &changes)
{
    const RegisterBlock &block = map.out(device);
    std::array<Register, 2> values{};
    std::array<Register, 2> masks{};
    bool isWithin = false;
    for (int i = 0; i < block.count; ++i) {
        const int change = block.first + i - first;
        if (change < 0 || change >= static_cast<int>(changes.size()))
            continue;
        values.at(static_cast<std::size_t>(i)) = changes[static_cast<std::size_t>(change)].value;
        masks.at(static_cast<std::size_t>(i)) = changes[static_cast<std::size_t>(change)].mask;
        isWithin = true;
    }
    if (!isWithin)
        return std::nullopt;
    const auto count = static_cast<std::size_t>(block.count);
    return GuestWord{device, map.word(std::span(values).first(count)),
                     map.word(std::span(masks).first(count))};
}

// Whether each of the registers is one of a device.
bool areOfDevices(const GatewayMap &map, int first, int count)
{
    int found = 0;
    for (std::size_t i = 0; i < map.devices(); ++i) {
        const RegisterBlock &block = map.out(i);
        found += std::max(0, std::min(block.end(), first + count) - std::max(block.first, first));
    }
    return found == count;
}

ModbusException exceptionOf(const Refusal &why)
{
    return why.id == RefusalId::wordHeldByJob ? ModbusException::deviceBusy : ModbusException::deviceFailure;
}

} // namespace

GatewaySettings servedSettings(GatewaySettings settings)
{
    constexpr int runBit = 5;
    static_assert(diagnostic::run == 1U << runBit);
    settings.statusRegister = status;
    settings.runBit = runBit;
    settings.faultBits = diagnostic::bus | diagnostic::controller | diagnostic::systemFail;
    settings.placeRegister = parameter;
    return settings;
}

Result<GatewayMap> servedMap(const RingStructure &ring)
{
    return GatewayMap::of(ring, {.inArea = RegisterArea::input, .inFirst = in, .outFirst = out});
}

std::shared_ptr<const GatewayMap> ServedRing::mapOf(const GuestImage &image) const
{
    const std::scoped_lock lock(m_mutex);
    if (m_ringOfMap != image.ring) {
        m_ringOfMap = image.ring;
        m_map = nullptr;
        if (image.ring)
            if (auto map = servedMap(*image.ring))
                m_map = std::make_shared<const GatewayMap>(*std::move(map));
    }
    return m_map;
}

tl::expected<std::vector<Register>, ModbusException> ServedRing::read(RegisterArea area, int first,
                                                                      int count) const
{
    const GuestImage image = m_guests->image(longestWait);
    const auto map = mapOf(image);
    if (!map)
        return tl::unexpected(ModbusException::deviceFailure);
    const bool isHolding = area == RegisterArea::holding;
    const Area ins{isHolding ? inAsHolding : in, sizeOf(*image.ring, &RingDevice::inWords)};
    const Area outs{out, isHolding ? sizeOf(*image.ring, &RingDevice::outWords) : 0};
    const auto part = [&](const std::vector<Register> &all, int begin) {
        const auto from = all.begin() + (first - begin);
        return std::vector<Register>(from, from + count);
    };
    if (Area{status, end - status}.holds(first, count))
        return part({image.status, image.parameter}, status);
    if (ins.holds(first, count))
        return part(registersOf(*map, image.in, &GatewayMap::in, ins.size), ins.first);
    if (outs.holds(first, count))
        return part(registersOf(*map, image.out, &GatewayMap::out, outs.size), outs.first);
    return tl::unexpected(ModbusException::illegalAddress);
}

tl::expected<std::optional<ServedWord>, ModbusException>
ServedRing::write(int first, const std::vector<ModbusRequest::Change> &changes) const
{
    const GuestImage image = m_guests->image(longestWait);
    const auto map = mapOf(image);
    if (!map)
        return tl::unexpected(ModbusException::deviceFailure);
    if (!areOfDevices(*map, first, static_cast<int>(changes.size())))
        return tl::unexpected(ModbusException::illegalAddress);
    std::vector<GuestWord> words;
    for (std::size_t i = 0; i < map->devices(); ++i)
        if (const auto word = changeOf(*map, i, first, changes))
            words.push_back(*word);
    const auto sent = m_guests->write(image, words, longestWait);
    if (!sent)
        return tl::unexpected(exceptionOf(sent.error()));
    for (std::size_t i = words.size(); i-- > 0;)
        if (sent->words[i] != sent->before[i])
            return ServedWord{(*image.ring)[words[i].device].number, sent->words[i], sent->at};
    return std::nullopt;
}

} // namespace codewheel
