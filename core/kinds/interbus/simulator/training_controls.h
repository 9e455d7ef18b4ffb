// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/simulator/fault_plan.h"
#include "simulator/turning_shaft.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace codewheel {

// What a trainer can do to a simulated ring while it runs. Any thread: requests take effect at the next
// cycle.
class TrainingControls
{
public:
    static constexpr double fastest = TurningShaft::fastest; // rpm, of every shaft

    // An encoder with a shaft.
    struct Shaft
    {
        NodeId number;
        std::int64_t raw = 0;            // physical position, steps
        int stepsPerTurn = 0;            // physical
        int turns = 0;                   // physical
        double revolutionsPerMinute = 0; // positive: clockwise, looking at the shaft
        bool powered = true;
        bool hasParameters = true; // can be set up: confirms, stores, and may lose what it stored
        bool slow = false;         // confirms slowly
        bool hasBattery = false;
        bool batteryLow = false;
        bool reportsFaults = false; // has error numbers for its EEPROM and its code disc
        bool eepromWornOut = false;
        bool codeDiscFaulty = false;
        bool hasCams = false;
        bool camOutOfRange = false;
        int eepromWrites = 0; // since the ring was created
    };

    // All that depends on the shaft alone.
    static Shaft of(const TurningShaft &shaft)
    {
        return {.number = {},
                .raw = shaft.raw(),
                .stepsPerTurn = shaft.resolution().stepsPerTurn,
                .turns = shaft.resolution().turns,
                .revolutionsPerMinute = shaft.speed()};
    }

    // A linear encoder: a magnet that travels along a rod.
    struct Rod
    {
        NodeId number;
        double millimetres = 0;          // of the magnet, from the head
        double lengthMillimetres = 0;    // measuring length
        double millimetresPerSecond = 0; // positive: away from the head
        bool magnetInRange = true;
        bool powered = true;
        bool slow = false;    // answers slowly
        int eepromWrites = 0; // since the ring was created
    };

    virtual ~TrainingControls() = default;

    // As of the last cycle, in ring order; a device has a shaft, a rod, or neither.
    virtual std::vector<Shaft> shafts() const = 0;
    virtual std::vector<Rod> rods() const = 0;

    // No effect on a device without such a part, or for a place that is not in the ring.
    virtual void turnTo(NodeId number, std::int64_t raw) = 0;
    virtual void turnBy(NodeId number, std::int64_t rawSteps) = 0;
    virtual void setSpeed(NodeId number, double revolutionsPerMinute) = 0;
    // 0..length; the magnet stops at the ends.
    virtual void moveMagnetTo(NodeId number, double millimetres) = 0;
    // 0 stops it; at the ends it turns round.
    virtual void setMagnetSpeed(NodeId number, double millimetresPerSecond) = 0;
    virtual void powerCycle(NodeId number) = 0; // off, then on

    // Each place of the ring, in ring order, with the faults that apply to it and their current values.
    virtual std::vector<TrainingPlace> places() const = 0;
    // Any fault; the value as in a fault plan. No effect if it does not apply to the place.
    virtual void setFault(TrainingFault fault, NodeId number, int value) = 0;

    // A fault plan in progress, by the ring's clock.
    struct PlanProgress
    {
        std::shared_ptr<const FaultPlan> plan; // null: none was started
        std::size_t next = 0;                  // next step
        std::chrono::milliseconds elapsed{};   // since its start
        bool isRunning = false;                // neither stopped nor finished
    };
    // Replaces any other. Its times count from the next cycle.
    virtual void startFaultPlan(FaultPlan plan) = 0;
    virtual void stopFaultPlan() = 0; // what it has caused stays
    virtual PlanProgress planProgress() const = 0;
};

} // namespace codewheel
