// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/setup/node_task_run.h"

#include "kinds/canopen/bus/canopen_session.h"

#include <utility>

namespace codewheel {

using canopen::LssOutcome;
using canopen::LssRequest;
using canopen::NmtRequest;
using canopen::SdoOutcome;
using canopen::SdoRequest;

NodeTaskRun::NodeTaskRun(QObject *parent)
    : QObject(parent)
{}

void NodeTaskRun::setBus(CanopenSession *bus)
{
    if (m_bus)
        m_bus->disconnect(this);
    endWithoutBus();
    m_bus = bus;
    if (bus == nullptr)
        return;
    connect(bus, &CanopenSession::configured, this, qOverload<const Configured &>(&NodeTaskRun::take));
    connect(bus, &CanopenSession::transferEnded, this, qOverload<const TransferEnded &>(&NodeTaskRun::take));
    connect(bus, &CanopenSession::frameSent, this, qOverload<const FrameSent &>(&NodeTaskRun::take));
    connect(bus, &CanopenSession::updated, this, &NodeTaskRun::goOn);
    connect(bus, &CanopenSession::stateChanged, this, [this] {
        if (!m_bus || !m_bus->isOpen())
            endWithoutBus();
    });
}

void NodeTaskRun::start(canopen::NodeTask &task)
{
    Q_ASSERT(m_task == nullptr);
    m_task = &task;
    m_whyRefused.reset();
    m_underWay.reset();
    if (m_bus && m_bus->isOpen())
        goOn();
    else
        endWithoutBus();
}

void NodeTaskRun::cancel()
{
    if (m_task == nullptr)
        return;
    m_task->cancel();
    const auto *lss = underWay<LssRequest>();
    if (m_bus && lss != nullptr && lss->kind == LssRequest::Kind::fastScan)
        m_bus->cancelConfiguration();
    if (!m_underWay)
        goOn();
}

void NodeTaskRun::goOn()
{
    if (m_task == nullptr || m_underWay || !m_bus)
        return;
    m_underWay = m_task->next(m_bus->latest());
    if (m_underWay) {
        send(*m_underWay);
        Q_EMIT changed();
    } else if (m_task->isEnded()) {
        m_task = nullptr;
        Q_EMIT ended();
    }
}

void NodeTaskRun::send(const canopen::NodeTask::Request &request)
{
    if (const auto *lss = std::get_if<LssRequest>(&request))
        m_bus->configure(*lss);
    else if (const auto *transfer = std::get_if<SdoRequest>(&request))
        m_bus->transfer(*transfer);
    else
        m_bus->send(std::get<NmtRequest>(request).frame());
}

void NodeTaskRun::endUnderWay(const std::optional<Refusal> &refused)
{
    m_whyRefused = refused ? refused : m_whyRefused;
    m_underWay.reset();
}

void NodeTaskRun::take(const Configured &end)
{
    const auto *mine = underWay<LssRequest>();
    if (mine == nullptr || *mine != end.request)
        return;
    endUnderWay(end.refused);
    m_task->answered(end.outcome);
    goOn();
}

void NodeTaskRun::take(const TransferEnded &end)
{
    const auto *mine = underWay<SdoRequest>();
    if (mine == nullptr || *mine != end.request)
        return;
    endUnderWay(end.refused);
    m_task->answered(end.outcome);
    goOn();
}

void NodeTaskRun::take(const FrameSent &end)
{
    const auto *mine = underWay<NmtRequest>();
    if (mine == nullptr || mine->frame() != end.frame)
        return;
    endUnderWay(end.refused);
    m_task->sent(end.fate);
    goOn();
}

// What was sent may have been carried out; what comes next is not sent.
void NodeTaskRun::endWithoutBus()
{
    if (m_task == nullptr)
        return;
    auto under = std::exchange(m_underWay, std::nullopt);
    const CanopenSnapshot nobody{};
    while (true) {
        const bool wasSent = under.has_value();
        if (!under)
            under = m_task->next(nobody);
        if (!under)
            break;
        if (std::holds_alternative<LssRequest>(*under))
            m_task->answered(
                LssOutcome{.kind = wasSent ? LssOutcome::Kind::noAnswer : LssOutcome::Kind::notSent});
        else if (std::holds_alternative<SdoRequest>(*under))
            m_task->answered(
                SdoOutcome{.kind = wasSent ? SdoOutcome::Kind::noAnswer : SdoOutcome::Kind::notSent});
        else
            m_task->sent(wasSent ? CanFate::notKnown : CanFate::refused);
        under.reset();
    }
    if (!m_task->isEnded())
        m_task->cancel();
    m_task = nullptr;
    Q_EMIT ended();
}

} // namespace codewheel
