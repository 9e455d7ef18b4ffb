// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/typed_value.h"

#include "kinds/canopen/protocol/object_value.h"
#include "vocabulary/hex.h"

#include <bit>
#include <cmath>
#include <compare>

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
    const bool isMissingItsSign = number && *number < 0 && !isSigned;
    if (!number || isMissingItsSign || width == 0 || width > mostOctetsTyped ||
        !fitsInto(*number, width, isSigned))
        return std::nullopt;
    return octetsOf(Value(*number), width);
}

TypedOctets octetsOfReal(const QString &typed, std::size_t width)
{
    bool isNumber = false;
    const double number = typed.toDouble(&isNumber);
    if (!isNumber || !std::isfinite(number))
        return std::nullopt;
    if (width == sizeof(float)) {
        const auto shorter = static_cast<float>(number);
        return std::isfinite(shorter)
                   ? std::optional(
                         octetsOf(Value(std::int64_t{std::bit_cast<std::uint32_t>(shorter)}), width))
                   : std::nullopt;
    }
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
    if (!type) // what is negative has a sign
        return octetsOfNumber(typed.trimmed(), typed.trimmed().startsWith(u'-'), width);
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

namespace {

// Of 64 bits without a sign the bits are kept.
std::partial_ordering orderOfValues(const FileValue &one, const FileValue &other,
                                    std::optional<DataType> type)
{
    const auto *real = std::get_if<double>(&one.value);
    const auto *otherReal = std::get_if<double>(&other.value);
    if ((real == nullptr && one.number() == nullptr) || (otherReal == nullptr && other.number() == nullptr))
        return std::partial_ordering::unordered;
    if (real != nullptr || otherReal != nullptr)
        return (real != nullptr ? *real : static_cast<double>(*one.number())) <=>
               (otherReal != nullptr ? *otherReal : static_cast<double>(*other.number()));
    if (type && factsOf(*type).form == DataTypeFacts::Form::isUnsigned)
        return static_cast<std::uint64_t>(*one.number()) <=> static_cast<std::uint64_t>(*other.number());
    return *one.number() <=> *other.number();
}

} // namespace

std::optional<FileValue> limitBroken(const FileObject &object, const FileValue &value,
                                     std::optional<int> node)
{
    const auto low = object.minimum ? object.minimum->at(node) : std::nullopt;
    const auto high = object.maximum ? object.maximum->at(node) : std::nullopt;
    if (low && std::is_lt(orderOfValues(value, *low, object.type)))
        return low;
    return high && std::is_gt(orderOfValues(value, *high, object.type)) ? high : std::nullopt;
}

} // namespace codewheel::canopen
