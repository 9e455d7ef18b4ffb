// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/simulator/simulated_esc_encoder.h"

#include <array>

namespace codewheel {
namespace {

constexpr std::int64_t fastestSteps = 819; // steps per ms: 6000 rpm, above which it warns (assumed)
constexpr qsizetype digitsOfAddress = 2;
constexpr std::int64_t tenthHour = 360'000; // ms

} // namespace

SimulatedEscEncoder::SimulatedEscEncoder(const EscEncoderPlan &plan)
    : m_plan(plan)
    , m_shaft(PhysicalResolution{}, plan.raw)
    , m_registers(plan.fractionBits)
    , m_address(plan.address)
    , m_baudRate(plan.baudRate)
{
    m_shaft.setSpeed(plan.revolutionsPerMinute);
}

void SimulatedEscEncoder::cycle()
{
    m_shaft.advance();
    if (m_condition.powered)
        ++m_millisecondsOn;
}

std::optional<SimulatedEscEncoder::Reply> SimulatedEscEncoder::hear(char byte)
{
    const bool isDeaf =
        !m_condition.powered || (m_plan.interface == EscEncoderPlan::Interface::rs422 && m_condition.stOpen);
    if (isDeaf) {
        m_listener.hearJunk();
        return std::nullopt;
    }
    const auto text = m_listener.hear(byte);
    if (!text || text->size() < digitsOfAddress)
        return std::nullopt;
    const auto to = EscLineAddress::fromWire(QString::fromLatin1(text->first(digitsOfAddress)));
    if (!to || (!to->isMaster() && *to != m_address))
        return std::nullopt;
    const int baudRate = m_baudRate;
    const QByteArray answer = answerTo(QByteArrayView(*text).sliced(digitsOfAddress));
    if (m_condition.mute)
        return std::nullopt;
    return Reply{answer, baudRate};
}

EscMotion SimulatedEscEncoder::motion() const
{
    const std::uint32_t position = positionNow();
    const bool hasLimits = m_registers.hasLimits();
    return {.standsStill = m_shaft.speed() == 0,
            .turnsCcw = m_shaft.speed() < 0,
            .tooFast = m_shaft.isFasterThan(fastestSteps),
            .aboveUpperLimit = hasLimits && position > m_registers.upperLimit,
            .belowLowerLimit = hasLimits && position < m_registers.lowerLimit,
            .atPreset = position == m_registers.preset};
}

std::uint32_t SimulatedEscEncoder::operatingParameters() const
{
    const auto bit = [](int number, bool set) { return set ? 1U << number : 0U; };
    return bit(0, m_registers.countsCcw) | bit(2, m_registers.isScaled) |
           bit(12, m_registers.hasCalculatedFactor) | bit(13, m_registers.isPerTurn) |
           bit(14, m_registers.hasLimits());
}

std::uint32_t SimulatedEscEncoder::warnings() const
{
    const std::uint32_t word = escWarnings(m_condition, motion());
    return m_plan.swapsWarningBytes ? (word >> 8 | (word & 0xFF) << 8) : word;
}

std::uint32_t SimulatedEscEncoder::operatingTime() const
{
    return m_plan.operatingTime + static_cast<std::uint32_t>(m_millisecondsOn / tenthHour);
}

// 25 characters, as the manual says.
QByteArray SimulatedEscEncoder::version() const
{
    return m_plan.interface == EscEncoderPlan::Interface::rs485 ? "5882 RS485 V1.2 SIMULATED"
                                                                : "5882 RS422 V1.2 SIMULATED";
}

// A preset beyond the measuring range is out of range (assumed).
bool SimulatedEscEncoder::writePreset(std::uint32_t value)
{
    if (value >= m_registers.range())
        return false;
    m_registers.preset = value;
    m_registers.setPosition(value, m_shaft.raw(), falls());
    return true;
}

bool SimulatedEscEncoder::writeFactor(std::uint32_t value)
{
    if (value < m_registers.leastFactor() || value > m_registers.one())
        return false;
    m_registers.setFactor(value);
    return true;
}

bool SimulatedEscEncoder::writeAddress(std::uint32_t digits)
{
    const std::uint32_t tens = digits >> 4;
    const std::uint32_t ones = digits & 0xF;
    const bool isDecimal = m_plan.addressDigits == EscEncoderPlan::AddressDigits::decimal;
    if (isDecimal && (tens > 9 || ones > 9))
        return false;
    const EscLineAddress address{static_cast<std::uint8_t>(isDecimal ? tens * 10 + ones : digits)};
    if (!address.isDevice())
        return false;
    m_address = address;
    return true;
}

bool SimulatedEscEncoder::writeBaudRate(std::uint32_t choice)
{
    constexpr std::array rates{19'200, 9'600, 4'800};
    if (choice >= rates.size())
        return false;
    m_baudRate = rates[choice];
    return true;
}

} // namespace codewheel
