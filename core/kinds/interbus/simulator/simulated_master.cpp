// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/simulated_master.h"

#include "kinds/interbus/ring/comparison.h"
#include "kinds/interbus/words/device_number.h"

#include <algorithm>
#include <numeric>

namespace codewheel {

SimulatedMaster::SimulatedMaster(const RingWiring &wiring)
    : m_wiring(wiring)
{}

void SimulatedMaster::powerUp()
{
    std::vector<std::size_t> places(m_wiring.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    use(m_wiring.planned(), std::move(places));
    enter(MasterState::run);
}

void SimulatedMaster::keep(const QString &fileName)
{
    m_kept = KeptConfiguration{fileName, m_configuration};
    publish();
}

void SimulatedMaster::use(RingStructure configuration, std::vector<std::size_t> places)
{
    m_peripheral = stillReported(configuration, places);
    m_configuration = std::move(configuration);
    m_places = std::move(places);
    m_off.clear();
    m_located.reset();
    m_status.segments.clear();
    for (const RingDevice &participant : m_configuration)
        if (DeviceNumber::of(participant.number).position == 0)
            m_status.segments.push_back({.segment = DeviceNumber::of(participant.number).segment});
}

// What a device reported is kept while it is there: only 0760 clears it.
std::vector<bool> SimulatedMaster::stillReported(const RingStructure &configuration,
                                                 const std::vector<std::size_t> &places) const
{
    std::vector<bool> reported(configuration.size(), false);
    for (std::size_t i = 0; i < std::min(places.size(), configuration.size()); ++i) {
        const auto before =
            static_cast<std::size_t>(std::ranges::find(m_places, places[i]) - m_places.begin());
        reported[i] = before < std::min(m_places.size(), m_configuration.size()) && m_peripheral[before] &&
                      isSameKind(m_configuration[before], configuration[i]);
    }
    return reported;
}

void SimulatedMaster::enter(MasterState state)
{
    m_status.state = state;
    m_looking = 0;
    if (state != MasterState::busFail)
        m_located.reset();
    m_seen = ~m_wiring.changes(); // look at the ring in the next cycle
    publish();
}

// A fault shows at once in data and ID cycles; in READY nobody looks.
void SimulatedMaster::look()
{
    m_seen = m_wiring.changes();
    switch (m_status.state) {
    case MasterState::ready:
        return;
    case MasterState::active:
    case MasterState::run:
        if (defect())
            fail();
        else
            lookAtPeripherals();
        return;
    case MasterState::busFail:
        lookForPlace();
    }
}

void SimulatedMaster::fail()
{
    m_status.state = MasterState::busFail;
    m_looking = lookingCycles;
    m_located.reset();
    publish();
}

void SimulatedMaster::lookForPlace()
{
    const auto found = defect();
    if (m_looking > 0) {
        if (--m_looking == 0) {
            m_located = found;
            publish();
        }
        return;
    }
    if (m_located && !found)
        enter(MasterState::ready); // repaired
    else if (found != m_located)
        fail();
}

void SimulatedMaster::lookAtPeripherals()
{
    bool isNew = false;
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        if (m_peripheral[i] || !takesPart(i) || !m_wiring.trouble(m_places[i]).peripheralFault)
            continue;
        m_peripheral[i] = true;
        isNew = true;
    }
    if (isNew)
        publish();
}

bool SimulatedMaster::isSwitchedOff(std::size_t device) const
{
    return !m_off.empty() && std::ranges::any_of(m_off, [&](int segment) {
        const auto head =
            std::ranges::find(m_configuration, DeviceNumber{segment, 0}.node(), &RingDevice::number);
        const auto from = static_cast<std::size_t>(head - m_configuration.begin());
        return device >= from && device < endOfCutOff(m_configuration, from);
    });
}

// The first one in ring order.
std::optional<SimulatedMaster::Defect> SimulatedMaster::defect() const
{
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        const PlaceTrouble &trouble = m_wiring.trouble(m_places[i]);
        const bool isRight = isSameKind(m_wiring.present(m_places[i]), m_configuration[i]);
        if ((!trouble.wireBroken && trouble.supplied && isRight) || isSwitchedOff(i))
            continue;
        if (trouble.wireBroken)
            return brokenBefore(i);
        const std::uint16_t code = trouble.supplied ? wrongIdCode : deviceMissing;
        return Defect{i, code, diagnosticParameterOf({.number = m_configuration[i].number})};
    }
    return std::nullopt;
}

// The outgoing interface of the device before it; the device itself if that is the master, or if the device
// is further along a local bus.
SimulatedMaster::Defect SimulatedMaster::brokenBefore(std::size_t device) const
{
    const RingDevice &behind = m_configuration[device];
    const bool isLocal = DeviceNumber::of(behind.number).position > 0;
    const std::uint16_t code = isLocal ? localBusBroken : remoteBusBroken;
    FaultPlace place{.number = behind.number};
    if (isLocal && DeviceNumber::of(behind.number).position == 1)
        place = {DeviceNumber{DeviceNumber::of(behind.number).segment, 0}.node(),
                 FaultSpot::outgoingLocalBus};
    for (std::size_t i = isLocal ? 0 : device; i-- > 0;) {
        const RingDevice &before = m_configuration[i];
        if (DeviceNumber::of(before.number).position > 0 || before.level > behind.level)
            continue;
        place = {before.number,
                 before.level == behind.level ? FaultSpot::outgoingRemoteBus : FaultSpot::outgoingLocalBus};
        break;
    }
    return {device, code, diagnosticParameterOf(place)};
}

void SimulatedMaster::showWhoTakesPart()
{
    m_status.devices.assign(m_configuration.size(), {});
    const std::size_t cutOff = m_located ? m_located->device : m_configuration.size();
    const std::size_t cutOffEnd = m_located ? endOfCutOff(m_configuration, cutOff) : cutOff;
    for (std::size_t i = 0; i < m_configuration.size(); ++i) {
        m_status.devices[i].inRing = !isSwitchedOff(i) && (i < cutOff || i >= cutOffEnd);
        m_status.devices[i].peripheralFault = m_peripheral[i];
    }
    for (MasterStatus::Segment &segment : m_status.segments)
        segment.switchedOff = m_off.contains(segment.segment);
    m_isWhole = m_places.size() == m_wiring.size() &&
                std::ranges::all_of(m_status.devices, &MasterStatus::Device::inRing);
}

std::uint16_t SimulatedMaster::statusBits() const
{
    unsigned bits = diagnostic::ready;
    if (holdsOutputs())
        bits |= diagnostic::active;
    if (runs())
        bits |= diagnostic::run;
    if (m_status.state == MasterState::busFail)
        bits |= m_looking > 0 ? diagnostic::detect : diagnostic::bus;
    if (std::ranges::find(m_peripheral, true) != m_peripheral.end())
        bits |= diagnostic::peripheralFault;
    if (!m_off.empty())
        bits |= diagnostic::bsa;
    if (m_toleratedCrcErrors > tolerableCrcErrors)
        bits |= diagnostic::quality;
    return static_cast<std::uint16_t>(bits);
}

// A fault of the bus takes precedence over one of the periphery.
void SimulatedMaster::publish()
{
    showWhoTakesPart();
    m_status.statusBits = statusBits();
    m_status.errorCode = 0;
    m_status.parameter = 0;
    const auto peripheral = std::ranges::find(m_peripheral, true);
    if (m_status.state == MasterState::busFail) {
        m_status.errorCode = m_looking > 0 ? bus_error::lookingForFault
                             : m_located   ? m_located->code
                                           : bus_error::nothingFound;
        m_status.parameter = m_located ? m_located->parameter : notLocated;
    } else if (peripheral != m_peripheral.end()) {
        const auto device = static_cast<std::size_t>(peripheral - m_peripheral.begin());
        m_status.errorCode = bus_error::peripheralFault;
        m_status.parameter = diagnosticParameterOf({.number = m_configuration[device].number});
    }
    m_status.configurationName = m_kept ? std::optional(m_kept->fileName) : std::nullopt;
    ++m_changes;
}

bool SimulatedMaster::isCycleFaulty()
{
    if (!m_wiring.hasCrcErrors())
        return false;
    bool isFaulty = false;
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        const int perThousand = m_wiring.trouble(m_places[i]).crcErrors;
        if (perThousand == 0 || !takesPart(i) || !m_errors.strikes(perThousand))
            continue;
        isFaulty = true;
        const int segment = DeviceNumber::of(m_configuration[i].number).segment;
        ++std::ranges::find(m_status.segments, segment, &MasterStatus::Segment::segment)->crcErrors;
        ++m_toleratedCrcErrors;
    }
    if (isFaulty)
        publish();
    return isFaulty;
}

} // namespace codewheel
