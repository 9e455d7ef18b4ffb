// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/interbus/gateway_access.h"

#include "cli/bus/present_ports.h"
#include "cli/call/subcommand.h"
#include "cli/call/texts.h"
#include "doctor/hindrance_of_refusal.h"
#include "doctor/link_hindrances.h"
#include "kinds/interbus/gateway/gateway_link.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/gateway/register_texts.h"
#include "kinds/interbus/links/modbus_port.h"
#include "kinds/interbus/plan/gateway_plan.h"
#include "links/port_access.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <algorithm>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

// Beside the poll interval, in which nothing happens.
constexpr Instant longestExchange = 5s;
constexpr int transactionsOfExchange = 10; // at most, in a ring of one block
constexpr int exchangesOfContact = 3;      // until a word can be believed

std::vector<ProjectDevice> plannedOn(const Project *project, BusId ring)
{
    if (project == nullptr)
        return {};
    const auto devices = devicesOn(*project, ring);
    return {devices.begin(), devices.end()};
}

bool asksForDevices(const Subcommand &command)
{
    const std::string_view name(command.name);
    return name == "scan" || name == "compare";
}

Complaint noIdCycle()
{
    return complaintAbout({RefusalKind::notSupported, GatewayRefusalId::noIdCycle, {}});
}

tl::unexpected<Complaint> needsProject(const GatewaySettings &gateway)
{
    return badInput(
        "gatewayNeedsProject",
        CommandLine::tr("The gateway %1 cannot say which devices are in its ring. Name the project "
                        "that does, with --project FILE."),
        {gatewayUnit(gateway)});
}

bool isNowhere(const GatewaySettings &gateway)
{
    return gateway.transport == GatewaySettings::Transport::tcp ? gateway.host.isEmpty()
                                                                : gateway.serialPort.isEmpty();
}

Complaint aboutNowhere(const QString &ring)
{
    return notDone(
        "noGatewayInProject",
        sentence(CommandLine::tr("The project does not say where the gateway of \"%1\" is. Enter it in the "
                                 "window, or name it, as --link modbus-tcp:192.168.0.5."),
                 {ring}),
        {ring});
}

Complaint aboutOpening(const Refusal &why)
{
    Complaint complaint = complaintAtGateway(why);
    if (why.id == RefusalId::portNotFound)
        complaint.text += u' ' + presentPortsText();
    return complaint;
}

} // namespace

Complaint complaintAtGateway(const Refusal &why)
{
    Complaint complaint = complaintAbout(why);
    if (why.id == GatewayRefusalId::outputsBlocked)
        complaint.text = sentence(
            CommandLine::tr("%1 does not carry out %2 (exception 4). The watchdog of its outputs may "
                            "have tripped: acknowledge it with codewheel-cli gateway "
                            "--acknowledge-watchdog."),
            registerRefusalTexts(why));
    return complaint;
}

GatewayAccess::Behind GatewayAccess::sessionBehind(const GatewaySettings &gateway, const Project *project,
                                                   BusId ring, const Catalog &catalog)
{
    auto devices =
        project != nullptr ? gatewayDevices(*project, ring, catalog) : std::vector<GatewayDevice>();
    auto link =
        std::make_unique<GatewayLink>(std::make_unique<ModbusPort>(gateway), gateway, std::move(devices));
    GatewayLink &its = *link;
    return {std::make_unique<RingSession>(std::move(link), catalog, QDateTime::currentDateTime(), nullptr,
                                          RingSession::DriverFactory(), ring),
            its};
}

GatewayAccess::GatewayAccess(const GatewaySettings &gateway, const Project *project, BusId ring,
                             const Catalog &catalog)
    : GatewayAccess(sessionBehind(gateway, project, ring, catalog), gateway, project, ring, catalog)
{}

GatewayAccess::GatewayAccess(Behind behind, const GatewaySettings &gateway, const Project *project,
                             BusId ring, const Catalog &catalog)
    : RingAccess(std::move(behind.session))
    , m_link(behind.link)
    , m_gateway(gateway)
    , m_planned(plannedOn(project, ring))
    , m_devices(project != nullptr ? checkedDevices(*project, ring, catalog) : std::vector<CheckedDevice>())
    , m_hasProject(project != nullptr)
{
    QObject::connect(&this->ring(), &RingSession::refused, &m_scope,
                     [this](const Refusal &why) { m_refusal = why; });
    QObject::connect(&this->ring(), &RingSession::messaged, &m_scope, [this](const Message &message) {
        m_outIsUnknown |= message.refusal && message.refusal->id == GatewayRefusalId::outNotReadBack;
    });
}

Hindrances GatewayAccess::hindrances() const
{
    if (m_gateway.transport == GatewaySettings::Transport::rtu)
        return portHindrances(portPath(m_gateway.serialPort), Computer());
    ModbusPort port(m_gateway);
    const auto opened = port.open();
    if (opened)
        return {};
    const auto why = hindranceOf(opened.error());
    return {why ? *why
                : Hindrance{HindranceId::hostRefuses, Hindrance::Weight::prevents, port.name(),
                            refusalText(opened.error())}};
}

Checked<void> GatewayAccess::open()
{
    if (ring().isOpen())
        return {};
    if (!m_hasProject)
        return needsProject(m_gateway);
    if (isNowhere(m_gateway))
        return tl::unexpected(aboutNowhere(name()));
    if (const auto opened = ring().open(RingSession::Start::watching); !opened) {
        m_notOpened = opened.error();
        return tl::unexpected(aboutOpening(opened.error()));
    }
    nameLabelled();
    return {};
}

// With the resolution on its label.
void GatewayAccess::nameLabelled()
{
    for (const ProjectDevice &device : m_planned)
        if (device.label.turns != 0 || device.label.stepsPerTurn != 0)
            (void)ring().name(device.place(), device.participant.deviceKey, device.label.turns,
                              device.label.stepsPerTurn);
}

std::optional<Complaint> GatewayAccess::whyNot(const Subcommand &command) const
{
    return asksForDevices(command) ? std::optional(noIdCycle()) : std::nullopt;
}

std::vector<Place> GatewayAccess::knownPlaces() const
{
    std::vector<Place> places;
    for (const ProjectDevice &device : m_planned)
        places.push_back(device.place());
    return places;
}

Checked<EncoderSession *> GatewayAccess::encoder(const Call &call, NodeId node, bool namesIt)
{
    if (m_hasProject && !mayHave(node))
        return tl::unexpected(notAPlace(bus().placeOf(node).shown()));
    if (const auto opened = open(); !opened)
        return tl::unexpected(opened.error());
    return RingAccess::encoder(call, node, namesIt).and_then([&](EncoderSession *encoder) {
        return inContact(call, encoder->place()).map([&] { return encoder; });
    });
}

Checked<void> GatewayAccess::contact(const Call &call, const ProjectDevice &planned)
{
    if (auto opened = open(); !opened)
        return opened;
    return inContact(call, planned.place());
}

// Until it shows a word that can be believed.
Checked<void> GatewayAccess::inContact(const Call &call, Place place)
{
    if (std::exchange(m_outIsUnknown, false))
        call.terminal.complain(
            refusalText({RefusalKind::notSupported, GatewayRefusalId::outNotReadBack, {}}));
    const EncoderSession *encoder = ring().encoder(place);
    const Instant end = ring().now() + exchangesOfContact * longestTurn();
    const auto isSilent = [&] {
        return encoder != nullptr && encoder->latest().state == EncoderState::notSeen;
    };
    while (isSilent() && !whyItStands() && ring().now() < end)
        if (!advance(lookInterval()))
            return tl::unexpected(linkLost());
    if (const auto standstill = whyItStands())
        return tl::unexpected(*standstill);
    if (!isSilent())
        return {};
    return tl::unexpected(
        complaintAbout({RefusalKind::link, GatewayRefusalId::wordNotSteady, {place.shown()}}));
}

bool GatewayAccess::startThread()
{
    ring().startThread({}); // as fast as the link
    return true;
}

// Reading needs words, too.
void GatewayAccess::prepare(const Job &)
{
    operate(true);
}

// The last word of a job has gone out before, and what is shown then was read after it.
void GatewayAccess::rest()
{
    exchange();
    operate(false);
    exchange();
}

void GatewayAccess::operate(bool on)
{
    if (on)
        m_refusal.reset();
    ring().setOperate(on);
    waitUntil([&] { return ring().isOperating() == on || (on && m_refusal); });
}

void GatewayAccess::exchange()
{
    const std::uint64_t before = ring().latest().cycle;
    waitUntil([&] { return ring().latest().cycle > before; });
}

void GatewayAccess::waitUntil(const std::function<bool()> &isSo)
{
    const Instant end = ring().now() + longestTurn();
    while (!isSo() && ring().now() < end && advance(lookInterval())) {
    }
}

Instant GatewayAccess::longestTurn() const
{
    return std::max(longestExchange, transactionsOfExchange * m_gateway.timeOut) + m_gateway.pollInterval;
}

// A job ends with the bus, or does not begin after it has gone back to Watch; what the bus says is why.
Complaint GatewayAccess::complaint(const Refusal &why) const
{
    const bool isOfBus = why.id == GatewayRefusalId::outsOfOther || why.id == RefusalId::busStopped ||
                         why.id == RefusalId::watchOnly;
    Complaint told = complaintAtGateway(why);
    if (isOfBus && m_refusal)
        told = complaintAtGateway(*m_refusal);
    else if (const Complaint lost = linkLost(); !isConnected() && told.key != lost.key)
        told.text = lost.text + u' ' + told.text;
    return told;
}

Checked<Answer> GatewayAccess::scan(const Call &)
{
    return tl::unexpected(noIdCycle());
}

SentZeros GatewayAccess::sentZeros() const
{
    return m_link.sentZeros();
}

std::shared_ptr<const LinkFigures> GatewayAccess::figures() const
{
    return std::make_shared<const LinkFigures>(m_link.figuresNow());
}

Refusal GatewayAccess::whatIsLost() const
{
    return m_notOpened.value_or(RingAccess::whatIsLost());
}

} // namespace codewheel
