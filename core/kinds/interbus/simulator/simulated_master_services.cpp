// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/hex_code.h"
#include "kinds/interbus/ring/comparison.h"
#include "kinds/interbus/ring/master_text.h"
#include "kinds/interbus/ring/ring_refusals.h"
#include "kinds/interbus/simulator/simulated_master.h"
#include "kinds/interbus/words/device_number.h"

#include <QStringList>

#include <algorithm>
#include <numeric>

namespace codewheel {
namespace {

tl::unexpected<Refusal> wrongState(MasterService service, MasterState state)
{
    return refuse(RefusalKind::busy, RingRefusalId::masterStateWrong,
                  {masterServiceName(service), masterStateName(state)});
}

QString codeText(const RingDevice *participant)
{
    return participant ? hexCode(participant->deviceCode, 4) : QStringLiteral("-");
}

tl::unexpected<Refusal> differs(NodeId place, const RingDevice *configured, const RingDevice *found)
{
    return refuse(RefusalKind::link, RefusalId::ringDiffers,
                  {place.toString(), codeText(configured), codeText(found)});
}

QString headsOf(const RingStructure &configuration)
{
    QStringList heads;
    for (const RingDevice &participant : configuration)
        if (DeviceNumber::of(participant.number).position == 0)
            heads << participant.number.toString();
    return heads.join(QStringLiteral(", "));
}

} // namespace

// Segments are counted along the ring: if devices are missing, those behind them move up.
RingStructure SimulatedMaster::foundAt(const std::vector<std::size_t> &places) const
{
    RingStructure found;
    int missing = 0;
    std::size_t next = 0;
    for (const std::size_t place : places) {
        for (; next < place; ++next)
            missing += DeviceNumber::of(m_wiring.planned()[next].number).position == 0 ? 1 : 0;
        next = place + 1;
        found.push_back(m_wiring.present(place));
        DeviceNumber number = DeviceNumber::of(found.back().number);
        number.segment -= missing;
        found.back().number = number.node();
    }
    return found;
}

// One device more per call.
Result<MasterLink::IdCycle> SimulatedMaster::createConfiguration()
{
    if (m_status.state != MasterState::ready)
        return wrongState(MasterService::createConfiguration, m_status.state);
    std::vector<std::size_t> places = m_wiring.reachable();
    const bool isComplete = ++m_found >= places.size();
    if (!isComplete)
        places.resize(m_found);
    RingStructure found = foundAt(places);
    if (isComplete) {
        m_loaded.reset();
        use(found, std::move(places));
        enter(found.empty() ? MasterState::ready : MasterState::active);
    }
    return MasterLink::IdCycle{std::move(found), isComplete};
}

// Segments that are switched off need not be there.
Result<void> SimulatedMaster::checkRing() const
{
    if (m_places.size() != m_configuration.size()) {
        const std::size_t first = std::min(m_places.size(), m_configuration.size());
        const RingDevice *configured = first < m_configuration.size() ? &m_configuration[first] : nullptr;
        const auto found =
            first < m_places.size() ? std::optional(m_wiring.present(m_places[first])) : std::nullopt;
        return differs(configured ? configured->number : found->number, configured,
                       found ? &*found : nullptr);
    }
    for (std::size_t i = 0; i < m_configuration.size(); ++i) {
        const RingDevice found = m_wiring.present(m_places[i]);
        if (!isSwitchedOff(i) && !isSameKind(found, m_configuration[i]))
            return differs(m_configuration[i].number, &m_configuration[i], &found);
    }
    if (const auto there = defect())
        return refuse(RefusalKind::link, RingRefusalId::busFault,
                      {Word{there->code}, Word{there->parameter}});
    return {};
}

Result<RingStructure> SimulatedMaster::activateConfiguration()
{
    const bool isPossible =
        m_status.state == MasterState::ready || (m_status.state == MasterState::busFail && m_looking == 0);
    if (!isPossible)
        return wrongState(MasterService::activateConfiguration, m_status.state);
    if (m_loaded)
        useLoaded();
    if (m_configuration.empty())
        return refuse(RefusalKind::busy, RingRefusalId::noConfiguration);
    if (auto checked = checkRing(); !checked)
        return tl::unexpected(checked.error());
    enter(MasterState::active);
    return m_configuration;
}

Result<void> SimulatedMaster::deactivateConfiguration()
{
    if (m_status.state != MasterState::active && m_status.state != MasterState::busFail)
        return wrongState(MasterService::deactivateConfiguration, m_status.state);
    alarmStop(); // with the same effect on the outputs
    return {};
}

Result<void> SimulatedMaster::startDataTransfer()
{
    if (m_status.state != MasterState::active)
        return wrongState(MasterService::startDataTransfer, m_status.state);
    for (MasterStatus::Segment &segment : m_status.segments)
        segment.crcErrors = 0;
    m_toleratedCrcErrors = 0;
    enter(MasterState::run);
    return {};
}

Result<void> SimulatedMaster::stopDataTransfer()
{
    if (!runs())
        return wrongState(MasterService::stopDataTransfer, m_status.state);
    enter(MasterState::active);
    return {};
}

void SimulatedMaster::alarmStop()
{
    m_found = 0;
    enter(MasterState::ready);
}

Result<void> SimulatedMaster::switchSegment(int segment, bool on)
{
    if (m_status.state == MasterState::ready || m_looking > 0)
        return wrongState(MasterService::switchSegment, m_status.state);
    const NodeId head = DeviceNumber{segment, 0}.node();
    if (std::ranges::find(m_configuration, head, &RingDevice::number) == m_configuration.end())
        return refuse(RefusalKind::badInput, RefusalId::unknownDevice,
                      {head.toString(), headsOf(m_configuration)});
    if (on)
        m_off.erase(segment);
    else
        m_off.insert(segment);
    m_seen = ~m_wiring.changes();
    publish();
    return {};
}

// A fault of the bus that the check does not find is considered gone.
Result<void> SimulatedMaster::confirmDiagnostics()
{
    m_peripheral.assign(m_configuration.size(), false);
    m_toleratedCrcErrors = 0;
    const bool nothingFound =
        m_status.state == MasterState::busFail && m_looking == 0 && !m_located && !defect();
    if (nothingFound)
        m_status.state = MasterState::ready;
    m_seen = ~m_wiring.changes();
    publish();
    return {};
}

// It is compared with the ring when it is activated.
Result<void> SimulatedMaster::keepConfiguration(const KeptConfiguration &configuration)
{
    m_kept = configuration;
    m_loaded = configuration.structure;
    publish();
    return {};
}

// If all of the ring is configured, a device that is not reached is a fault; otherwise it may have been left
// out on purpose.
void SimulatedMaster::useLoaded()
{
    std::vector<std::size_t> places = m_wiring.reachable();
    if (m_loaded->size() == m_wiring.size()) {
        places.resize(m_wiring.size());
        std::iota(places.begin(), places.end(), std::size_t{0});
    }
    use(*std::exchange(m_loaded, std::nullopt), std::move(places));
    publish();
}

Result<KeptConfiguration> SimulatedMaster::keptConfiguration() const
{
    if (!m_kept)
        return refuse(RefusalKind::busy, RingRefusalId::noConfiguration);
    return *m_kept;
}

} // namespace codewheel
