// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/served_ring.h"

#include <map>

namespace codewheel {

// Which ring answers to which Modbus unit, for the clients of a server: one ring to all units, or one for
// each seat. Any thread; the same for as long as it is offered.
class ServedUnits
{
public:
    enum class Writing : std::uint8_t { allowed, refused };

    struct Answer
    {
        ModbusBytes pdu;
        bool isException = false;
        bool isWrite = false;                // it was to write
        std::optional<ServedWord> written{}; // empty too if it stood there already
    };

    // One ring, whatever the unit.
    explicit ServedUnits(std::shared_ptr<RingGuests> ring, Writing writing = Writing::allowed);
    explicit ServedUnits(const std::map<int, std::shared_ptr<RingGuests>> &rings,
                         Writing writing = Writing::allowed);

    // Does what the request asks, and answers it. Blocks until what it writes was on the bus.
    Answer answer(int unit, std::span<const std::uint8_t> request) const;
    // Empty: all of them.
    std::vector<int> units() const;
    bool mayWrite() const { return m_writing == Writing::allowed; }

private:
    const ServedRing *ringOf(int unit) const;
    tl::expected<Answer, ModbusException> carryOut(int unit, std::span<const std::uint8_t> pdu,
                                                   const ModbusRequest &request) const;

    std::shared_ptr<const ServedRing> m_ofAll; // null: there are seats
    std::map<int, std::shared_ptr<const ServedRing>> m_ofUnits;
    Writing m_writing;
};

} // namespace codewheel
