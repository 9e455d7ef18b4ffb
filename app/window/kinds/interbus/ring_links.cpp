// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/interbus/ring_links.h"

#include "app/window/buses/leaving.h"
#include "app/window/connect/link_test.h"
#include "app/window/connect/port_rows.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "app/window/kinds/interbus/ring_connection.h"
#include "app/window/window_settings.h"
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "kinds/interbus/gateway/gateway_check_text.h"
#include "kinds/interbus/plan/gateway_plan.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "vocabulary/refusal_text.h"
#include "widgets/connect/connect_page.h"
#include "widgets/connect/plain_link_form.h"
#include "widgets/kinds/interbus/gateway/gateway_form.h"
#include "widgets/kinds/interbus/gateway/registers_page.h"
#include "widgets/project/project_document.h"

#include <algorithm>

namespace codewheel {
RingLinks::RingLinks(const Parts &parts, QObject *parent)
    : QObject(parent)
    , m_parts(parts)
    , m_tcp(new GatewayForm(GatewaySettings::Transport::tcp, &parts.page))
    , m_rtu(new GatewayForm(GatewaySettings::Transport::rtu, &parts.page))
{
    ConnectPage &page = parts.page;
    page.addForm(new PlainLinkForm(tr("Training bus"),
                                   tr("A simulated ring in this program. Nothing leaves this computer."),
                                   KindData(ProjectLink()), &page));
    page.addForm(m_tcp);
    page.addForm(m_rtu);
    connect(&page, &ConnectPage::portsWanted, this, &RingLinks::listPorts);
    connect(&page, &ConnectPage::connectWanted, this, &RingLinks::connectAs);
    connect(&page, &ConnectPage::keepWanted, this,
            [this](const KindData &plan) { keep(*plan.as<ProjectLink>()); });
    connect(&page, &ConnectPage::testWanted, this, &RingLinks::test);
    connect(&page, &ConnectPage::testCancelled, &m_test, &BackgroundSteps::cancel);
    connect(&m_test, &BackgroundSteps::ended, this, &RingLinks::endTest);
    connect(&parts.registers, &RegistersPage::readWanted, this, &RingLinks::readNow);
    connect(&parts.registers, &RegistersPage::orderWanted, this, &RingLinks::setOrder);
    connect(&parts.ring.project(), &ProjectDocument::changed, this, &RingLinks::showPlan);
    connect(parts.ring.bus(), &RingSession::stateChanged, this, &RingLinks::showState);
    showPlan();
    showState();
}

bool RingLinks::plansGateway() const
{
    return plannedGateway(m_parts.ring.project().project(), m_parts.ring.id()).has_value();
}

bool RingLinks::canConnect() const
{
    const Project &project = m_parts.ring.project().project();
    const auto gateway = plannedGateway(project, m_parts.ring.id());
    if (!gateway) // a training ring, unless nothing is planned yet
        return !devicesOn(project, m_parts.ring.id()).empty();
    if (!*gateway)
        return true; // its refusal says what is wrong
    const GatewaySettings &its = **gateway;
    return !(its.transport == GatewaySettings::Transport::tcp ? its.host : its.serialPort).isEmpty();
}

GatewaySettings RingLinks::planned() const
{
    const auto gateway = plannedGateway(m_parts.ring.project().project(), m_parts.ring.id());
    return gateway && *gateway ? **gateway : GatewaySettings();
}

void RingLinks::showPlan()
{
    const Project &project = m_parts.ring.project().project();
    const PlannedBus *bus = findBus(project, m_parts.ring.id());
    const QString name = bus != nullptr ? bus->name : m_parts.ring.nameOfNew();
    m_parts.page.setAbout(name);
    m_parts.registers.setAbout(name);
    m_tcp->setLast(m_parts.settings.lastLink(QString::fromLatin1(modbusTcpLink)));
    m_rtu->setLast(m_parts.settings.lastLink(QString::fromLatin1(modbusRtuLink)));
    m_parts.page.showPlan(KindData(ringPlan(project, m_parts.ring.id()).link));
}

void RingLinks::listPorts()
{
    const PortRows ports = portRows(serialPorts());
    m_parts.page.setPorts(ports.rows, ports.trouble);
}

void RingLinks::showState()
{
    const BusState state = m_parts.ring.bus()->state();
    m_parts.page.setConnecting(state == BusState::opening);
    using enum ConnectPage::Connected;
    const bool isOpen = state == BusState::open || state == BusState::lost;
    m_parts.page.setConnected(!isOpen ? no : m_parts.ring.gateway() ? real : simulated);
}

void RingLinks::keep(const ProjectLink &link)
{
    ProjectDocument &document = m_parts.ring.project();
    Project after = document.project();
    RingPlan plan = ringPlan(after, m_parts.ring.id());
    plan.link = link;
    setRingPlan(after, m_parts.ring.id(), std::move(plan));
    document.edit(std::move(after), tr("Connection"));
}

void RingLinks::connectAs(const KindData &plan)
{
    const ProjectLink &link = *plan.as<ProjectLink>();
    changeLink(link, [this, link] {
        if (isGatewayLink(link.kind))
            m_parts.settings.setLastLink(link.kind, link.settings);
        m_parts.connection.connectRing();
    });
}

void RingLinks::connectFound(const KindData &plan)
{
    m_parts.page.connectBy(plan);
}

// A connected ring is left first, after asking what that ends.
void RingLinks::changeLink(const ProjectLink &link, std::function<void()> then)
{
    const auto change = [this, link, then = std::move(then)] {
        m_parts.ring.bus()->close();
        keep(link);
        then();
    };
    if (m_parts.ring.isOpen())
        m_parts.leaving.ask(Leaving::Why::disconnect, {m_parts.ring.bus()}, change);
    else
        change();
}

std::vector<CheckedDevice> RingLinks::devices() const
{
    return checkedDevices(m_parts.ring.project().project(), m_parts.ring.id(), m_parts.ring.catalog());
}

void RingLinks::test(const KindData &plan)
{
    const ProjectLink &link = *plan.as<ProjectLink>();
    const auto settings = gatewaySettings(link.kind, link.settings);
    if (!settings) {
        m_parts.page.setProblem(refusalText(settings.error()));
        return;
    }
    m_tested = *settings;
    m_isReadNow = false;
    m_lastRead.clear();
    m_parts.page.setProblem({});
    m_parts.page.setTesting(true);
    startTest();
}

void RingLinks::readNow(const NodeId &device)
{
    m_tested = planned();
    m_isReadNow = true;
    m_parts.registers.setReading(true);
    startTest(device);
}

void RingLinks::startTest(std::optional<NodeId> only)
{
    m_test.start(std::make_unique<LinkTest<GatewayCheck, RegisterPort>>(
        m_parts.ring.makePort(m_tested), [this](const GatewayFinding &finding) { take(finding); }, m_tested,
        devices(), only));
}

void RingLinks::take(const GatewayFinding &finding)
{
    if (finding.shown) {
        std::erase_if(m_lastRead,
                      [&](const DeviceRegisters &its) { return its.place == finding.shown->place; });
        m_lastRead.push_back(*finding.shown);
    }
    if (m_isReadNow) {
        if (finding.outcome == CheckOutcome::failed)
            m_parts.registers.tell(finding.sentence);
        return;
    }
    if (!finding.proposed.empty())
        (m_tested.transport == GatewaySettings::Transport::tcp ? m_tcp : m_rtu)->propose(finding.proposed);
    const QString filledIn = finding.proposed.empty() ? QString() : u' ' + tr("The fields are filled in.");
    m_parts.page.addStep(finding.outcome, gatewayStepText(finding.step, m_tested.transport, finding.place),
                         finding.sentence + filledIn);
    if (finding.why)
        tellCommand(m_parts.page, *finding.why);
}

void RingLinks::endTest()
{
    m_parts.page.setTesting(false);
    m_parts.registers.setReading(false);
    showRegisters();
}

// Words of a device that was read are shown until it is read again; of the others only the registers.
std::vector<DeviceRegisters> RingLinks::plannedRegisters() const
{
    const auto map =
        GatewayMap::of(structureOf(m_parts.ring.project().project(), m_parts.ring.id()), planned());
    std::vector<DeviceRegisters> rows;
    if (!map)
        return rows;
    const auto checked = devices();
    for (std::size_t i = 0; i < checked.size(); ++i) {
        const NodeId place = checked[i].participant.number;
        const auto read = std::ranges::find(m_lastRead, place, &DeviceRegisters::place);
        if (read != m_lastRead.end() && read->in == map->in(i))
            rows.push_back(*read);
        else
            rows.push_back({.place = place, .in = map->in(i), .out = map->out(i)});
    }
    return rows;
}

// As the link reads them, put back into their registers.
std::vector<DeviceRegisters> RingLinks::liveRegisters() const
{
    const RingSession &bus = *m_parts.ring.bus();
    const auto map = GatewayMap::of(bus.structure(), *m_parts.ring.gateway());
    std::vector<DeviceRegisters> rows;
    if (!map)
        return rows;
    const auto checked = devices();
    for (std::size_t i = 0; i < bus.structure().size(); ++i) {
        const NodeId place = bus.structure()[i].number;
        DeviceRegisters its{.place = place, .in = map->in(i), .out = map->out(i)};
        const WordChannel *words = bus.channel(bus.placeOf(place));
        const auto sender = std::ranges::find(
            checked, place, [](const CheckedDevice &device) { return device.participant.number; });
        if (words != nullptr && words->freshness().isLive()) {
            its.inNow.resize(static_cast<std::size_t>(its.in.count));
            map->put(words->in(), its.inNow);
            its.readings =
                wordReadings(its.inNow, sender != checked.end() ? sender->sender : SendingEncoder());
        }
        rows.push_back(std::move(its));
    }
    return rows;
}

void RingLinks::showRegisters()
{
    const bool isLive = m_parts.ring.isOpen() && m_parts.ring.gateway();
    const bool isHighFirst = isLive ? m_parts.ring.gateway()->highWordFirst : planned().highWordFirst;
    m_parts.registers.show(isLive ? liveRegisters() : plannedRegisters(), wordOrderOf(isHighFirst), isLive);
}

// Once, for both directions. A connected ring is connected anew.
void RingLinks::setOrder(WordOrder order)
{
    GatewaySettings settings = planned();
    settings.highWordFirst = order == WordOrder::abcd;
    changeLink({linkKindOf(settings), linkTexts(settings)}, [this, wasOpen = m_parts.ring.isOpen()] {
        if (wasOpen)
            m_parts.connection.connectRing();
        showRegisters();
    });
}

} // namespace codewheel
