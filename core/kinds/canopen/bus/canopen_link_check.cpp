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
    : LinkCheck(link, {{CanopenLinkStep::opened}, {CanopenLinkStep::traffic}})
    , m_rate(rate)
{
    for (const CanopenAddress node : nodes)
        addStep(CanopenLinkStep::node, node);
    if (nodes.empty())
        addStep(CanopenLinkStep::node);
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

CanopenLinkFinding CanopenLinkCheck::found(CanopenLinkStep step, CanopenAddress address)
{
    switch (step) {
    case CanopenLinkStep::opened:
        return open();
    case CanopenLinkStep::traffic:
        return listen();
    case CanopenLinkStep::node:
        break;
    }
    return node(address);
}

CanopenLinkFinding CanopenLinkCheck::open()
{
    if (const auto opened = link().open(CanUse::watch); !opened)
        return refused(opened.error());
    const CanStatus status = link().status();
    const QString rate = inKilobits(status.rate.value_or(m_rate));
    const QString text =
        codewheel::sentence(status.listensOnly == true ? tr("%1 is open at %2 kBit/s, and listens only.")
                                                       : tr("%1 is open at %2 kBit/s. Nothing is sent."),
                            {link().name(), rate});
    const auto remark = link().remark();
    return told(CheckOutcome::passed, remark ? text + u' ' + refusalText(*remark) : text);
}

CanopenLinkFinding CanopenLinkCheck::listen()
{
    const Instant until = link().now() + listens;
    while (link().now() < until && !isStopped()) {
        const auto news = link().receive(until);
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
    if (m_extended == m_frames)
        return told(
            CheckOutcome::failed,
            tr("Only frames of 29 bits came: what is there speaks J1939, not CANopen. Another variant "
               "of the device is needed."));
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
    m_extended += frame.isExtended ? 1 : 0;
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
