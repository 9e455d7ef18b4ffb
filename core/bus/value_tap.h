// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/shown_values.h"

#include <utility>
#include <vector>

namespace codewheel {

// Of a device, by its place in the runner of its bus.
struct DeviceValues
{
    std::size_t device = 0;
    ShownValues shown;
};

// Notes what each device of a bus shows, once per cycle or answer, also where it shows the same as before;
// and that nothing was seen where the next one is long overdue, because the computer was busy or the bus was:
// nobody knows what it showed meanwhile. Used by the runners; the mail carries it on.
class ValueTap
{
public:
    // `isLive`: the device is exchanged, or asked; the bus is at `now`.
    void look(std::size_t device, const Reading &reading, bool isLive, Instant now,
              const std::optional<ExchangedWords> &exchanged = {});
    // Nothing was seen from the last values on, until the next ones come: the computer slept.
    void interrupt();
    // Where there are other devices now, none of them has shown anything.
    void forgetDevices() { m_last.clear(); }
    // Of all since the last call, oldest first.
    const std::vector<DeviceValues> &noted() const { return m_noted; }
    void clear() { m_noted.clear(); } // keeps its memory

private:
    struct Last
    {
        Instant at = Instant::min();
        bool hasShown = false; // ever
        bool showed = false;
        Instant usual = Instant::max(); // from one to the next
        bool wasOverdue = false;
    };

    void note(std::size_t device, const Reading &reading, const std::optional<ExchangedWords> &exchanged);
    static bool isOverdue(const Last &last, Instant passed);
    void noteWhatWasUnseen(std::size_t device, Instant from, Instant until);

    std::vector<Last> m_last;
    std::vector<DeviceValues> m_noted;
};

// Sorts what was shown on a bus by device, frame after frame in the same memory.
class ValueRound
{
public:
    // `isWhole`: false where some that came later were dropped: then no device shows anything behind them.
    const std::vector<ShownSeries> &sort(const std::vector<DeviceValues> &shown, bool isWhole)
    {
        for (ShownSeries &ofDevice : m_byDevice)
            ofDevice.clear();
        for (const DeviceValues &position : shown) {
            if (position.device >= m_byDevice.size())
                m_byDevice.resize(position.device + 1);
            m_byDevice[position.device].push_back(position.shown);
        }
        if (!isWhole && !shown.empty())
            for (ShownSeries &ofDevice : m_byDevice)
                ofDevice.push_back({.at = shown.back().shown.at});
        return m_byDevice;
    }

private:
    std::vector<ShownSeries> m_byDevice;
};

} // namespace codewheel
