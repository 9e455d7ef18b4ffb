// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_map.h"
#include "kinds/interbus/gateway/modbus_request.h"
#include "kinds/interbus/ring/ring_guests.h"

#include <memory>
#include <mutex>
#include <optional>

namespace codewheel {

// Where a ring is in the registers that are offered to Modbus clients (docs/manual/serving.md).
namespace served_registers {
inline constexpr int in = 0;              // input registers
inline constexpr int out = 0;             // holding registers, to read and write
inline constexpr int inAsHolding = 4'096; // holding registers, to read
inline constexpr int status = 8'192;      // input and holding registers, to read
inline constexpr int parameter = 8'193;   // behind it: diagnostic parameter register
inline constexpr int end = 8'194;
} // namespace served_registers

// The same gateway, with what the status register of an offered ring means.
GatewaySettings servedSettings(GatewaySettings settings);
// Where the words of each device of a ring are: high word first, in ring order. Refused: registerMapWrong.
Result<GatewayMap> servedMap(const RingStructure &ring);

// What a client wrote last.
struct ServedWord
{
    NodeId place;
    Word word = 0;
    Instant at{}; // on the ring's clock

    friend bool operator==(const ServedWord &, const ServedWord &) = default;
};

// The registers under which a ring is offered. Reading gives the words of one cycle; writing returns once the
// words were on the bus. Any thread.
class ServedRing
{
public:
    explicit ServedRing(std::shared_ptr<RingGuests> guests)
        : m_guests(std::move(guests))
    {}

    // illegalAddress: not in the map; deviceFailure: there is no ring at the moment.
    tl::expected<std::vector<Register>, ModbusException> read(RegisterArea area, int first, int count) const;
    // What is written only in part keeps its other bits. Empty: all of it stood there already, as when a
    // master repeats its words in each of its cycles; of several words the last that differs. deviceFailure:
    // the ring is stopped, has failed, or is in Watch; deviceBusy: a job holds one of the words.
    tl::expected<std::optional<ServedWord>, ModbusException>
    write(int first, const std::vector<ModbusRequest::Change> &changes) const;

private:
    std::shared_ptr<const GatewayMap> mapOf(const GuestImage &image) const;

    std::shared_ptr<RingGuests> m_guests;
    mutable std::mutex m_mutex; // guards the map, which is made once for a ring
    mutable std::shared_ptr<const RingStructure> m_ringOfMap;
    mutable std::shared_ptr<const GatewayMap> m_map;
};

} // namespace codewheel
