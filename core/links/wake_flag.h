// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <sys/eventfd.h>
#include <unistd.h>

namespace codewheel {

// A flag that any thread can raise, noticed by a poll(2) on its descriptor. Used by links that wait for a
// device.
class WakeFlag
{
public:
    WakeFlag()
        : m_descriptor(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK))
    {}
    ~WakeFlag() { ::close(m_descriptor); }
    WakeFlag(const WakeFlag &) = delete;
    WakeFlag &operator=(const WakeFlag &) = delete;

    int descriptor() const { return m_descriptor; } // readable while it is raised
    void raise() { ::eventfd_write(m_descriptor, 1); }
    // Whether it was raised.
    bool lower()
    {
        eventfd_t raised = 0;
        return ::eventfd_read(m_descriptor, &raised) == 0;
    }

private:
    int m_descriptor;
};

} // namespace codewheel
