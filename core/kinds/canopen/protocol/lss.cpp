// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/lss.h"

#include "kinds/canopen/protocol/cob_id.h"
#include "kinds/canopen/protocol/frames.h"

#include <array>

namespace codewheel::canopen {
namespace {

constexpr std::size_t lssFrameSize = 8;
constexpr std::size_t bitAt = 5;
constexpr std::size_t wordAt = 6;
constexpr std::size_t nextWordAt = 7;

} // namespace

std::optional<LssFrame> LssFrame::read(Octets data)
{
    if (data.size() != lssFrameSize)
        return std::nullopt;
    return LssFrame{.command = static_cast<LssCommand>(data[0]),
                    .number = numberOf(data.subspan(1, 4)),
                    .bit = data[bitAt],
                    .word = data[wordAt],
                    .nextWord = data[nextWordAt]};
}

CanFrame LssFrame::request() const
{
    std::array<std::uint8_t, lssFrameSize> data{static_cast<std::uint8_t>(command)};
    putNumber(std::span(data).subspan(1, sizeof number), number);
    data[bitAt] = bit;
    data[wordAt] = word;
    data[nextWordAt] = nextWord;
    return frameOf(CobId{.service = CobId::Service::lssRequest}.identifier(), data);
}

} // namespace codewheel::canopen
