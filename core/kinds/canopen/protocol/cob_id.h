// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace codewheel::canopen {

inline constexpr int lastNode = 127;

// What an identifier of 11 bits stands for by the predefined connection set (CiA 301, 7.3.5; LSS: CiA 305).
// Devices may have been given others.
struct CobId
{
    enum class Service : std::uint8_t {
        nmt,
        sync,
        time,
        emcy,
        tpdo, // of the node
        rpdo, // to the node
        sdoAnswer,
        sdoRequest,
        errorControl, // boot-up, heartbeat, guarding
        lssAnswer,
        lssRequest,
    };

    Service service = Service::nmt;
    int node = 0;   // 1 to 127; 0: the service has none
    int number = 0; // of a PDO, 1 to 4

    // Empty: it is not among them.
    static std::optional<CobId> of(std::uint32_t identifier);
    // The other way round; of what is not among them 0.
    std::uint32_t identifier() const;

    friend bool operator==(const CobId &, const CobId &) = default;
};

} // namespace codewheel::canopen
