// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/found.h"
#include "modbus/gateway_settings.h"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace codewheel {

// Looks for Modbus/TCP at a host: connects, and asks the usual units for a register each. Only reads. Each
// next() does one step.
class HostFinder
{
public:
    using MakePort = std::function<std::unique_ptr<RegisterPort>(const GatewaySettings &)>;

    // Host and port of `where` count.
    HostFinder(GatewaySettings where, MakePort makePort);
    ~HostFinder();
    Q_DISABLE_COPY_MOVE(HostFinder)

    bool isDone() const { return m_isDone; }
    FinderNews next();
    void interrupt(); // Any thread

    static QString announcement();

private:
    FinderNews connect();
    FinderNews askNext();
    std::optional<Found> ask(int unit);
    FinderNews end(FinderNews::Kind kind, const QString &sentence);
    void use(std::unique_ptr<RegisterPort> port);

    GatewaySettings m_where;
    const MakePort m_makePort;
    std::vector<int> m_units;
    std::mutex m_mutex; // of m_port being there
    std::unique_ptr<RegisterPort> m_port;
    int m_found = 0;
    bool m_isDone = false;
    std::atomic<bool> m_isStopped = false;
};

} // namespace codewheel
