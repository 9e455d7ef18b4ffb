// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/object_value.h"

#include <algorithm>
#include <array>

namespace codewheel::canopen {
namespace {

constexpr std::array<std::size_t, 7> widths{1, 2, 4, 1, 2, 4, 0}; // in the order of ObjectType
constexpr std::size_t widestNumber = 8;
constexpr unsigned octetWidth = 8;

// Makers fill texts up with zeros, and few say how they code what is not ASCII.
QString textIn(Octets octets)
{
    const auto end = std::ranges::find(octets, 0);
    const QByteArray bytes(reinterpret_cast<const char *>(octets.data()), end - octets.begin());
    const QString text = QString::fromUtf8(bytes);
    return text.contains(QChar::ReplacementCharacter) ? QString::fromLatin1(bytes) : text;
}

std::int64_t numberIn(Octets octets, bool isSigned)
{
    std::uint64_t bits = 0;
    for (auto octet = octets.rbegin(); octet != octets.rend(); ++octet)
        bits = bits << octetWidth | *octet;
    const std::size_t unused = octetWidth * (widestNumber - octets.size());
    const bool isNegative = isSigned && !octets.empty() && (octets.back() & 0x80) != 0;
    if (isNegative && unused > 0)
        bits |= ~std::uint64_t{0} << (octetWidth * octets.size());
    return static_cast<std::int64_t>(bits);
}

} // namespace

std::size_t widthOf(ObjectType type)
{
    return widths.at(static_cast<std::size_t>(type));
}

bool isSigned(ObjectType type)
{
    return type == ObjectType::i8 || type == ObjectType::i16 || type == ObjectType::i32;
}

Value objectValue(ObjectType type, Octets octets, bool isSizeTold)
{
    if (type == ObjectType::text)
        return Value(textIn(octets));
    const std::size_t width = isSizeTold ? widestNumber : widthOf(type);
    return numberIn(octets.first(std::min({octets.size(), width, widestNumber})), isSigned(type));
}

std::vector<std::uint8_t> octetsOf(const Value &value, std::size_t width)
{
    if (value.isText()) {
        const QByteArray bytes = value.toString().toUtf8();
        return {bytes.begin(), bytes.end()};
    }
    std::vector<std::uint8_t> octets(width);
    auto bits = static_cast<std::uint64_t>(value.number());
    for (std::uint8_t &octet : octets) {
        octet = static_cast<std::uint8_t>(bits);
        bits >>= octetWidth;
    }
    return octets;
}

} // namespace codewheel::canopen
