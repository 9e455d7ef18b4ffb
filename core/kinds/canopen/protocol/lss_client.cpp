// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/lss_client.h"

#include "kinds/canopen/protocol/cob_id.h"
#include "kinds/canopen/protocol/frames.h"

#include <algorithm>
#include <utility>

namespace codewheel::canopen {
namespace {

using LssKind = LssRequest::Kind;

constexpr std::uint8_t anyoneThere = 0x80; // instead of a bit
constexpr int stepsOfWord = 33;            // its bits from 31 to 0, then all of it
constexpr int highestBit = 31;
constexpr std::uint8_t noNode = 0xFF;
constexpr Instant shortestScan = std::chrono::milliseconds(50);
constexpr Instant longestScan = std::chrono::milliseconds(200);

struct LssService
{
    LssKind kind;
    LssCommand request;
    LssCommand answer;
    int frames;
};

constexpr std::array lssServices{
    LssService{LssKind::configureAll, LssCommand::switchAll, LssCommand::switchAll, 1},
    LssService{LssKind::operateAll, LssCommand::switchAll, LssCommand::switchAll, 1},
    LssService{LssKind::select, LssCommand::selectVendor, LssCommand::selected, 4},
    LssService{LssKind::inquireIdentity, LssCommand::inquireVendor, LssCommand::inquireVendor, 4},
    LssService{LssKind::inquireNode, LssCommand::inquireNode, LssCommand::inquireNode, 1},
    LssService{LssKind::setNode, LssCommand::configureNode, LssCommand::configureNode, 1},
    LssService{LssKind::setRate, LssCommand::configureRate, LssCommand::configureRate, 1},
    LssService{LssKind::activate, LssCommand::activateRate, LssCommand::activateRate, 1},
    LssService{LssKind::store, LssCommand::store, LssCommand::store, 1},
    LssService{LssKind::fastScan, LssCommand::fastScan, LssCommand::identified, LssClient::mostSteps},
};

const LssService &serviceOf(LssKind kind)
{
    return *std::ranges::find(lssServices, kind, &LssService::kind);
}

LssCommand plus(LssCommand command, int step)
{
    return static_cast<LssCommand>(static_cast<int>(command) + step);
}

// Where a fast scan is after the first question.
struct ScanPlace
{
    std::size_t word;
    int bit; // below 0: the word is confirmed
};

ScanPlace scanPlace(int step)
{
    return {static_cast<std::size_t>((step - 1) / stepsOfWord), highestBit - (step - 1) % stepsOfWord};
}

} // namespace

LssClient::LssClient(const LssTimes &times)
    : m_times(times)
{
    m_times.fastScan = std::clamp(m_times.fastScan, shortestScan, longestScan);
}

void LssClient::begin(const LssRequest &request, Instant now)
{
    m_request = request;
    m_result = {};
    m_outcome.reset();
    m_isBusy = true;
    m_isScannedAgain = false;
    m_givenBefore = m_given;
    goOn(-m_step, now);
}

void LssClient::goOn(int steps, Instant now)
{
    m_step += steps;
    m_isWaiting = false;
    m_dueAt = now;
}

std::optional<CanFrame> LssClient::next(Instant now)
{
    if (m_isBusy && m_isWaiting && now >= m_dueAt)
        silent(now);
    if (!m_isBusy || m_isWaiting)
        return std::nullopt;
    m_isWaiting = true;
    m_sentAt = now;
    m_dueAt = now + timeOut();
    ++m_given;
    return frameNow().request();
}

LssFrame LssClient::frameNow() const
{
    const LssService &service = serviceOf(m_request.kind);
    const auto number = static_cast<std::uint32_t>(m_request.number);
    const auto word = static_cast<std::size_t>(m_step);
    switch (m_request.kind) {
    case LssKind::configureAll:
        return {.command = service.request, .number = 1};
    case LssKind::select:
        return {.command = plus(service.request, m_step), .number = m_request.identity.words.at(word)};
    case LssKind::setNode:
    case LssKind::activate:
        return {.command = service.request, .number = number};
    case LssKind::setRate: // behind the number of the table
        return {.command = service.request, .number = number << 8};
    case LssKind::fastScan:
        return scanFrame();
    default:
        return {.command = plus(service.request, m_step)};
    }
}

LssFrame LssClient::scanFrame() const
{
    if (m_step == 0)
        return {.command = LssCommand::fastScan, .bit = anyoneThere};
    const auto [word, bit] = scanPlace(m_step);
    const auto next = bit < 0 ? (word + 1) % NodeIdentity::size : word;
    return {.command = LssCommand::fastScan,
            .number = m_result.identity.words.at(word),
            .bit = static_cast<std::uint8_t>(std::max(bit, 0)),
            .word = static_cast<std::uint8_t>(word),
            .nextWord = static_cast<std::uint8_t>(next)};
}

// Of four frames that select only the last one is.
bool LssClient::isAnswered() const
{
    switch (m_request.kind) {
    case LssKind::configureAll:
    case LssKind::operateAll:
    case LssKind::activate:
        return false;
    case LssKind::select:
        return m_step + 1 == serviceOf(m_request.kind).frames;
    default:
        return true;
    }
}

Instant LssClient::timeOut() const
{
    if (!isAnswered())
        return m_request.kind == LssKind::select ? Instant() : m_times.pause;
    if (m_request.kind == LssKind::fastScan)
        return m_isScannedAgain ? longestScan : m_times.fastScan;
    return m_request.kind == LssKind::store ? m_times.store : m_times.answer;
}

void LssClient::fate(std::uint64_t number, CanFate fate, Instant now)
{
    if (!m_isBusy || number <= m_givenBefore)
        return;
    if (fate == CanFate::refused)
        end(LssOutcome::Kind::notSent);
    else if (m_isWaiting && number == m_given)
        m_dueAt = now + timeOut();
}

void LssClient::silent(Instant now)
{
    if (m_request.kind == LssKind::fastScan)
        scanned(false, now);
    else if (isAnswered())
        end(LssOutcome::Kind::noAnswer);
    else if (m_step + 1 == serviceOf(m_request.kind).frames)
        end(LssOutcome::Kind::done);
    else
        goOn(1, now);
}

bool LssClient::take(const CanFrame &frame, Instant now)
{
    if (!isDataOf(frame, CobId{.service = CobId::Service::lssAnswer}.identifier()))
        return false;
    const auto answer = LssFrame::read(frame.data());
    const bool isTooEarly = frame.time && *frame.time < m_sentAt; // it was under way when we asked
    if (!answer || !m_isBusy || !m_isWaiting || isTooEarly || !isAnswered()) {
        ++m_extraAnswers;
        return true;
    }
    const LssCommand expected = serviceOf(m_request.kind).answer;
    const bool isInquiry = m_request.kind == LssKind::inquireIdentity;
    if (answer->command == (isInquiry ? plus(expected, m_step) : expected))
        answered(*answer, now);
    else
        ++m_extraAnswers;
    return true;
}

void LssClient::answered(const LssFrame &answer, Instant now)
{
    switch (m_request.kind) {
    case LssKind::fastScan:
        scanned(true, now);
        return;
    case LssKind::inquireIdentity:
        m_result.identity.words.at(static_cast<std::size_t>(m_step)) = answer.number;
        if (m_step + 1 < serviceOf(m_request.kind).frames) {
            goOn(1, now);
            return;
        }
        break;
    case LssKind::inquireNode:
        if (answer.first() != noNode)
            m_result.node = answer.first();
        break;
    case LssKind::select:
        break;
    default: // they say how it went
        m_result.code = answer.first();
        m_result.codeOfMaker = answer.second();
    }
    end(m_result.code == 0 ? LssOutcome::Kind::done : LssOutcome::Kind::refused);
}

// Silence says that a bit is 1; a whole word has to be confirmed.
void LssClient::scanned(bool isAnswered, Instant now)
{
    const ScanPlace place = scanPlace(m_step);
    const bool isBit = m_step > 0 && place.bit >= 0;
    if (!isAnswered && !isBit) {
        lostInScan(now);
        return;
    }
    if (!isAnswered)
        m_result.identity.words.at(place.word) |= std::uint32_t{1} << place.bit;
    if (m_step + 1 == mostSteps)
        end(LssOutcome::Kind::done);
    else
        goOn(1, now);
}

void LssClient::lostInScan(Instant now)
{
    const bool isIncomplete = m_step > 0 || m_isScannedAgain;
    m_result = {};
    if (isIncomplete && !std::exchange(m_isScannedAgain, true)) {
        goOn(-m_step, now);
        return;
    }
    m_result.isIncomplete = isIncomplete;
    end(LssOutcome::Kind::noAnswer);
}

void LssClient::end(LssOutcome::Kind kind)
{
    m_result.kind = kind;
    m_result.extraAnswers = std::exchange(m_extraAnswers, 0);
    m_outcome = m_result;
    m_isBusy = false;
    m_isWaiting = false;
}

} // namespace codewheel::canopen
