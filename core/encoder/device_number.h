// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/line_address.h"

#include <QString>

#include <compare>
#include <optional>

namespace codewheel {

// The place of a device. On INTERBUS its device number "segment.position": remote-bus devices are n.0, those
// of the local bus behind them n.1, n.2, ... On a serial line its address, and segment and position are 0; an
// encoder that is alone on its line may also stand at the master address 00.
struct DeviceNumber
{
    int segment = 0;
    int position = 0;
    LineAddress line{};
    bool isAtMasterAddress = false; // what tells esc:00 from no place at all

    static constexpr DeviceNumber onLine(LineAddress address)
    {
        return {0, 0, address, address.value == LineAddress::master().value};
    }
    bool isOnLine() const { return !line.isMaster() || isAtMasterAddress; }

    // clang-tidy 14 takes the 0 in a defaulted <=> for a null pointer.
    // NOLINTNEXTLINE(modernize-use-nullptr)
    friend constexpr auto operator<=>(const DeviceNumber &, const DeviceNumber &) = default;

    // "6.1"; on a serial line the address as on the wire, with what tells it from a number: "esc:12" is 12h
    // = 18.
    QString toString() const;
    // "1.0", "6.1", "esc:12", and "12" for the same; nothing for anything else.
    static std::optional<DeviceNumber> parse(QStringView text);
};

} // namespace codewheel
