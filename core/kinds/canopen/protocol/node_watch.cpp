// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/node_watch.h"

#include "kinds/canopen/protocol/cob_id.h"
#include "kinds/canopen/protocol/frames.h"

#include <algorithm>
#include <array>

namespace codewheel::canopen {
namespace {

constexpr std::size_t beatsCompared = 5; // of one node in four times its time, of two nodes in two
constexpr int beatsTime = 3;
constexpr int secondAnswersOfTwo = 3; // to requests in a row: a single one may be a doubled frame
constexpr int firstAnswersOfOne = 3;  // without a second one between
constexpr std::size_t mostAsked = 4096;
// Assumed: who has answered nothing for so long answers nothing any more that was asked before.
constexpr Instant longestLateness = std::chrono::seconds(10);
constexpr std::size_t statesCompared = 3;
// Assumed: one device does not go to and fro so fast, nor boot twice.
constexpr Instant statesTime = std::chrono::seconds(3);
constexpr Instant bootUpsTime = std::chrono::milliseconds(500);
constexpr Instant underWay = std::chrono::milliseconds(50); // what was sent before a command was taken
// Assumed: nobody switches a supply off and on so soon behind a reset.
constexpr Instant resetTime = std::chrono::seconds(2);

constexpr std::array commandRows{std::pair(NmtCommand::start, NmtState::operational),
                                 std::pair(NmtCommand::stop, NmtState::stopped),
                                 std::pair(NmtCommand::preOperational, NmtState::preOperational)};

std::uint32_t identifierOf(CobId::Service service, int node, int number = 0)
{
    return CobId{.service = service, .node = node, .number = number}.identifier();
}

Instant lateAfter(Instant producerTime)
{
    return producerTime * 3 / 2;
}

Instant lostAfter(Instant producerTime)
{
    return producerTime * 3;
}

struct RegisterBit
{
    std::uint16_t errors;
    std::uint16_t mask;
    std::uint8_t bit;
};

// Classes of errors with a bit of their own in object 1001h.
constexpr std::array registerBitsOfClasses{
    RegisterBit{0x2000, 0xF000, 1},
    RegisterBit{0x3000, 0xF000, 2},
    RegisterBit{0x4000, 0xF000, 3},
    RegisterBit{0x8100, 0xFF00, 4},
};

// Whether it went with what the register says; of errors without a bit of their own that is not known.
bool isGone(const Emcy &error, std::uint8_t errorRegister)
{
    return errorRegister == 0 || std::ranges::any_of(registerBitsOfClasses, [&](const RegisterBit &each) {
               return (error.code & each.mask) == each.errors && (error.errorRegister >> each.bit & 1) != 0 &&
                      (errorRegister >> each.bit & 1) == 0;
           });
}

bool isFor(const NmtRequest &request, int node)
{
    return request.node == 0 || request.node == node;
}

bool saysTheSame(const SdoFrame &one, const SdoFrame &other)
{
    return one.kind == other.kind && one.octets == other.octets && one.abortCode == other.abortCode;
}

} // namespace

NodeWatch::NodeWatch(int node)
    : m_node(node)
{
    for (int number = 1; number <= 4; ++number)
        m_tpdos.push_back(identifierOf(CobId::Service::tpdo, node, number));
}

void NodeWatch::forget()
{
    NodeWatch anew(m_node);
    anew.m_isStopped = m_isStopped;
    anew.m_bootUps = m_bootUps;
    anew.m_unaskedBootUps = m_unaskedBootUps;
    anew.m_isResetUnderWay = m_isResetUnderWay;
    anew.m_resetAt = m_resetAt;
    *this = std::move(anew);
}

void NodeWatch::setProducerTime(std::optional<Instant> time, Instant now)
{
    if (m_producerTime == time)
        return;
    m_producerTime = time;
    m_beats.clear();
    if (m_countsFrom)
        m_countsFrom = now;
}

void NodeWatch::setMayBeSilent(bool may, Instant now)
{
    if (m_mayBeSilent && !may && m_countsFrom)
        m_countsFrom = now;
    m_mayBeSilent = may;
}

void NodeWatch::take(const CanFrame &frame, Instant now)
{
    const Instant at = frame.time.value_or(now);
    if (frame.isExtended || frame.isError)
        return;
    const auto cob = CobId::of(frame.id);
    const auto isIts = [&](CobId::Service service) {
        return cob && cob->service == service && cob->node == m_node;
    };
    if (cob && cob->service == CobId::Service::nmt)
        takeCommand(frame, at);
    else if (isIts(CobId::Service::errorControl))
        takeErrorControl(frame, now);
    else if (frame.isRemote)
        return;
    else if (isIts(CobId::Service::emcy)) {
        if (const auto emcy = Emcy::read(frame.data()))
            takeEmcy(*emcy);
    } else if (std::ranges::count(m_tpdos, frame.id) != 0)
        takeTpdo(at);
    else
        takeSdo(frame, at);
}

void NodeWatch::takeCommand(const CanFrame &frame, Instant at)
{
    const auto request = NmtRequest::read(frame.data());
    if (!request)
        return;
    mayBeReset(*request, at);
    if (!isFor(*request, m_node))
        return;
    m_command = request->command;
    m_commandAt = at;
    m_isStopped = request->command == NmtCommand::stop;
    if (request->command != NmtCommand::start)
        m_pdoAt.reset();
    m_state.reset();
    m_statesTold.clear();
    m_bootedAt.reset();
}

bool NodeWatch::hasBooted() const
{
    return m_bootedAt && !m_state;
}

std::optional<NmtState> NodeWatch::commandedState() const
{
    const auto row =
        std::ranges::find_if(commandRows, [&](const auto &each) { return each.first == m_command; });
    return row != commandRows.end() ? std::optional(row->second) : std::nullopt;
}

void NodeWatch::takeErrorControl(const CanFrame &frame, Instant now)
{
    if (frame.isRemote) {
        m_isGuarded = true;
        return;
    }
    const auto told = NodeState::read(frame.data());
    if (!told)
        return;
    if (told->state == NmtState::bootUp && !told->toggle)
        takeBootUp(frame.time.value_or(now));
    else
        takeBeat(*told, frame.time, now);
}

void NodeWatch::mayBeReset(const NmtRequest &request, Instant at)
{
    if (!isReset(request.command))
        return;
    m_resetAt = at;
    m_isResetUnderWay = m_isResetUnderWay || isFor(request, m_node);
}

bool NodeWatch::isAskedFor(Instant bootUpAt) const
{
    return m_isResetUnderWay || (m_resetAt && bootUpAt - *m_resetAt <= resetTime);
}

// It has been through its reset, and its boot-up was not heard.
void NodeWatch::isAtWork(Instant at)
{
    if (m_resetAt && at - *m_resetAt > resetTime)
        m_isResetUnderWay = false;
}

// What was set and not stored is lost, the heartbeat with it.
void NodeWatch::takeBootUp(Instant at)
{
    ++m_bootUps;
    m_unaskedBootUps += isAskedFor(at) ? 0 : 1;
    m_isResetUnderWay = m_isStopped = false;
    m_hasTwoBootUps = m_bootedAt && at - *m_bootedAt < bootUpsTime;
    m_bootedAt = at;
    m_statesTold.clear();
    m_state.reset();
    m_command.reset();
    m_pdoAt.reset();
    m_countsFrom.reset();
    m_beats.clear();
    m_isGuarded = false;
    m_standing.clear();
}

void NodeWatch::takeBeat(const NodeState &told, std::optional<Instant> at, Instant now)
{
    m_state = told.state == NmtState::bootUp ? std::nullopt : std::optional(told.state);
    m_command.reset();
    m_isStopped = told.state == NmtState::stopped;
    if (told.state != NmtState::operational)
        m_pdoAt.reset();
    isAtWork(at.value_or(now));
    m_isGuarded = m_isGuarded || told.toggle;
    compareStates(told.state, at.value_or(now));
    if (m_isGuarded)
        return;
    m_countsFrom = at.value_or(now);
    if (at && isSupervised())
        compareBeats(*at);
}

void NodeWatch::compareBeats(Instant at)
{
    m_beats.push_back(at);
    if (m_beats.size() < beatsCompared)
        return;
    m_hasTooManyBeats = at - m_beats.front() < *m_producerTime * beatsTime;
    m_beats.pop_front();
}

// One device goes from one state to another, two of them tell theirs in turn.
void NodeWatch::compareStates(NmtState state, Instant at)
{
    m_statesTold.emplace_back(state, at);
    if (m_statesTold.size() < statesCompared)
        return;
    const auto &[first, since] = m_statesTold.front();
    const bool isBack = first == state && m_statesTold[1].first != state;
    const Instant together =
        m_producerTime.value_or(Instant()) > Instant() ? *m_producerTime * 2 : statesTime;
    m_hasTwoStates = isBack && at - since <= together;
    m_statesTold.pop_front();
}

void NodeWatch::takeTpdo(Instant at)
{
    if (m_command && at <= m_commandAt + (m_command == NmtCommand::start ? Instant() : underWay))
        return;
    m_state = NmtState::operational;
    m_pdoAt = at;
    m_command.reset();
    m_isStopped = false;
    isAtWork(at);
}

void NodeWatch::takeEmcy(const Emcy &emcy)
{
    if (emcy.isGone()) {
        std::erase_if(m_standing, [&](const Emcy &each) { return isGone(each, emcy.errorRegister); });
        return;
    }
    m_errors.push_back(emcy);
    if (m_errors.size() > mostErrors)
        m_errors.pop_front();
    std::erase_if(m_standing, [&](const Emcy &each) { return each.code == emcy.code; });
    if (m_standing.size() < mostErrors)
        m_standing.push_back(emcy);
}

// Within a block transfer requests and answers are not one to one; a log may have no requests at all.
void NodeWatch::takeSdo(const CanFrame &frame, Instant at)
{
    const bool counts = m_isAskingHeard && !m_isInBlocks;
    if (frame.id == identifierOf(CobId::Service::sdoAnswer, m_node)) {
        isAtWork(at);
        if (counts)
            takeSdoAnswer(frame, at);
    }
    if (frame.id != identifierOf(CobId::Service::sdoRequest, m_node))
        return;
    const auto request = SdoFrame::request(frame.data());
    if (!request)
        return;
    m_isAskingHeard = true;
    m_isInBlocks = request->kind == SdoFrame::Kind::block;
    if (request->kind == SdoFrame::Kind::abort)
        return;
    forgetUnanswered(at);
    m_asked.push_back({request->namedObject(), at});
    if (m_lastAnswer && m_lastAnswer->namedObject() == request->namedObject())
        m_lastAnswer.reset();
}

void NodeWatch::forgetUnanswered(Instant now)
{
    if (now - m_answeredAt > longestLateness)
        std::erase_if(m_asked, [&](const Asked &each) { return now - each.at > longestLateness; });
    if (m_asked.size() >= mostAsked)
        m_asked.pop_front();
}

// That of the second node may come only after the next request. That of one that is late may come after many,
// and after an abort: one node alone never sends more answers than there were requests. It answers them in
// turn, so that what was asked before the one that it answers has got none.
void NodeWatch::takeSdoAnswer(const CanFrame &frame, Instant at)
{
    const auto answer = SdoFrame::answer(frame.data());
    if (!answer)
        return;
    auto asked = std::ranges::find(m_asked, answer->namedObject(), &Asked::object);
    if (asked == m_asked.end() && answer->kind == SdoFrame::Kind::abort) // within segments
        asked = std::ranges::find(m_asked, std::optional<SdoObject>(), &Asked::object);
    m_answeredAt = at;
    if (asked != m_asked.end()) {
        hasAnswered(asked->at);
        m_asked.erase(m_asked.begin(), asked + 1);
        if (++m_firstInARow >= firstAnswersOfOne) {
            m_secondInARow = 0;
            m_hasOtherAnswer = m_hasTwoBootUps = false;
        }
    } else {
        m_firstInARow = 0;
        ++m_secondAnswers;
        ++m_secondInARow;
        const bool isOfSame =
            answer->namedObject() && m_lastAnswer && m_lastAnswer->namedObject() == answer->namedObject();
        m_hasOtherAnswer = m_hasOtherAnswer || (isOfSame && !saysTheSame(*answer, *m_lastAnswer));
    }
    m_lastAnswer = answer;
}

// A stopped node does not.
void NodeWatch::hasAnswered(Instant askedAt)
{
    if (!m_isStopped || askedAt <= m_commandAt)
        return;
    m_isStopped = false;
    m_command.reset();
}

bool NodeWatch::isDoubled() const
{
    return m_secondInARow >= secondAnswersOfTwo || m_hasOtherAnswer || m_hasTooManyBeats || m_hasTwoStates ||
           m_hasTwoBootUps;
}

Heartbeat NodeWatch::heartbeat(Instant now) const
{
    if (!m_countsFrom || m_isGuarded)
        return Heartbeat::notHeard;
    if (!isSupervised())
        return Heartbeat::heard;
    const Instant since = now - *m_countsFrom;
    if (m_mayBeSilent || since <= lateAfter(*m_producerTime))
        return Heartbeat::present;
    return since <= lostAfter(*m_producerTime) ? Heartbeat::late : Heartbeat::lost;
}

std::optional<Instant> NodeWatch::wakesAt(Instant now) const
{
    if (!isSupervised() || !m_countsFrom || m_mayBeSilent)
        return std::nullopt;
    for (const Instant after : {lateAfter(*m_producerTime), lostAfter(*m_producerTime)})
        if (now <= *m_countsFrom + after)
            return *m_countsFrom + after + Instant(1);
    return std::nullopt;
}

} // namespace codewheel::canopen
