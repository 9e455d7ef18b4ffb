// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_settings.h"
#include "kinds/interbus/gateway/register_port.h"

namespace codewheel {

// How often a transaction is tried, and when again: at once where no valid answer came, after a pause that
// doubles each time where the gateway is busy.
class RegisterTries
{
public:
    // Both must outlive it.
    RegisterTries(RegisterPort &port, const GatewaySettings &settings)
        : m_port(port)
        , m_settings(settings)
    {}

    int sent() const { return m_sent; }
    int failures() const { return m_failures; } // without a valid answer
    // Whether the transaction that has failed is to be repeated: waits until then. An interrupted wait
    // becomes the error.
    bool goOn(RegisterPort::Done &done);
    // It failed without having been sent: whether that may happen once more.
    bool mayFailAgain() { return ++m_failures <= m_settings.retries; }
    void wasSent() { ++m_sent; }

private:
    bool waitsWhileBusy(RegisterPort::Done &done);

    RegisterPort &m_port;
    const GatewaySettings &m_settings;
    int m_sent = 0;
    int m_failures = 0;
    Instant m_pause{}; // until a busy gateway is asked again
    Instant m_busyUntil{};
};

} // namespace codewheel
