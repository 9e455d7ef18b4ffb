// SPDX-License-Identifier: GPL-3.0-or-later
// What an SLCAN adapter says, and to which command it belongs.
#include "can/slcan_conversation.h"

#include <algorithm>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant leastOpenTime = 1s; // what is said sooner belongs to opening

// Of the answer to F.
enum StatusBit : std::uint8_t {
    receiveQueueFull = 0x01,
    transmitQueueFull = 0x02,
    errorWarning = 0x04,
    overrun = 0x08,
    errorPassive = 0x20,
    arbitrationLost = 0x40,
    busError = 0x80,
};

// What a status says beyond the state, as an error frame of SocketCAN (linux/can/error.h).
CanFrame errorFrameOf(std::uint8_t bits)
{
    constexpr std::uint32_t lostArbitration = 0x02;
    constexpr std::uint32_t controller = 0x04;
    constexpr std::uint32_t bus = 0x80;
    constexpr std::uint8_t receiveOverflow = 0x01; // of the second byte
    constexpr std::uint8_t transmitOverflow = 0x02;
    constexpr std::uint8_t warning = 0x0C;
    constexpr std::uint8_t passive = 0x30;
    CanFrame frame{.isError = true, .length = CanFrame::mostBytes};
    std::uint8_t &detail = frame.bytes[1];
    if ((bits & (receiveQueueFull | overrun)) != 0)
        detail |= receiveOverflow;
    if ((bits & transmitQueueFull) != 0)
        detail |= transmitOverflow;
    if ((bits & errorPassive) != 0)
        detail |= passive;
    else if ((bits & errorWarning) != 0)
        detail |= warning;
    frame.id = (detail != 0 ? controller : 0U) | ((bits & arbitrationLost) != 0 ? lostArbitration : 0U) |
               ((bits & busError) != 0 ? bus : 0U);
    return frame;
}

// A torn frame is none.
bool mayBeVersion(const QByteArray &text)
{
    return !std::ranges::all_of(
        text, [](char c) { return QByteArray("0123456789ABCDEFabcdeftTrRzZ").contains(c); });
}

} // namespace

void SlcanConversation::received(const QByteArray &bytes, Instant now)
{
    for (const SlcanItem &item : m_reader.read(bytes))
        take(item, now);
}

void SlcanConversation::take(const SlcanItem &item, Instant now)
{
    switch (item.kind) {
    case SlcanItem::Kind::frame:
        takeFrame(item, now);
        break;
    case SlcanItem::Kind::done:
        answerOldest(Answer::done, now);
        break;
    case SlcanItem::Kind::refused:
        answerOldest(Answer::refused, now);
        break;
    case SlcanItem::Kind::sent:
        if (!takeAnswerTo(Waiting::What::frame))
            ++m_skipped;
        break;
    case SlcanItem::Kind::text:
        if (m_state == State::opening)
            takeTextInOpening(item.text, now);
        else
            takeText(item.text, now);
        break;
    }
}

void SlcanConversation::takeFrame(const SlcanItem &item, Instant now)
{
    if (m_state != State::open) // of an adapter that was open before
        return;
    CanFrame frame = item.frame;
    frame.time = item.stamp ? m_clock.timeOf(*item.stamp, now) : now;
    m_news.frames.push_back(frame);
}

// Silent firmware says neither.
void SlcanConversation::answerOldest(Answer answer, Instant now)
{
    m_firmware.answers = m_firmware.answers || m_state == State::opening;
    if (m_waiting.empty()) {
        ++m_skipped;
        return;
    }
    const Waiting oldest = m_waiting.front();
    m_waiting.pop_front();
    if (oldest.what == Waiting::What::frame && !oldest.isToldUnknown)
        m_news.fates.push_back(answer == Answer::done ? CanFate::done : CanFate::refused);
    if (m_state != State::opening)
        return;
    if (m_step == Step::settle ? m_waiting.empty() : oldest.step == m_step)
        stepEnded(m_step, answer, now);
}

// Adapters answer in turn, so those before it have no answer.
bool SlcanConversation::takeAnswerTo(Waiting::What what)
{
    const auto found = std::ranges::find(m_waiting, what, &Waiting::what);
    if (found == m_waiting.end())
        return false;
    for (auto one = m_waiting.begin(); one != found; ++one)
        tellUnknown(*one);
    if (what == Waiting::What::frame && !found->isToldUnknown)
        m_news.fates.push_back(CanFate::done);
    m_waiting.erase(m_waiting.begin(), found + 1);
    return true;
}

// A board that starts says so before it answers anything; some answer even what they do not know in words.
void SlcanConversation::takeTextInOpening(const QByteArray &text, Instant now)
{
    if (m_step != Step::boot && m_firmware.version.isEmpty() && mayBeVersion(text) &&
        takeAnswerTo(Waiting::What::version)) {
        m_firmware.version = text;
        if (m_step == Step::version)
            stepEnded(m_step, Answer::done, now);
    } else if (m_step != Step::boot && m_firmware.version.isEmpty() && text.startsWith('V')) {
        m_isKnown = false; // something else has been taken for the answer to V, and for those since
        waitForBoot(now);
    } else if (m_step == Step::probe && mayBeVersion(text)) {
        m_firmware.answers = true;
        stepEnded(m_step, Answer::done, now);
    } else if (m_step == Step::boot || (m_step == Step::close && !m_isKnown && hasWords(text))) {
        waitForBoot(now);
    } else {
        m_skipped += static_cast<std::uint64_t>(text.size());
    }
}

void SlcanConversation::takeText(const QByteArray &text, Instant now)
{
    const auto bits = slcanStatusBits(text);
    if (bits && m_firmware.isLawicel() && takeAnswerTo(Waiting::What::status))
        takeStatus(*bits, now);
    else if (text == m_firmware.version && takeAnswerTo(Waiting::What::version))
        return;
    else if (m_state == State::open && hasWords(text) && text != m_firmware.version &&
             now >= m_openSince + leastOpenTime)
        reopen(now);
    else
        m_skipped += static_cast<std::uint64_t>(text.size());
}

void SlcanConversation::takeStatus(std::uint8_t bits, Instant now)
{
    constexpr std::uint8_t lasting = errorWarning | errorPassive;
    m_busState = (bits & errorPassive) != 0   ? CanState::passive
                 : (bits & errorWarning) != 0 ? CanState::warning
                                              : CanState::active;
    const bool isNew = std::exchange(m_statusBits, bits) != bits || (bits & ~lasting) != 0;
    if (CanFrame error = errorFrameOf(bits); error.id != 0 && isNew) {
        error.time = now;
        m_news.frames.push_back(error);
    }
}

} // namespace codewheel
