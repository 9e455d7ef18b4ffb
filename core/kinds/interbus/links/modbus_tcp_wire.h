// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_settings.h"
#include "kinds/interbus/links/modbus_wire.h"
#include "links/connect_to_host.h"

#include <chrono>
#include <optional>

namespace codewheel {

// A connection to a gateway (MODBUS Messaging on TCP/IP Implementation Guide V1.0b). TCP is a stream: an
// answer may come in any pieces.
//
// Answers are told apart by their transaction. After silence the connection stays: a late answer has the
// number of a transaction that is over and is dropped, while connecting anew would lose nothing but time, and
// many gateways have room for few connections and give up an old one slowly. After half an answer or a
// foreign one nobody knows where the next one begins; then the wire connects anew before the next request. So
// it does before a read where the gateway has closed the connection meanwhile, and each time where it does
// that after each answer. A write is not sent then: a gateway may change its outputs when it closes. A read
// that met the end of a connection which had been answered on is sent once more on a new one; a write is not,
// since it may have been carried out.
class ModbusTcpWire final : public ModbusWire
{
public:
    explicit ModbusTcpWire(const GatewaySettings &settings);

    Result<void> open() override;
    void close() override;
    tl::expected<modbus_message::Pdu, RegisterError> exchange(const modbus_message::Pdu &request) override;
    void distrust() override { m_isOutOfStep = true; }
    RegisterPort::Noticed noticed() const override
    {
        return {.renewals = m_renewals,
                .reconnections = m_reconnections,
                .closedAfterEach = m_closedAfterEach,
                .keepsNone = m_keepsNone,
                .closesAfterEach = m_closesAfterEach};
    }
    Instant now() const override;
    void wait(Instant until) override;
    void interrupt() override { m_wake.raise(); }

private:
    using Time = std::chrono::steady_clock::time_point;
    using Failed = tl::unexpected<RegisterError>;
    // Answers with one number, in exchanges without another one between them.
    struct OneNumber
    {
        std::uint16_t transaction = 0;
        std::uint16_t request = 0; // the last that got one
        int times = 0;
    };
    struct Answer
    {
        std::uint16_t transaction = 0;
        int unit = 0;
        modbus_message::Pdu pdu{};
    };

    Result<void> connect(Instant timeOut);
    tl::expected<modbus_message::Pdu, RegisterError> ask(const modbus_message::Pdu &request);
    RegisterPort::Done connectAnew();
    bool isGivenUp();
    bool isKept() const;
    void countClosing();
    void countAnswer();
    bool keepsAgain(bool writes);
    void learnFromClosing(bool crossesRequest);
    RegisterPort::Done send(const modbus_message::Pdu &request);
    tl::expected<modbus_message::Pdu, RegisterError> receive(Time until);
    RegisterPort::Done receiveMore(Time until);
    tl::expected<std::optional<Answer>, RegisterError> nextAnswer();
    bool isOver(std::uint16_t transaction) const;
    int timesInARow(std::uint16_t transaction);
    Failed ofForeignTransaction(std::uint16_t transaction);
    Failed failed(RegisterError error);
    Failed outOfStep(WrongAnswer what, std::initializer_list<int> numbers = {});

    const GatewaySettings m_settings;
    WakeFlag m_wake;
    std::vector<SocketAddress> m_addresses;
    bool m_isOpen = false;
    Descriptor m_socket;                  // none: to be connected anew
    std::vector<std::uint8_t> m_received; // and not yet an answer
    bool m_isOutOfStep = false;
    bool m_comesLate = false; // an answer to an earlier request has come since the last right one
    OneNumber m_oneNumber;
    std::uint16_t m_transaction = 0; // the last one
    int m_before = -1;               // transactions before it on this connection
    int m_answers = 0;               // on this connection
    bool m_closesAfterEach = false;  // the gateway does
    int m_shortConnections = 0;      // in a row, whose end crossed a request
    unsigned m_untried = 0;          // connections since, that it had not closed yet
    int m_closedSoon = 0;            // connections in a row, that were not kept
    Time m_connectedAt{};
    Time m_answeredAt{};
    bool m_keepsNone = false;
    std::uint64_t m_renewals = 0;
    std::uint64_t m_reconnections = 0;
    std::uint64_t m_closedAfterEach = 0;
    const Time m_begin = std::chrono::steady_clock::now();
};

} // namespace codewheel
