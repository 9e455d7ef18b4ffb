// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_line_address.h"
#include "kinds/esc/simulator/esc_condition.h"
#include "kinds/esc/simulator/esc_listener.h"
#include "kinds/esc/simulator/esc_registers.h"
#include "simulator/turning_shaft.h"

#include <optional>

namespace codewheel {

// A simulated encoder as it is found on the line.
struct EscEncoderPlan
{
    enum class Interface : std::uint8_t { rs485, rs422 };
    // How the digits of the command X are read: the manual prints 21, with 1Fh as the last address.
    enum class AddressDigits : std::uint8_t { hexadecimal, decimal };

    EscLineAddress address{1};
    Interface interface = Interface::rs485;
    std::int64_t raw = 0;            // physical position, steps
    double revolutionsPerMinute = 0; // positive: clockwise
    std::uint32_t serialNumber = 0;
    std::uint32_t operatingTime = 0; // 0.1 h
    int baudRate = 19'200;           // 19200, 9600, 4800
    // What the manual leaves open.
    AddressDigits addressDigits = AddressDigits::hexadecimal;
    int fractionBits = 29;          // of the scaling factor
    bool swapsWarningBytes = false; // as in the manual's example "0098"
};

// A Kübler 5882, 5862 or 9081 with the ESC protocol and its shaft: bytes in, answers out, according to the
// two tables of the manual. It answers on its address and on the master address. What it does where the
// manual is silent is marked as assumed. Used by SimulatedEscLine.
class SimulatedEscEncoder
{
public:
    // What it sends in answer: at the baud rate of the request, even if that was to change it (assumed).
    struct Reply
    {
        QByteArray bytes;
        int baudRate = 0;

        friend bool operator==(const Reply &, const Reply &) = default;
    };

    explicit SimulatedEscEncoder(const EscEncoderPlan &plan);

    // One byte at its own baud rate and format.
    std::optional<Reply> hear(char byte);
    // One byte at another rate, or two at once.
    void hearJunk() { m_listener.hearJunk(); }
    // A millisecond passes.
    void cycle();

    EscLineAddress address() const { return m_address; }
    int baudRate() const { return m_baudRate; }
    const EscRegisters &registers() const { return m_registers; }
    TurningShaft &shaft() { return m_shaft; }
    const TurningShaft &shaft() const { return m_shaft; }
    // For the trainer.
    EscCondition &condition() { return m_condition; }
    const EscCondition &condition() const { return m_condition; }

private:
    struct ReadCommand;
    struct WriteCommand;

    // `command` is what follows the address. In simulated_esc_commands.cpp.
    QByteArray answerTo(QByteArrayView command);
    QByteArray write(const WriteCommand &row, QByteArrayView data);

    bool falls() const { return m_registers.countsCcw || m_condition.vrHigh; }
    std::uint32_t positionNow() const { return m_registers.position(m_shaft.raw(), falls()); }
    EscMotion motion() const;

    std::uint32_t operatingParameters() const;
    std::uint32_t alarms() const { return escAlarms(m_condition, motion()); }
    std::uint32_t warnings() const;
    std::uint32_t serialNumber() const { return m_plan.serialNumber; }
    std::uint32_t deviceCode() const { return 0x8000; } // the lowest of 8000..A000
    std::uint32_t operatingTime() const;
    QByteArray version() const;

    bool writePreset(std::uint32_t value);
    bool writeFactor(std::uint32_t value);
    bool writeAddress(std::uint32_t digits);
    bool writeBaudRate(std::uint32_t choice);

    EscEncoderPlan m_plan;
    TurningShaft m_shaft;
    EscRegisters m_registers;
    EscCondition m_condition;
    EscListener m_listener;
    EscLineAddress m_address;
    int m_baudRate;
    std::int64_t m_millisecondsOn = 0;
};

} // namespace codewheel
