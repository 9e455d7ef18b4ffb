// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/gateway_map.h"

#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/gateway/gateway_texts.h"
#include "vocabulary/sentence.h"

#include <algorithm>
#include <set>

namespace codewheel {
namespace {

tl::unexpected<Refusal> mapWrong(const QString &text)
{
    return refuse(RefusalKind::badInput, GatewayRefusalId::registerMapWrong, {text});
}

// Each device's registers, and after them the first one that belongs to no device.
std::vector<RegisterBlock> placed(const RingStructure &ring, int RingDevice::*count, int first, int &end)
{
    std::vector<RegisterBlock> blocks;
    for (const RingDevice &device : ring) {
        blocks.push_back({first, std::min(device.*count, GatewayMap::wordRegisters)});
        first += device.*count;
    }
    end = first;
    return blocks;
}

// As long as possible, but not as long as one in `lengths` (see the class). What is between devices is
// bridged only if it may be.
std::vector<RegisterBlock> inFew(const std::vector<RegisterBlock> &devices, int longest, bool bridgesGaps,
                                 std::set<int> &lengths)
{
    std::vector<RegisterBlock> blocks;
    auto device = devices.begin();
    while (device != devices.end()) {
        if (device->count == 0) {
            ++device;
            continue;
        }
        RegisterBlock block{device->first, 0};
        auto behind = device;
        std::vector<decltype(behind)> ends;
        for (; behind != devices.end() && behind->end() - block.first <= longest; ++behind) {
            if (behind->count == 0)
                continue;
            if (!bridgesGaps && !ends.empty() && behind->first != std::prev(ends.back())->end())
                break;
            ends.push_back(std::next(behind));
        }
        while (ends.size() > 1 && lengths.contains(std::prev(ends.back())->end() - block.first))
            ends.pop_back();
        block.count = std::prev(ends.back())->end() - block.first;
        lengths.insert(block.count);
        blocks.push_back(block);
        device = ends.back();
    }
    return blocks;
}

bool overlap(const RegisterBlock &one, const RegisterBlock &other)
{
    return one.first < other.end() && other.first < one.end();
}

} // namespace

GatewayMap::GatewayMap(const RingStructure &ring, const GatewaySettings &settings)
    : m_highWordFirst(settings.highWordFirst)
    , m_mostWritten(settings.writesWithRead ? std::min(settings.mostWritten, modbus_limit::writtenWithRead)
                                            : settings.mostWritten)
{
    int inEnd = 0;
    int outEnd = 0;
    m_in = placed(ring, &RingDevice::inWords, settings.inFirst, inEnd);
    m_out = placed(ring, &RingDevice::outWords, settings.outFirst, outEnd);
    std::set<int> reads;
    m_inBlocks = inFew(m_in, settings.mostRead, true, reads);
    if (settings.inArea == RegisterArea::input)
        reads.clear(); // by another function
    m_readBackBlocks = inFew(m_out, settings.mostRead, true, reads);
    m_outBlocks = outBlocksOf(std::vector<bool>(m_out.size(), true));
}

std::vector<RegisterBlock> GatewayMap::outBlocksOf(const std::vector<bool> &devices) const
{
    std::vector<RegisterBlock> those;
    for (std::size_t i = 0; i < m_out.size(); ++i)
        those.push_back({m_out[i].first, devices[i] ? m_out[i].count : 0});
    std::set<int> writes;
    return inFew(those, m_mostWritten, false, writes);
}

void GatewayMap::writeAtMost(int registers)
{
    m_mostWritten = registers;
    m_outBlocks = outBlocksOf(std::vector<bool>(m_out.size(), true));
}

Result<GatewayMap> GatewayMap::of(const RingStructure &ring, const GatewaySettings &settings)
{
    int inEnd = 0;
    int outEnd = 0;
    placed(ring, &RingDevice::inWords, settings.inFirst, inEnd);
    placed(ring, &RingDevice::outWords, settings.outFirst, outEnd);
    const RegisterBlock in{settings.inFirst, inEnd - settings.inFirst};
    const RegisterBlock out{settings.outFirst, outEnd - settings.outFirst};
    if (inEnd - 1 > modbus_limit::lastRegister || outEnd - 1 > modbus_limit::lastRegister)
        return mapWrong(GatewayTexts::tr("The image of this ring would end behind register 65535."));
    if (settings.writesWithRead && settings.inArea != RegisterArea::holding)
        return mapWrong(
            GatewayTexts::tr("Function 23 reads holding registers only, and IN is in input registers."));
    if (settings.inArea == RegisterArea::holding && overlap(in, out))
        return mapWrong(sentence(GatewayTexts::tr("IN (registers %1 to %2) and OUT (%3 to %4) overlap."),
                                 {QString::number(in.first), QString::number(in.end() - 1),
                                  QString::number(out.first), QString::number(out.end() - 1)}));
    const auto isWithin = [&](const std::optional<int> &at) {
        const RegisterBlock its{at.value_or(0), 1};
        return at && (overlap(its, out) || (settings.inArea == RegisterArea::holding && overlap(its, in)));
    };
    if (isWithin(settings.controlRegister))
        return mapWrong(sentence(GatewayTexts::tr("The control register %1 is within the image."),
                                 {QString::number(*settings.controlRegister)}));
    if (isWithin(settings.watchdogRegister))
        return mapWrong(sentence(GatewayTexts::tr("The watchdog register %1 is within the image."),
                                 {QString::number(*settings.watchdogRegister)}));
    if (settings.placeRegister && settings.placeRegister == settings.statusRegister)
        return mapWrong(sentence(GatewayTexts::tr("The register of the place is the status register, %1."),
                                 {QString::number(*settings.placeRegister)}));
    return GatewayMap(ring, settings);
}

// A device of 16 bits has them in the low half of its word.
Word GatewayMap::word(std::span<const Register> registers) const
{
    if (registers.empty())
        return 0;
    if (registers.size() == 1)
        return registers[0];
    const Word high = registers[m_highWordFirst ? 0 : 1];
    const Word low = registers[m_highWordFirst ? 1 : 0];
    return (high << 16) | low;
}

void GatewayMap::put(Word word, std::span<Register> registers) const
{
    const auto low = static_cast<Register>(word & 0xFFFF);
    const auto high = static_cast<Register>(word >> 16);
    if (registers.size() == 1)
        registers[0] = low;
    if (registers.size() < wordRegisters)
        return;
    registers[m_highWordFirst ? 0 : 1] = high;
    registers[m_highWordFirst ? 1 : 0] = low;
}

} // namespace codewheel
