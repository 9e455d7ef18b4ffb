// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/typed_value.h"
#include "kinds/canopen/protocol/object_value.h"

#include <bit>

namespace codewheel::canopen {
namespace {

constexpr std::size_t widestOctets = 8;
constexpr std::size_t shortReal = 4;

FileValue hexadecimalText(Octets octets)
{
    const QByteArray bytes(reinterpret_cast<const char *>(octets.data()),
                           static_cast<qsizetype>(octets.size()));
    return {QString::fromLatin1(bytes.toHex())};
}

FileValue realIn(Octets octets)
{
    const auto bits = static_cast<std::uint64_t>(objectValue(ObjectType::u32, octets).number());
    if (octets.size() == shortReal)
        return {static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))};
    return {std::bit_cast<double>(bits)};
}

} // namespace

FileValue fileValueOf(std::optional<DataType> type, Octets octets)
{
    using TypeForm = DataTypeFacts::Form;
    if (type == DataType::text)
        return {objectValue(ObjectType::text, octets).toString()};
    const bool hasNumber = !octets.empty() && octets.size() <= widestOctets;
    const TypeForm form = type ? factsOf(*type).form : TypeForm::isUnsigned;
    if (!hasNumber || form == TypeForm::text)
        return hexadecimalText(octets);
    if (form == TypeForm::real && (octets.size() == shortReal || octets.size() == widestOctets))
        return realIn(octets);
    const ObjectType sign = form == TypeForm::isSigned ? ObjectType::i32 : ObjectType::u32;
    return {objectValue(sign, octets).number()};
}

} // namespace codewheel::canopen
