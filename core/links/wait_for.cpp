// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/wait_for.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <poll.h>

namespace codewheel {

Waited waitFor(int descriptor, short events, WakeFlag &wake, std::chrono::steady_clock::time_point until)
{
    using namespace std::chrono;
    std::array<pollfd, 2> waited{{{descriptor, events, 0}, {wake.descriptor(), POLLIN, 0}}};
    int ready = 0;
    do {
        const nanoseconds left = std::max<nanoseconds>(until - steady_clock::now(), 0ns);
        const timespec timeOut{duration_cast<seconds>(left).count(), (left % 1s).count()};
        ready = ::ppoll(waited.data(), waited.size(), &timeOut, nullptr);
    } while (ready < 0 && errno == EINTR);
    if (waited[1].revents != 0 && wake.lower())
        return Waited::woken;
    return waited[0].revents != 0 ? Waited::ready : Waited::timeOut;
}

} // namespace codewheel
