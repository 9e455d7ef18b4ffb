// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/plan/check_project.h"

#include "kinds/interbus/plan/gateway_plan.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/ring/id_code.h"
#include "kinds/interbus/ring/numbering.h"
#include "kinds/interbus/ring/ring_rules.h"
#include "vocabulary/refusal_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

// With Step 5 the process image overwrites what is below (FRABA manual 4).
constexpr int lastOfStep5Image = 127; // P127

// The translation context of these texts.
struct CheckProject
{
    Q_DECLARE_TR_FUNCTIONS(CheckProject)
};

struct Direction
{
    std::optional<AddressRange> DeviceAddresses::*range;
    const char *name;
};
constexpr std::array directions{Direction{&DeviceAddresses::in, "IN"},
                                Direction{&DeviceAddresses::out, "OUT"}};

bool isEncoder(const RingDevice &participant)
{
    constexpr std::array encoderCodes{0x36U, 0x37U, 0xB2U, 0xB3U, 0xF7U};
    return !participant.deviceKey.isEmpty() ||
           std::ranges::find(encoderCodes, participant.idCode()) != encoderCodes.end();
}

// Everything found in one project.
class Check
{
public:
    Check(const RingPlan &plan, std::span<const ProjectDevice> devices,
          const std::vector<DeviceAddresses> &addresses)
        : m_plan(plan)
        , m_devices(devices)
        , m_addresses(addresses)
    {}

    void overlaps(const Direction &direction);
    void alignment(const Direction &direction);
    void step5(const Direction &direction);
    void localBusDevices();
    void add(Severity severity, std::size_t device, const QString &text)
    {
        m_findings.push_back({severity, device, text});
    }
    std::vector<Finding> take()
    {
        std::ranges::stable_sort(m_findings, {}, &Finding::device);
        return std::move(m_findings);
    }

private:
    const std::optional<AddressRange> &range(std::size_t device, const Direction &direction) const
    {
        return m_addresses[device].*direction.range;
    }
    QString number(std::size_t device) const { return m_devices[device].place().toString(); }
    QString shown(int byte) const { return addressText(byte, m_plan.addresses.unit); }

    const RingPlan &m_plan;
    const std::span<const ProjectDevice> m_devices;
    const std::vector<DeviceAddresses> &m_addresses;
    std::vector<Finding> m_findings;
};

void Check::overlaps(const Direction &direction)
{
    std::vector<std::size_t> devices;
    for (std::size_t device = 0; device < m_addresses.size(); ++device)
        if (range(device, direction))
            devices.push_back(device);
    std::ranges::stable_sort(devices, {},
                             [&](std::size_t device) { return range(device, direction)->first; });
    std::optional<std::size_t> furthest; // of those before
    for (const std::size_t device : devices) {
        if (furthest && range(*furthest, direction)->last() >= range(device, direction)->first)
            for (const auto &[here, there] : {std::pair(device, *furthest), std::pair(*furthest, device)})
                add(Severity::fault, here,
                    CheckProject::tr("%1 at %2 overlaps that of %3.")
                        .arg(QLatin1String(direction.name), shown(range(here, direction)->first),
                             number(there)));
        if (!furthest || range(device, direction)->last() > range(*furthest, direction)->last())
            furthest = device;
    }
}

void Check::alignment(const Direction &direction)
{
    for (std::size_t device = 0; device < m_addresses.size(); ++device)
        if (const auto &given = range(device, direction); given && given->first % 2 != 0)
            add(Severity::attention, device,
                CheckProject::tr("%1 begins at the odd byte %2, within a word.")
                    .arg(QLatin1String(direction.name), QString::number(given->first)));
}

void Check::step5(const Direction &direction)
{
    for (std::size_t device = 0; device < m_addresses.size(); ++device) {
        const auto &given = range(device, direction);
        if (given && given->first <= lastOfStep5Image && isEncoder(ringDevice(m_devices[device].participant)))
            add(Severity::attention, device,
                CheckProject::tr("%1 is not above P127: with Step 5, the process image overwrites it.")
                    .arg(QLatin1String(direction.name)));
    }
}

// Loop 2 and Inline have no interface for the remote bus (FRABA manual 3.1). It can be planned all the same,
// since connected devices may be taken over line by line.
void Check::localBusDevices()
{
    for (std::size_t device = 0; device < m_devices.size(); ++device)
        if (const RingDevice participant = ringDevice(m_devices[device].participant);
            standsOnLocalBus(participant.idCode()) && !isOnLocalBus(participant))
            add(Severity::attention, device,
                CheckProject::tr("Devices with this ID code belong on the local bus of a bus terminal."));
}

// Why the image of the ring cannot be in the registers of its gateway; empty: it can, or it has none.
std::optional<Refusal> whyNotInGateway(const Project &project, BusId ring)
{
    const auto gateway = plannedGateway(project, ring);
    if (!gateway)
        return std::nullopt;
    const auto map = gateway->and_then([&](const GatewaySettings &settings) {
        return GatewayMap::of(structureOf(project, ring), settings);
    });
    return map ? std::nullopt : std::optional(map.error());
}

} // namespace

std::vector<Finding> checkProject(const Project &project, const std::vector<DeviceAddresses> &addresses,
                                  BusId ring)
{
    const RingPlan &plan = ringPlan(project, ring);
    Check check(plan, devicesOn(project, ring), addresses);
    const RingStructure structure = structureOf(project, ring);
    for (const RingFinding &finding : checkRing(structure))
        check.add(Severity::fault, finding.device, ringFindingText(finding, structure));
    check.localBusDevices();
    if (const auto why = whyNotInGateway(project, ring); why && !structure.empty())
        check.add(Severity::fault, 0, refusalText(*why));
    for (const Direction &direction : directions) {
        check.overlaps(direction);
        check.alignment(direction);
        if (plan.addresses.step5)
            check.step5(direction);
    }
    return check.take();
}

} // namespace codewheel
