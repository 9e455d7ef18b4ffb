// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/pty_pair.h"

#include <array>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace codewheel {

PtyPair::PtyPair()
    : m_far(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC))
{
    ::grantpt(m_far);
    ::unlockpt(m_far);
    std::array<char, 128> name{};
    ::ptsname_r(m_far, name.data(), name.size());
    m_path = QString::fromLocal8Bit(name.data());
    m_near = ::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios settings = {};
    ::tcgetattr(m_near, &settings);
    ::cfmakeraw(&settings);
    ::tcsetattr(m_near, TCSANOW, &settings);
}

PtyPair::~PtyPair()
{
    unplug();
    leave();
}

void PtyPair::send(const QByteArray &bytes)
{
    [[maybe_unused]] const auto sent =
        ::write(m_far, bytes.constData(), static_cast<std::size_t>(bytes.size()));
}

QByteArray PtyPair::receive(qsizetype count)
{
    constexpr int patience = 20'000; // ms
    QByteArray received;
    pollfd far{m_far, POLLIN, 0};
    while (received.size() < count && ::poll(&far, 1, patience) == 1) {
        std::array<char, 256> bytes{};
        const auto got = ::read(m_far, bytes.data(), bytes.size());
        if (got <= 0)
            break;
        received.append(bytes.data(), got);
    }
    return received;
}

void PtyPair::leave()
{
    if (m_near >= 0)
        ::close(std::exchange(m_near, -1));
}

// The near end stays open, so that the number of the terminal is not reused by a concurrent test, which would
// plug in another adapter there.
void PtyPair::unplug()
{
    if (m_far >= 0)
        ::close(std::exchange(m_far, -1));
}

} // namespace codewheel
