// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/number_series.h"

#include <algorithm>
#include <bit>

namespace codewheel {
namespace {

// Numbers are added and subtracted modulo 2^64, so that any number may follow any other.
using Residuals = std::vector<std::uint64_t>;
constexpr std::size_t groupSize = 32; // residuals packed with the same number of bits

// What is packed of a distance: how far it is from the usual one, or from the distance before it.
enum class Order : std::uint8_t { distances = 1, changes = 2 };
constexpr std::uint8_t ofGrayCode =
    4; // added to it: the numbers are Gray code, and were taken as what it stands for

struct Plan
{
    Order order = Order::distances;
    std::uint64_t first = 0;
    std::uint64_t usual = 0; // distance; of changes: the first one
    Residuals residuals;
    std::size_t bytes = 0;
};

unsigned widthOf(std::span<const std::uint64_t> group)
{
    std::uint64_t all = 0;
    for (const std::uint64_t residual : group)
        all |= residual;
    return static_cast<unsigned>(std::bit_width(all));
}

std::size_t bytesOf(std::size_t count, unsigned width)
{
    return (count * width + 7) / 8;
}

// Calls `with` for each group.
template <class With>
void forEachGroup(std::span<const std::uint64_t> residuals, With with)
{
    for (std::size_t begin = 0; begin < residuals.size(); begin += groupSize)
        with(residuals.subspan(begin, std::min(groupSize, residuals.size() - begin)));
}

Plan planned(Order order, std::uint64_t first, std::uint64_t usual, Residuals residuals)
{
    Plan plan{order, first, usual, std::move(residuals)};
    forEachGroup(plan.residuals,
                 [&](auto group) { plan.bytes += 1 + bytesOf(group.size(), widthOf(group)); });
    return plan;
}

std::uint64_t median(std::vector<std::int64_t> numbers)
{
    const auto middle = numbers.begin() + std::ssize(numbers) / 2;
    std::ranges::nth_element(numbers, middle);
    return static_cast<std::uint64_t>(*middle);
}

// The order that takes fewer bytes: of a steady motion with noise the first, of one that changes its speed
// the second.
Plan bestPlan(std::span<const std::int64_t> numbers)
{
    std::vector<std::int64_t> distances(numbers.size() - 1);
    for (std::size_t i = 0; i < distances.size(); ++i)
        distances[i] = static_cast<std::int64_t>(static_cast<std::uint64_t>(numbers[i + 1]) -
                                                 static_cast<std::uint64_t>(numbers[i]));
    const auto begin = static_cast<std::uint64_t>(numbers.front());
    if (distances.empty())
        return {.first = begin, .residuals = {}};
    const std::uint64_t usual = median(distances);
    const auto first = static_cast<std::uint64_t>(distances.front());
    Residuals fromUsual(distances.size());
    Residuals fromBefore(distances.size());
    std::uint64_t before = first;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const auto distance = static_cast<std::uint64_t>(distances[i]);
        fromUsual[i] = zigzag(distance - usual);
        fromBefore[i] = zigzag(distance - before);
        before = distance;
    }
    Plan distancesPlan = planned(Order::distances, begin, usual, std::move(fromUsual));
    Plan changesPlan = planned(Order::changes, begin, first, std::move(fromBefore));
    return changesPlan.bytes < distancesPlan.bytes ? changesPlan : distancesPlan;
}

std::uint64_t fromGray(std::uint64_t gray)
{
    for (unsigned shift = 1; shift < 64; shift *= 2)
        gray ^= gray >> shift;
    return gray;
}

std::uint64_t toGray(std::uint64_t number)
{
    return number ^ (number >> 1U);
}

// Puts numbers of some bits one behind the other, the lowest bit first.
void packBits(QByteArray &bytes, std::span<const std::uint64_t> group, unsigned width)
{
    std::uint64_t gathered = 0;
    unsigned bits = 0;
    const auto put = [&](std::uint64_t part, unsigned count) { // up to 32 bits
        gathered |= part << bits;
        for (bits += count; bits >= 8; bits -= 8, gathered >>= 8U)
            bytes.append(static_cast<char>(gathered & 0xFFU));
    };
    for (const std::uint64_t number : group) {
        put(number & 0xFFFFFFFFU & (width < 32 ? (std::uint64_t{1} << width) - 1 : ~std::uint64_t{0}),
            std::min(width, 32U));
        if (width > 32)
            put(number >> 32U, width - 32);
    }
    if (bits > 0)
        bytes.append(static_cast<char>(gathered));
}

class BitReader
{
public:
    explicit BitReader(QByteArrayView bytes)
        : m_bytes(bytes)
    {}
    std::uint64_t take(unsigned width)
    {
        const std::uint64_t low = part(std::min(width, 32U));
        return width > 32 ? low | part(width - 32) << 32U : low;
    }

private:
    std::uint64_t part(unsigned width)
    {
        for (; m_bits < width; m_bits += 8)
            m_gathered |= std::uint64_t{static_cast<std::uint8_t>(m_bytes[m_next++])} << m_bits;
        const std::uint64_t number = m_gathered & ((std::uint64_t{1} << width) - 1);
        m_gathered >>= width;
        m_bits -= width;
        return number;
    }

    QByteArrayView m_bytes;
    qsizetype m_next = 0;
    std::uint64_t m_gathered = 0;
    unsigned m_bits = 0;
};

// False: there is less.
bool unpackGroup(PackedBytes &bytes, std::size_t count, Residuals &residuals)
{
    const auto width = bytes.byte();
    if (!width || *width > 64)
        return false;
    const std::size_t size = bytesOf(count, *width);
    const QByteArrayView packed = bytes.bytes(size);
    if (static_cast<std::size_t>(packed.size()) != size)
        return false;
    BitReader bits(packed);
    for (std::size_t i = 0; i < count; ++i)
        residuals.push_back(bits.take(*width));
    return true;
}

} // namespace

std::optional<std::uint8_t> PackedBytes::byte()
{
    const QByteArrayView taken = bytes(1);
    return taken.isEmpty() ? std::nullopt : std::optional(static_cast<std::uint8_t>(taken.front()));
}

std::optional<std::uint64_t> PackedBytes::number()
{
    std::uint64_t number = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
        const auto next = byte();
        if (!next)
            return std::nullopt;
        number |= std::uint64_t{*next & 0x7FU} << shift;
        if ((*next & 0x80U) == 0)
            return number;
    }
    return std::nullopt;
}

QByteArrayView PackedBytes::bytes(std::size_t count)
{
    const auto size = static_cast<qsizetype>(std::min(count, static_cast<std::size_t>(m_rest.size())));
    const QByteArrayView taken = m_rest.first(size);
    m_rest = m_rest.sliced(size);
    return taken;
}

void packNumber(QByteArray &bytes, std::uint64_t number)
{
    for (; number >= 0x80U; number >>= 7U)
        bytes.append(static_cast<char>((number & 0x7FU) | 0x80U));
    bytes.append(static_cast<char>(number));
}

void packSeries(QByteArray &bytes, std::span<const std::int64_t> numbers)
{
    Plan plan = bestPlan(numbers);
    auto order = static_cast<std::uint8_t>(plan.order);
    if (plan.bytes > numbers.size()) { // a byte each is much for a motion
        std::vector<std::int64_t> meant(numbers.begin(), numbers.end());
        for (std::int64_t &number : meant)
            number = static_cast<std::int64_t>(fromGray(static_cast<std::uint64_t>(number)));
        if (Plan other = bestPlan(meant); other.bytes < plan.bytes) {
            plan = std::move(other);
            order = static_cast<std::uint8_t>(plan.order) | ofGrayCode;
        }
    }
    bytes.append(static_cast<char>(order));
    packNumber(bytes, zigzag(plan.first));
    packNumber(bytes, zigzag(plan.usual));
    forEachGroup(plan.residuals, [&](auto group) {
        const unsigned width = widthOf(group);
        bytes.append(static_cast<char>(width));
        packBits(bytes, group, width);
    });
}

std::optional<std::vector<std::int64_t>> unpackSeries(PackedBytes &bytes, std::size_t count)
{
    const auto kind = bytes.byte();
    const auto first = bytes.number();
    const auto usual = bytes.number();
    if (!first || !usual)
        return std::nullopt;
    const auto order = static_cast<Order>(*kind & ~ofGrayCode);
    const bool isGray = (*kind & ofGrayCode) != 0;
    if (order != Order::distances && order != Order::changes)
        return std::nullopt;
    Residuals residuals;
    for (std::size_t left = count - 1; left > 0; left -= std::min(left, groupSize))
        if (!unpackGroup(bytes, std::min(left, groupSize), residuals))
            return std::nullopt;
    std::vector<std::int64_t> numbers(count);
    std::uint64_t number = unzigzag(*first);
    std::uint64_t distance = unzigzag(*usual);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t residual = i > 0 ? unzigzag(residuals[i - 1]) : 0;
        if (order == Order::changes)
            distance += residual;
        if (i > 0)
            number += order == Order::changes ? distance : distance + residual;
        numbers[i] = static_cast<std::int64_t>(isGray ? toGray(number) : number);
    }
    return numbers;
}

} // namespace codewheel
