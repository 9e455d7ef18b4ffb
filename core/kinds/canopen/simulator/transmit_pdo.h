// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_frame.h"
#include "kinds/canopen/simulator/canopen_encoder_plan.h"
#include "kinds/canopen/simulator/object_dictionary.h"

namespace codewheel::canopen {

// A PDO that a simulated node sends, as its objects say: on change and timer, or at SYNC.
class TransmitPdo
{
public:
    explicit TransmitPdo(int number); // 1..

    // The node has become operational: what is sent on change is sent once.
    void begin();
    void sync(const ObjectDictionary &objects);
    void ask(std::uint32_t identifier, const ObjectDictionary &objects); // a remote frame

    // What is to be sent now; given once.
    std::optional<CanFrame> next(const ObjectDictionary &objects, Instant now);
    // `changesAt`: when the objects may have others values; empty: not by themselves
    std::optional<Instant> wakesAt(const ObjectDictionary &objects, std::optional<Instant> changesAt) const;

private:
    bool isOff(const ObjectDictionary &objects) const;
    bool isEventDriven(const ObjectDictionary &objects) const;
    Instant inhibit(const ObjectDictionary &objects) const;
    Instant timer(const ObjectDictionary &objects) const;
    std::vector<std::uint8_t> data(const ObjectDictionary &objects) const;

    std::uint16_t m_index;   // of its communication
    std::uint16_t m_mapping; // of its objects
    bool m_isWanted = false;
    std::int64_t m_syncs = 0; // since it was sent
    std::optional<Instant> m_sentAt{};
    std::vector<std::uint8_t> m_sent{};
};

// Why what would be in an object of a PDO is refused; empty: it is not, or the object is of no PDO.
std::optional<AbortCode> pdoRefusal(const SimulatedObject &with, const ObjectDictionary &objects,
                                    const NodeQuirks &quirks);

} // namespace codewheel::canopen
