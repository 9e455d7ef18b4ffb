// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"

#include <QString>

#include <cstdint>

namespace codewheel {

// The settings of a serial line. The defaults are those of a Kübler encoder as delivered (manual, "Preset
// values").
struct SerialSettings
{
    enum class Parity : std::uint8_t { none, even, odd };

    int baudRate = 19'200; // bit/s
    int dataBits = 8;      // 7, 8
    Parity parity = Parity::none;
    int stopBits = 2;       // 1, 2
    bool lowLatency = true; // requested from the adapter

    // Start bit, data, parity and stop bits.
    int bitsPerCharacter() const { return 1 + dataBits + (parity == Parity::none ? 0 : 1) + stopBits; }
    // "8N2".
    QString format() const
    {
        const QLatin1Char letter(QLatin1String("NEO").at(static_cast<qsizetype>(parity)));
        return QStringLiteral("%1%2%3").arg(dataBits).arg(letter).arg(stopBits);
    }
    // How long `characters` take on the wire, rounded up to a microsecond.
    Instant timeOf(int characters) const
    {
        const std::int64_t bits = std::int64_t{characters} * bitsPerCharacter();
        return Instant{(bits * 1'000'000 + baudRate - 1) / baudRate};
    }

    friend bool operator==(const SerialSettings &, const SerialSettings &) = default;
};

} // namespace codewheel
