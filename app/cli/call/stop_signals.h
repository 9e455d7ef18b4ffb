// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <sys/signalfd.h>
#include <unistd.h>

namespace codewheel {

// As long as it lives, turns what asks the program to end into something to wait for: SIGINT and SIGTERM,
// SIGHUP unless it is ignored (as with nohup), and SIGPIPE, since nobody is listening any more. Used by
// commands that run until they are told to end, or that say what they have done before they do.
class StopSignals
{
public:
    StopSignals()
    {
        ::sigemptyset(&m_signals);
        ::sigaddset(&m_signals, SIGINT);
        ::sigaddset(&m_signals, SIGTERM);
        ::sigaddset(&m_signals, SIGPIPE); // main() ignores it; while blocked it arrives all the same
        if (!isIgnored(SIGHUP))
            ::sigaddset(&m_signals, SIGHUP);
        ::pthread_sigmask(SIG_BLOCK, &m_signals, &m_before);
        m_descriptor = ::signalfd(-1, &m_signals, SFD_CLOEXEC | SFD_NONBLOCK);
    }
    ~StopSignals()
    {
        while (m_hasCome && came()) // a terminal that closes sends more than one
            ;
        ::close(m_descriptor);
        ::pthread_sigmask(SIG_SETMASK, &m_before, nullptr);
    }
    StopSignals(const StopSignals &) = delete;
    StopSignals &operator=(const StopSignals &) = delete;

    int descriptor() const { return m_descriptor; } // readable once one came
    bool came()
    {
        signalfd_siginfo signal = {};
        const bool isOne = ::read(m_descriptor, &signal, sizeof signal) == sizeof signal;
        m_hasCome = m_hasCome || isOne;
        return isOne;
    }

private:
    static bool isIgnored(int signal)
    {
        struct sigaction now = {};
        return ::sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN; // NOLINT(*-union-access)
    }

    sigset_t m_signals = {};
    sigset_t m_before = {};
    int m_descriptor = -1;
    bool m_hasCome = false;
};

} // namespace codewheel
