// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/bus/canopen_event.h"
#include "kinds/canopen/setup/node_task.h"

#include <QObject>
#include <QPointer>

namespace codewheel {

class CanopenSession;

// Carries out tasks with devices on a connected bus, by hand and one at a time. Used by NodeSetupPage.
class NodeTaskRun final : public QObject
{
    Q_OBJECT

public:
    explicit NodeTaskRun(QObject *parent = nullptr);

    // Null: none. What runs has ended by then.
    void setBus(codewheel::CanopenSession *bus);

    // While none runs. It must outlive its end.
    void start(canopen::NodeTask &task);
    void cancel();
    bool isRunning() const { return m_task != nullptr; }
    // Why something was not sent, and so the task has ended.
    const std::optional<Refusal> &whyRefused() const { return m_whyRefused; }

Q_SIGNALS:
    void changed(); // another request is under way
    void ended();

private:
    void goOn();
    void send(const canopen::NodeTask::Request &request);
    void take(const Configured &end);
    void take(const TransferEnded &end);
    void take(const FrameSent &end);
    // Null: none of this kind is.
    template <class Request>
    const Request *underWay() const
    {
        return m_task != nullptr && m_underWay ? std::get_if<Request>(&*m_underWay) : nullptr;
    }
    void endUnderWay(const std::optional<Refusal> &refused);
    void endWithoutBus();

    QPointer<CanopenSession> m_bus;
    canopen::NodeTask *m_task = nullptr;
    std::optional<canopen::NodeTask::Request> m_underWay;
    std::optional<Refusal> m_whyRefused;
};

} // namespace codewheel
