// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/instant.h"
#include "encoder/traffic_kind.h"
#include "esc/esc_answer.h"
#include "esc/esc_request.h"

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace codewheel::esc {

// What the manual leaves open is settable (spec kuebler-esc.md).
struct Timing
{
    Instant character{573};         // one character on the wire: 11 bits at 19200 Bd
    Instant answerTimeOut{100'000}; // from the last bit of the request to the first of the answer
    int retries = 2;                // of reads; a write is sent once
    Instant quietAfterWrite{100'000};
    // From the end of a request to the end of its answer, as long as it was seen to take on this line. After
    // a time-out the line has to be silent for twice that, and at least for twice the longest answer there
    // is.
    Instant longestAnswer{};
    // How much later than it came in a byte may be told of: 2 ms at a USB adapter, 16 ms more without low
    // latency.
    Instant adapterDelay{2'000};

    friend bool operator==(const Timing &, const Timing &) = default;
};

// What passed on the line, one row each, for the terminal and the figures.
struct LineRow
{
    using Kind = TrafficKind;

    Instant at{}; // of its last byte; of the first one of what was sent
    Kind kind = Kind::sent;
    QByteArray bytes;

    friend bool operator==(const LineRow &, const LineRow &) = default;
};

// How one request ended.
struct ExchangeResult
{
    std::optional<Answer> answer; // nothing: none came
    int sent = 0;                 // how often it was sent
    int timeOuts = 0;
    int garbageBytes = 0; // neither echo nor part of a well-formed answer
    int lateBytes = 0;    // drained, or of an answer that came too early to be that of this request
    Instant answerTime{}; // from the end of the request that was answered to the end of the answer
};

// One request from its first byte to its end: sends it, finds the answer among echo and garbage, sends a read
// again when none came, and waits until the line is quiet before it is done, so that a late answer is never
// taken for that of the next request. A machine without I/O: next() says what to do, received() tells what
// came; what came before the first next() is drained. Used by the line's runner.
class Exchange
{
public:
    struct Send
    {
        QByteArray bytes;
    };
    struct Wait // for bytes, at most until then
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

    // Send is answered once for each sending; it is taken for carried out at `now`.
    Action next(Instant now);
    void received(const QByteArray &bytes, Instant at);

    const Request &request() const;
    const ExchangeResult &result() const; // complete when next() said Done
    std::vector<LineRow> takeRows();

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace codewheel::esc
