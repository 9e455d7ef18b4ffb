// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modbus/gateway_check.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace codewheel {

// A GatewayCheck in a thread of its own, since every step of it may wait for its gateway. What it finds is
// fetched every now and then.
class GatewayTest : public QObject
{
    Q_OBJECT

public:
    explicit GatewayTest(QObject *parent = nullptr);
    ~GatewayTest() override; // ends it

    // Ends one that is running. `only`: see GatewayCheck.
    void start(std::unique_ptr<RegisterPort> port, const GatewaySettings &settings,
               std::vector<CheckedDevice> devices, std::optional<NodeId> only = std::nullopt);
    void cancel(); // after the present step
    bool isRunning() const { return m_run != nullptr; }

Q_SIGNALS:
    void found(const codewheel::GatewayFinding &finding);
    void ended();

private:
    struct Run;

    void fetch();

    std::unique_ptr<Run> m_run;
    QTimer m_looks;
};

} // namespace codewheel
