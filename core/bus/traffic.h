// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"
#include "vocabulary/place.h"
#include "vocabulary/traffic_kind.h"
#include "vocabulary/word.h"

#include <QByteArray>
#include <QDateTime>

#include <functional>
#include <optional>

namespace codewheel {

// Of a frame on CAN.
struct FrameIdentifier
{
    std::uint32_t number = 0;
    bool isLong = false; // 29 bits

    QString text() const; // "185", "0CFFE0E0"
};

// What passed on a bus, one row each, whatever bus it is. Made by the session of the bus; views show the
// columns that the bus has.
struct TrafficRow
{
    Instant at{};
    QDateTime time{};                  // that `at` corresponds to
    std::optional<Place> place{};      // whose it is, a device or the bus itself
    std::optional<TrafficKind> kind{}; // empty: both directions at once, like the words of a bus cycle
    std::uint64_t cycle = 0;           // of the bus, if it has cycles
    Word out = 0;
    Word in = 0;
    bool isAnswered = true; // false: its link was lost in this cycle
    QByteArray bytes{};     // as on the wire, unless what passes is words
    qsizetype head = 0;     // so many of them are no data: the identifier of a frame on CAN
    std::optional<FrameIdentifier> identifier{}; // which they say
    std::function<QString()> meaning{};          // in the current language
    bool isAutomatic = false;  // asked automatically by the bus, or its answer, and nothing is wrong with it
    bool isTyped = false;      // or its answer
    bool isOfTransfer = false; // another row tells all of it

    bool isRoutine() const { return isAutomatic && !isTyped; }
};

enum class TrafficColumn : std::uint8_t {
    time,
    sinceLast,
    cycle,
    direction,
    out,
    in,
    text,
    meaning,
    bytes,  // the data
    remark, // the user's
    identifier,
    who, // has sent it, or is meant
};

// "sent", "answer", "echo", "garbage", "late"
QString rowKindWord(TrafficKind kind);

// How control characters are shown: as the pictures Unicode has, "␛05P␍␊"; as signs that more fonts have,
// "⎋05P↵↓"; as numbers, "<1B>05P<0D><0A>". Pictures and signs are one glyph each.
enum class ControlCharacters { pictures, signs, numbers };

// Bytes that are not ASCII are shown as <FF>.
QString controlText(const QByteArray &bytes, ControlCharacters controls = ControlCharacters::pictures);
// "1B 30 35 50 0D 0A"
QString byteText(const QByteArray &bytes);

} // namespace codewheel
