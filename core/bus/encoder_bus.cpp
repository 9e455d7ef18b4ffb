// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/encoder_bus.h"

#include "bus/word_channel.h"

namespace codewheel {

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
