// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/stop_signals.h"
#include "cli/call/subcommand.h"
#include "vocabulary/instant.h"

#include <QDateTime>

#include <chrono>

namespace codewheel {

// Lets time pass on all open buses of a call at once. Real ones work in threads of their own; simulated ones
// are in virtual time, and keep to the clock only where they have to.
class PassingTime
{
public:
    enum class Pace {
        asFastAsPossible, // unless one of the buses is real
        byTheClock,
    };

    // From now on the simulated buses have the same date and time.
    PassingTime(const Call &call, Pace pace);

    // Some milliseconds; a signal ends them early.
    void goOn(const StopSignals &stop);
    bool isVirtual() const { return m_isVirtual; }
    Instant passed() const; // by the clock, or in virtual time
    // The date and time by the clock of the computer, which virtual time has of its own.
    QDateTime now() const;

private:
    using Clock = std::chrono::steady_clock;

    void wait(const StopSignals &stop);

    const Call &m_call;
    std::vector<BusAccess *> m_byHand;
    std::vector<BusAccess *> m_byThemselves;
    bool m_isVirtual;
    Instant m_passed{}; // of virtual time
    Clock::time_point m_begin = Clock::now();
    Clock::time_point m_next = m_begin;
};

} // namespace codewheel
