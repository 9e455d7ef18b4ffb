// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/cob_id.h"
#include "vocabulary/place.h"

#include <QString>

#include <compare>
#include <optional>
#include <string_view>

namespace codewheel {

// The bus that "can:5" is on where no bus is named.
inline constexpr BusId firstCanBus{3};

// The number of a node on CANopen, 1 to 127; 0: of none.
struct CanopenAddress
{
    int node = 0;

    // NOLINTNEXTLINE(modernize-use-nullptr)
    friend constexpr auto operator<=>(const CanopenAddress &, const CanopenAddress &) = default;

    static constexpr std::string_view prefix = "can:"; // of a place

    bool isNode() const { return node >= 1 && node <= canopen::lastNode; }
    // In decimal, as on switches, and as in identifiers: "5 (05h)".
    QString shown() const;
    NodeId place() const { return NodeId(std::string(prefix) + std::to_string(node)); } // "can:5"

    // 0: it is no place on CANopen.
    static CanopenAddress of(NodeId place) { return read(place.toString()).value_or(CanopenAddress()); }
    // "can:5"; empty for anything else.
    static std::optional<CanopenAddress> read(QStringView text);
};

} // namespace codewheel
