// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/sdo_frames.h"

#include <vector>

namespace codewheel::canopen {

struct SdoOutcome
{
    enum class Kind : std::uint8_t {
        read,
        written,
        aborted,
        noAnswer, // of a write: it may have been carried out
        notSent,
    };

    Kind kind = Kind::noAnswer;
    std::vector<std::uint8_t> value{}; // read, the lowest octet first
    bool isSizeTold = true;            // otherwise the value has four octets and may have fewer
    std::uint32_t abortCode = 0;
    bool isOwnAbort = false; // what the device answered made no sense, or was too much

    friend bool operator==(const SdoOutcome &, const SdoOutcome &) = default;
};

// The dialogue of one transfer, in one frame or in segments, without any time. Used by SdoClient.
class SdoTransfer
{
public:
    // So many segments are taken, and no more.
    static constexpr int mostSegments = 40'000;

    enum class Taken : std::uint8_t {
        yes,     // the next request() is due, or the outcome is there
        doubled, // the answer before once more
        no,      // it does not belong to this transfer
    };

    // Without a value the object is read.
    SdoTransfer(const SdoObject &object, std::optional<std::vector<std::uint8_t>> value);

    const SdoObject &object() const { return m_object; }
    bool isWrite() const { return m_isWrite; }
    bool isInSegments() const { return m_isInSegments; }
    SdoOctets request() const;
    Taken take(const SdoFrame &answer);
    const std::optional<SdoOutcome> &outcome() const
    {
        return m_outcome;
    } // of an own abort, which is to be sent

private:
    Taken takeFirst(const SdoFrame &answer);
    Taken takeSegment(const SdoFrame &answer);
    Taken takeAcknowledgement(const SdoFrame &answer);
    Taken wrongToggle(bool isDoubled);
    Taken end(SdoOutcome::Kind kind);
    Taken giveUp(std::uint32_t code);
    Octets nextPiece() const;

    SdoObject m_object;
    bool m_isWrite;
    std::vector<std::uint8_t> m_value; // what is written, or was read so far
    bool m_isInSegments = false;
    bool m_toggle = false;
    int m_segments = 0;                         // done
    std::optional<std::uint32_t> m_wholeSize{}; // as told
    std::array<std::uint8_t, SdoFrame::mostOctets> m_before{};
    std::optional<SdoOutcome> m_outcome{};
};

} // namespace codewheel::canopen
