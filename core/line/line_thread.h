// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <thread>

namespace codewheel {

class ByteLink;
class LineRunner;

// The thread of a serial line, from its making to its end, which interrupts a call that blocks in the link.
// Runner and link must outlive it.
class LineThread
{
public:
    LineThread(LineRunner &runner, ByteLink &link);
    ~LineThread();

    LineThread(const LineThread &) = delete;
    LineThread &operator=(const LineThread &) = delete;

private:
    ByteLink &m_link;
    std::jthread m_thread;
};

} // namespace codewheel
