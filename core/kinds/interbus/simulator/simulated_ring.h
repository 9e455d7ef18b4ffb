// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/simulated_device.h"
#include "kinds/interbus/simulator/simulated_master.h"
#include "kinds/interbus/simulator/training_controls.h"
#include "vocabulary/refusal.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace codewheel {

// A running fault plan: knows which step is due in which cycle of 1 ms. Used by SimulatedRing.
class FaultPlanRun
{
public:
    void start(const FaultPlan &plan)
    {
        m_plan = std::make_shared<const FaultPlan>(plan);
        m_next = 0;
        m_elapsed = -1; // the next cycle is at 0
        m_isRunning = true;
    }
    void stop() { m_isRunning = false; }
    bool isRunning() const { return m_isRunning; }

    // To be called once per cycle, then due() until it returns null.
    void passCycle() { ++m_elapsed; }
    const FaultStep *due()
    {
        if (m_plan->steps[m_next].at.count() > m_elapsed)
            return nullptr;
        const FaultStep *step = &m_plan->steps[m_next++];
        m_isRunning = m_next < m_plan->steps.size();
        return step;
    }

    TrainingControls::PlanProgress progress() const
    {
        return {m_plan, m_next, std::chrono::milliseconds(std::max<std::int64_t>(m_elapsed, 0)), m_isRunning};
    }

private:
    std::shared_ptr<const FaultPlan> m_plan;
    std::size_t m_next = 0;
    std::int64_t m_elapsed = 0; // ms
    bool m_isRunning = false;
};

// A ring of simulated devices with its master, and the trainer's controls. Its clock is the bus cycle: one is
// 1 ms, whether the ring runs or not. What moves goes by the clock, even if cycles are missed. Shared by the
// link (bus thread) and the training panel (any thread); one uncontended lock per cycle.
class SimulatedRing final : public TrainingControls
{
public:
    // Before the ring is used.
    void add(RingDevice participant, std::unique_ptr<SimulatedDevice> device);

    // The file name of the configuration its master stores from the beginning. Without a call: none.
    void keepConfiguration(const QString &fileName) { m_master.keep(fileName); }

    // The configuration of the master, and its OUT words.
    RingStructure structure() const;
    std::vector<Word> lastOut() const;
    // A data cycle; refused if there is not one word per configured device, and while the ring does not run.
    Result<void> exchange(std::span<const Word> out, std::span<Word> in);
    // Cycles that were due but came too late: shafts keep turning.
    void missCycles(std::chrono::milliseconds time);
    // A cycle without data.
    void idleCycle();
    // Services of the master, and its status. Bus thread only.
    template <typename Service, typename... Arguments>
    auto withMaster(Service service, Arguments &&...arguments)
    {
        const std::scoped_lock lock(m_mutex);
        return std::invoke(service, m_master, std::forward<Arguments>(arguments)...);
    }
    const SimulatedMaster &master() const { return m_master; }

    std::vector<Shaft> shafts() const override;
    std::vector<Rod> rods() const override;
    void turnTo(NodeId number, std::int64_t raw) override;
    void turnBy(NodeId number, std::int64_t rawSteps) override;
    void setSpeed(NodeId number, double revolutionsPerMinute) override;
    void moveMagnetTo(NodeId number, double millimetres) override;
    void setMagnetSpeed(NodeId number, double millimetresPerSecond) override;
    void powerCycle(NodeId number) override;

    std::vector<TrainingPlace> places() const override;
    void setFault(TrainingFault fault, NodeId number, int value) override;
    void startFaultPlan(FaultPlan plan) override;
    void stopFaultPlan() override;
    PlanProgress planProgress() const override;

private:
    template <typename State>
    std::vector<State> states(std::optional<State> (SimulatedDevice::*stateOf)() const) const;
    template <typename Act, typename... Arguments>
    void with(NodeId number, Act act, Arguments... arguments);

    void passTime();
    Result<void> exchangeSome(std::span<const Word> out, std::span<Word> in);
    void idle();
    void cause(TrainingFault fault, std::size_t place, int value);
    void causeInRing(TrainingFault fault, std::size_t place, int value);
    void putDevice(std::size_t place, bool wrong);
    std::optional<int> standing(TrainingFault fault, std::size_t place) const;
    std::optional<int> standingOfRing(TrainingFault fault, std::size_t place) const;

    mutable std::mutex m_mutex; // guards everything below
    RingWiring m_wiring;
    SimulatedMaster m_master{m_wiring};
    std::vector<std::unique_ptr<SimulatedDevice>> m_devices;
    std::vector<std::unique_ptr<SimulatedDevice>> m_wrongDevices; // that replace them; null: none
    std::vector<SimulatedDevice *> m_present;                     // one or the other
    std::vector<Word> m_lastOut;                                  // by place, as held by the devices
    std::vector<Word> m_lastIn;                                   // by configured device
    FaultPlanRun m_plan;
};

} // namespace codewheel
