// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/typed_value.h"

#include "kinds/canopen/protocol/object_value.h"
#include "vocabulary/hex.h"

#include <bit>

namespace codewheel::canopen {
namespace {

using TypedOctets = std::optional<std::vector<std::uint8_t>>;

constexpr std::size_t mostOctetsTyped = 8;

std::optional<std::int64_t> typedNumber(const QString &typed)
{
    if (!typed.startsWith(u'-'))
        return parseNumber(typed);
    const auto size = parseNumber(QStringView(typed).sliced(1));
    return size ? std::optional(-*size) : std::nullopt;
}

// What is negative is signed, whatever the type.
bool fitsInto(std::int64_t number, std::size_t width, bool isSigned)
{
    if (width >= mostOctetsTyped)
        return true;
    const auto bits = static_cast<unsigned>(8 * width);
    const std::int64_t most = (std::int64_t{1} << (isSigned ? bits - 1 : bits)) - 1;
    return number <= most && number >= (isSigned ? -most - 1 : 0);
}

TypedOctets octetsOfNumber(const QString &typed, bool isSigned, std::size_t width)
{
    const auto number = typedNumber(typed);
    if (!number || width == 0 || width > mostOctetsTyped ||
        !fitsInto(*number, width, isSigned || *number < 0))
        return std::nullopt;
    return octetsOf(Value(*number), width);
}

TypedOctets octetsOfReal(const QString &typed, std::size_t width)
{
    bool isNumber = false;
    const double number = typed.toDouble(&isNumber);
    if (!isNumber)
        return std::nullopt;
    if (width == sizeof(float))
        return octetsOf(Value(std::int64_t{std::bit_cast<std::uint32_t>(static_cast<float>(number))}), width);
    return octetsOf(Value(std::bit_cast<std::int64_t>(number)), sizeof(double));
}

TypedOctets octetsOfDigits(QString typed)
{
    typed.remove(u' ');
    const QByteArray bytes = QByteArray::fromHex(typed.toLatin1());
    if (bytes.isEmpty() || 2 * bytes.size() != typed.size())
        return std::nullopt;
    return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
}

} // namespace

TypedOctets octetsTyped(const QString &typed, std::optional<DataType> type, std::size_t width)
{
    using TypeForm = DataTypeFacts::Form;
    if (type == DataType::text)
        return octetsOf(Value(typed), 0);
    if (!type)
        return octetsOfNumber(typed.trimmed(), false, width);
    const DataTypeFacts &facts = factsOf(*type);
    const std::size_t wide = width != 0 ? width : static_cast<std::size_t>((facts.bits + 7) / 8);
    switch (facts.form) {
    case TypeForm::isSigned:
    case TypeForm::isUnsigned:
        return octetsOfNumber(typed.trimmed(), facts.form == TypeForm::isSigned, wide);
    case TypeForm::real:
        return octetsOfReal(typed.trimmed(), wide);
    case TypeForm::text:
        break;
    }
    return octetsOfDigits(typed);
}

} // namespace codewheel::canopen
