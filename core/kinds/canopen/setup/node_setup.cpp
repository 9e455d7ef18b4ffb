// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/setup/node_setup.h"

#include "kinds/canopen/protocol/encoder_objects.h"

#include <algorithm>
#include <utility>

namespace codewheel::canopen {
namespace {

constexpr SdoObject deviceTypeObject{0x1000, 0};
constexpr Instant longestStore = std::chrono::seconds(5);
// One that sends a heartbeat or PDOs does so within this, in nearly all plants.
constexpr Instant heardLately = std::chrono::seconds(3);

bool isHeardLately(const CanopenSnapshot &bus, int node)
{
    const CanopenSnapshot::Node *heard = bus.heard(node);
    return heard != nullptr && heard->heardAt + heardLately > bus.at;
}

std::vector<std::uint8_t> fourOctetsOf(std::uint32_t value)
{
    std::vector<std::uint8_t> octets;
    for (unsigned shift = 0; shift < 32; shift += 8)
        octets.push_back(static_cast<std::uint8_t>(value >> shift));
    return octets;
}

bool isWritingStep(NodeSetup::Step step)
{
    using enum NodeSetup::Step;
    return step == node || step == rate || step == store;
}

} // namespace

NodeSetup::NodeSetup(const NodeSetupWish &wish)
    : m_wish(wish)
    , m_selection(LssSelection::By::identity, wish.identity)
    , m_identity(wish.nodeBefore.value_or(0))
{
    const bool isLss = wish.way != NodeSetupWish::Way::object;
    const bool storesByLss = wish.way == NodeSetupWish::Way::lss;
    if (wish.changesNode())
        m_steps.push_back(Step::free);
    m_steps.push_back(isLss ? Step::select : Step::identity);
    if (wish.changesNode())
        m_steps.push_back(Step::node);
    if (isLss && wish.rate)
        m_steps.push_back(Step::rate);
    if (storesByLss)
        m_steps.push_back(Step::store);
    if (isLss)
        m_steps.push_back(Step::leave);
    if (!storesByLss)
        m_steps.push_back(Step::store);
    if (wish.isResetAfterwards())
        m_steps.push_back(Step::reset);
}

NodeSetup::StepState NodeSetup::stateOf(std::size_t step) const
{
    if (m_failedAt == step)
        return StepState::failed;
    if (m_failedAt && step > *m_failedAt) {
        if (m_steps[step] == Step::leave && m_hasLeft)
            return m_mayStay ? StepState::failed : StepState::done;
        return step == m_at ? StepState::now : StepState::leftOut;
    }
    return step < m_at ? StepState::done : step == m_at ? StepState::now : StepState::planned;
}

std::optional<NodeTask::Request> NodeSetup::next(const CanopenSnapshot &bus)
{
    if (m_isAsked || isEnded())
        return std::nullopt;
    if (m_isCancelled && !m_trouble && step() < Step::leave && m_store == Fate::notTried)
        fail(Trouble::cancelled);
    if (!isEnded() && step() == Step::free && isHeardLately(bus, *m_wish.node))
        fail(Trouble::numberTaken);
    if (!isEnded() && step() == Step::free && bus.isStopped(*m_wish.node))
        fail(Trouble::numberStopped);
    if (isEnded())
        return std::nullopt;
    m_isAsked = true;
    return requestOf(step(), bus);
}

std::optional<NodeTask::Request> NodeSetup::requestOf(Step step, const CanopenSnapshot &bus)
{
    switch (step) {
    case Step::free:
        return SdoRequest{.node = *m_wish.node, .object = deviceTypeObject};
    case Step::identity:
        return m_identity.next(bus);
    case Step::select:
        return *m_selection.next();
    case Step::leave:
        return LssRequest{.kind = LssRequest::Kind::operateAll};
    case Step::reset:
        return NmtRequest{NmtCommand::resetNode, *m_wish.nodeBefore};
    default:
        return writeOf(step);
    }
}

NodeTask::Request NodeSetup::writeOf(Step step) const
{
    const int before = m_wish.nodeBefore.value_or(0);
    const bool isByLss = step == Step::store ? m_wish.way == NodeSetupWish::Way::lss
                                             : m_wish.way != NodeSetupWish::Way::object;
    if (isByLss)
        return step == Step::node ? LssRequest{.kind = LssRequest::Kind::setNode, .number = *m_wish.node}
               : step == Step::rate
                   ? LssRequest{.kind = LssRequest::Kind::setRate, .number = m_wish.rate->place}
                   : LssRequest{.kind = LssRequest::Kind::store, .number = before};
    if (step == Step::store)
        return SdoRequest{.node = before,
                          .object = object::store,
                          .value = fourOctetsOf(object::saveSignature),
                          .timeOut = longestStore};
    SdoRequest request{.node = before, .object = m_wish.nodeObject};
    if (!m_isReadBack)
        request.value = {static_cast<std::uint8_t>(*m_wish.node)};
    return request;
}

void NodeSetup::done()
{
    if (isWritingStep(step()))
        fateOf(step()) = Fate::done;
    ++m_at;
}

// Nothing more is written, but a device is not left in configuration.
void NodeSetup::fail(Trouble trouble)
{
    m_trouble = trouble;
    m_failedAt = m_at;
    const auto indexOf = [this](Step step) {
        return static_cast<std::size_t>(std::ranges::find(m_steps, step) - m_steps.begin());
    };
    const std::size_t leaves = indexOf(Step::leave);
    const bool isConfigured = m_at >= indexOf(Step::select) && m_at < leaves;
    m_at = isConfigured ? leaves : m_steps.size();
}

void NodeSetup::answered(const LssOutcome &outcome)
{
    if (!std::exchange(m_isAsked, false))
        return;
    if (step() == Step::select) {
        takeSelection(outcome);
    } else if (step() == Step::leave) {
        m_mayStay = outcome.kind != LssOutcome::Kind::done;
        m_hasLeft = true;
        if (m_trouble)
            m_at = m_steps.size();
        else if (m_mayStay && m_wish.isResetAfterwards()) // which would end that, too
            fail(Trouble::notSent);
        else
            done();
    } else {
        m_code = outcome.code;
        m_codeOfMaker = outcome.codeOfMaker;
        takeWritten(outcome.kind);
    }
}

void NodeSetup::takeSelection(const LssOutcome &outcome)
{
    m_selection.take(outcome);
    if (m_selection.next())
        return;
    if (m_selection.isSelected()) {
        if (m_selection.node() == m_wish.nodeBefore)
            done();
        else
            fail(Trouble::isOther);
        return;
    }
    switch (*m_selection.trouble()) {
    case LssSelection::Trouble::notSent:
        return fail(Trouble::notSent);
    case LssSelection::Trouble::nobody:
    case LssSelection::Trouble::lost:
        return fail(Trouble::nobody);
    case LssSelection::Trouble::notTold:
        return fail(Trouble::identityNotTold);
    case LssSelection::Trouble::isOther:
        return fail(Trouble::isOther);
    case LssSelection::Trouble::several:
        return fail(Trouble::several);
    }
}

void NodeSetup::takeWritten(LssOutcome::Kind kind)
{
    switch (kind) {
    case LssOutcome::Kind::done:
        return done();
    case LssOutcome::Kind::refused:
        fateOf(step()) = Fate::notDone;
        return fail(Trouble::refused);
    case LssOutcome::Kind::notSent:
        fateOf(step()) = Fate::notDone;
        return fail(Trouble::notSent);
    case LssOutcome::Kind::noAnswer:
        fateOf(step()) = Fate::notKnown;
        return fail(Trouble::noAnswer);
    }
}

void NodeSetup::answered(const SdoOutcome &outcome)
{
    if (!std::exchange(m_isAsked, false))
        return;
    switch (step()) {
    case Step::free:
        if (outcome.kind == SdoOutcome::Kind::noAnswer)
            done();
        else
            fail(outcome.kind == SdoOutcome::Kind::notSent ? Trouble::notSent : Trouble::numberTaken);
        break;
    case Step::identity:
        takeIdentity(outcome);
        break;
    case Step::node:
        m_isReadBack ? takeReadBack(outcome) : takeNodeObject(outcome);
        break;
    default:
        takeStored(outcome);
        break;
    }
}

void NodeSetup::takeIdentity(const SdoOutcome &outcome)
{
    m_identity.answered(outcome);
    if (!m_identity.isEnded())
        return;
    if (m_identity.result() == IdentityReading::Result::notSent)
        fail(Trouble::notSent);
    else if (m_identity.result() != IdentityReading::Result::read)
        fail(Trouble::identityNotTold);
    else if (m_identity.identity() != m_wish.identity)
        fail(Trouble::isOther);
    else
        done();
}

// Without an answer it is read back, too: that tells.
void NodeSetup::takeNodeObject(const SdoOutcome &outcome)
{
    m_abortCode = outcome.abortCode;
    if (outcome.kind == SdoOutcome::Kind::aborted) {
        m_node = Fate::notDone;
        fail(Trouble::refused);
    } else if (outcome.kind == SdoOutcome::Kind::notSent) {
        m_node = Fate::notDone;
        fail(Trouble::notSent);
    } else {
        m_node = Fate::notKnown;
        m_isReadBack = true;
    }
}

void NodeSetup::takeReadBack(const SdoOutcome &outcome)
{
    if (outcome.kind != SdoOutcome::Kind::read) {
        fail(outcome.kind == SdoOutcome::Kind::notSent ? Trouble::notSent : Trouble::noAnswer);
    } else if (numberOf(outcome.value) != static_cast<std::uint32_t>(*m_wish.node)) {
        m_node = Fate::notDone;
        fail(Trouble::readBackOther);
    } else {
        done();
    }
}

void NodeSetup::takeStored(const SdoOutcome &outcome)
{
    m_abortCode = outcome.abortCode;
    takeWritten(outcome.kind == SdoOutcome::Kind::written   ? LssOutcome::Kind::done
                : outcome.kind == SdoOutcome::Kind::aborted ? LssOutcome::Kind::refused
                : outcome.kind == SdoOutcome::Kind::notSent ? LssOutcome::Kind::notSent
                                                            : LssOutcome::Kind::noAnswer);
}

void NodeSetup::sent(CanFate fate)
{
    if (!std::exchange(m_isAsked, false))
        return;
    m_isReset = fate != CanFate::refused;
    if (m_isReset)
        done();
    else
        fail(Trouble::notSent);
}

} // namespace codewheel::canopen
