// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/not_live.h"

#include "bus/encoder_bus.h"
#include "bus/word_channel.h"

namespace codewheel {
namespace {

template <typename Shown> // EncoderSession, WordChannel
std::optional<NotLive> notLiveOf(const Shown &shown)
{
    const Freshness &freshness = shown.freshness();
    if (freshness.isLive())
        return std::nullopt;
    return NotLive{freshness.reason(), freshness.isOld() ? shown.dateTime(freshness.seen()) : QDateTime()};
}

} // namespace

std::optional<NotLive> notLive(const EncoderBus &bus, Place place)
{
    if (const EncoderSession *encoder = bus.encoder(place))
        return notLiveOf(*encoder);
    if (const WordChannel *words = bus.channel(place))
        return notLiveOf(*words);
    return std::nullopt;
}

} // namespace codewheel
