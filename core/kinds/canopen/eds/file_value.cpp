// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/file_value.h"

#include "kinds/canopen/eds/ini_text.h"

#include <QLocale>

#include <cmath>

namespace codewheel::canopen {
namespace {

using TypeForm = DataTypeFacts::Form;
constexpr int widestBits = 64;
constexpr std::uint64_t largestWithoutType = ~std::uint64_t{0} >> 1;

QString unsignedText(std::int64_t bits)
{
    return QString::number(static_cast<std::uint64_t>(bits));
}

QString shownNumber(std::int64_t number, std::optional<DataType> type)
{
    return type == DataType::u64 ? unsignedText(number) : QString::number(number);
}

// The number as the type has it. Empty: it does not fit.
std::optional<std::int64_t> fitted(const ReadNumber &number, TypeForm form, int bits)
{
    const std::uint64_t all = bits == widestBits ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
    const std::uint64_t signBit = std::uint64_t{1} << (bits - 1);
    const std::uint64_t magnitude = *number.magnitude;
    const auto negative = static_cast<std::int64_t>(~magnitude + 1);
    if (form == TypeForm::isUnsigned)
        return magnitude <= all && (!number.isNegative || magnitude == 0)
                   ? std::optional(static_cast<std::int64_t>(magnitude))
                   : std::nullopt;
    if (number.isNegative)
        return magnitude <= signBit ? std::optional(negative) : std::nullopt;
    if (magnitude < signBit)
        return static_cast<std::int64_t>(magnitude);
    if (!number.isHexadecimal || magnitude > all)
        return std::nullopt;
    return static_cast<std::int64_t>(magnitude | ~all);
}

ReadValue asInteger(std::string_view text, std::optional<DataType> type, bool addsNode)
{
    const ReadNumber number = readFileNumber(text);
    const QString written = textOf(text);
    if (!number.magnitude && !number.isTooLarge)
        return {{}, EdsFault::notANumber, {written}};
    const DataTypeFacts &facts = factsOf(type.value_or(DataType::i64));
    const auto value = number.magnitude && (type || *number.magnitude <= largestWithoutType)
                           ? fitted(number, facts.form, facts.bits)
                           : std::nullopt;
    if (!value)
        return {{}, EdsFault::doesNotFit, {written, dataTypeKey(facts.type)}};
    ReadValue read{.value = FileValue{*value, addsNode}, .fault = number.fault};
    if (read.fault)
        read.parts << shownNumber(*value, type);
    return read;
}

ReadValue asReal(std::string_view text)
{
    bool isReal = false;
    const double number = QLocale::c().toDouble(textOf(text), &isReal);
    if (!isReal || !std::isfinite(number))
        return {{}, EdsFault::notANumber, {textOf(text)}};
    return {.value = FileValue{number}};
}

ReadValue asText(std::string_view text)
{
    const bool isQuoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
    return {.value = FileValue{textOf(isQuoted ? text.substr(1, text.size() - 2) : text)}};
}

// What is added to the number of the node: of "$NODEID + 384" the 384, of "$NODEID" nothing. Empty: the text
// does not name it.
std::optional<std::string_view> addedToNode(std::string_view text)
{
    constexpr std::string_view name = "$NODEID";
    for (std::size_t at = 0; at + name.size() <= text.size(); ++at) {
        if (text[at] != name.front() || !isSameKey(text.substr(at, name.size()), name))
            continue;
        const std::string_view before = trimmed(text.substr(0, at));
        const std::string_view after = trimmed(text.substr(at + name.size()));
        if (before.empty() && (after.empty() || after.front() == '+'))
            return after.empty() ? "0" : trimmed(after.substr(1));
        if (after.empty() && before.back() == '+')
            return trimmed(before.substr(0, before.size() - 1));
        return std::nullopt;
    }
    return std::nullopt;
}

} // namespace

std::optional<FileValue> FileValue::at(std::optional<int> node) const
{
    if (!addsNode)
        return *this;
    if (!node || number() == nullptr)
        return std::nullopt;
    return FileValue{*number() + *node};
}

QString FileValue::text(std::optional<DataType> type) const
{
    if (const auto *real = std::get_if<double>(&value))
        return QLocale::c().toString(*real, 'g', QLocale::FloatingPointShortest);
    if (const auto *letters = std::get_if<QString>(&value))
        return *letters;
    const QString digits = shownNumber(*number(), type);
    return addsNode ? QStringLiteral("$NODEID+") + digits : digits;
}

ReadValue readFileValue(std::string_view text, std::optional<DataType> type)
{
    text = trimmed(text);
    if (text.empty())
        return {};
    if (type && factsOf(*type).form == TypeForm::text)
        return asText(text);
    if (const auto added = addedToNode(text))
        return asInteger(*added, type, true);
    if (type && factsOf(*type).form == TypeForm::real)
        return asReal(text);
    ReadValue read = asInteger(text, type, false);
    return type || read.fault != EdsFault::notANumber ? read : asText(text);
}

} // namespace codewheel::canopen
