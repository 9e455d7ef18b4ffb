// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/encoder_bus.h"

#include "bus/word_channel.h"

#include <utility>

namespace codewheel {

EncoderBus::EncoderBus(QDateTime begin, QObject *parent)
    : QObject(parent)
    , m_wallTime(std::move(begin))
{}

void EncoderBus::takeSleep(const Slept &slept, Instant at)
{
    m_wallTime.slept(slept.duration, at);
    const auto seconds = std::chrono::ceil<std::chrono::seconds>(slept.duration).count();
    Q_EMIT messaged({.at = at,
                     .severity = Severity::attention,
                     .id = MessageId::computerSlept,
                     .arguments = {std::int64_t{seconds}}});
}

WordChannel *EncoderBus::channel(DeviceNumber) const
{
    return nullptr;
}

std::vector<DeviceNumber> devicesWithOut(const EncoderBus &bus)
{
    std::vector<DeviceNumber> found;
    for (const DeviceNumber number : bus.numbers())
        if (const WordChannel *channel = bus.channel(number); channel != nullptr && channel->out() != 0)
            found.push_back(number);
    return found;
}

} // namespace codewheel
