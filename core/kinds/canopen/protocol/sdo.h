// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/octets.h"

#include <QString>

#include <array>
#include <optional>

namespace codewheel::canopen {

struct SdoObject
{
    std::uint16_t index = 0;
    std::uint8_t sub = 0;

    QString text() const; // "6004h:0"

    friend bool operator==(const SdoObject &, const SdoObject &) = default;
};

// A frame of the service that reads and writes objects (CiA 301, 7.2.4), by itself: which object a segment
// belongs to is said by those before it.
struct SdoFrame
{
    enum class Kind : std::uint8_t {
        // of the client
        read,
        readSegment, // asks for the next one
        write,       // with the value
        writeBegins, // segments follow
        // of the server
        value,
        valueBegins, // segments follow when they are asked for
        written,
        segmentWritten,
        // of both
        segment,
        abort,
        block, // begins one, or goes on with it
        unknown,
    };
    static constexpr std::size_t mostOctets = 7;

    Kind kind = Kind::unknown;
    bool isAnswer = false;
    SdoObject object{};                            // where the frame names one
    std::array<std::uint8_t, mostOctets> octets{}; // of a value of up to four, or of a segment
    std::size_t size = 0;                          // of these
    bool isSizeTold = true;                        // of a value; otherwise it may be smaller
    std::optional<std::uint32_t> wholeSize{};      // of what follows in segments
    bool toggle = false;                           // of segments
    bool isLast = false;                           // segment
    std::uint32_t abortCode = 0;

    bool namesObject() const
    {
        return kind != Kind::segment && kind != Kind::readSegment && kind != Kind::segmentWritten;
    }
    std::optional<SdoObject> namedObject() const
    {
        return namesObject() ? std::optional(object) : std::nullopt;
    }
    Octets data() const { return Octets(octets).first(size); }

    // Empty: it does not have eight bytes.
    static std::optional<SdoFrame> request(Octets frame);
    static std::optional<SdoFrame> answer(Octets frame);
};

} // namespace codewheel::canopen
