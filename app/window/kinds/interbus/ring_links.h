// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/background_steps.h"
#include "kinds/interbus/gateway/gateway_check.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "links/serial_ports.h"

#include <QObject>

#include <functional>

namespace codewheel {

class ConnectPage;
class GatewayForm;
class Leaving;
class RegistersPage;
class RingAtWork;
class RingConnection;
class WindowSettings;

// How a ring is connected, in the window: the page of its connection, with its test, and the page of its
// registers. What is chosen there is kept in the project. Used by RingViews.
class RingLinks : public QObject
{
    Q_OBJECT

public:
    struct Parts
    {
        RingAtWork &ring;
        RingConnection &connection;
        WindowSettings &settings;
        Leaving &leaving;
        ConnectPage &page;
        RegistersPage &registers;
    };
    explicit RingLinks(const Parts &parts, QObject *parent = nullptr);

    bool plansGateway() const;
    // Whether the project says enough to connect; otherwise its page has to be shown.
    bool canConnect() const;
    void showPlan();      // in the pages, as the project has it
    void showRegisters(); // as they are now
    void listPorts();
    void connectFound(const KindData &plan); // by a search; shown in the page

private:
    void keep(const ProjectLink &link);
    void connectAs(const KindData &plan);
    void changeLink(const ProjectLink &link, std::function<void()> then);
    void test(const KindData &plan);
    void readNow(const NodeId &device);
    void take(const GatewayFinding &finding);
    void startTest(std::optional<NodeId> only = std::nullopt);
    void endTest();
    void setOrder(WordOrder order);
    void showState();
    std::vector<CheckedDevice> devices() const;
    std::vector<DeviceRegisters> liveRegisters() const;
    std::vector<DeviceRegisters> plannedRegisters() const;
    GatewaySettings planned() const;

    const Parts m_parts;
    GatewayForm *m_tcp;
    GatewayForm *m_rtu;
    BackgroundSteps m_test;
    GatewaySettings m_tested;                // by m_test
    bool m_isReadNow = false;                // m_test is of one device, for the registers
    std::vector<DeviceRegisters> m_lastRead; // by tests
};

} // namespace codewheel
