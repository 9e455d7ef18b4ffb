// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/kinds/canopen/canopen_at_work.h"
#include "can/can_refusals.h"
#include "can/simulator/simulated_can_link.h"
#include "kinds/canopen/simulator/simulated_canopen_plant.h"
#include "tests/app/window_test.h"
#include "widgets/structure/structure_view.h"

#include <QSemaphore>

#include <atomic>
#include <vector>

namespace codewheel::test {

inline constexpr Place nodeFive{firstCanBus, NodeId("can:5")};
inline constexpr Place nodeSix{firstCanBus, NodeId("can:6")};
inline constexpr Place nodeSeven{firstCanBus, NodeId("can:7")};

// What the adapters of a computer do, for the links to them and for the test beside them.
struct AdapterBench
{
    canopen::SimulatedCanopenPlant plant;
    QSemaphore mayOpen{1'000}; // taken by each opening
    std::atomic<bool> listensOnly = true;
    std::atomic<bool> isMissing = false;
    std::atomic<int> sent = 0;
    std::vector<CanLinkArgument> made; // links
};

// An adapter at the encoders of the training bus, in real time, which is not simulated as far as the program
// knows.
class BenchCanLink final : public CanLink
{
public:
    BenchCanLink(AdapterBench &bench, const CanLinkArgument &at)
        : m_bench(bench)
        , m_name(at.where)
        , m_link(bench.plant.bus(), 125'000, [] {
            return std::chrono::duration_cast<Instant>(std::chrono::steady_clock::now().time_since_epoch());
        })
    {}

    Result<void> open(CanUse use) override
    {
        m_bench.mayOpen.acquire();
        if (m_bench.isMissing)
            return refuse(RefusalKind::link, CanRefusalId::interfaceMissing, {m_name});
        if (use == CanUse::watch && !m_bench.listensOnly && !m_takesUnsureWatch)
            return refuse(RefusalKind::link, CanRefusalId::watchNotSure,
                          {m_name, QStringLiteral("sudo ip link set can0 up type can listen-only on")});
        return m_link.open(use);
    }
    void close() override { m_link.close(); }
    void takeUnsureWatch() override { m_takesUnsureWatch = true; }
    Instant now() const override { return m_link.now(); }
    void wait(Instant until) override { m_link.wait(until); }
    Result<CanNews> receive(Instant until) override
    {
        return m_bench.isMissing
                   ? Result<CanNews>(refuse(RefusalKind::link, CanRefusalId::interfaceLost, {m_name}))
                   : m_link.receive(until);
    }
    Result<bool> send(const CanFrame &frame) override
    {
        ++m_bench.sent;
        return m_link.send(frame);
    }
    CanStatus status() const override { return m_link.status(); }
    QString name() const override { return m_name; }
    void interrupt() override { m_link.interrupt(); }

private:
    AdapterBench &m_bench;
    const QString m_name;
    SimulatedCanLink m_link;
    bool m_takesUnsureWatch = false;
};

// The window, whose CAN interfaces are at a bench.
class CanopenWindowTest : public WindowTest
{
protected:
    CanopenWindowTest()
    {
        canBus().setMakeLink([this](const CanLinkArgument &at) {
            bench.made.push_back(at);
            return std::make_unique<BenchCanLink>(bench, at);
        });
        advance(50);
    }
    ~CanopenWindowTest() override
    {
        bench.mayOpen.release(1'000);
        canBus().close();
    }

    CanopenAtWork &canBus() { return *shown->plant().first<CanopenAtWork>(); }
    CanopenSession &session() { return *canBus().session(); }
    StructureView &tree() { return *window().findChild<StructureView *>(); }
    // Gives the project this bus, as if it had been opened from a file.
    void plan(const QString &link, const std::vector<Place> &encoders)
    {
        Project planned = shown->project().project();
        setCanopenPlan(planned, firstCanBus, {{.link = link, .rate = 125'000}});
        std::vector<ProjectDevice> devices;
        for (const Place place : encoders) {
            ProjectDevice &device = devices.emplace_back();
            device.standAt(place);
            device.participant.deviceKey = QStringLiteral("canopen-406-multi-turn");
        }
        setDevicesOn(planned, firstCanBus, std::move(devices));
        shown->project().setProject(planned, {});
        advance(50);
    }
    template <typename Condition>
    bool comes(Condition condition)
    {
        return QTest::qWaitFor(
            [&] {
                advance(33);
                return condition();
            },
            20'000);
    }
    bool hasOpened()
    {
        return comes([this] { return !canBus().isOpening(); }) && canBus().isOpen();
    }

    AdapterBench bench;
};

} // namespace codewheel::test
