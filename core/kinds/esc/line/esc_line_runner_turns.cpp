// SPDX-License-Identifier: GPL-3.0-or-later
// Whose turn it is. A request without an answer takes as long as a dozen others, so those that do not answer
// share a small part of the line's time while others answer.
#include "kinds/esc/line/esc_line_runner_private.h"

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

// Of the line's time, in percent, for all of them together: until they are known to be silent, and
// afterwards.
constexpr int shareWhileDoubtful = 75;
constexpr int shareWhileSilent = 5;

// A position counts as old after so many rounds, but not before two encoders may have fallen silent, each
// asked three times.
constexpr int roundsUntilLate = 3;
constexpr Instant soonestLate = std::chrono::seconds(1);
constexpr int roundsForgotten = 8; // so soon one that took longer no longer counts

} // namespace

bool EscLineWork::beginDevice()
{
    const auto device = state.running ? deviceInTurn() : std::nullopt;
    if (!device)
        return false;
    devices[*device].turn = ++turns;
    const auto request = driver(*device)->next(link.now());
    collect(*device);
    return request && ask(Asker::device, *device, *request,
                          driver(*device)->wantedBaudRate().value_or(settings.baudRate));
}

std::optional<std::size_t> EscLineWork::deviceInTurn() const
{
    std::optional<std::size_t> chosen;
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const auto due = turnOf(i);
        if (due && *due <= link.now() && (!chosen || devices[i].turn < devices[*chosen].turn))
            chosen = i;
    }
    return chosen;
}

std::optional<Instant> EscLineWork::nextWish() const
{
    std::optional<Instant> first;
    for (std::size_t i = 0; i < devices.size() && state.running; ++i) {
        const auto due = turnOf(i);
        if (due && (!first || *due < *first))
            first = due;
    }
    return first;
}

// A job has its time-outs and retries, whatever happened before: its answers are awaited.
bool EscLineWork::isDoubtful(std::size_t device) const
{
    return !devices[device].answers && !driver(device)->busy();
}

bool EscLineWork::isSilent(std::size_t device) const
{
    return isDoubtful(device) && driver(device)->reading().state == EncoderState::silent;
}

bool EscLineWork::anyAnswers() const
{
    for (std::size_t i = 0; i < devices.size(); ++i)
        if (drivers[i] && devices[i].answers)
            return true;
    return false;
}

std::optional<Instant> EscLineWork::turnOf(std::size_t device) const
{
    const auto wakes = driver(device) ? driver(device)->wakesAt() : std::nullopt;
    if (wakes && isDoubtful(device) && anyAnswers())
        return std::max(*wakes, doubtfulFrom);
    return wakes;
}

void EscLineWork::noteTurn(const UnderWay &ended)
{
    Device &device = devices[ended.device];
    device.answers = ended.exchange.result().answer.has_value();
    if (device.answers || !anyAnswers())
        return;
    const int share = isSilent(ended.device) ? shareWhileSilent : shareWhileDoubtful;
    doubtfulFrom = link.now() + (link.now() - ended.begun) * (100 - share) / share;
}

void EscLineWork::noteRound(std::size_t device)
{
    Device &its = devices[device];
    const Instant at = driver(device)->reading().at;
    const Instant before = std::exchange(its.shownAt, at);
    if (at == before || before == Instant{})
        return;
    its.round = std::max(at - before, its.round - (its.round - (at - before)) / roundsForgotten);
}

Instant EscLineWork::lateAfter(std::size_t device) const
{
    const Instant round = std::max(devices[device].round, driver(device)->positionInterval());
    return std::clamp<Instant>(roundsUntilLate * round, soonestLate, Freshness::lateAfter);
}

void EscLineWork::forget()
{
    doubtfulFrom = {};
    for (Device &device : devices)
        device.answers = false;
}

} // namespace codewheel
