// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/interbus/ring_operate_warning.h"

#include "bus/bus_outline.h"
#include "bus/encoder_bus.h"
#include "bus/word_channel.h"

#include <utility>

namespace codewheel {
namespace {

constexpr qsizetype mostNamed = 8; // the question has to fit a small screen

QString listed(QStringList lines)
{
    const int others = static_cast<int>(lines.size() - mostNamed);
    if (others > 0) {
        lines.resize(mostNamed);
        lines += OperateQuestion::tr("and %n more", nullptr, others);
    }
    return lines.join(u'\n');
}

} // namespace

RingOperateWarning::RingOperateWarning(const EncoderBus &ring, Called called)
    : m_ring(ring)
    , m_called(std::move(called))
{}

OperateWarning RingOperateWarning::warning() const
{
    const QString name = nameAmongOthers(m_ring.id());
    return {.question =
                name.isEmpty()
                    ? OperateQuestion::tr("This ring is real. Shall the program write to it?")
                    : OperateQuestion::tr("%1 is a real ring. Shall the program write to it?").arg(name),
            .explanation = explanation(),
            .helpTopic = "gateway.md#watch-and-operate"};
}

QString RingOperateWarning::explanation() const
{
    QStringList paragraphs{OperateQuestion::tr(
        "In Operate, the OUT words that you send go to the devices of the ring. A preset or a parameter "
        "changes the position that the controller sees. Switching over changes no OUT word.")};
    if (const QStringList devices = movable(); devices.isEmpty())
        paragraphs += OperateQuestion::tr("All devices with OUT words are encoders.");
    else
        paragraphs += OperateQuestion::tr(
                          "These devices have OUT words and are not known as encoders. What they drive can "
                          "move:") +
                      u'\n' + listed(devices);
    if (const QStringList devices = outNotKnown(); !devices.isEmpty())
        paragraphs +=
            OperateQuestion::tr(
                "OUT cannot be read back of these. It stays as it is until something is sent there:") +
            u'\n' + listed(devices);
    return paragraphs.join(QStringLiteral("\n\n"));
}

QStringList RingOperateWarning::movable() const
{
    QStringList devices;
    for (const BusNode &node : m_ring.outline().nodes()) {
        const WordChannel *channel = m_ring.channel(node.node);
        if (channel != nullptr && channel->outWords() > 0 && m_ring.encoder(node.node) == nullptr)
            devices += m_called(channel->place(), node.name);
    }
    return devices;
}

QStringList RingOperateWarning::outNotKnown() const
{
    QStringList devices;
    for (const BusNode &node : m_ring.outline().nodes()) {
        const WordChannel *channel = m_ring.channel(node.node);
        if (channel != nullptr && channel->outWords() > 0 && !channel->outIsKnown())
            devices += m_called(channel->place(), node.name);
    }
    return devices;
}

} // namespace codewheel
