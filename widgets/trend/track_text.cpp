// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/track_text.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

struct TrackText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::TrackText)
};

} // namespace

QString trackText(const Track &track)
{
    switch (track.channel) {
    case Channel::position:
        return TrackText::tr("position");
    case Channel::speed:
        return TrackText::tr("speed");
    case Channel::in:
        return track.bit ? TrackText::tr("IN bit %1").arg(*track.bit) : QStringLiteral("IN");
    case Channel::out:
        return track.bit ? TrackText::tr("OUT bit %1").arg(*track.bit) : QStringLiteral("OUT");
    case Channel::cams:
        return track.bit ? TrackText::tr("cam %1").arg(*track.bit) : TrackText::tr("cams");
    }
    return {};
}

QString unitName(TrackUnit unit)
{
    switch (unit) {
    case TrackUnit::steps:
        return TrackText::tr("steps");
    case TrackUnit::turns:
        return TrackText::tr("turns");
    case TrackUnit::degrees:
        return TrackText::tr("degrees");
    case TrackUnit::millimetres:
        return TrackText::tr("millimetres");
    }
    return {};
}

QString unitSymbol(const TrackScale &scale, Channel channel)
{
    if (bitCount(channel) > 0)
        return {};
    const bool isSpeed = channel == Channel::speed;
    switch (scale.unit) {
    case TrackUnit::steps:
        return isSpeed ? TrackText::tr("steps/s") : TrackText::tr("steps");
    case TrackUnit::turns:
        return isSpeed ? TrackText::tr("rpm") : TrackText::tr("turns");
    case TrackUnit::degrees:
        return isSpeed ? QStringLiteral("°/s") : QStringLiteral("°");
    case TrackUnit::millimetres:
        return isSpeed ? QStringLiteral("mm/s") : QStringLiteral("mm");
    }
    return {};
}

} // namespace codewheel
