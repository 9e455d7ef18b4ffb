// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>
#include <optional>

namespace codewheel::canopen {

// A basic data type of CiA 301, by its number there.
enum class DataType : std::uint8_t {
    boolean = 0x01,
    i8 = 0x02,
    i16 = 0x03,
    i32 = 0x04,
    u8 = 0x05,
    u16 = 0x06,
    u32 = 0x07,
    real32 = 0x08,
    text = 0x09,
    octets = 0x0A,
    unicode = 0x0B,
    timeOfDay = 0x0C,
    timeDifference = 0x0D,
    domain = 0x0F,
    i24 = 0x10,
    real64 = 0x11,
    i40 = 0x12,
    i48 = 0x13,
    i56 = 0x14,
    i64 = 0x15,
    u24 = 0x16,
    u40 = 0x18,
    u48 = 0x19,
    u56 = 0x1A,
    u64 = 0x1B,
};

struct DataTypeFacts
{
    enum class Form : std::uint8_t { isUnsigned, isSigned, real, text };

    DataType type;
    const char *key; // "u32"
    Form form;
    int bits; // of a number; 0: any length
};

const DataTypeFacts &factsOf(DataType type);
std::optional<DataType> dataTypeOf(std::int64_t number); // empty: it is none of them
QString dataTypeKey(DataType type);
bool isNumber(DataType type); // a whole one

} // namespace codewheel::canopen
