// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "finder/place_finder.h"
#include "kinds/interbus/gateway/gateway_settings.h"

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace codewheel {

// Looks for Modbus/TCP at a host: connects, and asks the usual units for a register each. Only reads. Each
// next() does one step.
class GatewayHostFinder final : public PlaceFinder
{
public:
    using MakePort = std::function<std::unique_ptr<RegisterPort>(const GatewaySettings &)>;

    // Host and port of `where` count.
    GatewayHostFinder(GatewaySettings where, MakePort makePort);
    ~GatewayHostFinder() override;
    Q_DISABLE_COPY_MOVE(GatewayHostFinder)

    bool isDone() const override { return m_isDone; }
    FinderNews next() override;
    void interrupt() override;

    static QString announcement();

private:
    FinderNews connect();
    FinderNews askNext();
    std::optional<Found> ask(int unit);
    FinderNews end(FinderNews::Kind kind, const QString &sentence);
    FinderNews end(FinderNews news);
    void use(std::unique_ptr<RegisterPort> port);

    GatewaySettings m_where;
    const MakePort m_makePort;
    std::vector<int> m_units;
    std::mutex m_mutex; // of m_port being there
    std::unique_ptr<RegisterPort> m_port;
    std::optional<int> m_lastFound; // unit
    bool m_isDone = false;
    std::atomic<bool> m_isStopped = false;
};

// Behind a link: ",unit=2,parity=none".
QString settingsText(const GatewaySettings &settings);

} // namespace codewheel
