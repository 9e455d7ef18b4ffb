// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/canopen_status.h"

#include "can/can_state.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "vocabulary/sentence.h"

#include <QLocale>

#include <algorithm>

namespace codewheel {
namespace {

QString percent(double share)
{
    constexpr double hundred = 100;
    return QLocale().toString(share * hundred, 'f', 0);
}

} // namespace

ShownStatus CanopenStatus::of(const CanopenSession &session)
{
    const CanopenSnapshot &bus = session.latest();
    const QString name = session.linkName().section(QStringLiteral("/dev/"), -1);
    if (!bus.connected)
        return {Role::fault, sentence(tr("%1: no link", "CAN adapter"), {name})};
    const auto places = session.places();
    const auto heard = std::ranges::count_if(
        places, [&bus](Place place) { return bus.heard(CanopenAddress::of(place.node).node) != nullptr; });
    const bool isWhole = heard == std::ssize(places) && bus.status.state != CanState::busOff;
    const QString text =
        places.empty()
            ? sentence(tr("%1, %2 kBit/s, load %3 %, nodes heard: %4", "CAN adapter, rate"),
                       {name, inKilobits(session.rate()), percent(bus.figures.load),
                        QString::number(bus.nodes.size())})
            : sentence(tr("%1, %2 kBit/s, load %3 %, %4 of %5 heard", "CAN adapter, rate, encoders"),
                       {name, inKilobits(session.rate()), percent(bus.figures.load), QString::number(heard),
                        QString::number(places.size())});
    const QLocale locale;
    const QString figures = sentence(
        tr("CAN bus: %1 frames received, %2 sent, %3 error frames. State of the "
           "controller: %4"),
        {locale.toString(qulonglong{bus.figures.received}), locale.toString(qulonglong{bus.figures.sent}),
         locale.toString(qulonglong{bus.figures.errorFrames}), canStateText(bus.status.state)});
    return {isWhole ? Role::running : Role::fault, text, figures};
}

} // namespace codewheel
