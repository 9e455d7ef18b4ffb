// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/canopen/canopen_access.h"

#include "can/can_refusals.h"
#include "can/simulator/simulated_can_link.h"
#include "catalog/catalog.h"
#include "cli/bus/present_ports.h"
#include "cli/call/subcommand.h"
#include "cli/call/texts.h"
#include "cli/encoder/consent.h"
#include "cli/encoder/jobs.h"
#include "cli/kinds/canopen/device_on_node.h"
#include "doctor/link_hindrances.h"
#include "kinds/canopen/bus/canopen_bus_refusals.h"
#include "kinds/canopen/bus/canopen_facts.h"
#include "kinds/canopen/driver/node_job.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/simulator/simulated_canopen_plant.h"
#include "links/can_interface.h"
#include "links/can_link_to.h"
#include "links/port_access.h"
#include "links/slcan_link.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <algorithm>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant listeningBeforeSending = 200ms; // for another master
constexpr Instant longestSilence = 2s;            // before it is asked about
constexpr Instant longestContactWithNode = 20s;   // silence is noticed long before
constexpr Instant longestIdentityOfNode = 1s;
constexpr Instant longestListening = 3s; // to a node that tells of itself once a second
constexpr Instant longestLookAtNode = 1s;
constexpr Instant longestWaitForHeartbeat = 1'500ms; // which comes once a second, with most
constexpr Instant longestTransfer = 60s;             // in segments
constexpr Instant longestAlone = 500ms;              // a frame needs some of them at most
constexpr Instant untilFateIsTold = 1'200ms;         // by a serial adapter, of what it does not get rid of
constexpr Instant untilSecondAnswer = 50ms;

// What is watched is not asked.
bool onlyListens(const Call &call)
{
    return std::string_view(call.command.name) == "monitor";
}

Complaint aboutSilentNode(CanopenAddress address, bool wasAsked)
{
    return notDone(
        "nodeSilent",
        sentence(wasAsked ? CommandLine::tr("Node %1 does not answer. Check its number, its supply and "
                                            "the rate of the bus; a node that was stopped answers nothing "
                                            "until it is started. codewheel-cli scan --ask looks for "
                                            "nodes.")
                          : CommandLine::tr("Nothing is heard of node %1. It may be waiting to be started "
                                            "(codewheel-cli nmt start), or tell nothing by itself: "
                                            "codewheel-cli scan --ask asks it."),
                 {address.shown()}),
        {address.place().toString()});
}

} // namespace

CanopenAccess::CanopenAccess(std::unique_ptr<CanLink> link, const CanopenLink &settings,
                             const Catalog &catalog, BusId id)
    : CanopenAccess(settings, std::make_unique<CanopenSession>(std::move(link), catalog,
                                                               QDateTime::currentDateTime(), nullptr, id))
{}

CanopenAccess::CanopenAccess(const CanopenLink &settings, std::unique_ptr<CanopenSession> session)
    : BusAccess(*session, QString::fromLatin1(canopenKind))
    , m_link(settings)
    , m_session(std::move(session))
{
    QObject::connect(m_session.get(), &CanopenSession::passed, m_session.get(),
                     [this](const CanopenRow &row) { m_firstPdos.take(row.frame); });
}

std::unique_ptr<CanopenAccess> CanopenAccess::to(const CanopenLink &link, const Catalog &catalog, BusId id)
{
    if (link.isSimulated())
        return std::make_unique<CanopenAccess>(
            std::make_unique<SimulatedCanLink>(canopen::SimulatedCanopenPlant().bus(), link.settings.rate),
            link, catalog, id);
    auto its = canLinkTo(link.at);
    auto *adapter = dynamic_cast<SlcanLink *>(its.get());
    auto access = std::make_unique<CanopenAccess>(std::move(its), link, catalog, id);
    access->m_adapter = adapter;
    return access;
}

Hindrances CanopenAccess::hindrances() const
{
    if (m_link.isSimulated())
        return {};
    if (m_link.at.isSerial)
        return portHindrances(portPath(m_link.at.where), Computer());
    if (!canInterface(m_link.at.where, Computer(), {})) {
        const auto missing =
            canHindranceOf({RefusalKind::link, CanRefusalId::interfaceMissing, {m_link.at.where}});
        return missing ? Hindrances{*missing} : Hindrances();
    }
    Hindrances its = canHindrances(Computer());
    std::erase_if(its, [this](const Hindrance &one) { return one.about != m_link.at.where; });
    return its;
}

Checked<void> CanopenAccess::open()
{
    if (m_session->isOpen())
        return {};
    if (m_link.whyNot)
        return tl::unexpected(*m_link.whyNot);
    if (m_link.takesUnsureWatch)
        m_session->takeUnsureWatch();
    return open(CanopenSession::Start::watching);
}

Checked<void> CanopenAccess::open(CanopenSession::Start start)
{
    const auto opened = m_session->open(m_link.settings, start, CanopenSession::Drive::byHand);
    if (opened)
        return {};
    m_notOpened = opened.error();
    return tl::unexpected(aboutOpening(opened.error()));
}

// The master that is at work shows itself only by its frames. An adapter that cannot listen only acknowledges
// them meanwhile, as it would in Operate.
Checked<void> CanopenAccess::openToSend(const Call &call)
{
    if (m_session->isOperating())
        return {};
    auto opened = open();
    if (!opened && m_notOpened && m_notOpened->id == CanRefusalId::watchNotSure)
        opened = open(CanopenSession::Start::operating);
    if (!opened)
        return opened;
    if (auto may = listenFirst(call); !may)
        return may;
    if (const auto others = whetherOnlyJ1939())
        return tl::unexpected(*others);
    if (m_link.sendsBesideOthers)
        m_session->sendBesideOthers();
    m_session->setOperate(true);
    if (!advance(lookInterval()))
        return tl::unexpected(linkLost());
    if (const auto may = whetherHeldBack(); !may)
        return may;
    if (!m_session->isOperating())
        return tl::unexpected(linkLost());
    if (!m_link.isSimulated())
        call.terminal.complain(
            sentence(CommandLine::tr("%1: in Operate, frames are sent."), {m_session->linkName()}));
    tellRemark(call);
    return {};
}

Checked<void> CanopenAccess::openToListen(const Call &call)
{
    if (m_session->isOpen())
        return {};
    auto opened = open();
    if (opened)
        tellRemark(call);
    return opened;
}

void CanopenAccess::tellRemark(const Call &call) const
{
    if (const auto remark = m_adapter != nullptr ? m_adapter->remark() : std::nullopt)
        call.terminal.complain(refusalText(*remark));
}

// Some adapters repeat a frame that nobody acknowledges for ever.
Checked<void> CanopenAccess::listenFirst(const Call &call)
{
    const auto isHeard = [this] { return !m_session->latest().figures.isNothingHeard(); };
    advance(listeningBeforeSending);
    if (isHeard())
        return {};
    if (waitUntil(isHeard, longestSilence - listeningBeforeSending)) {
        advance(listeningBeforeSending);
        return {};
    }
    if (!isConnected())
        return tl::unexpected(linkLost());
    const bool isAgreed = call.arguments.has("--yes") || call.arguments.has("--ask");
    if (!isAgreed && call.terminal.isInteractive && !call.arguments.has("--json"))
        return consent(call,
                       CommandLine::tr("Nothing was heard on the bus for 2 s: the rate may be wrong, or "
                                       "nobody there. Send all the same?"),
                       {});
    call.terminal.complain(CommandLine::tr("Nothing was heard on the bus for 2 s before sending."));
    return {};
}

Checked<void> CanopenAccess::changeRate(int rate)
{
    m_session->close();
    m_adapter->setRate(rate);
    m_link.settings.rate = m_link.at.rate = rate;
    if (auto opened = open(CanopenSession::Start::operating); !opened)
        return opened;
    if (m_link.sendsBesideOthers)
        m_session->sendBesideOthers();
    return advance(lookInterval()) ? Checked<void>() : tl::unexpected(linkLost());
}

Checked<void> CanopenAccess::whetherHeldBack() const
{
    const auto held = whyHeldBack(m_session->latest());
    return held ? Checked<void>(tl::unexpected(complaint(*held))) : Checked<void>();
}

Checked<void> CanopenAccess::listenAgain()
{
    return advance(listeningBeforeSending) ? whetherHeldBack() : tl::unexpected(linkLost());
}

// An interface of the system goes on by hand, too: Qt's device belongs to the thread that opened it.
bool CanopenAccess::startThread()
{
    if (m_adapter == nullptr)
        return false;
    m_session->startThread();
    return true;
}

std::optional<NodeId> CanopenAccess::placeTyped(const QString &text) const
{
    const auto address = CanopenAddress::read(text);
    return address ? std::optional(address->place()) : std::nullopt;
}

bool CanopenAccess::isMeant(const QString &typed) const
{
    return typed.startsWith(
        QLatin1String(CanopenAddress::prefix.data(), qsizetype{CanopenAddress::prefix.size()}));
}

Complaint CanopenAccess::notAPlace(const QString &typed) const
{
    return complaintAbout({RefusalKind::badInput, CanopenBusRefusalId::nodeNumberWrong, {typed}});
}

QString CanopenAccess::somePlaces() const
{
    return CommandLine::tr("the numbers of nodes, as can:5");
}

Checked<EncoderSession *> CanopenAccess::encoder(const Call &call, NodeId node, bool)
{
    const CanopenAddress address = CanopenAddress::of(node);
    const bool listens = onlyListens(call);
    if (const auto opened = listens ? openToListen(call) : openToSend(call); !opened)
        return tl::unexpected(opened.error());
    if (m_session->encoder(node) == nullptr) {
        const auto device = deviceAt(call, address);
        if (!device)
            return tl::unexpected(device.error());
        if (const auto added = m_session->add(address.node, *device); !added)
            return tl::unexpected(complaintAbout(added.error()));
    }
    EncoderSession *encoder = m_session->encoder(node);
    if (listens)
        return heard(encoder);
    if (m_link.mayStopNodes)
        QObject::connect(encoder, &EncoderSession::finished, m_session.get(),
                         [this, place = encoder->place()] { m_session->mayStopNode(place); });
    if (m_link.mayStopNodes)
        m_session->mayStopNode(encoder->place());
    return inContact(encoder);
}

// Where nobody has named it, the node itself tells what it is.
Checked<QString> CanopenAccess::deviceAt(const Call &call, CanopenAddress address)
{
    auto device = deviceOnNode(call, bus().placeOf(address.place()));
    if (!device || !device->isEmpty())
        return device;
    if (onlyListens(call))
        return usualDeviceOnNode();
    constexpr canopen::SdoObject deviceType{0x1000, 0};
    const auto told = transfer({.node = address.node, .object = deviceType});
    if (!told)
        return tl::unexpected(told.error());
    if (told->kind == canopen::SdoOutcome::Kind::noAnswer)
        return tl::unexpected(besideLoad(aboutSilentNode(address, true)));
    const auto identity = identityOf(call, address.node);
    if (!identity)
        return tl::unexpected(identity.error());
    const auto type = told->kind == canopen::SdoOutcome::Kind::read
                          ? std::optional(canopen::numberOf(told->value))
                          : std::nullopt;
    const QString its = deviceOfNode(call.catalog, type, *identity);
    return its.isEmpty() ? usualDeviceOnNode() : its;
}

Checked<canopen::ToldIdentity> CanopenAccess::identityOf(const Call &call, int node)
{
    canopen::ToldIdentity identity{};
    if (!canopen::describesNodes(call.catalog.devices()))
        return identity;
    constexpr std::uint16_t index = 0x1018;
    for (std::uint8_t sub = 1; sub < canopen::NodeIdentity::size; ++sub) {
        const auto told = transfer({.node = node, .object = {index, sub}});
        if (!told)
            return tl::unexpected(told.error());
        if (told->kind == canopen::SdoOutcome::Kind::read)
            identity.at(sub - 1U) = static_cast<std::uint32_t>(canopen::numberOf(told->value));
    }
    return identity;
}

Checked<void> CanopenAccess::contact(const Call &call, const ProjectDevice &planned)
{
    const auto there = encoder(call, planned.place().node, false);
    return there || (isConnected() && there.error().key == QStringLiteral("nodeSilent"))
               ? Checked<void>()
               : tl::unexpected(there.error());
}

Checked<EncoderSession *> CanopenAccess::heard(EncoderSession *encoder)
{
    const CanopenAddress address = CanopenAddress::of(encoder->place().node);
    const auto isHeard = [&] { return m_session->latest().heard(address.node) != nullptr; };
    if (waitUntil(isHeard, longestListening))
        return encoder;
    return tl::unexpected(isConnected() ? besideLoad(aboutSilentNode(address, false)) : linkLost());
}

// If it already shows its position, no time passes.
Checked<EncoderSession *> CanopenAccess::inContact(EncoderSession *encoder)
{
    const auto state = [encoder] { return encoder->latest().state; };
    const auto isSilent = [&] { return state() == EncoderState::silent; };
    waitUntil([&] { return encoder->latest().position || isSilent(); }, longestContactWithNode);
    if (!isConnected() || isAlone())
        return tl::unexpected(whyNothingCame());
    if (const auto doubled = whetherDoubled(CanopenAddress::of(encoder->place().node).node))
        return tl::unexpected(*doubled);
    if (isSilent() || state() == EncoderState::notSeen)
        return tl::unexpected(besideLoad(aboutSilentNode(CanopenAddress::of(encoder->place().node), true)));
    waitUntil([&] { return encoder->known(Parameter::serialNumber).has_value(); }, longestIdentityOfNode);
    if (!isConnected())
        return tl::unexpected(linkLost());
    return encoder;
}

// Whether the node runs, where it may have to be stopped.
void CanopenAccess::listenBefore(const EncoderSession &encoder, const Job &job)
{
    if (m_link.mayStopNodes || !canopen::changesEncoder(job))
        return;
    const int node = CanopenAddress::of(encoder.place().node).node;
    const auto isTold = [&] {
        const CanopenSnapshot::Node *heard = m_session->latest().heard(node);
        return heard != nullptr && (heard->stateOrCommanded() || heard->heartbeatTime == Instant());
    };
    waitUntil(isTold, longestWaitForHeartbeat);
}

// It has been switched to Operate when the encoder was first asked.
void CanopenAccess::prepare(const Job &)
{
    m_session->setOperate(true);
    advance(lookInterval());
}

void CanopenAccess::lookAgain(const EncoderSession &encoder)
{
    const Instant jobEnd = m_session->latest().at;
    waitUntil([&] { return encoder.latest().at > jobEnd || encoder.latest().state == EncoderState::silent; },
              longestLookAtNode);
}

bool CanopenAccess::waitUntil(const std::function<bool()> &isDone, Instant atMost, WhenStopped stopped)
{
    for (Instant waited{}; !isDone() && waited < atMost; waited += lookInterval())
        if (!advance(lookInterval()) || (waited >= longestAlone && isAlone()) ||
            (stopped == WhenStopped::ends && isStopped()))
            break;
    return isDone();
}

CanopenAccess::ByHand::ByHand(CanopenAccess &bus)
    : m_bus(bus)
{
    m_bus.m_stop.emplace();
    m_bus.m_isStopped = false;
}

CanopenAccess::ByHand::~ByHand()
{
    m_bus.isStopped(); // what came last is of this, too
    m_bus.m_stop.reset();
}

bool CanopenAccess::isStopped()
{
    m_isStopped = m_isStopped || (m_stop && m_stop->came());
    return m_stop && m_isStopped;
}

// A controller sends a frame again and again until it is acknowledged.
bool CanopenAccess::isAlone() const
{
    constexpr std::uint64_t notByChance = 16;
    return m_session->latest().figures.notAcknowledged >= notByChance;
}

// LSS does not wait as long as it takes to find out.
bool CanopenAccess::mayBeAlone() const
{
    const CanopenFigures &figures = m_session->latest().figures;
    return m_adapter != nullptr && (figures.received == 0 || figures.errorFrames > 0);
}

Complaint CanopenAccess::whyNothingCame() const
{
    if (isConnected() && m_stop && m_isStopped)
        return aboutCancelling();
    return !isConnected() || !isAlone() ? linkLost() : aboutNobody();
}

Complaint CanopenAccess::aboutNobody() const
{
    QString text = CommandLine::tr("Nobody on the bus acknowledges what is sent: no node is there or has "
                                   "supply, the rate is another one, or the wiring is interrupted.");
    if (m_adapter != nullptr)
        text += u' ' + CommandLine::tr("The adapter is closed now, which ends its attempts. If it goes on, "
                                       "unplug it.");
    return notDone("nobodyAcknowledges", text);
}

std::optional<Complaint> CanopenAccess::whetherOnlyJ1939() const
{
    if (m_link.sendsBesideOthers || !m_session->latest().onlyJ1939)
        return std::nullopt;
    return complaintAbout({RefusalKind::busy, CanopenBusRefusalId::onlyJ1939, {}});
}

std::optional<Complaint> CanopenAccess::whetherDoubled(int node) const
{
    const CanopenSnapshot::Node *heard = m_session->latest().heard(node);
    return heard != nullptr && heard->isDoubled ? std::optional(complaint(canopen::nodeIsDoubled(node)))
                                                : std::nullopt;
}

// A write that was sent is waited for. The answer of another one comes a little later than the first.
Checked<canopen::SdoOutcome> CanopenAccess::transfer(const canopen::SdoRequest &request, WhenStopped stopped)
{
    if (stopped == WhenStopped::ends && isStopped())
        return tl::unexpected(aboutCancelling());
    const auto seconds = [&] {
        const CanopenSnapshot::Node *heard = m_session->latest().heard(request.node);
        return heard != nullptr ? heard->secondAnswers : 0;
    };
    const int before = seconds();
    std::optional<TransferEnded> ended;
    QObject scope;
    QObject::connect(m_session.get(), &CanopenSession::transferEnded, &scope, [&](const TransferEnded &one) {
        if (one.request == request)
            ended = one;
    });
    m_session->transfer(request);
    if (!waitUntil([&] { return ended.has_value(); }, longestTransfer,
                   request.value ? WhenStopped::goesOn : stopped))
        return tl::unexpected(whyNothingCame());
    if (ended->refused)
        return tl::unexpected(complaint(*ended->refused));
    if (!request.value && stopped == WhenStopped::ends && isStopped())
        return tl::unexpected(aboutCancelling());
    if (ended->outcome.kind != canopen::SdoOutcome::Kind::noAnswer)
        advance(untilSecondAnswer);
    if (const auto doubled = whetherDoubled(request.node))
        return tl::unexpected(*doubled);
    if (seconds() > before)
        return tl::unexpected(complaint(canopen::nodeIsDoubled(request.node)));
    return ended->outcome;
}

// What was sent is waited for; a search is not.
Checked<canopen::LssOutcome> CanopenAccess::configure(const canopen::LssRequest &request, WhenStopped stopped)
{
    if (stopped == WhenStopped::ends && isStopped())
        return tl::unexpected(aboutCancelling());
    std::optional<Configured> ended;
    QObject scope;
    QObject::connect(m_session.get(), &CanopenSession::configured, &scope,
                     [&](const Configured &one) { ended = one; });
    m_session->configure(request);
    using Kind = canopen::LssRequest::Kind;
    const bool isSearch = request.kind == Kind::fastScan;
    const bool isWrite = request.kind == Kind::setNode || request.kind == Kind::setRate ||
                         request.kind == Kind::activate || request.kind == Kind::store;
    const auto isEnded = [&] { return ended.has_value(); };
    const bool isDone = waitUntil(isEnded, longestTransfer, isSearch ? stopped : WhenStopped::goesOn);
    if (!isDone && isSearch && isStopped()) {
        m_session->cancelConfiguration();
        waitUntil(isEnded, longestLookAtNode, WhenStopped::goesOn);
    }
    if (!isDone)
        return tl::unexpected(whyNothingCame());
    if (ended->refused)
        return tl::unexpected(complaint(*ended->refused));
    if (ended->outcome.kind == canopen::LssOutcome::Kind::noAnswer && mayBeAlone() &&
        waitUntil([this] { return isAlone(); }, untilFateIsTold, stopped))
        return tl::unexpected(aboutNobody());
    if (!isWrite && stopped == WhenStopped::ends && isStopped())
        return tl::unexpected(aboutCancelling());
    return ended->outcome;
}

Checked<CanFate> CanopenAccess::send(const CanFrame &frame)
{
    std::optional<FrameSent> ended;
    QObject scope;
    QObject::connect(m_session.get(), &CanopenSession::frameSent, &scope,
                     [&](const FrameSent &one) { ended = one; });
    m_session->send(frame);
    if (!waitUntil([&] { return ended.has_value(); }, longestContactWithNode, WhenStopped::goesOn))
        return tl::unexpected(whyNothingCame());
    if (ended->refused)
        return tl::unexpected(complaint(*ended->refused));
    return ended->fate;
}

QString CanopenAccess::linkKey() const
{
    return m_link.isSimulated() ? QStringLiteral("training") : m_session->linkName();
}

Refusal CanopenAccess::whatIsLost() const
{
    const Refusal closed{RefusalKind::link, CanopenBusRefusalId::closed, {}};
    return m_session->latest().whyLost.value_or(m_notOpened.value_or(closed));
}

Complaint CanopenAccess::aboutOpening(const Refusal &why) const
{
    Complaint told = complaint(why);
    if (why.id == RefusalId::portNotFound)
        told.text += u' ' + presentPortsText();
    return told;
}

// What the user can agree to stands behind the link.
QString CanopenAccess::howToAgree(const Refusal &why) const
{
    const auto behindLink = [](const char *key) {
        return sentence(CommandLine::tr("To agree, write %1=yes behind the link."),
                        {QString::fromLatin1(key)});
    };
    if (why.id == CanRefusalId::watchNotSure)
        return behindLink(unsureWatchKey);
    if (why.id == CanopenBusRefusalId::otherMaster)
        return behindLink(besideMasterKey);
    return canopen::isAboutStopping(why) ? behindLink(mayStopKey) : QString();
}

// What does not come may be late, or lost, where the bus is nearly full.
Complaint CanopenAccess::besideLoad(Complaint told) const
{
    if (const QString load = highLoadText(m_session->latest()); !load.isEmpty())
        told.text += u' ' + load;
    return told;
}

Complaint CanopenAccess::complaint(const Refusal &why) const
{
    Complaint told = complaintAbout(why);
    if (why.id == CanopenRefusalId::sdoNoAnswer || why.id == CanopenRefusalId::notBackAfterReset)
        told = besideLoad(std::move(told));
    if (const QString how = howToAgree(why); !how.isEmpty())
        told.text += u' ' + how;
    const Complaint lost = m_session->isOpen() && !isConnected() ? linkLost() : told;
    if (lost.key != told.key)
        told.text = lost.text + u' ' + told.text;
    return told;
}

} // namespace codewheel
