// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modbus/gateway_counter.h"
#include "modbus/gateway_map.h"
#include "modbus/word_gate.h"
#include "ring/process_data_link.h"

#include <memory>
#include <optional>
#include <vector>

namespace codewheel {

// A device of a ring behind a gateway, as planned: a gateway has no ID cycle.
struct GatewayDevice
{
    Participant participant;
    std::optional<Profile> profile{}; // empty: not known
};

// The link to a ring whose process image a gateway shows as Modbus registers. One exchange writes all OUT
// words and reads all IN words, in as few transactions as possible; transactions without a valid answer are
// repeated. The gateway runs the ring by itself, so words are not bounded to its cycles.
//
// Nothing is ever written but by exchange() and sendZeros(). Before each write OUT is read back: what
// somebody else has put there is not overwritten (outNotOurs). An IN word counts once the reads agree
// (WordGate).
class GatewayLink final : public ProcessDataLink
{
public:
    GatewayLink(std::unique_ptr<RegisterPort> port, GatewaySettings settings,
                const std::vector<GatewayDevice> &ring);
    ~GatewayLink() override;

    // The port's refusals, and registerMapWrong, gatewayHasNoDevices; reads IN once, so that a wrong unit or
    // an image that is too short is noticed: registersUnanswered, registersRefused, registersGarbled.
    Result<RingStructure> open() override;
    void close() override;
    Result<std::vector<Word>> readBackOut() override;
    Result<void> exchange(std::span<const Word> out, std::span<Word> in) override;
    Result<void> watch(std::span<Word> out, std::span<Word> in) override;
    Result<std::optional<bool>> sendZeros(std::span<Word> in) override;
    bool isUpToDate(std::size_t device) const override;
    std::shared_ptr<const LinkFigures> figures() const override { return m_counter.figures(); }
    Instant now() const override { return m_port->now(); }
    // While open: until the next exchange is due.
    void wait(Instant until) override;
    bool boundsWordsToCycles() const override { return false; }
    void interrupt() override { m_port->interrupt(); }

private:
    struct Device;
    enum class Write : std::uint8_t { none, alone, withRead };

    Result<void> checkUse(std::size_t outWords, std::size_t inWords) const;
    Result<void> readIn();
    Result<void> readDoubtfulAgain();
    Result<void> readBlock(const RegisterBlock &block);
    void takeBlock(const RegisterBlock &block);
    Result<void> readOut(std::vector<Word> &words);
    Result<void> checkIsOurs();
    Result<void> writeOut(std::span<const Word> out);
    Result<void> exchangeWords(std::span<const Word> out, std::span<Word> in);
    Result<void> readStatus();
    void showIn(std::span<Word> in);
    void settle(Instant begun);
    bool isDoubtful(std::size_t device) const;
    template <class Call>
    Result<void> transact(int function, const RegisterBlock &block, Call call);

    const std::unique_ptr<RegisterPort> m_port;
    const GatewaySettings m_settings;
    RingStructure m_ring;
    std::vector<Device> m_devices;
    std::optional<GatewayMap> m_map; // empty: not open
    bool m_readsBack = false;        // OUT, as far as the gateway lets it be
    std::vector<Register> m_inRegisters;
    std::vector<Register> m_outRegisters;
    GatewayCounter m_counter;
    Instant m_nextExchange{};
    Instant m_nextStatus{};
};

} // namespace codewheel
