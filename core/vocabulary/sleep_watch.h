// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>

namespace codewheel {

// Notices that the computer slept (suspended to memory or disk) since it was last asked. Used by the threads
// of the buses before anything is sent.
class SleepWatch
{
public:
    // How long the computer has slept since it was booted.
    using Slept = std::function<std::chrono::milliseconds()>;
    static std::chrono::milliseconds ofThisComputer();

    explicit SleepWatch(Slept slept = ofThisComputer)
        : m_slept(std::move(slept))
        , m_known(m_slept())
    {}

    // Since the last call, or since construction; 0: not at all.
    std::chrono::milliseconds sleptSinceLast()
    {
        const auto slept = m_slept();
        const auto since = slept - m_known;
        if (since < shortest)
            return {};
        m_known = slept;
        return since;
    }

private:
    static constexpr std::chrono::milliseconds shortest{100}; // the clocks are read one after the other

    Slept m_slept;
    std::chrono::milliseconds m_known;
};

} // namespace codewheel
