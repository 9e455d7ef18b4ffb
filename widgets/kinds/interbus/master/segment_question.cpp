// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/master/segment_question.h"

#include "bus/word_channel.h"
#include "kinds/interbus/ring/id_code.h"
#include "kinds/interbus/ring/numbering.h"
#include "kinds/interbus/ring/ring_session.h"
#include "vocabulary/hex.h"
#include "widgets/kinds/interbus/master/master_panel.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr qsizetype devicesNamed = 8;

QString lostDeviceText(const RingSession &bus, const RingDevice &device)
{
    const EncoderSession *encoder = bus.encoder(device.number);
    return QStringLiteral("%1 %2").arg(device.number.toString(),
                                       nameOrTerminal(device, encoder ? &encoder->device() : nullptr));
}

QString listText(const QStringList &texts)
{
    const QString named = texts.first(std::min(texts.size(), devicesNamed)).join(QStringLiteral(", "));
    const auto more = static_cast<int>(texts.size() - devicesNamed);
    return more > 0 ? MasterPanel::tr("%1 and %n more", nullptr, more).arg(named) : named;
}

} // namespace

QString segmentQuestion(const RingSession &bus, int segment)
{
    QStringList devices;
    QStringList outputs;
    int withOutputs = 0;
    for (const std::size_t place : placesBehindSegment(bus.structure(), segment)) {
        const RingDevice &device = bus.structure()[place];
        devices << lostDeviceText(bus, device);
        withOutputs += device.outWords > 0 ? 1 : 0;
        if (const WordChannel *channel = bus.channel(device.number); channel && channel->out() != 0)
            outputs << MasterPanel::tr("OUT %1 is %2").arg(device.number.toString(), hexWord(channel->out()));
    }
    QStringList sentences{MasterPanel::tr("Switch segment %1 off? Out of the data cycles go: %2.")
                              .arg(segment)
                              .arg(listText(devices))};
    if (withOutputs > 0)
        sentences << MasterPanel::tr("The outputs of %n devices go to 0.", nullptr, withOutputs);
    if (!outputs.isEmpty())
        sentences << MasterPanel::tr("Not 0 now: %1.").arg(listText(outputs));
    return sentences.join(u' ');
}

} // namespace codewheel
