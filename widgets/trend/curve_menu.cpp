// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/curve_menu.h"

#include "catalog/device_description.h"
#include "widgets/look/label_text.h"
#include "widgets/trend/track_text.h"

#include <set>

namespace codewheel {
namespace {

QString asTitle(const QString &text)
{
    return text.left(1).toUpper() + text.mid(1);
}

} // namespace

CurveMenu::CurveMenu(const Buses &buses, const Histories &histories, std::function<QString(Place)> station,
                     QWidget *parent)
    : QMenu(parent)
    , m_buses(buses)
    , m_histories(histories)
    , m_station(std::move(station))
{
    connect(this, &QMenu::aboutToShow, this, &CurveMenu::fill);
}

void CurveMenu::fill()
{
    clear();
    std::set<Place> places;
    for (const Place place : m_histories.places())
        places.insert(place);
    for (const Place place : places)
        addEncoder(place);
    if (places.empty())
        addAction(tr("No encoder is connected"))->setEnabled(false);
}

void CurveMenu::addEncoder(Place place)
{
    const QString station = m_station(place);
    QMenu *menu = addMenu(
        asLabel(station.isEmpty() ? place.shown() : QStringLiteral("%1  %2").arg(place.shown(), station)));
    const auto isKept = [&](Channel channel) {
        const History *history = m_histories.of(place, channel);
        return history != nullptr && history->span().has_value();
    };
    for (const Channel channel : {Channel::position, Channel::speed})
        add(*menu, asTitle(trackText({place, channel, {}})), {place, channel, {}});
    if (const EncoderSession *encoder = m_buses.encoder(place);
        (encoder != nullptr && encoder->can().cams) || isKept(Channel::cams))
        addBits(*menu, place, Channel::cams);
    for (const Channel channel : {Channel::in, Channel::out}) {
        if (!isKept(channel))
            continue;
        add(*menu, trackText({place, channel, {}}), {place, channel, {}});
        addBits(*menu, place, channel);
    }
}

void CurveMenu::addBits(QMenu &menu, Place place, Channel channel)
{
    QMenu *bits = menu.addMenu(channel == Channel::cams
                                   ? tr("Cams")
                                   : tr("Bits of %1", "IN or OUT").arg(trackText({place, channel, {}})));
    for (unsigned bit = 0; bit < bitCount(channel); ++bit)
        add(*bits, asTitle(trackText({place, channel, bit})), {place, channel, bit});
}

void CurveMenu::add(QMenu &menu, const QString &text, const Track &track)
{
    connect(menu.addAction(text), &QAction::triggered, this, [this, track] { Q_EMIT chosen(track); });
}

} // namespace codewheel
