// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"
#include "vocabulary/refusal.h"

#include <QString>

#include <cstdint>
#include <span>
#include <tl/expected.hpp>

namespace codewheel {

// A Modbus register has 16 bits.
using Register = std::uint16_t;

enum class RegisterArea : std::uint8_t {
    input,   // read by function 4
    holding, // read by function 3, written by functions 16 and 23
};

// Why a transaction gave nothing.
struct RegisterError
{
    enum class Kind : std::uint8_t {
        noAnswer,    // within the time-out
        exception,   // the unit answered with an exception
        wrongAnswer, // of the wrong length, unit or function, or damaged
        closed,      // the connection is gone; the port has to be opened again
        unplugged,   // so is the serial port itself
        stopped,     // by interrupt()
    };

    Kind kind = Kind::noAnswer;
    int exception = 0;     // its code, 1..11
    QString text{};        // what the system says, or what was wrong (wrongAnswerKey()); may be empty
    bool isSent = true;    // false: closed before a write was sent
    bool isLate = false;   // noAnswer: answers do come, but to earlier requests
    bool isAtOnce = false; // closed: without any answer in this connection, or it was refused

    friend bool operator==(const RegisterError &, const RegisterError &) = default;
};

// What a Modbus transaction can hold (Modbus Application Protocol V1.1b3, 6.3, 6.4, 6.12, 6.17).
namespace modbus_limit {
inline constexpr int readRegisters = 125;
inline constexpr int writtenRegisters = 123;
inline constexpr int writtenWithRead = 121; // by function 23
inline constexpr int lastRegister = 0xFFFF;
inline constexpr int lastUnit = 255; // TCP; on a serial line 247
inline constexpr int lastSerialUnit = 247;
inline constexpr int tcpPort = 502;
} // namespace modbus_limit

// The contract of a way to the registers of one Modbus unit: one call is one transaction, sent once.
// Blocking, bounded by the time-out of its settings; used by one thread, interrupt() by any. It knows nothing
// of what the registers mean. An answer to an earlier request is never taken for that to this one, as far as
// the protocol lets it be told.
class RegisterPort
{
public:
    using Done = tl::expected<void, RegisterError>;

    virtual ~RegisterPort() = default;

    // Connects; sends no request. Opened again, it connects anew. Refused: hostNotFound, connectionRefused,
    // connectionSilent, those of a serial port (SerialPortLink::open()), or `stopped`.
    virtual Result<void> open() = 0;
    virtual void close() = 0;
    // Function 3 or 4: as many registers as `to` has, 1..modbus_limit::readRegisters.
    virtual Done read(RegisterArea area, int first, std::span<Register> to) = 0;
    // Function 16: 1..modbus_limit::writtenRegisters.
    virtual Done write(int first, std::span<const Register> from) = 0;
    // Function 23, which writes before it reads: at most modbus_limit::writtenWithRead are written. Holding
    // registers only.
    virtual Done writeAndRead(int writeFirst, std::span<const Register> from, int readFirst,
                              std::span<Register> to) = 0;

    // The time of its clock, which starts at 0 with the port and never goes back: real for hardware. Any
    // thread.
    virtual Instant now() const = 0;
    // Lets time pass, on a closed port too; interrupt() ends it early.
    virtual void wait(Instant until) = 0;
    // Ends the current call, or else the next one, early with `stopped`. Any thread.
    virtual void interrupt() = 0;
    // As known to the user: "192.168.0.5:502", "/dev/ttyUSB0".
    virtual QString name() const = 0;

    // What it has put up with, since it was made.
    struct Noticed
    {
        std::uint64_t renewals = 0;        // connections made by a request, besides those of open()
        std::uint64_t reconnections = 0;   // of these: the gateway had closed the one before, now and then
        std::uint64_t closedAfterEach = 0; // of these: by one that keeps no connection
        bool keepsNone = false;            // the gateway closes each connection a moment after an answer
        bool closesAfterEach = false;      // it does so that soon that each is left before the next request
        std::uint64_t strayBytes = 0;      // that belong to no frame
        std::uint64_t echoes = 0;          // of our own requests

        friend bool operator==(const Noticed &, const Noticed &) = default;
    };
    virtual Noticed noticed() const { return {}; }
};

} // namespace codewheel
