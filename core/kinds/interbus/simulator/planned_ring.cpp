// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/simulator/planned_ring.h"

#include "kinds/interbus/simulator/fraba_k3.h"
#include "kinds/interbus/simulator/simulated_bus_terminal.h"
#include "kinds/interbus/simulator/simulated_device.h"
#include "kinds/interbus/simulator/simulated_ring_link.h"
#include "kinds/interbus/words/k3_explain.h"
#include "kinds/interbus/words/k3_word.h"
#include "kinds/interbus/words/profiles.h"

namespace codewheel {

namespace {

// A device that nobody simulates, such as a digital module or a drive: IN shows the OUT word of the cycle
// before, so that it can be seen that it arrived, as far as it has words.
class SimulatedWords final : public SimulatedDevice
{
public:
    SimulatedWords(int inWords, int outWords)
        : m_mask(maskOf(inWords) & maskOf(outWords))
    {}

    Word cycle(Word out) override { return std::exchange(m_in, out & m_mask); }

private:
    static constexpr Word maskOf(int words) { return words == 0 ? 0 : words == 1 ? 0xFFFF : ~Word{0}; }

    Word m_mask;
    Word m_in = 0; // prepared for the next cycle
};

constexpr std::int64_t slowTurning = 10;  // rpm
constexpr std::int64_t rodLength = 1'000; // mm
constexpr std::int64_t slowTravel = 10;   // mm/s

bool isK3OfAnyMake(const DeviceDescription &device)
{
    return device.profile == profile::k3 && device.dialect == k3::Dialect::generic;
}

TrainingParticipant participantOf(const ProjectDevice &planned, const DeviceDescription &device)
{
    TrainingParticipant participant;
    participant.number = planned.participant.number;
    participant.device = &device;
    participant.revolutionsPerMinute = slowTurning;
    participant.rodMillimetres = rodLength;
    participant.millimetresPerSecond = slowTravel;
    participant.serialNumber = planned.label.serialNumber.toUInt() & k3::dataMask;
    return participant;
}

std::unique_ptr<SimulatedDevice> anyK3()
{
    auto encoder = std::make_unique<FrabaK3>(PhysicalResolution{}, 0, FrabaPlate{});
    encoder->setSpeed(static_cast<double>(slowTurning));
    return encoder;
}

std::unique_ptr<SimulatedDevice> simulated(const ProjectDevice &planned, const Catalog &catalog)
{
    const RingDevice its = ringDevice(planned.participant);
    if (its.idCode() == busTerminalIdCode)
        return std::make_unique<SimulatedBusTerminal>();
    const DeviceDescription *found = catalog.find(its.deviceKey, its.deviceCode);
    if (found == nullptr)
        return std::make_unique<SimulatedWords>(its.inWords, its.outWords);
    const DeviceDescription device = found->labelled(planned.label.turns, planned.label.stepsPerTurn);
    if (canBeSimulated(device))
        return simulatedDevice(participantOf(planned, device));
    if (isK3OfAnyMake(device))
        return anyK3();
    return std::make_unique<SimulatedWords>(its.inWords, its.outWords);
}

} // namespace

TrainingBus makePlannedRing(const Project &project, BusId ring, const Catalog &catalog)
{
    auto simulatedRing = std::make_shared<SimulatedRing>();
    for (const ProjectDevice &planned : devicesOn(project, ring))
        simulatedRing->add(ringDevice(planned.participant), simulated(planned, catalog));
    return {.link = std::make_unique<SimulatedRingLink>(simulatedRing), .controls = simulatedRing};
}

} // namespace codewheel
