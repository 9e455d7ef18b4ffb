// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace codewheel {

// Reads what BlockCodec wrote, from bytes that may be anything: beyond the end there is nothing.
class PackedBytes
{
public:
    explicit PackedBytes(QByteArrayView bytes)
        : m_rest(bytes)
    {}

    std::optional<std::uint8_t> byte();
    std::optional<std::uint64_t> number();   // 7 bits a byte, the lowest first
    QByteArrayView bytes(std::size_t count); // fewer where there are not so many
    bool isAtEnd() const { return m_rest.isEmpty(); }

private:
    QByteArrayView m_rest;
};

void packNumber(QByteArray &bytes, std::uint64_t number);

// Numbers that follow each other, such as the times or the values of a block, in as few bits as their
// distances take (docs/recording-files.md, "A block").
void packSeries(QByteArray &bytes, std::span<const std::int64_t> numbers);
// `count` of them; nothing: the bytes hold something else. No more memory is taken than the bytes account
// for.
std::optional<std::vector<std::int64_t>> unpackSeries(PackedBytes &bytes, std::size_t count);

// 0, -1, 1, -2, ... as 0, 1, 2, 3, ...: small numbers of either sign have few bits.
constexpr std::uint64_t zigzag(std::uint64_t number)
{
    return (number << 1U) ^ (0 - (number >> 63U));
}
constexpr std::uint64_t unzigzag(std::uint64_t number)
{
    return (number >> 1U) ^ (0 - (number & 1U));
}

} // namespace codewheel
