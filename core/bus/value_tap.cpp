// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/value_tap.h"

namespace codewheel {

namespace {

constexpr Instant shortestUnseen = std::chrono::seconds(1);
constexpr int usualUnseen = 4; // intervals

} // namespace

void ValueTap::look(std::size_t device, const Reading &reading, bool isLive, Instant now,
                    const std::optional<ExchangedWords> &exchanged)
{
    if (device >= m_last.size())
        m_last.resize(device + 1);
    Last &last = m_last[device];
    const Instant before = std::exchange(last.at, reading.at);
    const bool isNew = before != reading.at || !last.hasShown; // it may be the moment of the opening
    const bool shows = isLive && (exchanged || reading.cams || reading.showsPosition());
    if (shows && isNew) {
        if (last.showed)
            noteWhatWasUnseen(device, before, reading.at);
        note(device, reading, exchanged);
    } else if (!shows && last.showed)
        m_noted.push_back({device, {.at = now}});
    last.showed = shows && (isNew || last.showed);
    last.hasShown = last.hasShown || last.showed;
}

// In its place: to copy what was put together field by field just before takes longer than all the rest.
void ValueTap::note(std::size_t device, const Reading &reading,
                    const std::optional<ExchangedWords> &exchanged)
{
    DeviceValues &noted = m_noted.emplace_back();
    noted.device = device;
    noted.shown.at = reading.at;
    noted.shown.words = exchanged;
    if (reading.cams)
        noted.shown.cams = reading.cams->on;
    if (reading.showsPosition()) {
        noted.shown.position = reading.position;
        noted.shown.stepsPerSecond = reading.stepsPerSecond;
    }
}

void ValueTap::interrupt()
{
    for (std::size_t device = 0; device < m_last.size(); ++device)
        if (std::exchange(m_last[device].showed, false))
            m_noted.push_back({device, {.at = m_last[device].at}});
}

bool ValueTap::isOverdue(const Last &last, Instant passed)
{
    return passed > shortestUnseen && last.usual < passed / usualUnseen;
}

// A second time in a row, the user may have chosen another pace: from then on, that is the usual one.
void ValueTap::noteWhatWasUnseen(std::size_t device, Instant from, Instant until)
{
    Last &last = m_last[device];
    const bool isUnseen = isOverdue(last, until - from);
    if (isUnseen)
        m_noted.push_back({device, {.at = from + last.usual}});
    if (!isUnseen || last.wasOverdue)
        last.usual = until - from;
    last.wasOverdue = isUnseen;
}

} // namespace codewheel
