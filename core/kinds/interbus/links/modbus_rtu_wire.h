// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_settings.h"
#include "kinds/interbus/gateway/rtu_answers.h"
#include "kinds/interbus/links/modbus_wire.h"
#include "links/serial_port_link.h"

namespace codewheel {

// A serial line with Modbus RTU (MODBUS over Serial Line V1.02), held exclusively.
//
// An answer says no more of its request than unit, function and length. So after silence, a damaged answer or
// an interruption the next request waits until the line has been quiet for the time-out; and every request
// for the gap that must be between two frames, in which the second of two answers would show. An answer later
// than that, to a request of the same form, cannot be told. One of another form is dropped, and that answers
// come late is told (RegisterError::isLate).
class ModbusRtuWire final : public ModbusWire
{
public:
    explicit ModbusRtuWire(const GatewaySettings &settings);

    Result<void> open() override;
    void close() override { m_line.close(); }
    tl::expected<modbus_message::Pdu, RegisterError> exchange(const modbus_message::Pdu &request) override;
    RegisterPort::Noticed noticed() const override
    {
        return {.strayBytes = m_answers.strayBytes(), .echoes = m_answers.echoes()};
    }
    void distrust() override { m_doubt = Doubt::unanswered; }
    Instant now() const override { return m_line.now(); }
    void wait(Instant until) override { m_line.wait(until); }
    void interrupt() override { m_line.interrupt(); }

private:
    enum class Doubt : std::uint8_t {
        none,
        another,    // an answer came that nobody had asked for
        unanswered, // the answer to the last request may still come
    };
    using Done = RegisterPort::Done;
    using Answer = tl::expected<modbus_message::Pdu, RegisterError>;

    Answer ask(const modbus_message::Pdu &request);
    Done send(const modbus_message::Pdu &request);
    Answer askWhileInDoubt(const modbus_message::Pdu &request);
    Answer receive(const modbus_message::Pdu &request, Instant firstUntil, Instant until);
    bool isOfEarlier(const modbus_message::Pdu &answer) const;
    void learn(const modbus_message::Pdu &request, Answer &answer, bool isCertain);
    std::optional<modbus_message::Pdu> nextAnswer();
    RegisterError whyNone() const;
    tl::expected<std::optional<modbus_message::Pdu>, RegisterError> waitForGap();
    Done waitForQuiet();
    tl::expected<bool, RegisterError> takeBytes(Instant until);

    const GatewaySettings m_settings;
    SerialPortLink m_line;
    RtuAnswers m_answers;
    int m_otherUnit = -1;   // that answered in place of ours
    bool m_hasCome = false; // something, since the last request
    Doubt m_doubt = Doubt::none;
    std::vector<modbus_message::Pdu> m_unanswered; // requests since the last answer that is certain
    bool m_mayHaveComeLate = false;                // the last answer: to the request before
    bool m_comesLate = false;                      // an answer did, since the last that is certain
    Instant m_lastByte{};
};

} // namespace codewheel
