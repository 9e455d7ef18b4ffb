// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/protocol/esc_answer.h"
#include "kinds/esc/protocol/esc_request.h"
#include "vocabulary/instant.h"
#include "vocabulary/traffic_kind.h"

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace codewheel::esc {

// What the manual leaves open can be set (spec kuebler-esc.md).
struct Timing
{
    Instant character{573};         // one character on the wire: 11 bits at 19200 Bd
    Instant answerTimeOut{100'000}; // from the last bit of the request to the first of the answer
    int retries = 2;                // of reads; a write is sent once
    Instant quietAfterWrite{100'000};
    // From the end of a request to the end of its answer, the longest seen on this line. After a time-out the
    // line has to be silent for twice that, and at least for twice the longest answer there is.
    Instant longestAnswer{};
    // How late a byte may be reported after it came in: 2 ms at a USB adapter, 16 ms more without low
    // latency.
    Instant adapterDelay{2'000};

    friend bool operator==(const Timing &, const Timing &) = default;
};

// What passed on the line, one piece per row, for the terminal and the figures.
struct EscLineRow
{
    using Kind = TrafficKind;

    Instant at{}; // of its last byte; for what was sent, of the first
    Kind kind = Kind::sent;
    QByteArray bytes;

    friend bool operator==(const EscLineRow &, const EscLineRow &) = default;
};

// How one request ended.
struct ExchangeResult
{
    std::optional<Answer> answer; // empty: none came
    int sent = 0;                 // how often it was sent
    int timeOuts = 0;
    int garbageBytes = 0;  // neither echo nor part of a well-formed answer
    bool isEchoed = false; // the request came back
    int lateBytes = 0;     // drained, or part of an answer that came too early to be this request's
    Instant answerTime{};  // from the end of the answered request to the end of the answer
};

// One request from its first byte to its end: sends it, finds the answer among echo and garbage, sends a read
// again if none came, and waits until the line is quiet before it is done, so that a late answer is never
// taken for the answer to the next request. A state machine without I/O: next() says what to do, received()
// takes what came in; what came before the first next() is drained. Used by the line's runner.
class Exchange
{
public:
    struct Send
    {
        QByteArray bytes;
    };
    struct Wait // for bytes, no later than `until`
    {
        Instant until;
    };
    struct Done
    {};
    using Action = std::variant<Send, Wait, Done>;

    Exchange(Request request, const Timing &timing);
    ~Exchange();
    Exchange(Exchange &&) noexcept;
    Exchange &operator=(Exchange &&) noexcept;

    // Each Send is returned once; it counts as carried out at `now`.
    Action next(Instant now);
    void received(const QByteArray &bytes, Instant at);

    const Request &request() const;
    const ExchangeResult &result() const; // complete when next() said Done
    std::vector<EscLineRow> takeRows();

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace codewheel::esc
