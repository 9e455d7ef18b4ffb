// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/simulator/simulated_node.h"

#include <algorithm>
#include <utility>

namespace codewheel::canopen {
namespace {

using std::chrono::duration_cast;
using std::chrono::milliseconds;

constexpr std::uint32_t nmtIdentifier = 0x000;
constexpr std::uint32_t lssRequestIdentifier = 0x7E5;
constexpr std::uint32_t lssAnswerIdentifier = 0x7E4;
constexpr std::uint32_t errorControlIdentifier = 0x700; // the node is added

constexpr std::int64_t mostStepsPerMillisecond = 819;      // per ms: 6000 rpm, above which it warns (assumed)
constexpr std::int64_t millisecondsPerTenthHour = 360'000; // ms

std::optional<Instant> sooner(std::optional<Instant> one, std::optional<Instant> other)
{
    return one && other ? std::min(one, other) : one ? one : other;
}

} // namespace

SimulatedNode::SimulatedNode(const CanopenEncoderPlan &plan)
    : m_plan(plan)
    , m_measurement(plan)
    , m_objects(encoderObjects(plan, plan.node.value_or(0)))
    , m_storedSettings{.node = plan.node, .rate = plan.rate}
    , m_rate(plan.rate)
    , m_lss(plan.identity, m_storedSettings)
{}

// What waits is sent in its order, except what is not due yet.
const CanFrame *SimulatedNode::toSend() const
{
    if (!m_isOn || isSilent())
        return nullptr;
    const auto isDue = [this](const Outgoing &each) { return each.due <= m_now; };
    const auto found = std::ranges::find_if(m_out, isDue);
    return found == m_out.end() ? nullptr : &found->frame;
}

void SimulatedNode::sent(const CanFrame &frame, Instant now)
{
    const auto isIt = [&frame](const Outgoing &each) {
        return each.frame.id == frame.id && each.frame.bytes == frame.bytes;
    };
    if (const auto found = std::ranges::find_if(m_out, isIt); found != m_out.end())
        m_out.erase(found);
    proceed(now);
}

void SimulatedNode::send(std::uint32_t identifier, Octets data, Instant delay)
{
    CanFrame frame{.id = identifier, .length = static_cast<std::uint8_t>(data.size())};
    std::ranges::copy(data, frame.bytes.begin());
    m_out.push_back({frame, m_now + delay});
}

// Most frames on a bus are those of others.
bool SimulatedNode::concerns(const CanFrame &frame) const
{
    if (!m_isOn || frame.isExtended || frame.isError)
        return false;
    return frame.id == lssRequestIdentifier || frame.id == nmtIdentifier || frame.isRemote ||
           frame.id == m_objects.word(0x1200, 1) || frame.id == syncIdentifier();
}

void SimulatedNode::take(const CanFrame &frame, Instant now)
{
    if (!concerns(frame))
        return;
    pass(now);
    if (frame.id == lssRequestIdentifier && !isSilent())
        answerLss(frame.data());
    else if (isRunning() && !isSilent())
        heed(frame);
    settle();
}

void SimulatedNode::heed(const CanFrame &frame)
{
    if (frame.isRemote)
        return answerRemote(frame.id);
    if (frame.id == nmtIdentifier) {
        if (const auto request = NmtRequest::read(frame.data()))
            command(*request);
    } else if (frame.id == syncIdentifier()) {
        measure();
        for (TransmitPdo &pdo : m_pdos)
            pdo.sync(m_objects);
    } else if (m_state != NmtState::stopped) {
        if (const auto answer = m_sdo.answer(frame.data(), *this))
            send(m_objects.word(0x1200, 2), *answer, answerDelay);
    }
}

void SimulatedNode::proceed(Instant now)
{
    pass(now);
    settle();
}

void SimulatedNode::settle()
{
    offerPdos();
    m_wakes = nextTime();
}

void SimulatedNode::pass(Instant now)
{
    const auto passed = duration_cast<milliseconds>(now) - duration_cast<milliseconds>(m_now);
    m_measurement.shaft().advance(passed);
    m_now = std::max(m_now, now);
    m_isTouched = false;
    if (!m_isOn)
        return;
    m_millisecondsOn += passed.count();
    if (m_isStarting) {
        m_lss.setSettings(m_storedSettings);
        m_rate = m_storedSettings.rate;
        restart(Reset::node);
        m_isStarting = false;
    }
    if (m_boots && m_now >= *m_boots)
        boot();
    if (m_changesRate && m_now >= *m_changesRate) {
        m_rate = m_lss.settings().rate;
        m_changesRate.reset();
    }
    if (!isRunning())
        return;
    if (m_errorControl.isHeartbeatDue(m_objects, m_now) && !isSilent())
        send(errorControlIdentifier + static_cast<std::uint32_t>(*m_node),
             std::array{static_cast<std::uint8_t>(m_state)});
    if (m_errorControl.isGuardingLost(m_now)) {
        raise({.code = 0x8130, .bits = 0x11});
        if (m_state == NmtState::operational)
            enter(NmtState::preOperational);
    }
}

std::optional<Instant> SimulatedNode::nextTime() const
{
    if (!m_isOn)
        return std::nullopt;
    std::optional<Instant> at = sooner(m_boots, m_changesRate);
    if (isSilent())
        at = sooner(at, m_silentUntil);
    for (const Outgoing &each : m_out)
        if (each.due > m_now)
            at = sooner(at, each.due);
    if (!isRunning())
        return at;
    at = sooner(at, m_errorControl.wakesAt(m_objects));
    if (m_state != NmtState::operational || isSilent())
        return at;
    const bool isMoving = m_measurement.shaft().speed() != 0;
    const auto nextMillisecond = Instant(duration_cast<milliseconds>(m_now) + milliseconds(1));
    for (const TransmitPdo &pdo : m_pdos)
        at = sooner(at, pdo.wakesAt(m_objects, isMoving ? std::optional(nextMillisecond) : std::nullopt));
    return at;
}

// What was not stored is forgotten, by a reset of the communication only in its area.
void SimulatedNode::restart(Reset what)
{
    if (what == Reset::node)
        m_lss.setSettings({.node = m_storedSettings.node, .rate = m_lss.settings().rate});
    m_node = m_lss.settings().node;
    m_lss.setNode(m_node);
    m_lss.reset();
    const ObjectDictionary before = m_objects;
    m_objects = encoderObjects(m_plan, m_node.value_or(0));
    m_objects.load(m_stored);
    if (what == Reset::communication)
        m_objects.takeProfile(before);
    m_sdo.reset();
    m_errors.clear();
    m_out.clear();
    m_state = NmtState::bootUp;
    m_boots = m_node ? std::optional(m_now + bootTime) : std::nullopt;
}

void SimulatedNode::boot()
{
    m_boots.reset();
    m_state = NmtState::preOperational;
    m_errorControl.begin(m_now);
    send(errorControlIdentifier + static_cast<std::uint32_t>(*m_node), std::array<std::uint8_t, 1>{});
    const std::uint16_t alarms = std::exchange(m_alarms, std::uint16_t{0});
    setAlarms(alarms);
    if (m_plan.quirks.startsItself)
        enter(NmtState::operational);
}

void SimulatedNode::enter(NmtState state)
{
    if (state == NmtState::operational && m_state != state)
        for (TransmitPdo &pdo : m_pdos)
            pdo.begin();
    if (state == NmtState::stopped)
        m_sdo.reset();
    m_state = state;
}

void SimulatedNode::command(const NmtRequest &request)
{
    if (request.node != 0 && request.node != m_node)
        return;
    switch (request.command) {
    case NmtCommand::start:
        return enter(NmtState::operational);
    case NmtCommand::stop:
        return enter(NmtState::stopped);
    case NmtCommand::preOperational:
        return enter(NmtState::preOperational);
    case NmtCommand::resetNode:
        return restart(Reset::node);
    case NmtCommand::resetCommunication:
        return restart(Reset::communication);
    }
}

void SimulatedNode::answerRemote(std::uint32_t identifier)
{
    if (identifier == errorControlIdentifier + static_cast<std::uint32_t>(*m_node)) {
        if (const auto answer = m_errorControl.guarded(m_state, m_objects, m_now)) {
            clear({.code = 0x8130, .bits = 0x11});
            send(identifier, std::array{*answer}, answerDelay);
        }
        return;
    }
    for (TransmitPdo &pdo : m_pdos)
        pdo.ask(identifier, m_objects);
}

void SimulatedNode::answerLss(Octets data)
{
    if (m_plan.quirks.lssOnlyWhenStopped && m_node && m_state != NmtState::stopped)
        return;
    const LssSlave::Outcome outcome = m_lss.take(data);
    if (outcome.answer)
        send(lssAnswerIdentifier, *outcome.answer, answerDelay);
    carryOut(outcome.event);
}

void SimulatedNode::carryOut(LssSlave::Event event)
{
    const Instant delay = milliseconds(m_lss.delay());
    switch (event) {
    case LssSlave::Event::none:
        return;
    case LssSlave::Event::store:
        if (m_plan.quirks.lssForgets)
            return;
        m_storedSettings = m_lss.settings();
        return wrote();
    case LssSlave::Event::activateRate:
        m_changesRate = m_now + delay;
        m_silentUntil = m_now + 2 * delay;
        return;
    case LssSlave::Event::leaves:
        if (!m_node && m_lss.settings().node)
            restart(Reset::communication);
        return;
    }
}

void SimulatedNode::measure()
{
    m_measurement.refresh(m_objects);
    const bool isTooFast = m_measurement.shaft().isFasterThan(mostStepsPerMillisecond);
    m_objects.set(0x6503, 0, m_alarms);
    m_objects.set(0x6505, 0, m_warnings | (isTooFast ? 1 : 0));
    m_objects.set(0x6508, 0, m_plan.operatingTime + m_millisecondsOn / millisecondsPerTenthHour);
}

// A PDO that has not got through yet takes the newer values.
void SimulatedNode::offerPdos()
{
    if (m_state != NmtState::operational || isSilent())
        return;
    measure();
    for (TransmitPdo &pdo : m_pdos) {
        const auto frame = pdo.next(m_objects, m_now);
        if (!frame)
            continue;
        const auto waiting = std::ranges::find_if(
            m_out, [&frame](const Outgoing &each) { return each.frame.id == frame->id; });
        if (waiting != m_out.end())
            waiting->frame = *frame;
        else
            m_out.push_back({*frame, m_now});
    }
}

TurningShaft &SimulatedNode::shaft()
{
    m_isTouched = true;
    return m_measurement.shaft();
}

void SimulatedNode::setOn(bool on)
{
    m_isTouched = true;
    m_isStarting = on && !m_isOn;
    m_isOn = on;
    if (on)
        return;
    m_node.reset();
    m_state = NmtState::bootUp;
    m_boots.reset();
    m_changesRate.reset();
    m_silentUntil = {};
    m_out.clear();
}

void SimulatedNode::setQuirks(const NodeQuirks &quirks)
{
    m_plan.quirks = quirks;
    m_measurement.setQuirks(quirks);
    if (m_isOn) {
        setOn(false);
        setOn(true);
    }
}

tl::expected<std::vector<std::uint8_t>, AbortCode> SimulatedNode::read(SdoObject object)
{
    measure();
    if (object.index == 0x1003 && object.sub > m_objects.number(0x1003) && m_objects.find(object) != nullptr)
        return tl::unexpected(AbortCode::noData);
    return m_objects.read(object);
}

} // namespace codewheel::canopen
