// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_settings.h"
#include "kinds/interbus/ring/ring_device.h"
#include "vocabulary/refusal.h"
#include "vocabulary/word.h"

#include <vector>

namespace codewheel {

// Registers that one transaction moves.
struct RegisterBlock
{
    int first = 0;
    int count = 0;

    int end() const { return first + count; }
    friend bool operator==(const RegisterBlock &, const RegisterBlock &) = default;
};

// Where the words of each device are in the registers of a gateway, and the transactions that move them: as
// few as the protocol allows, with no device's word split between two.
//
// The words of all devices are in ring order, each device beginning at a register of its own (word aligned:
// assumed, spec interbus.md). Of a device with more than 32 bits the first 32 are shown; what is behind them
// is read over and never written.
//
// Wherever the ring allows it, no two reads by the same function have the same length: an answer that comes
// late, to a request of before, is not taken for that to another block, even on Modbus RTU, whose answers say
// no more than their length.
class GatewayMap
{
public:
    static constexpr int wordRegisters = 2; // of a 32-bit word

    // Refused (registerMapWrong): areas overlap, or end behind the last register.
    static Result<GatewayMap> of(const RingStructure &ring, const GatewaySettings &settings);

    const RegisterBlock &in(std::size_t device) const { return m_in[device]; } // count 0..2
    const RegisterBlock &out(std::size_t device) const { return m_out[device]; }
    const std::vector<RegisterBlock> &inBlocks() const { return m_inBlocks; }
    const std::vector<RegisterBlock> &outBlocks() const { return m_outBlocks; } // to write
    const std::vector<RegisterBlock> &readBackBlocks() const { return m_readBackBlocks; }
    // To write only the words of some devices.
    std::vector<RegisterBlock> outBlocksOf(const std::vector<bool> &devices) const;
    // So many registers in one request from now on, at least those of a word.
    void writeAtMost(int registers);
    std::size_t devices() const { return m_in.size(); }

    // The word of a device from its registers, and the registers of a word.
    Word word(std::span<const Register> registers) const;
    void put(Word word, std::span<Register> registers) const;

private:
    explicit GatewayMap(const RingStructure &ring, const GatewaySettings &settings);

    std::vector<RegisterBlock> m_in;
    std::vector<RegisterBlock> m_out;
    std::vector<RegisterBlock> m_inBlocks;
    std::vector<RegisterBlock> m_outBlocks;
    std::vector<RegisterBlock> m_readBackBlocks;
    bool m_highWordFirst;
    int m_mostWritten;
};

} // namespace codewheel
