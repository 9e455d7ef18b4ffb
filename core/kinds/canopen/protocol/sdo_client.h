// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link.h"
#include "kinds/canopen/protocol/sdo_transfer.h"

#include <deque>

namespace codewheel::canopen {

struct SdoRequest
{
    int node = 0;
    SdoObject object{};
    std::optional<std::vector<std::uint8_t>>
        value{}; // to be written, the lowest octet first; empty: it is read
    Instant timeOut = std::chrono::milliseconds(500); // for each answer

    friend bool operator==(const SdoRequest &, const SdoRequest &) = default;
};

struct SdoIdentifiers
{
    std::uint32_t request = 0;
    std::uint32_t answer = 0;

    static SdoIdentifiers predefined(int node); // object 1200h may name others

    friend bool operator==(const SdoIdentifiers &, const SdoIdentifiers &) = default;
};

// Transfers with one node, one at a time. A read is repeated twice after a time-out, a write never. A state
// machine without I/O. An answer says which object it is of, but not which request: what still may be
// answered late, up to twice its time-out, is waited for before anything that such an answer fits is sent.
class SdoClient
{
public:
    explicit SdoClient(const SdoIdentifiers &identifiers);

    bool isBusy() const;                         // with a transfer, or with an abort that is to be sent
    void begin(SdoRequest request, Instant now); // while there is no transfer
    // To be sent now, given once; acts on time-outs.
    std::optional<CanFrame> next(Instant now);
    // How many frames next() has given: the number of the last one.
    std::uint64_t given() const { return m_given; }
    // Of the frame with this number.
    void fate(std::uint64_t number, CanFate fate, Instant now);
    // Whether it is an SDO answer of this node. Late and foreign ones are, too; they are counted, never
    // believed.
    bool take(const CanFrame &frame, Instant now);
    std::optional<SdoOutcome> takeOutcome() { return std::exchange(m_outcome, std::nullopt); }
    // When next() has something to do, if nothing comes in before.
    std::optional<Instant> wakesAt() const;
    // No outcome follows. Segments under way are aborted, by next().
    void cancel(Instant now);

    std::uint64_t lateAnswers() const { return m_lateAnswers; } // and doubled ones
    std::uint64_t foreignAnswers() const { return m_foreignAnswers; }

private:
    // An answer that may still come.
    struct Owed
    {
        SdoObject object;
        bool isSegment; // which names no object
        bool isOnlyOne; // no other one after it
        Instant until;
        std::uint64_t frame; // the number of that which it answers
    };

    void timedOut(Instant now);
    void owe(Instant until, bool isOnlyOne);
    void end(const SdoOutcome &outcome, Instant now);
    void lateFate(std::uint64_t number, CanFate fate, Instant now);
    void settle(Instant now);
    bool isOwed(const Owed &owed) const;
    Instant quietUntil() const;
    void count(const std::optional<SdoFrame> &answer);

    SdoIdentifiers m_identifiers;
    SdoRequest m_request{};
    std::optional<SdoTransfer> m_transfer{};
    int m_attempts = 0;
    std::uint64_t m_given = 0;
    bool m_isWaiting = false; // for an answer
    Instant m_sentAt{};
    Instant m_dueAt{}; // of what is to be sent, or the time-out
    std::optional<SdoOctets> m_abort{};
    std::optional<SdoOutcome> m_outcome{};
    std::vector<Owed> m_owed{};
    std::deque<SdoObject> m_before{}; // the last ones that were asked for
    bool m_wasInSegments = false;     // the transfer before
    std::uint64_t m_lateAnswers = 0;
    std::uint64_t m_foreignAnswers = 0;
};

} // namespace codewheel::canopen
