// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/value_tap.h"

namespace codewheel {

namespace {

ShownValues valuesOf(const Reading &reading, const std::optional<ExchangedWords> &exchanged)
{
    ShownValues values{.at = reading.at, .cams = {}, .words = exchanged};
    if (reading.cams)
        values.cams = reading.cams->on;
    if (reading.state == EncoderState::operation && !reading.suspect) {
        values.position = reading.position;
        values.stepsPerSecond = reading.position ? reading.stepsPerSecond : std::nullopt;
    }
    return values;
}

} // namespace

void ValueTap::look(std::size_t device, const Reading &reading, bool isLive, Instant now,
                    const std::optional<ExchangedWords> &exchanged)
{
    if (device >= m_last.size())
        m_last.resize(device + 1);
    Last &last = m_last[device];
    const bool isNew = std::exchange(last.at, reading.at) != reading.at;
    const ShownValues values = isLive ? valuesOf(reading, exchanged) : ShownValues{};
    const bool shows = !values.isEmpty();
    if (shows && isNew)
        m_noted.push_back({device, values});
    else if (!shows && last.showed)
        m_noted.push_back({device, {.at = now}});
    last.showed = shows && (isNew || last.showed);
}

} // namespace codewheel
