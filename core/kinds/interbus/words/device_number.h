// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"

namespace codewheel {

// The device number on INTERBUS, "segment.position": remote-bus devices are n.0, those of the local bus
// behind them n.1, n.2, ...
struct DeviceNumber
{
    int segment = 0;
    int position = 0;

    // clang-tidy 14 takes the 0 in a defaulted <=> for a null pointer.
    // NOLINTNEXTLINE(modernize-use-nullptr)
    friend constexpr auto operator<=>(const DeviceNumber &, const DeviceNumber &) = default;

    QString toString() const { return QStringLiteral("%1.%2").arg(segment).arg(position); } // "6.1"
    NodeId node() const; // "6.1"; none for 0.0
    // 0.0: there is none, or it is no place on INTERBUS.
    static DeviceNumber of(NodeId node);
    // "1.0", "6.1"; empty for anything else.
    static std::optional<DeviceNumber> parse(QStringView text);
};

} // namespace codewheel
