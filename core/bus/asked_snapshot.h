// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/freshness.h"
#include "vocabulary/place.h"
#include "vocabulary/reading.h"
#include "vocabulary/refusal.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace codewheel {

// What determines whether anything may be sent on a bus whose encoders are asked; its kind adds to it.
struct AskingState
{
    bool connected = false;           // false: the link is gone
    std::optional<Refusal> whyLost{}; // while it is
    bool running = false;             // the drivers are asked what they want to send
    bool operate = false;             // writing is allowed

    friend bool operator==(const AskingState &, const AskingState &) = default;
};

// An encoder that is asked.
struct AskedDevice
{
    NodeId node{};
    Reading reading{};
    bool hasJob = false;
    bool present = true;                                         // false: it has been removed
    bool answers = true;                                         // its last request was answered
    Freshness::Reason whyNotAsked = Freshness::Reason::notAsked; // if it is not
    Instant lateAfter = Freshness::lateAfter;                    // by the pace at which its positions come
};

// The bus as it is now.
template <class BusStateOfKind, class DeviceOfKind>
struct AskedSnapshot : BusStateOfKind
{
    using State = BusStateOfKind;
    using Device = DeviceOfKind;

    Instant at{};
    Instant awakeSince{};          // the computer slept until then; 0: not since the bus was opened
    std::uint64_t droppedRows = 0; // rows lost because nobody took them
    std::vector<Device> devices{};
};

} // namespace codewheel
