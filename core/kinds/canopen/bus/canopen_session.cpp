// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_session.h"

#include "kinds/canopen/bus/canopen_bus_messages.h"
#include "kinds/canopen/bus/canopen_bus_refusals.h"
#include "kinds/canopen/bus/canopen_checks.h"
#include "kinds/canopen/bus/canopen_runner.h"
#include "kinds/canopen/protocol/frames.h"
#include "vocabulary/hex.h"

namespace codewheel {
namespace {

// Of up to four octets their number, of more of them what they are one by one.
QString textOf(const std::vector<std::uint8_t> &octets)
{
    constexpr std::size_t ofNumber = 4;
    if (octets.size() <= ofNumber)
        return hexNumber(canopen::numberOf(octets), 2 * static_cast<int>(octets.size()));
    const QByteArray bytes(reinterpret_cast<const char *>(octets.data()), std::ssize(octets));
    return QString::fromLatin1(bytes.toHex(' ').toUpper());
}

TypedEnd endOf(CanFate fate)
{
    return fate == CanFate::refused ? TypedEnd::notDone
           : fate == CanFate::done  ? TypedEnd::done
                                    : TypedEnd::notKnown;
}

TypedEnd endOf(const canopen::SdoOutcome &outcome)
{
    using Kind = canopen::SdoOutcome::Kind;
    if (outcome.kind == Kind::written)
        return TypedEnd::done;
    return outcome.kind == Kind::noAnswer || outcome.isOwnAbort ? TypedEnd::notKnown : TypedEnd::notDone;
}

TypedEnd endOf(const canopen::LssOutcome &outcome)
{
    using Kind = canopen::LssOutcome::Kind;
    return outcome.kind == Kind::done       ? TypedEnd::done
           : outcome.kind == Kind::noAnswer ? TypedEnd::notKnown
                                            : TypedEnd::notDone;
}

} // namespace

CanopenSession::CanopenSession(std::unique_ptr<CanLink> link, const Catalog &catalog, const QDateTime &begin,
                               QObject *parent, BusId id)
    : BusSession(id, begin,
                 {.columns = canTrafficColumns,
                  .words = canopenOutlineWords,
                  .name = "CANopen",
                  .closed = CanopenBusRefusalId::closed},
                 std::move(link), catalog, parent)
    , m_outline(*this)
{}

Result<void> CanopenSession::open(const CanopenSettings &settings, Start start, Drive drive,
                                  SleepWatch::Slept slept)
{
    close();
    m_settings = settings;
    auto runner = std::make_unique<CanopenRunner>(
        link(), settings.rate, start == Start::operating ? CanUse::operate : CanUse::watch);
    return begin(std::move(runner), start, drive, std::move(slept));
}

Message CanopenSession::openedMessage() const
{
    return {.at = now(),
            .id = CanopenBusMessageId::opened,
            .arguments = {linkArgument(link()), std::int64_t{m_settings.rate}}};
}

Message CanopenSession::closedMessage() const
{
    return {.at = now(), .id = CanopenBusMessageId::closed, .arguments = {linkArgument(link())}};
}

void CanopenSession::takeUnsureWatch()
{
    if (isBegun())
        post(canopen_command::TakeUnsureWatch{});
    else
        link().takeUnsureWatch();
}

void CanopenSession::mayStopNode(Place place)
{
    if (const AskedEncoder *encoder = encoderAt(place.node))
        post(canopen_command::MayStopNode{encoder->index()});
}

void CanopenSession::takeOther(const CanopenEvent &event)
{
    if (const auto *row = std::get_if<CanopenRow>(&event.what)) {
        Q_EMIT passed(*row, event.at);
        TrafficRow told = m_traffic.row(*row, event.at);
        told.place = placeOf(told.place ? told.place->node : NodeId());
        tellTraffic(std::move(told));
    } else if (const auto *sent = std::get_if<FrameSent>(&event.what)) {
        Q_EMIT frameSent(*sent);
        tellNmt(*sent);
        tellEnd(storing(sent->frame), endOf(sent->fate));
    } else if (const auto *ended = std::get_if<TransferEnded>(&event.what)) {
        Q_EMIT transferEnded(*ended);
        tellWritten(*ended);
        tellEnd(storing(ended->request), endOf(ended->outcome));
    } else if (const auto *lss = std::get_if<Configured>(&event.what)) {
        Q_EMIT configured(*lss);
        tellEnd(storing(lss->request), endOf(lss->outcome));
    } else if (const auto *found = std::get_if<NodesScanned>(&event.what)) {
        Q_EMIT scanned(*found);
    } else if (const auto *unsure = std::get_if<WatchNotSure>(&event.what)) {
        Q_EMIT watchNotSure(unsure->why);
    }
}

void CanopenSession::tellNmt(const FrameSent &sent)
{
    const bool isNmt = canopen::isDataOf(sent.frame, 0);
    const auto request = isNmt ? canopen::NmtRequest::read(sent.frame.data()) : std::nullopt;
    if (!request || sent.refused || sent.fate == CanFate::refused)
        return;
    const bool isInDoubt = sent.fate == CanFate::notKnown;
    const NodeId node = request->node != 0 ? CanopenAddress{request->node}.place() : NodeId();
    Q_EMIT messaged(
        {.at = now(),
         .place = placeOf(node),
         .severity = isInDoubt ? Severity::attention : Severity::information,
         .id = isInDoubt ? CanopenBusMessageId::nmtInDoubt : CanopenBusMessageId::nmtSent,
         .arguments = {static_cast<std::int64_t>(request->command), std::int64_t{request->node}}});
}

// An object by hand. What was refused, the answer to whoever wrote it says.
void CanopenSession::tellWritten(const TransferEnded &ended)
{
    const bool isInDoubt = ended.outcome.kind == canopen::SdoOutcome::Kind::noAnswer;
    if (!ended.request.value || (!isInDoubt && ended.outcome.kind != canopen::SdoOutcome::Kind::written))
        return;
    Q_EMIT messaged(
        {.at = now(),
         .place = placeOf(CanopenAddress{ended.request.node}.place()),
         .severity = isInDoubt ? Severity::attention : Severity::information,
         .id = isInDoubt ? CanopenBusMessageId::objectInDoubt : CanopenBusMessageId::objectWritten,
         .arguments = {ended.request.object.text(), textOf(*ended.request.value)}});
}

Result<void> CanopenSession::mayAdd(NodeId node) const
{
    const QString place = node.toString();
    if (CanopenAddress::read(place))
        return {};
    return refuse(RefusalKind::badInput, CanopenBusRefusalId::nodeNumberWrong,
                  {place.sliced(qsizetype{CanopenAddress::prefix.size()})});
}

void CanopenSession::startAsking(NodeId node, const DeviceDescription &device)
{
    auto driver = canopen::makeNodeDriver(device, CanopenAddress::of(node).node);
    if (m_isUsuallyMapped)
        driver->takeUsualMapping();
    post(canopen_command::AddNode{std::move(driver)});
}

Result<void> CanopenSession::mayStart(const Job & /*job*/, const QString &place) const
{
    return codewheel::mayStart(latest(), place);
}

DataChecks CanopenSession::dataChecks(NodeId node, const std::vector<Participant> &planned) const
{
    return canopenChecks(*this, node, planned);
}

void CanopenSession::send(const CanFrame &frame)
{
    accountFor(storing(frame));
    post(canopen_command::Send{frame});
}

void CanopenSession::transfer(const canopen::SdoRequest &request)
{
    accountFor(storing(request));
    post(canopen_command::Transfer{request});
}

// What is written to 1010h and 1011h goes to the EEPROM. Of others nobody knows.
std::optional<TypedWrite> CanopenSession::storing(int node, const canopen::SdoObject &object,
                                                  bool isWrite) const
{
    if (!isWrite || (object.index != 0x1010 && object.index != 0x1011))
        return std::nullopt;
    return TypedWrite{placeOf(CanopenAddress{node}.place()), object.text().toLatin1()};
}

std::optional<TypedWrite> CanopenSession::storing(const canopen::SdoRequest &request) const
{
    return storing(request.node, request.object, request.value.has_value());
}

std::optional<TypedWrite> CanopenSession::storing(const CanFrame &frame) const
{
    const auto cob = frame.isExtended || frame.isRemote ? std::nullopt : canopen::CobId::of(frame.id);
    if (!cob || cob->service != canopen::CobId::Service::sdoRequest)
        return std::nullopt;
    const auto request = canopen::SdoFrame::request(frame.data());
    return request ? storing(cob->node, request->object, request->kind == canopen::SdoFrame::Kind::write)
                   : std::nullopt;
}

// Of a device without a number nobody keeps an account.
std::optional<TypedWrite> CanopenSession::storing(const canopen::LssRequest &request) const
{
    if (request.kind != canopen::LssRequest::Kind::store || request.number == 0)
        return std::nullopt;
    return TypedWrite{placeOf(CanopenAddress{request.number}.place()), QByteArrayLiteral("LSS 17h")};
}

void CanopenSession::configure(const canopen::LssRequest &request)
{
    accountFor(storing(request));
    post(canopen_command::Configure{request});
}

// Before it is sent.
void CanopenSession::accountFor(const std::optional<TypedWrite> &write)
{
    if (isOpen() && write)
        Q_EMIT writeAboutToBeSent(*write);
}

void CanopenSession::tellEnd(const std::optional<TypedWrite> &write, TypedEnd end)
{
    if (!write)
        return;
    if (AskedEncoder *its = encoderAt(write->place.node); end == TypedEnd::done && its != nullptr)
        its->take(Event(KnowledgeChanged{.known = {}, .noLongerKnown = {}, .eepromWrites = 1}), now());
    Q_EMIT typedWriteEnded(*write, end);
}

} // namespace codewheel
