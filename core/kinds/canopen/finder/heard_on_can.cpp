// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/finder/heard_on_can.h"

#include "finder/finder_texts.h"
#include "kinds/canopen/plan/canopen_plan.h"
#include "kinds/canopen/protocol/cob_id.h"
#include "vocabulary/sentence.h"

#include <QStringList>

namespace codewheel {

void HeardOnCan::take(const CanFrame &frame)
{
    if (frame.isError) {
        ++m_errors;
        return;
    }
    ++m_frames;
    m_master.take(frame);
    if (frame.isExtended) {
        ++m_extended;
        return;
    }
    using Service = canopen::CobId::Service;
    const auto its = canopen::CobId::of(frame.id);
    const bool isOfNode = its && its->node != 0 && !frame.isRemote && its->service != Service::sdoRequest &&
                          its->service != Service::rpdo;
    if (isOfNode)
        m_nodes.insert(its->node);
}

QString HeardOnCan::sentence() const
{
    QStringList numbers;
    for (const int node : m_nodes)
        numbers << QString::number(node);
    QString text = m_nodes.empty() ? FinderTexts::tr("Frames are heard, but none of a CANopen node.")
                   : m_nodes.size() == 1
                       ? codewheel::sentence(FinderTexts::tr("CANopen node %1 is heard."), {numbers.front()})
                       : codewheel::sentence(FinderTexts::tr("CANopen nodes are heard: %1."),
                                             {numbers.join(QStringLiteral(", "))});
    if (m_extended > 0 && m_extended == m_frames)
        text = FinderTexts::tr("Only frames of 29 bits are heard: J1939, not CANopen.");
    if (isMasterAtWork())
        text += u' ' + FinderTexts::tr("Another master is at work.");
    return text;
}

Found canBusAt(const QString &place, const QString &link, std::optional<int> rate, const QString &sentence)
{
    CanopenPlan plan;
    plan.settings.link = link;
    plan.settings.rate = rate.value_or(plan.settings.rate);
    return {.kind = QString::fromLatin1(canopenKind),
            .place = place,
            .settings = rate ? QStringLiteral("%1 Bd").arg(*rate) : QString(),
            .sentence = sentence,
            .plan = KindData(plan),
            .link = rate ? QStringLiteral("%1,rate=%2").arg(link).arg(*rate) : link};
}

} // namespace codewheel
