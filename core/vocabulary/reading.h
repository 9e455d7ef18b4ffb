// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/instant.h"
#include "vocabulary/mode.h"
#include "vocabulary/position_coding.h"
#include "vocabulary/word.h"

#include <optional>

namespace codewheel {

enum class EncoderState : std::uint8_t {
    notSeen, // no exchange yet
    operation,
    parameterization,
    readOut, // a read-out value or the self test is in IN
    service, // LA-66: the answer to a service is in IN
    error,
    waiting, // for its parameters, or to be started: a PROFIBUS slave, a CANopen node in pre-operational
    silent,  // a serial encoder that no longer answers; what it showed last is still there
    unknown, // IN has no meaning known to the manuals or the description
};

// What the encoder shows in one cycle. position is empty while IN holds none, or while its coding is not
// known. An LA-66 shows a position in error as well: the last one before the magnet left the measuring range.
struct Reading
{
    // IN of an encoder in cam mode (FRABA manual 5.4.4).
    struct Cams
    {
        std::uint8_t on = 0;   // bit n: cam n
        Word positionPart = 0; // D24..D8: (position >> shift_iw) & 1FFFFh

        friend bool operator==(const Cams &, const Cams &) = default;
    };

    Instant at{};
    EncoderState state = EncoderState::notSeen;
    Word in = 0;
    std::optional<std::int64_t> position;   // steps, as parameterized
    std::optional<double> stepsPerSecond{}; // of the position, from those before; empty: not known (yet)
    bool mayMissTurns = false; // of the shaft, since positions come too seldom: so no speed can be told
    std::optional<std::int64_t> velocity{}; // revolutions per minute, in velocity mode
    std::optional<Cams> cams{};             // in cam mode
    std::optional<Mode> mode;               // empty: not known
    std::optional<unsigned> camProgram{};   // in cam mode: 1..8; empty: not known
    std::optional<PositionCoding> coding;   // empty: not known
    std::optional<unsigned> errorNumber;    // while state is error
    // Serial encoders only.
    bool suspect =
        false; // the position jumped further than the encoder can turn, and is being asked for again
    std::optional<std::uint16_t> alarms{};   // as last read
    std::optional<std::uint16_t> warnings{}; // as last read

    // Whether its position can be taken as the encoder's. One that waits, such as a node on CANopen that was
    // not started, may be asked for it.
    bool showsPosition() const
    {
        const bool mayShow = state == EncoderState::operation || state == EncoderState::waiting;
        return mayShow && position && !suspect;
    }

    friend bool operator==(const Reading &, const Reading &) = default;
};

} // namespace codewheel
