// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/data_type.h"

#include <algorithm>
#include <array>

namespace codewheel::canopen {
namespace {

using Form = DataTypeFacts::Form;

constexpr std::array dataTypeRows{
    DataTypeFacts{DataType::boolean, "bool", Form::isUnsigned, 1},
    DataTypeFacts{DataType::i8, "i8", Form::isSigned, 8},
    DataTypeFacts{DataType::i16, "i16", Form::isSigned, 16},
    DataTypeFacts{DataType::i32, "i32", Form::isSigned, 32},
    DataTypeFacts{DataType::u8, "u8", Form::isUnsigned, 8},
    DataTypeFacts{DataType::u16, "u16", Form::isUnsigned, 16},
    DataTypeFacts{DataType::u32, "u32", Form::isUnsigned, 32},
    DataTypeFacts{DataType::real32, "real32", Form::real, 32},
    DataTypeFacts{DataType::text, "text", Form::text, 0},
    DataTypeFacts{DataType::octets, "octets", Form::text, 0},
    DataTypeFacts{DataType::unicode, "unicode", Form::text, 0},
    DataTypeFacts{DataType::timeOfDay, "time-of-day", Form::text, 0},
    DataTypeFacts{DataType::timeDifference, "time-difference", Form::text, 0},
    DataTypeFacts{DataType::domain, "domain", Form::text, 0},
    DataTypeFacts{DataType::i24, "i24", Form::isSigned, 24},
    DataTypeFacts{DataType::real64, "real64", Form::real, 64},
    DataTypeFacts{DataType::i40, "i40", Form::isSigned, 40},
    DataTypeFacts{DataType::i48, "i48", Form::isSigned, 48},
    DataTypeFacts{DataType::i56, "i56", Form::isSigned, 56},
    DataTypeFacts{DataType::i64, "i64", Form::isSigned, 64},
    DataTypeFacts{DataType::u24, "u24", Form::isUnsigned, 24},
    DataTypeFacts{DataType::u40, "u40", Form::isUnsigned, 40},
    DataTypeFacts{DataType::u48, "u48", Form::isUnsigned, 48},
    DataTypeFacts{DataType::u56, "u56", Form::isUnsigned, 56},
    DataTypeFacts{DataType::u64, "u64", Form::isUnsigned, 64},
};

} // namespace

const DataTypeFacts &factsOf(DataType type)
{
    return *std::ranges::find(dataTypeRows, type, &DataTypeFacts::type);
}

std::optional<DataType> dataTypeOf(std::int64_t number)
{
    const auto found = std::ranges::find(
        dataTypeRows, number, [](const DataTypeFacts &row) { return static_cast<std::int64_t>(row.type); });
    return found == dataTypeRows.end() ? std::nullopt : std::optional(found->type);
}

QString dataTypeKey(DataType type)
{
    return QLatin1String(factsOf(type).key);
}

bool isNumber(DataType type)
{
    const Form form = factsOf(type).form;
    return form == Form::isUnsigned || form == Form::isSigned;
}

} // namespace codewheel::canopen
