// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <compare>
#include <optional>

namespace codewheel {

// INTERBUS device number "segment.position": remote-bus devices are n.0, those of the local bus behind them
// n.1, n.2, ...
struct DeviceNumber
{
    int segment = 0;
    int position = 0;

    friend constexpr auto operator<=>(const DeviceNumber &, const DeviceNumber &) = default;

    QString toString() const;
    // "1.0", "6.1"; nothing for anything else.
    static std::optional<DeviceNumber> parse(QStringView text);
};

} // namespace codewheel
