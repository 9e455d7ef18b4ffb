// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/slcan_conversation.h"

#include "can/can_refusals.h"

#include <algorithm>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant probeTimeOut = 200ms;     // assumed; of the first commands too
constexpr Instant slcanCommandTimeOut = 1s; // assumed
constexpr Instant slcanFrameTimeOut = 1s;   // assumed
constexpr Instant longestOpening = 10s;     // of what says something all the time
constexpr Instant bootTime = 2s;            // of a board that was reset when its port was opened
constexpr Instant slcanStatusInterval = 1s;
constexpr Instant quietAfterBoot = 200ms;
constexpr int mostOpeningTries = 2;
constexpr int mostBoots = 3;
constexpr std::size_t mostUnansweredFrames = 16; // a Lawicel adapter has room for 32 frames
constexpr std::size_t mostSlcanWaiting = 64;

const QByteArray probeCommand = "?\r"; // assumed: no firmware has it

} // namespace

SlcanConversation::SlcanConversation(QString name, int rate)
    : m_name(std::move(name))
    , m_rate(rate)
{}

void SlcanConversation::open(CanUse use, bool takesUnsureWatch, bool isPortNew, Instant now)
{
    const bool isBegunAnew = m_state == State::opening; // answers to what was asked may still come
    if (!isBegunAnew)
        m_waiting.clear();
    m_use = use;
    m_takesUnsureWatch = takesUnsureWatch;
    m_state = State::opening;
    m_isKnown = m_opensPlain = false;
    m_firmware = {};
    m_listensOnly.reset();
    m_busState = CanState::notKnown;
    m_boots = m_rateTries = 0;
    m_statusBits = 0;
    m_bootEnds = isPortNew ? now + bootTime : isBegunAnew ? std::max(m_bootEnds, now) : now;
    m_opensUntil = now + longestOpening;
    m_reader = {};
    m_clock = {};
    m_out.clear();
    m_news = {};
    enter(Step::close, now);
}

QByteArray SlcanConversation::close()
{
    m_state = State::closed;
    m_step = Step::none;
    m_out.clear();
    forgetWaiting();
    return "C\r";
}

void SlcanConversation::ask(const QByteArray &command, Waiting::What what, Instant now, Instant timeOut)
{
    m_out += command;
    m_waiting.push_back({what, m_step, now + timeOut});
    if (m_waiting.size() > mostSlcanWaiting && m_waiting.front().isToldUnknown)
        m_waiting.pop_front();
}

void SlcanConversation::enter(Step step, Instant now)
{
    m_tries = step == m_step ? m_tries + 1 : 1;
    m_step = step;
    m_stepEnds = now + (step == Step::rate || step == Step::start ? slcanCommandTimeOut : probeTimeOut);
    switch (step) {
    case Step::boot:
    case Step::none:
        break;
    case Step::close:
        ask("C\r", Waiting::What::command, now, probeTimeOut);
        break;
    case Step::version:
        ask("V\r", Waiting::What::version, now, probeTimeOut);
        break;
    case Step::probe:
        ask(probeCommand, Waiting::What::command, now, probeTimeOut);
        break;
    case Step::settle:
        m_stepEnds = now + slcanCommandTimeOut;
        if (m_waiting.empty())
            enter(Step::rate, now);
        break;
    case Step::rate:
        ask(slcanRateCommand(m_rate), Waiting::What::command, now, slcanCommandTimeOut);
        break;
    case Step::start:
        ask(m_use == CanUse::watch && !m_opensPlain ? "L\r" : "O\r", Waiting::What::command, now,
            slcanCommandTimeOut);
        break;
    }
}

// 07h is right for `close` too.
void SlcanConversation::stepEnded(Step step, Answer answer, Instant now)
{
    switch (step) {
    case Step::boot:
        m_waiting.clear();
        enter(Step::close, now);
        break;
    case Step::close:
        enter(m_isKnown ? Step::settle : Step::version, now);
        break;
    case Step::version:
        enter(Step::probe, now);
        break;
    case Step::probe:
        probed(now);
        break;
    case Step::settle:
        m_waiting.clear();
        enter(Step::rate, now);
        break;
    case Step::rate:
        rateEnded(answer, now);
        break;
    case Step::start:
        startEnded(answer, now);
        break;
    case Step::none:
        break;
    }
}

// Firmware that answers to nothing else still says its version.
void SlcanConversation::probed(Instant now)
{
    if (m_firmware.answers) {
        m_isKnown = true;
        enter(Step::settle, now);
    } else if (m_tries < mostOpeningTries) {
        enter(Step::probe, now);
    } else if (now < m_bootEnds) {
        m_firmware = {}; // a board that starts says something, too
        enter(Step::boot, now);
        m_stepEnds = m_bootEnds;
    } else if (!m_firmware.version.isEmpty()) {
        openSilently(now);
    } else {
        fail({RefusalKind::link, CanRefusalId::adapterSilent, {m_name}});
    }
}

// A bus that is still open takes none: it is closed once more.
void SlcanConversation::rateEnded(Answer answer, Instant now)
{
    if (answer == Answer::done) {
        enter(Step::start, now);
    } else if (++m_rateTries < mostOpeningTries) {
        enter(Step::close, now);
    } else if (answer == Answer::refused) {
        fail({RefusalKind::link, CanRefusalId::rateRefused, {m_name, std::int64_t{m_rate}}});
    } else {
        fail({RefusalKind::link, CanRefusalId::openingNotKnown, {m_name}});
    }
}

void SlcanConversation::startEnded(Answer answer, Instant now)
{
    const bool hasListened = m_use == CanUse::watch && !m_opensPlain;
    if (answer == Answer::done) {
        m_listensOnly = hasListened;
        becomeOpen(now);
    } else if (hasListened && m_takesUnsureWatch) {
        m_opensPlain = true;
        enter(Step::close, now);
    } else if (hasListened) {
        fail({RefusalKind::link, CanRefusalId::watchNotSure, {m_name}});
    } else if (answer == Answer::refused) {
        fail({RefusalKind::link, CanRefusalId::openingRefused, {m_name}});
    } else {
        fail({RefusalKind::link, CanRefusalId::openingNotKnown, {m_name}});
    }
}

// It does not say whether it has done so.
void SlcanConversation::openSilently(Instant now)
{
    m_isKnown = true;
    m_waiting.clear();
    if (m_use == CanUse::watch && !m_takesUnsureWatch) {
        fail({RefusalKind::link, CanRefusalId::watchNotSure, {m_name}});
        return;
    }
    m_out += slcanRateCommand(m_rate) + "O\r";
    m_listensOnly = false;
    becomeOpen(now);
}

void SlcanConversation::becomeOpen(Instant now)
{
    m_state = State::open;
    m_step = Step::none;
    m_openSince = now;
    m_nextStatus = now;
}

// The board has started anew, and its bus is closed.
void SlcanConversation::reopen(Instant now)
{
    forgetWaiting();
    m_state = State::opening;
    m_isKnown = false;
    m_firmware = {};
    m_boots = m_rateTries = 0;
    m_bootEnds = now;
    m_opensUntil = now + longestOpening;
    waitForBoot(now);
}

// Until it says nothing more.
void SlcanConversation::waitForBoot(Instant now)
{
    if (m_step != Step::boot && ++m_boots > mostBoots)
        return;
    enter(Step::boot, now);
    m_stepEnds = now + quietAfterBoot;
}

// Whatever it has done meanwhile, it is not to stay open.
void SlcanConversation::fail(const Refusal &why)
{
    m_out += close();
    m_state = State::failed;
    m_failure = why;
}

QByteArray SlcanConversation::next(Instant now)
{
    tellTimeOuts(now);
    if (m_state == State::opening && now >= m_opensUntil)
        fail({RefusalKind::link, CanRefusalId::adapterSilent, {m_name}});
    if (m_state == State::opening && now >= m_stepEnds)
        stepEnded(m_step, Answer::none, now);
    if (m_state == State::open && m_firmware.isLawicel() && now >= m_nextStatus &&
        !isAwaited(Waiting::What::status)) {
        ask("F\r", Waiting::What::status, now, slcanFrameTimeOut);
        m_nextStatus = now + slcanStatusInterval;
    }
    return std::exchange(m_out, {});
}

// Their late answers are still theirs. What the adapter says to V shows that none of them has one any more.
void SlcanConversation::tellTimeOuts(Instant now)
{
    bool isAny = false;
    for (Waiting &one : m_waiting)
        if (!one.isToldUnknown && one.until <= now) {
            tellUnknown(one);
            isAny = true;
        }
    if (isAny && m_state == State::open && !m_firmware.version.isEmpty() &&
        !isAwaited(Waiting::What::version))
        ask("V\r", Waiting::What::version, now, slcanFrameTimeOut);
}

void SlcanConversation::tellUnknown(Waiting &one)
{
    if (one.what == Waiting::What::frame && !one.isToldUnknown)
        m_news.fates.push_back(CanFate::notKnown);
    one.isToldUnknown = true;
}

bool SlcanConversation::isAwaited(Waiting::What what) const
{
    return std::ranges::any_of(m_waiting,
                               [&](const Waiting &one) { return one.what == what && !one.isToldUnknown; });
}

std::optional<Instant> SlcanConversation::wakesAt() const
{
    if (m_state == State::opening)
        return std::min(m_stepEnds, m_opensUntil);
    if (m_state != State::open)
        return std::nullopt;
    std::optional<Instant> first;
    for (const Waiting &one : m_waiting)
        if (!one.isToldUnknown)
            first = std::min(first.value_or(one.until), one.until);
    if (m_firmware.isLawicel() && !isAwaited(Waiting::What::status))
        first = std::min(first.value_or(m_nextStatus), m_nextStatus);
    return first;
}

bool SlcanConversation::send(const CanFrame &frame, Instant now)
{
    const auto unanswered = std::ranges::count(m_waiting, false, &Waiting::isToldUnknown);
    if (m_state != State::open || std::cmp_greater_equal(unanswered, mostUnansweredFrames))
        return false;
    if (m_firmware.answers) {
        ask(slcanCommand(frame), Waiting::What::frame, now, slcanFrameTimeOut);
    } else {
        m_out += slcanCommand(frame);
        m_news.fates.push_back(CanFate::notKnown);
    }
    return true;
}

CanStatus SlcanConversation::status() const
{
    const bool isOpen = m_state == State::open;
    return {.state = m_busState,
            .rate = isOpen && !mayRunAt750() ? std::optional(m_rate) : std::nullopt,
            .listensOnly = isOpen ? m_listensOnly : std::nullopt};
}

bool SlcanConversation::mayRunAt750() const
{
    constexpr int asked = 800'000;
    return m_rate == asked && !m_firmware.isLawicel();
}

void SlcanConversation::forgetWaiting()
{
    for (Waiting &one : m_waiting)
        tellUnknown(one);
    m_waiting.clear();
}

} // namespace codewheel
