// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/esc/esc_line_access.h"

#include "catalog/catalog.h"
#include "cli/bus/present_ports.h"
#include "cli/call/subcommand.h"
#include "cli/call/texts.h"
#include "cli/kinds/esc/device_on_line.h"
#include "doctor/link_hindrances.h"
#include "kinds/esc/driver/esc_driver.h"
#include "kinds/esc/links/project_adapter.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/esc/protocol/esc_refusals.h"
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "links/port_access.h"
#include "links/serial_port_link.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr Instant longestContact = 30s; // with the slowest settings; silence is noticed long before
constexpr Instant longestIdentity = 1s;

constexpr Instant longestLook = 1s; // for what the encoder shows after a job

KeptAdapter adapterOf(const EscLineLink &link)
{
    EscLinePlan line;
    line.settings = link.settings;
    line.adapter = link.adapter;
    return keptAdapterOf(line);
}

// At the master address, if no two reads agree because several answer at once.
Complaint aboutSeveral(EscLineAddress address)
{
    return notDone(
        "encoderNotAlone",
        sentence(
            CommandLine::tr("At %1 no encoder tells its serial number twice the same: several may answer at "
                            "once. The address is for an encoder that is alone on its line. codewheel-cli "
                            "scan finds the addresses of all."),
            {address.shown()}),
        {address.node().toString()});
}

Complaint aboutSilence(EscLineAddress address, int baudRate)
{
    if (address.isMaster())
        return aboutSeveral(address);
    return notDone(
        "encoderSilent",
        sentence(CommandLine::tr("No encoder answers at %1 at %2 Bd. Check address, baud rate, wiring and "
                                 "supply; an RS-422 encoder also needs ST (pin 7) at +UB. codewheel-cli "
                                 "scan --all-rates looks for encoders."),
                 {address.shown(), QString::number(baudRate)}),
        {address.node().toString(), std::int64_t{baudRate}});
}

Complaint aboutStrayBytes(EscLineAddress address, int baudRate, std::uint64_t bytes)
{
    return notDone(
        "noAnswerAmongBytes",
        sentence(CommandLine::tr("No answer comes from %1 at %2 Bd, but bytes that are no answers: %3 until "
                                 "now. Either the answers come late (time-out=500 behind the port waits "
                                 "longer), or another baud rate or format is needed (codewheel-cli scan "
                                 "--all-rates tries the rates), or the wiring is wrong or disturbed (A and "
                                 "B exchanged, no termination), or a device on the line speaks another "
                                 "protocol."),
                 {address.shown(), QString::number(baudRate), QString::number(bytes)}),
        {address.node().toString(), std::int64_t{baudRate}, static_cast<std::int64_t>(bytes)});
}

// `alsoOf`: another bus of the project at this port; empty: there is none.
Complaint aboutOpening(const Refusal &why, const QString &alsoOf)
{
    Complaint complaint = complaintAbout(why);
    if (why.id == RefusalId::portInUse && !alsoOf.isEmpty())
        complaint.text = sentence(CommandLine::tr("%1 is in use: the project gives it to the bus \"%2\" too. "
                                                  "A port is for one bus. Choose another one for it."),
                                  {argumentText(why.arguments.front()), alsoOf});
    if (why.id == RefusalId::portNotFound)
        complaint.text += u' ' + presentPortsText();
    return complaint;
}

} // namespace

EscLineAccess::EscLineAccess(std::unique_ptr<ByteLink> link, const EscLineLink &settings,
                             const Catalog &catalog, BusId id)
    : EscLineAccess(settings, std::make_unique<EscLineSession>(
                                  std::move(link), catalog, QDateTime::currentDateTime(),
                                  [driver = settings.driver()](const DeviceDescription &device,
                                                               EscLineAddress address) {
                                      return std::make_unique<EscDriver>(device, address, driver);
                                  },
                                  nullptr, id))
{}

EscLineAccess::EscLineAccess(const EscLineLink &settings, std::unique_ptr<EscLineSession> session)
    : BusAccess(*session, QString::fromLatin1(escKind))
    , m_link(settings)
    , m_session(std::move(session))
{
    m_session->setFractionBits(m_link.driver().fractionBits);
}

std::unique_ptr<EscLineAccess> EscLineAccess::to(const EscLineLink &link, const Catalog &catalog, BusId id)
{
    if (link.isSimulated())
        return std::make_unique<EscLineAccess>(
            std::make_unique<SimulatedEscLineLink>(std::make_shared<SimulatedEscLine>()), link, catalog, id);
    auto port = std::make_unique<SerialPortLink>(adapterOf(link));
    const SerialPortLink *its = port.get();
    auto access = std::make_unique<EscLineAccess>(std::move(port), link, catalog, id);
    access->m_port = its;
    return access;
}

Hindrances EscLineAccess::hindrances() const
{
    return m_link.isSimulated() ? Hindrances() : portHindrances(portPath(m_link.settings.port), Computer());
}

Checked<void> EscLineAccess::open()
{
    if (m_session->isOpen())
        return {};
    if (m_link.whyNot)
        return tl::unexpected(*m_link.whyNot);
    const auto opened = m_session->open(m_link.settings.serial, m_link.settings.timing,
                                        EscLineSession::Start::watching, EscLineSession::Drive::byHand);
    if (opened)
        return {};
    m_notOpened = opened.error();
    return tl::unexpected(aboutOpening(opened.error(), m_link.alsoOf));
}

bool EscLineAccess::startThread()
{
    if (m_session->isSimulated())
        return false;
    m_session->startThread();
    return true;
}

std::optional<NodeId> EscLineAccess::placeTyped(const QString &text) const
{
    const auto address = addressTyped(text);
    return address ? std::optional(address->node()) : std::nullopt;
}

// Two hexadecimal digits, or with the prefix of addresses.
bool EscLineAccess::isMeant(const QString &typed) const
{
    constexpr QLatin1String prefix(EscLineAddress::prefix.data(), qsizetype{EscLineAddress::prefix.size()});
    return typed.startsWith(prefix) || (typed.size() == 2 && parseHexDigits(typed, 2));
}

Complaint EscLineAccess::notAPlace(const QString &typed) const
{
    return complaintAbout({RefusalKind::badInput, EscRefusalId::lineAddressWrong, {typed}});
}

QString EscLineAccess::somePlaces() const
{
    return CommandLine::tr("the addresses of encoders as two hexadecimal digits, as 05");
}

Checked<EncoderSession *> EscLineAccess::encoder(const Call &call, NodeId node, bool)
{
    const EscLineAddress address = EscLineAddress::of(node);
    if (const auto alone = checkIsAlone(call, bus().placeOf(node)); !alone)
        return tl::unexpected(alone.error());
    const auto device = deviceOnLine(call, bus().placeOf(node));
    if (!device)
        return tl::unexpected(device.error());
    return encoder(address, *device);
}

Checked<EncoderSession *> EscLineAccess::encoder(EscLineAddress address, const QString &deviceKey)
{
    if (const auto opened = open(); !opened)
        return tl::unexpected(opened.error());
    const Place place = bus().placeOf(address.node());
    if (m_session->encoder(place) == nullptr) {
        if (const auto added = m_session->add(address, deviceKey); !added)
            return tl::unexpected(complaintAbout(added.error()));
        m_session->setSwapsWarningBytes(place, explainOptions().swaps(address));
    }
    return inContact(m_session->encoder(place));
}

Checked<void> EscLineAccess::contact(const Call &call, const ProjectDevice &planned)
{
    const Place place = planned.place();
    const auto there = encoder(EscLineAddress::of(place.node), deviceOf(call, &planned));
    if (planned.its<EscEncoderSettings>().swapsWarningBytes)
        m_session->setSwapsWarningBytes(place, true);
    const EncoderSession *encoder = m_session->encoder(place);
    const bool isSilent = encoder != nullptr && encoder->latest().state == EncoderState::silent;
    return there || (isSilent && isConnected()) ? Checked<void>() : tl::unexpected(there.error());
}

// If it already shows its position, no time passes.
Checked<EncoderSession *> EscLineAccess::inContact(EncoderSession *encoder)
{
    const Place place = encoder->place();
    const EscLineAddress address = EscLineAddress::of(place.node);
    const auto state = [&] { return encoder->latest().state; };
    if (!waitUntil([&] { return state() == EncoderState::operation || state() == EncoderState::silent; },
                   longestContact))
        return tl::unexpected(linkLost());
    if (!isConnected())
        return tl::unexpected(linkLost());
    if (state() != EncoderState::operation)
        return tl::unexpected(noAnswerFrom(address));
    if (!waitUntil([&] { return encoder->known(Parameter::serialNumber).has_value(); }, longestIdentity))
        return tl::unexpected(linkLost());
    if (address.isMaster() && !encoder->known(Parameter::serialNumber))
        return tl::unexpected(aboutSeveral(address));
    if (std::exchange(m_link.asksForFractionBits, false))
        if (const auto determined = determineFractionBits(place); !determined)
            return tl::unexpected(determined.error());
    return encoder;
}

void EscLineAccess::prepare(const Job &job)
{
    if (std::holds_alternative<ReadParameters>(job) || m_session->isOperating())
        return;
    m_session->setOperate(true);
    advance(lookInterval());
}

void EscLineAccess::lookAgain(const EncoderSession &encoder)
{
    const Instant jobEnd = m_session->latest().at;
    waitUntil([&] { return encoder.latest().at > jobEnd || encoder.latest().state == EncoderState::silent; },
              longestLook);
}

QString EscLineAccess::versionOf(const EncoderSession &encoder)
{
    waitUntil([&] { return !encoder.version().isEmpty(); }, longestIdentity);
    return encoder.version();
}

// The format that fits this encoder's scaling factor is used for it from then on.
Checked<void> EscLineAccess::determineFractionBits(Place place)
{
    std::optional<Result<int>> bits;
    QObject scope;
    QObject::connect(m_session.get(), &EscLineSession::fractionBitsDetermined, &scope,
                     [&](Place, const Result<int> &determined) { bits = determined; });
    if (const auto asked = m_session->determineFractionBits(place); !asked)
        return tl::unexpected(complaintAbout(asked.error()));
    if (!waitUntil([&] { return bits.has_value(); }, longestContact) || !bits)
        return tl::unexpected(linkLost());
    if (!*bits)
        return tl::unexpected(complaint(bits->error()));
    m_link.settings.fractionBits = **bits;
    m_session->setFractionBits(**bits);
    advance(lookInterval());
    return {};
}

// False: the port is gone.
bool EscLineAccess::waitUntil(const std::function<bool()> &isDone, Instant atMost)
{
    for (Instant waited{}; !isDone() && waited < atMost; waited += lookInterval())
        if (!advance(lookInterval()))
            return false;
    return true;
}

QString EscLineAccess::portKey() const
{
    return m_link.isSimulated() ? QStringLiteral("training") : m_session->linkName();
}

Complaint EscLineAccess::noAnswerFrom(EscLineAddress address) const
{
    const int baudRate = m_link.settings.serial.baudRate;
    const std::uint64_t bytes = strayBytes();
    return bytes == 0 || address.isMaster() ? aboutSilence(address, baudRate)
                                            : aboutStrayBytes(address, baudRate, bytes);
}

std::uint64_t EscLineAccess::strayBytes() const
{
    const EscLineFigures &figures = m_session->latest().figures;
    return figures.garbageBytes + figures.lateBytes;
}

QString EscLineAccess::strayBytesText() const
{
    const std::uint64_t bytes = strayBytes();
    if (bytes == 0)
        return {};
    return sentence(
        CommandLine::tr("Bytes come that are no answers: %1 until now. The answers may come late "
                        "(time-out=500 behind the port waits longer), the baud rate or the format "
                        "may be another one, the wiring wrong or disturbed, or a device on the "
                        "line speaks another protocol."),
        {QString::number(bytes)});
}

Refusal EscLineAccess::whatIsLost() const
{
    const Refusal gone{RefusalKind::link, RefusalId::portLost, {m_session->linkName()}};
    return m_session->latest().whyLost.value_or(m_notOpened.value_or(gone));
}

Complaint EscLineAccess::complaint(const Refusal &why) const
{
    Complaint told = complaintAbout(why);
    const bool isSilence = why.id == RefusalId::escNoAnswer || why.id == EscRefusalId::notSentInTime;
    if (const Complaint lost = linkLost(); !isConnected() && told.key != lost.key)
        told.text = isSilence ? lost.text : lost.text + u' ' + told.text; // nothing else was wrong
    else if (isSilence)
        if (const QString stray = strayBytesText(); !stray.isEmpty())
            told.text += u' ' + stray;
    return told;
}

} // namespace codewheel
