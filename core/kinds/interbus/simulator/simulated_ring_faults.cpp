// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/simulated_position_encoder.h"
#include "kinds/interbus/simulator/simulated_ring.h"
#include "kinds/interbus/words/device_number.h"

#include <algorithm>

namespace codewheel {
namespace {

// A device put in place of the right one stands still.
constexpr PhysicalResolution wrongResolution{.stepsPerTurn = 8192, .turns = 4096};
constexpr std::int64_t wrongPosition = 4'096;

int asValue(bool standing)
{
    return standing ? 1 : 0;
}

std::optional<int> onlyIf(bool fits, bool standing)
{
    return fits ? std::optional(asValue(standing)) : std::nullopt;
}

} // namespace

void SimulatedRing::setFault(TrainingFault fault, NodeId number, int value)
{
    const std::scoped_lock lock(m_mutex);
    const auto place = std::ranges::find(m_wiring.planned(), number, &RingDevice::number);
    if (place != m_wiring.planned().end())
        cause(fault, static_cast<std::size_t>(place - m_wiring.planned().begin()), value);
}

void SimulatedRing::cause(TrainingFault fault, std::size_t place, int value)
{
    SimulatedDevice &device = *m_devices[place];
    const bool on = value > 0;
    switch (fault) {
    case TrainingFault::powerOff:
        device.setPower(!on);
        return;
    case TrainingFault::slowConfirmation:
        device.setSlow(on);
        return;
    case TrainingFault::eepromWornOut:
        device.setEepromWornOut(on);
        return;
    case TrainingFault::parametersLost:
        if (on)
            device.loseParameters();
        return;
    case TrainingFault::batteryLow:
        device.setBatteryLow(on);
        return;
    case TrainingFault::codeDiscFault:
        device.setCodeDiscFaulty(on);
        return;
    case TrainingFault::camOutOfRange:
        device.setCamOutOfRange(on);
        return;
    case TrainingFault::magnetLost:
        device.setMagnetInRange(!on);
        return;
    default:
        causeInRing(fault, place, value);
    }
}

void SimulatedRing::causeInRing(TrainingFault fault, std::size_t place, int value)
{
    PlaceTrouble trouble = m_wiring.trouble(place);
    const bool on = value > 0;
    switch (fault) {
    case TrainingFault::wireBreak:
        trouble.wireBroken = on;
        break;
    case TrainingFault::crcErrors:
        if (DeviceNumber::of(m_wiring.planned()[place].number).position == 0)
            trouble.crcErrors = std::clamp(value, 0, mostCrcErrors);
        break;
    case TrainingFault::noSupply:
        if (trouble.supplied == on)
            m_devices[place]->setPower(!on);
        trouble.supplied = !on;
        break;
    case TrainingFault::wrongDevice:
        if (!m_wiring.canBeWrong(place))
            return;
        putDevice(place, on);
        trouble.wrongDevice = on;
        break;
    default:
        trouble.peripheralFault = on;
    }
    m_wiring.setTrouble(place, trouble);
}

// The right one has no power while it lies on the bench.
void SimulatedRing::putDevice(std::size_t place, bool wrong)
{
    if (wrong == (m_wrongDevices[place] != nullptr))
        return;
    m_devices[place]->setPower(!wrong);
    if (wrong)
        m_wrongDevices[place] = std::make_unique<SimulatedPositionEncoder>(wrongResolution, wrongPosition);
    else
        m_wrongDevices[place].reset();
    m_present[place] = wrong ? m_wrongDevices[place].get() : m_devices[place].get();
}

std::vector<TrainingPlace> SimulatedRing::places() const
{
    const std::scoped_lock lock(m_mutex);
    std::vector<TrainingPlace> places;
    for (std::size_t i = 0; i < m_wiring.size(); ++i) {
        TrainingPlace place{.number = m_wiring.planned()[i].number, .faults = {}};
        for (int fault = 0; fault < trainingFaults; ++fault)
            if (const auto value = standing(static_cast<TrainingFault>(fault), i))
                place.faults.push_back({static_cast<TrainingFault>(fault), *value});
        places.push_back(std::move(place));
    }
    return places;
}

// Empty: the fault does not apply to the device. Lost parameters are an event, not a state.
std::optional<int> SimulatedRing::standing(TrainingFault fault, std::size_t place) const
{
    const auto shaft = m_devices[place]->shaftState();
    const auto rod = m_devices[place]->rodState();
    switch (fault) {
    case TrainingFault::powerOff:
        return onlyIf(shaft || rod, (shaft && !shaft->powered) || (rod && !rod->powered));
    case TrainingFault::slowConfirmation:
        return onlyIf((shaft && shaft->hasParameters) || rod, (shaft && shaft->slow) || (rod && rod->slow));
    case TrainingFault::parametersLost:
        return onlyIf(shaft && shaft->hasParameters, false);
    case TrainingFault::eepromWornOut:
        return onlyIf(shaft && shaft->reportsFaults, shaft && shaft->eepromWornOut);
    case TrainingFault::codeDiscFault:
        return onlyIf(shaft && shaft->reportsFaults, shaft && shaft->codeDiscFaulty);
    case TrainingFault::batteryLow:
        return onlyIf(shaft && shaft->hasBattery, shaft && shaft->batteryLow);
    case TrainingFault::camOutOfRange:
        return onlyIf(shaft && shaft->hasCams, shaft && shaft->camOutOfRange);
    case TrainingFault::magnetLost:
        return onlyIf(rod.has_value(), rod && !rod->magnetInRange);
    default:
        return standingOfRing(fault, place);
    }
}

std::optional<int> SimulatedRing::standingOfRing(TrainingFault fault, std::size_t place) const
{
    const PlaceTrouble &trouble = m_wiring.trouble(place);
    const bool isOnRemoteBus = DeviceNumber::of(m_wiring.planned()[place].number).position == 0;
    switch (fault) {
    case TrainingFault::wireBreak:
        return asValue(trouble.wireBroken);
    case TrainingFault::crcErrors:
        return isOnRemoteBus ? std::optional(trouble.crcErrors) : std::nullopt;
    case TrainingFault::noSupply:
        return asValue(!trouble.supplied);
    case TrainingFault::wrongDevice:
        return onlyIf(m_wiring.canBeWrong(place), trouble.wrongDevice);
    default:
        return asValue(trouble.peripheralFault);
    }
}

void SimulatedRing::startFaultPlan(FaultPlan plan)
{
    const std::scoped_lock lock(m_mutex);
    m_plan.start(plan);
}

void SimulatedRing::stopFaultPlan()
{
    const std::scoped_lock lock(m_mutex);
    m_plan.stop();
}

TrainingControls::PlanProgress SimulatedRing::planProgress() const
{
    const std::scoped_lock lock(m_mutex);
    return m_plan.progress();
}

} // namespace codewheel
