// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <sys/signalfd.h>
#include <unistd.h>

namespace codewheel {

// SIGINT and SIGTERM as something to wait for, as long as it lives. Used by commands that run until they are
// told to end.
class StopSignals
{
public:
    StopSignals()
    {
        ::sigemptyset(&m_signals);
        ::sigaddset(&m_signals, SIGINT);
        ::sigaddset(&m_signals, SIGTERM);
        ::pthread_sigmask(SIG_BLOCK, &m_signals, &m_before);
        m_descriptor = ::signalfd(-1, &m_signals, SFD_CLOEXEC | SFD_NONBLOCK);
    }
    ~StopSignals()
    {
        ::close(m_descriptor);
        ::pthread_sigmask(SIG_SETMASK, &m_before, nullptr);
    }
    StopSignals(const StopSignals &) = delete;
    StopSignals &operator=(const StopSignals &) = delete;

    int descriptor() const { return m_descriptor; } // readable once one came
    bool came()
    {
        signalfd_siginfo signal = {};
        return ::read(m_descriptor, &signal, sizeof signal) == sizeof signal;
    }

private:
    sigset_t m_signals = {};
    sigset_t m_before = {};
    int m_descriptor = -1;
};

} // namespace codewheel
