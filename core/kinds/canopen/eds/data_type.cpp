// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/data_type.h"

#include <algorithm>
#include <array>

namespace codewheel::canopen {
namespace {

using TypeForm = DataTypeFacts::Form;

constexpr std::array dataTypeRows{
    DataTypeFacts{DataType::boolean, "bool", TypeForm::isUnsigned, 1},
    DataTypeFacts{DataType::i8, "i8", TypeForm::isSigned, 8},
    DataTypeFacts{DataType::i16, "i16", TypeForm::isSigned, 16},
    DataTypeFacts{DataType::i32, "i32", TypeForm::isSigned, 32},
    DataTypeFacts{DataType::u8, "u8", TypeForm::isUnsigned, 8},
    DataTypeFacts{DataType::u16, "u16", TypeForm::isUnsigned, 16},
    DataTypeFacts{DataType::u32, "u32", TypeForm::isUnsigned, 32},
    DataTypeFacts{DataType::real32, "real32", TypeForm::real, 32},
    DataTypeFacts{DataType::text, "text", TypeForm::text, 0},
    DataTypeFacts{DataType::octets, "octets", TypeForm::text, 0},
    DataTypeFacts{DataType::unicode, "unicode", TypeForm::text, 0},
    DataTypeFacts{DataType::timeOfDay, "time-of-day", TypeForm::text, 0},
    DataTypeFacts{DataType::timeDifference, "time-difference", TypeForm::text, 0},
    DataTypeFacts{DataType::domain, "domain", TypeForm::text, 0},
    DataTypeFacts{DataType::i24, "i24", TypeForm::isSigned, 24},
    DataTypeFacts{DataType::real64, "real64", TypeForm::real, 64},
    DataTypeFacts{DataType::i40, "i40", TypeForm::isSigned, 40},
    DataTypeFacts{DataType::i48, "i48", TypeForm::isSigned, 48},
    DataTypeFacts{DataType::i56, "i56", TypeForm::isSigned, 56},
    DataTypeFacts{DataType::i64, "i64", TypeForm::isSigned, 64},
    DataTypeFacts{DataType::u24, "u24", TypeForm::isUnsigned, 24},
    DataTypeFacts{DataType::u40, "u40", TypeForm::isUnsigned, 40},
    DataTypeFacts{DataType::u48, "u48", TypeForm::isUnsigned, 48},
    DataTypeFacts{DataType::u56, "u56", TypeForm::isUnsigned, 56},
    DataTypeFacts{DataType::u64, "u64", TypeForm::isUnsigned, 64},
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
    const TypeForm form = factsOf(type).form;
    return form == TypeForm::isUnsigned || form == TypeForm::isSigned;
}

} // namespace codewheel::canopen
