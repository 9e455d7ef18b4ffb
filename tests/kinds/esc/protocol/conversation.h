// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_exchange.h"

#include <functional>
#include <ostream>
#include <vector>

namespace codewheel::esc {

// Bytes that reach the program together, the last of them at `at`.
struct Arrival
{
    Instant at{};
    QByteArray bytes;
};
using Arrivals = std::vector<Arrival>;

// What arrives in answer to the n-th sending (from 0) of a request whose last bit is on the wire at `end`.
using Peer = std::function<Arrivals(int n, Instant end)>;

// 19200 Bd 8N2, rounded up to a microsecond.
inline constexpr Instant character{573};
inline constexpr Instant millisecond{1'000};

// An answer that begins at `start`, in one piece or byte by byte.
Arrival whole(const QByteArray &bytes, Instant start);
Arrivals byteByByte(const QByteArray &bytes, Instant start);
Arrivals operator+(Arrivals first, const Arrivals &then);

// How an exchange went, in virtual time.
struct Conversation
{
    ExchangeResult result;
    std::vector<EscLineRow> rows;
    std::vector<Instant> sendings; // when each began
    std::vector<QByteArray> sent;
    Instant doneAt{};
    QByteArray arrived; // all of it
    bool ended = false; // it came to an end

    // All of one kind, in order.
    QByteArray bytesOf(EscLineRow::Kind kind) const;
    // Everything that was not sent: nothing may be lost or reordered.
    QByteArray bytesOfAllArrivals() const;
};

// `before` has arrived when the exchange begins, at 0.
Conversation converse(const Request &request, const Peer &peer, const Timing &timing = {},
                      const Arrivals &before = {});

// A peer that answers each sending with the same bytes, 2 ms after the sending ends.
Peer answering(const QByteArray &bytes);
Peer silent();

inline const Answer accepted{Answer::Kind::accepted, 0, {}};

Request positionOf05();
Request presetOf03(); // 5200h

void PrintTo(const Answer &answer, std::ostream *out);

} // namespace codewheel::esc
