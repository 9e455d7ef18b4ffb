// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/register_tries.h"

#include "kinds/interbus/gateway/register_refusal.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr Instant shortestPause = std::chrono::milliseconds(20); // of a busy gateway (assumed)

} // namespace

bool RegisterTries::goOn(RegisterPort::Done &done)
{
    ++m_sent;
    return isBusy(done.error()) ? waitsWhileBusy(done) : isWorthRepeating(done.error()) && mayFailAgain();
}

bool RegisterTries::waitsWhileBusy(RegisterPort::Done &done)
{
    const Instant now = m_port.now();
    if (m_pause == Instant())
        m_busyUntil = now + m_settings.patience;
    m_pause = m_pause == Instant() ? shortestPause : 2 * m_pause;
    if (now >= m_busyUntil)
        return false;
    const Instant until = std::min(now + m_pause, m_busyUntil);
    m_port.wait(until);
    if (m_port.now() >= until)
        return true;
    done = tl::unexpected(RegisterError{RegisterError::Kind::stopped, 0, {}});
    return false;
}

} // namespace codewheel
