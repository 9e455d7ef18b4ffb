// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/descriptor.h"
#include "links/modbus_library.h"
#include "links/modbus_wire.h"
#include "links/wake_flag.h"
#include "modbus/gateway_settings.h"

#include <chrono>

namespace codewheel {

// A serial line with Modbus RTU (MODBUS over Serial Line V1.02), held exclusively.
//
// An answer says no more of its request than unit, function and length. So after silence, a damaged answer or
// an interruption the next request waits until the line has been quiet for the time-out; and every request
// for the gap that must be between two frames, in which the second of two answers would show. An answer later
// than that, to a request of the same form, cannot be told.
class ModbusRtuWire final : public ModbusWire
{
public:
    ModbusRtuWire(const GatewaySettings &settings, WakeFlag &wake);
    ~ModbusRtuWire() override;

    Result<void> open() override;
    void close() override;
    tl::expected<modbus_message::Message, RegisterError>
    exchange(const modbus_message::Message &request) override;
    void distrust() override { m_doubt = Doubt::unanswered; }

private:
    using Time = std::chrono::steady_clock::time_point;
    enum class Doubt : std::uint8_t {
        none,
        noise,      // something came that nobody asked for
        unanswered, // the answer to the last request may still come
    };
    using Failed = tl::unexpected<RegisterError>;

    Result<void> lock(const QString &path);
    Result<void> setUp(const QString &path);
    tl::expected<bool, RegisterError> isQuietUntil(Time time);
    RegisterPort::Done waitForGap(); // what comes meanwhile is noise
    RegisterPort::Done waitForQuiet();
    RegisterPort::Done drop();
    RegisterPort::Done send(const modbus_message::Message &request);
    tl::expected<modbus_message::Message, RegisterError> ask(const modbus_message::Message &request);
    tl::expected<modbus_message::Message, RegisterError> receive(Instant time);
    Failed failed(RegisterError error);

    const GatewaySettings m_settings;
    WakeFlag &m_wake;
    Descriptor m_lock;
    Modbus m_modbus; // null: closed
    Doubt m_doubt = Doubt::none;
    Time m_lastByte{};
};

} // namespace codewheel
