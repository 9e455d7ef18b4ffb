// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_exchange.h"

#include "kinds/esc/protocol/esc_reception.h"

#include <algorithm>
#include <utility>

namespace codewheel::esc {
namespace {

// A line that does not become quiet within this many times the required quiet is given up: somebody else is
// talking.
constexpr int drainingAtMost = 10;
// This much garbage can no longer be an answer.
constexpr qsizetype mostBytes = 4'096;

} // namespace

struct Exchange::Private
{
    enum class Stage { sending, listening, draining, done };

    Request request;
    Timing timing;
    ExchangeResult result{};
    std::vector<EscLineRow> rows{};
    Reception reception{};
    Stage stage = Stage::sending;
    Stage afterDraining = Stage::done;
    Instant requestEnd{};
    Instant lastHeard{}; // or when draining began
    Instant quiet{};
    Instant drainingEnd{};

    bool writes() const { return shapeOf(request.command).writes; }
    Instant characters(qsizetype count) const { return timing.character * count; }
    Instant quietAfterTimeOut() const;
    Instant deadline() const;
    Instant settlesAt(const Reception::Found &found) const { return found.settlesAt + timing.adapterDelay; }

    Send send(Instant now);
    Wait waitFor() const;
    void pass(Instant now);
    void listen(const QByteArray &bytes, Instant at);
    void take(const Reception::Found &found);
    void giveUp(Instant now);
    void drain(Instant from, Instant quietTime, Stage next);
    void addLate(const QByteArray &bytes, Instant at);
    void keepRows(const std::optional<Reception::Found> &taken);
};

Instant Exchange::Private::quietAfterTimeOut() const
{
    const Instant quietTime = 2 * std::max(timing.longestAnswer, characters(longestAnswerSize));
    return writes() ? std::max(quietTime, timing.quietAfterWrite) : quietTime;
}

// The answer has to begin within the time-out; from then on it may take as long as an answer takes, and
// settle.
Instant Exchange::Private::deadline() const
{
    const Instant begun = requestEnd + timing.answerTimeOut + timing.adapterDelay;
    if (!reception.hasMoreThanEcho())
        return begun + characters(1);
    return begun + characters(answerSize(shapeOf(request.command)) + silentCharacters) + timing.adapterDelay;
}

Exchange::Send Exchange::Private::send(Instant now)
{
    const QByteArray bytes = request.bytes();
    requestEnd = now + characters(bytes.size());
    reception = Reception(request, {requestEnd, timing.character});
    stage = Stage::listening;
    ++result.sent;
    rows.push_back({now, EscLineRow::Kind::sent, bytes});
    return {bytes};
}

Exchange::Wait Exchange::Private::waitFor() const
{
    if (stage == Stage::draining)
        return {std::min(lastHeard + quiet, drainingEnd)};
    const auto found = reception.answer();
    return {found ? std::min(settlesAt(*found), deadline()) : deadline()};
}

// What happens through the passing of time alone.
void Exchange::Private::pass(Instant now)
{
    if (stage == Stage::listening) {
        const auto found = reception.answer();
        if (found && now >= settlesAt(*found))
            take(*found);
        else if (now >= deadline())
            giveUp(now);
    }
    if (stage == Stage::draining) {
        if (now >= lastHeard + quiet)
            stage = afterDraining;
        else if (now >= drainingEnd)
            stage = Stage::done;
    }
}

void Exchange::Private::listen(const QByteArray &bytes, Instant at)
{
    reception.add(bytes, at);
    const auto found = reception.answer();
    if (found && found->isCertain)
        take(*found);
    else if (reception.size() > mostBytes)
        giveUp(at);
}

void Exchange::Private::take(const Reception::Found &found)
{
    const int lateBefore = result.lateBytes;
    keepRows(found);
    result.answer = found.frame.answer;
    result.answerTime = std::max(found.end - requestEnd, Instant{});
    const bool mayBeMore =
        result.timeOuts > 0 || result.lateBytes > lateBefore || reception.hasBytesBehind(found);
    if (writes())
        drain(reception.lastHeard(), timing.quietAfterWrite, Stage::done);
    else if (mayBeMore)
        drain(reception.lastHeard(), quietAfterTimeOut(), Stage::done);
    else
        stage = Stage::done;
}

void Exchange::Private::giveUp(Instant now)
{
    ++result.timeOuts;
    keepRows({});
    const bool again = !writes() && result.sent <= timing.retries;
    drain(now, quietAfterTimeOut(), again ? Stage::sending : Private::Stage::done);
}

void Exchange::Private::drain(Instant from, Instant quietTime, Stage next)
{
    stage = Stage::draining;
    afterDraining = next;
    lastHeard = from;
    quiet = quietTime;
    drainingEnd = from + drainingAtMost * quietTime;
}

void Exchange::Private::addLate(const QByteArray &bytes, Instant at)
{
    rows.push_back({at, EscLineRow::Kind::late, bytes});
    result.lateBytes += static_cast<int>(bytes.size());
    lastHeard = std::max(lastHeard, at);
}

void Exchange::Private::keepRows(const std::optional<Reception::Found> &taken)
{
    for (EscLineRow &row : reception.rows(taken)) {
        const int size = static_cast<int>(row.bytes.size());
        if (row.kind == EscLineRow::Kind::garbage)
            result.garbageBytes += size;
        else if (row.kind == EscLineRow::Kind::late)
            result.lateBytes += size;
        else if (row.kind == EscLineRow::Kind::echo)
            result.isEchoed = true;
        rows.push_back(std::move(row));
    }
}

Exchange::Exchange(Request request, const Timing &timing)
    : d(std::make_unique<Private>(Private{.request = request, .timing = timing}))
{}

Exchange::~Exchange() = default;
Exchange::Exchange(Exchange &&) noexcept = default;
Exchange &Exchange::operator=(Exchange &&) noexcept = default;

Exchange::Action Exchange::next(Instant now)
{
    d->pass(now);
    switch (d->stage) {
    case Private::Stage::sending:
        return d->send(now);
    case Private::Stage::listening:
    case Private::Stage::draining:
        return d->waitFor();
    case Private::Stage::done:
        break;
    }
    return Done{};
}

void Exchange::received(const QByteArray &bytes, Instant at)
{
    if (bytes.isEmpty())
        return;
    d->pass(at - d->characters(bytes.size() - 1));
    if (d->stage == Private::Stage::listening) {
        d->listen(bytes, at);
        return;
    }
    // Whatever is there before a request goes out belongs to an earlier one, and more of it may come.
    if (d->stage == Private::Stage::sending)
        d->drain(at, d->quietAfterTimeOut(), Private::Stage::sending);
    d->addLate(bytes, at);
}

const Request &Exchange::request() const
{
    return d->request;
}

const ExchangeResult &Exchange::result() const
{
    return d->result;
}

std::vector<EscLineRow> Exchange::takeRows()
{
    return std::exchange(d->rows, {});
}

} // namespace codewheel::esc
