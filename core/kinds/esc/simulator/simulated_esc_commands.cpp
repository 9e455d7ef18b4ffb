// SPDX-License-Identifier: GPL-3.0-or-later
// The two tables of the manual, and how a request is looked up in them.
#include "kinds/esc/simulator/simulated_esc_encoder.h"
#include "vocabulary/find_by.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace codewheel {
namespace {

using Encoder = SimulatedEscEncoder;

constexpr QByteArrayView lineEnd = "\r\n";

QByteArray unknownCommand()
{
    return QByteArrayLiteral("03\r\n");
}

// Incomplete command, or a value out of range.
QByteArray refused()
{
    return QByteArrayLiteral("05\r\n");
}

QByteArray digits(std::uint32_t value, int count)
{
    return QByteArray::number(value, 16).toUpper().rightJustified(count, '0');
}

QByteArray inLineEnds(const QByteArray &text)
{
    return lineEnd.toByteArray() + text + lineEnd.toByteArray();
}

std::string_view lettersOf(QByteArrayView command)
{
    const qsizetype count = command.startsWith('G') ? 2 : 1;
    return {command.data(), static_cast<std::size_t>(std::min(count, command.size()))};
}

bool isHexDigit(char c)
{
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f');
}

} // namespace

struct SimulatedEscEncoder::ReadCommand
{
    std::string_view letters;
    int digits;
    std::uint32_t (*value)(const Encoder &);

    template <auto reg>
    static std::uint32_t kept(const Encoder &encoder)
    {
        return encoder.m_registers.*reg;
    }
    template <auto function>
    static std::uint32_t made(const Encoder &encoder)
    {
        return (encoder.*function)();
    }
    static const std::array<ReadCommand, 15> all;
};

struct SimulatedEscEncoder::WriteCommand
{
    std::string_view letters;
    int digits;
    std::uint32_t minimum;
    std::uint32_t maximum;
    bool (*carryOut)(Encoder &, std::uint32_t value); // false: out of range

    template <auto reg>
    static bool keep(Encoder &encoder, std::uint32_t value)
    {
        encoder.m_registers.*reg = value;
        return true;
    }
    template <auto setter>
    static bool set(Encoder &encoder, std::uint32_t value)
    {
        (encoder.m_registers.*setter)(value);
        return true;
    }
    template <auto function>
    static bool call(Encoder &encoder, std::uint32_t value)
    {
        return (encoder.*function)(value);
    }
    static const std::array<WriteCommand, 11> all;
};

// The version, V, is text and handled in answerTo().
constinit const std::array<Encoder::ReadCommand, 15> Encoder::ReadCommand::all{{
    {"O", 4, made<&Encoder::operatingParameters>},
    {"M", 8, kept<&EscRegisters::measuringRange>},
    {"D", 4, kept<&EscRegisters::stepsPerTurn>},
    {"S", 8, kept<&EscRegisters::preset>},
    {"A", 4, made<&Encoder::alarms>},
    {"E", 4, made<&Encoder::warnings>},
    {"T", 8, made<&Encoder::operatingTime>},
    {"C", 8, kept<&EscRegisters::offset>},
    {"N", 8, made<&Encoder::serialNumber>},
    {"H", 8, kept<&EscRegisters::upperLimit>},
    {"L", 8, kept<&EscRegisters::lowerLimit>},
    {"F", 8, kept<&EscRegisters::factor>},
    {"B", 4, made<&Encoder::deviceCode>},
    {"U", 4, kept<&EscRegisters::revolutions>},
    {"P", 8, made<&Encoder::positionNow>},
}};

// Of the ranges that the manual prints twice, the one that includes the limits. GL may be above GH (assumed).
constinit const std::array<Encoder::WriteCommand, 11> Encoder::WriteCommand::all{{
    {"GP", 8, 1, 33'554'431, call<&Encoder::writePreset>},
    {"GR", 8, 1, 8'192, set<&EscRegisters::setStepsPerTurn>},
    {"GM", 4, 1, 4'096, set<&EscRegisters::setRevolutions>},
    {"GT", 8, 1, 33'554'431, set<&EscRegisters::setMeasuringRange>},
    {"GL", 8, 1, 33'554'431, keep<&EscRegisters::lowerLimit>},
    {"GH", 8, 1, 33'554'431, keep<&EscRegisters::upperLimit>},
    {"GF", 8, 0, 0xFFFF'FFFF, call<&Encoder::writeFactor>},
    {"GD", 1, 0, 1, keep<&EscRegisters::countsCcw>},
    {"GS", 1, 0, 1, keep<&EscRegisters::isScaled>},
    {"X", 2, 0, 0xFF, call<&Encoder::writeAddress>},
    {"Y", 1, 0, 2, call<&Encoder::writeBaudRate>},
}};

QByteArray SimulatedEscEncoder::answerTo(QByteArrayView command)
{
    const std::string_view letters = lettersOf(command);
    const QByteArrayView data = command.sliced(static_cast<qsizetype>(letters.size()));
    if (letters.empty() || letters == "G")
        return refused();
    if (letters == "V")
        return data.isEmpty() ? inLineEnds(version()) : refused();
    if (const auto *row = findBy(ReadCommand::all, letters, &ReadCommand::letters))
        return data.isEmpty() ? inLineEnds(digits(row->value(*this), row->digits)) : refused();
    if (const auto *row = findBy(WriteCommand::all, letters, &WriteCommand::letters))
        return write(*row, data);
    return unknownCommand();
}

QByteArray SimulatedEscEncoder::write(const WriteCommand &row, QByteArrayView data)
{
    if (data.size() != row.digits || !std::ranges::all_of(data, isHexDigit))
        return refused();
    const std::uint32_t value = data.toByteArray().toUInt(nullptr, 16);
    if (value < row.minimum || value > row.maximum || !row.carryOut(*this, value))
        return refused();
    return lineEnd.toByteArray();
}

} // namespace codewheel
