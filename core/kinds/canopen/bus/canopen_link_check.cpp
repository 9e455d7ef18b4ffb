// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_link_check.h"

#include "can/can_state.h"
#include "kinds/canopen/protocol/cob_id.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

using canopen::CobId;

// What only a node itself sends with its number.
bool isOfNode(CobId::Service service)
{
    using enum CobId::Service;
    return service == emcy || service == tpdo || service == sdoAnswer || service == errorControl;
}

} // namespace

CanopenLinkCheck::CanopenLinkCheck(CanLink &link, int rate, const std::vector<CanopenAddress> &nodes)
    : m_link(link)
    , m_rate(rate)
    , m_steps{{CanopenLinkStep::opened}, {CanopenLinkStep::traffic}}
{
    for (const CanopenAddress node : nodes)
        m_steps.push_back({CanopenLinkStep::node, node});
    if (nodes.empty())
        m_steps.push_back({CanopenLinkStep::node});
}

CanopenLinkCheck::~CanopenLinkCheck()
{
    m_link.close();
}

QString CanopenLinkCheck::stepText(CanopenLinkStep step, CanopenAddress address)
{
    switch (step) {
    case CanopenLinkStep::opened:
        return tr("CAN adapter");
    case CanopenLinkStep::traffic:
        return tr("Traffic on the bus");
    case CanopenLinkStep::node:
        break;
    }
    return address.isNode() ? codewheel::sentence(tr("Node %1"), {address.shown()}) : tr("Nodes");
}

void CanopenLinkCheck::interrupt()
{
    m_isStopped = true;
    m_link.interrupt();
}

CanopenLinkFinding CanopenLinkCheck::told(CheckOutcome outcome, const QString &sentence) const
{
    CanopenLinkFinding finding = m_steps[m_next];
    finding.outcome = outcome;
    finding.sentence = sentence;
    return finding;
}

CanopenLinkFinding CanopenLinkCheck::refused(const Refusal &why)
{
    m_isOver = true;
    CanopenLinkFinding finding = told(CheckOutcome::failed, refusalText(why));
    finding.why = why;
    return finding;
}

CanopenLinkFinding CanopenLinkCheck::next()
{
    CanopenLinkFinding finding =
        told(CheckOutcome::skipped, m_isStopped ? tr("Not tested: the test was ended.")
                                                : tr("Not tested, because of what failed before."));
    if (!m_isOver && !m_isStopped) {
        switch (m_steps[m_next].step) {
        case CanopenLinkStep::opened:
            finding = open();
            break;
        case CanopenLinkStep::traffic:
            finding = listen();
            break;
        case CanopenLinkStep::node:
            finding = node(m_steps[m_next].address);
            break;
        }
    }
    ++m_next;
    if (isDone())
        m_link.close();
    return finding;
}

CanopenLinkFinding CanopenLinkCheck::open()
{
    if (const auto opened = m_link.open(CanUse::watch); !opened)
        return refused(opened.error());
    const CanStatus status = m_link.status();
    const QString rate = inKilobits(status.rate.value_or(m_rate));
    return told(CheckOutcome::passed,
                codewheel::sentence(status.listensOnly == true
                                        ? tr("%1 is open at %2 kBit/s, and listens only.")
                                        : tr("%1 is open at %2 kBit/s. Nothing is sent."),
                                    {m_link.name(), rate}));
}

CanopenLinkFinding CanopenLinkCheck::listen()
{
    const Instant until = m_link.now() + listens;
    while (m_link.now() < until && !m_isStopped) {
        const auto news = m_link.receive(until);
        if (!news)
            return refused(news.error());
        std::ranges::for_each(news->frames, [this](const CanFrame &frame) { take(frame); });
    }
    const QLocale locale;
    if (m_errors > 0)
        return told(CheckOutcome::failed,
                    codewheel::sentence(
                        tr("Error frames: %1, others: %2. The rate is probably wrong, or the wiring: check "
                           "the terminators at both ends, and that CAN_H and CAN_L are not swapped."),
                        {locale.toString(m_errors), locale.toString(m_frames)}));
    if (m_frames == 0)
        return told(CheckOutcome::skipped,
                    tr("Nothing was heard for three seconds. Nodes may be silent until they are started or "
                       "asked; or check the rate, the wiring and the supply of the nodes."));
    const QString heard =
        codewheel::sentence(tr("%1 frames came in three seconds."), {locale.toString(m_frames)});
    return told(CheckOutcome::passed,
                !m_master.isHeard() ? heard
                                    : heard + u' ' +
                                          codewheel::sentence(tr("Another master is at work (heard: %1)."),
                                                              {OtherMaster::textOf(m_master.argument())}));
}

void CanopenLinkCheck::take(const CanFrame &frame)
{
    if (frame.isError) {
        ++m_errors;
        return;
    }
    ++m_frames;
    m_master.take(frame);
    const auto cob = frame.isExtended || frame.isRemote ? std::nullopt : CobId::of(frame.id);
    if (!cob || !isOfNode(cob->service))
        return;
    Heard &heard = m_heard.at(static_cast<std::size_t>(cob->node));
    ++heard.frames;
    if (cob->service != CobId::Service::errorControl)
        return;
    if (const auto told = canopen::NodeState::read(frame.data()))
        heard.state = told->state;
}

// "operational"; empty: it tells no state.
QString CanopenLinkCheck::heardText(CanopenAddress address) const
{
    const auto &state = m_heard.at(static_cast<std::size_t>(address.node)).state;
    return state ? canopen::NodeState{.state = *state}.text() : QString();
}

CanopenLinkFinding CanopenLinkCheck::node(CanopenAddress address) const
{
    if (address.isNode()) {
        if (m_heard.at(static_cast<std::size_t>(address.node)).frames == 0)
            return told(CheckOutcome::skipped,
                        tr("It was not heard. It may tell nothing by itself: connected, in Operate, it is "
                           "asked."));
        const QString state = heardText(address);
        return told(CheckOutcome::passed, state.isEmpty()
                                              ? tr("It is heard.")
                                              : codewheel::sentence(tr("It is heard: %1."), {state}));
    }
    QStringList heard;
    for (CanopenAddress one{1}; one.isNode(); ++one.node)
        if (m_heard.at(static_cast<std::size_t>(one.node)).frames > 0)
            heard << one.shown();
    if (heard.isEmpty())
        return told(CheckOutcome::skipped, tr("None is heard. The search asks each number."));
    return told(CheckOutcome::passed,
                codewheel::sentence(tr("Heard: %1."), {heard.join(QStringLiteral(", "))}));
}

} // namespace codewheel
