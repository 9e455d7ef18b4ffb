// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/gateway_test.h"

#include <chrono>
#include <mutex>
#include <thread>
#include <utility>

namespace codewheel {
namespace {

constexpr std::chrono::milliseconds betweenFetches{30};

} // namespace

struct GatewayTest::Run
{
    Run(std::unique_ptr<RegisterPort> itsPort, const GatewaySettings &settings,
        std::vector<CheckedDevice> devices, std::optional<NodeId> only)
        : port(std::move(itsPort))
        , check(*port, settings, std::move(devices), only)
        , thread([this](const std::stop_token &stop) { work(stop); })
    {}
    ~Run() { cancel(); }

    void work(const std::stop_token &stop)
    {
        while (!stop.stop_requested() && !check.isDone()) {
            GatewayFinding finding = check.next();
            const std::scoped_lock lock(mutex);
            findings.push_back(std::move(finding));
        }
        const std::scoped_lock lock(mutex);
        isDone = true;
    }
    void cancel()
    {
        thread.request_stop();
        port->interrupt();
    }

    const std::unique_ptr<RegisterPort> port;
    GatewayCheck check;
    std::mutex mutex;
    std::vector<GatewayFinding> findings; // not fetched yet
    bool isDone = false;
    std::jthread thread; // ends first
};

GatewayTest::GatewayTest(QObject *parent)
    : QObject(parent)
{
    m_looks.setInterval(betweenFetches);
    connect(&m_looks, &QTimer::timeout, this, &GatewayTest::fetch);
}

GatewayTest::~GatewayTest() = default;

void GatewayTest::start(std::unique_ptr<RegisterPort> port, const GatewaySettings &settings,
                        std::vector<CheckedDevice> devices, std::optional<NodeId> only)
{
    m_run.reset();
    m_run = std::make_unique<Run>(std::move(port), settings, std::move(devices), only);
    m_looks.start();
}

void GatewayTest::cancel()
{
    if (m_run)
        m_run->cancel();
}

// A handler may start another one.
void GatewayTest::fetch()
{
    std::vector<GatewayFinding> findings;
    bool isDone = false;
    {
        const std::scoped_lock lock(m_run->mutex);
        findings = std::exchange(m_run->findings, {});
        isDone = m_run->isDone;
    }
    if (isDone) {
        m_looks.stop();
        m_run.reset();
    }
    for (const GatewayFinding &finding : findings)
        Q_EMIT found(finding);
    if (isDone)
        Q_EMIT ended();
}

} // namespace codewheel
