// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_exchange.h"
#include "kinds/esc/protocol/esc_frame.h"

namespace codewheel::esc {

// How long nothing may follow an answer that could also be the beginning of another one.
inline constexpr int silentCharacters = 2;

// What came in since a request was sent, byte by byte with its time, and which part of it is the answer. Used
// by Exchange, one for each sending.
class Reception
{
public:
    // When a sending ended, and how long a character takes.
    struct Clock
    {
        Instant requestEnd{};
        Instant character{};
    };

    struct Found
    {
        Frame frame;
        Instant end{};          // of the answer
        Instant settlesAt{};    // counts from then on, if nothing else comes in first
        bool isCertain = false; // counts at once
    };

    // Nothing received, and nothing sent either.
    Reception() = default;
    Reception(const Request &request, Clock clock);

    // `at`: when the last of them came in; the others came one character time apart before it.
    void add(const QByteArray &bytes, Instant at);
    qsizetype size() const { return m_bytes.size(); }
    Instant lastHeard() const { return m_times.back(); } // only if something came in
    // Whether anything but complete echoes came in.
    bool hasMoreThanEcho() const;

    // The answer among what came in; empty while there is none, or while several contradict each other.
    std::optional<Found> answer() const;
    bool hasBytesBehind(const Found &found) const { return m_bytes.size() > found.frame.end; }
    // All of it, in the order it came in: echo, answer (`taken`), late answers before it, and garbage.
    std::vector<EscLineRow> rows(const std::optional<Found> &taken) const;

private:
    std::vector<qsizetype> echoes() const; // where each begins
    qsizetype echoEnd() const;             // just past the last one
    Instant endOf(const Frame &frame) const { return m_times.at(static_cast<std::size_t>(frame.end - 1)); }
    // When an answer of this size ends that begins as soon as the request is out.
    Instant earliestEnd(const Frame &frame) const;
    Instant settlesAt(const Frame &frame) const;
    bool isTooEarly(const Frame &frame) const;
    std::vector<Frame> frames() const;
    std::optional<Frame> chosen() const;

    QByteArray m_echo; // the request, as an adapter echoes it
    const CommandShape *m_shape = nullptr;
    Clock m_clock;
    QByteArray m_bytes;
    std::vector<Instant> m_times; // of each byte
};

} // namespace codewheel::esc
