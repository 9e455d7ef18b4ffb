// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/served_units.h"

namespace codewheel {

ServedUnits::ServedUnits(std::shared_ptr<RingGuests> ring, Writing writing)
    : m_ofAll(std::make_shared<const ServedRing>(std::move(ring)))
    , m_writing(writing)
{}

ServedUnits::ServedUnits(const std::map<int, std::shared_ptr<RingGuests>> &rings, Writing writing)
    : m_writing(writing)
{
    for (const auto &[unit, ring] : rings)
        m_ofUnits.emplace(unit, std::make_shared<const ServedRing>(ring));
}

const ServedRing *ServedUnits::ringOf(int unit) const
{
    if (m_ofAll)
        return m_ofAll.get();
    const auto found = m_ofUnits.find(unit);
    return found == m_ofUnits.end() ? nullptr : found->second.get();
}

std::vector<int> ServedUnits::units() const
{
    std::vector<int> units;
    for (const auto &[unit, ring] : m_ofUnits)
        units.push_back(unit);
    return units;
}

ServedUnits::Answer ServedUnits::answer(int unit, std::span<const std::uint8_t> pdu) const
{
    const auto request = ModbusRequest::parse(pdu);
    const bool isWrite = request && !request->changes.empty();
    auto answer = request.and_then([&](const ModbusRequest &asked) { return carryOut(unit, pdu, asked); });
    if (!answer)
        return {.pdu = modbusAnswer(pdu, answer.error()), .isException = true, .isWrite = isWrite};
    answer->isWrite = isWrite;
    return *std::move(answer);
}

// Function 23 writes before it reads. Whether it can be read is known before anything is written.
tl::expected<ServedUnits::Answer, ModbusException>
ServedUnits::carryOut(int unit, std::span<const std::uint8_t> pdu, const ModbusRequest &request) const
{
    if (!request.changes.empty() && !mayWrite())
        return tl::unexpected(ModbusException::illegalFunction);
    const ServedRing *ring = ringOf(unit);
    if (ring == nullptr)
        return tl::unexpected(ModbusException::noSuchUnit);
    Answer answer;
    std::vector<Register> read;
    const auto readNow = [&]() -> tl::expected<void, ModbusException> {
        if (request.readCount == 0)
            return {};
        return ring->read(request.area, request.readFirst, request.readCount)
            .map([&](std::vector<Register> registers) { read = std::move(registers); });
    };
    if (const auto canBeRead = readNow(); !canBeRead)
        return tl::unexpected(canBeRead.error());
    if (!request.changes.empty()) {
        const auto written = ring->write(request.writeFirst, request.changes);
        if (!written)
            return tl::unexpected(written.error());
        answer.written = *written;
        if (const auto reread = readNow(); !reread)
            return tl::unexpected(reread.error());
    }
    answer.pdu = modbusAnswer(pdu, read);
    return answer;
}

} // namespace codewheel
