// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_session.h"

#include "kinds/esc/driver/esc_values.h"
#include "kinds/esc/line/esc_line_checks.h"
#include "kinds/esc/line/esc_line_encoder_session.h"
#include "kinds/esc/line/esc_line_permission.h"
#include "kinds/esc/line/esc_line_runner.h"
#include "kinds/esc/line/port_argument.h"
#include "kinds/esc/protocol/esc_messages.h"
#include "kinds/esc/protocol/esc_refusals.h"
#include "vocabulary/message_items.h"

#include <algorithm>
#include <utility>

namespace codewheel {

EscLineSession::EscLineSession(std::unique_ptr<ByteLink> link, const Catalog &catalog, const QDateTime &begin,
                               DriverFactory makeDriver, QObject *parent, BusId id)
    : BusSession(id, begin,
                 {.columns = lineTrafficColumns,
                  .words = lineOutlineWords,
                  .name = "ESC",
                  .closed = RefusalId::lineClosed},
                 std::move(link), catalog, parent)
    , m_outline(*this)
    , m_makeDriver(std::move(makeDriver))
{
    const auto explain = [this] { m_traffic.setExplainOptions(explainOptions()); };
    connect(this, &EscLineSession::explainOptionsChanged, this, explain);
    connect(this, &EscLineSession::nodesChanged, this, explain);
    connect(this, &EscLineSession::moved, this, explain);
}

Result<void> EscLineSession::open(const SerialSettings &settings, const esc::Timing &timing, Start start,
                                  Drive drive, SleepWatch::Slept slept)
{
    close();
    m_settings = settings;
    return begin(std::make_unique<EscLineRunner>(link(), settings, timing), start, drive, std::move(slept));
}

Message EscLineSession::openedMessage() const
{
    return {.at = now(),
            .id = EscMessageId::lineOpened,
            .arguments = {portArgument(link()), std::int64_t{m_settings.baudRate}}};
}

Message EscLineSession::closedMessage() const
{
    return {.at = now(), .id = EscMessageId::lineClosed, .arguments = {portArgument(link())}};
}

void EscLineSession::takeOther(const EscLineEvent &event)
{
    if (const auto *other = std::get_if<OtherAdapter>(&event.what)) {
        Q_EMIT otherAdapterFound(other->which);
    } else if (const auto *row = std::get_if<esc::EscLineRow>(&event.what)) {
        Q_EMIT passed(*row);
        TrafficRow told = m_traffic.row(*row);
        told.place = placeOf(told.place ? told.place->node : NodeId());
        tellTraffic(std::move(told));
    } else if (const auto *progress = std::get_if<ScanProgress>(&event.what)) {
        Q_EMIT scanProgressed(*progress);
    } else if (const auto *ended = std::get_if<ScanEnded>(&event.what)) {
        Q_EMIT scanEnded(*ended);
    } else if (const auto *answered = std::get_if<TypedAnswered>(&event.what)) {
        tellEnd(*answered);
    }
}

std::optional<Refusal> EscLineSession::addressTaken(EscLineAddress wanted, EscLineAddress own) const
{
    for (const EscLineAddress reading : escReadingsOf(wanted))
        if (const EncoderSession *there = encoderAt(reading.node()); there != nullptr && reading != own)
            return Refusal{RefusalKind::badInput,
                           RefusalId::lineAddressTaken,
                           {reading.shown(), there->device().fullName()}};
    return std::nullopt;
}

Result<void> EscLineSession::mayAdd(NodeId node) const
{
    const auto address = addressTyped(node.toString());
    if (!address)
        return refuse(RefusalKind::badInput, EscRefusalId::lineAddressWrong,
                      {node.toString().sliced(qsizetype{EscLineAddress::prefix.size()})});
    const auto others = places();
    if (others.empty() || !(address->isMaster() || EscLineAddress::of(others.front().node).isMaster()))
        return {};
    return refuse(
        RefusalKind::badInput, EscRefusalId::lineAddressNotAlone,
        {EscLineAddress::master().shown(), (address->isMaster() ? others.front() : placeOf(node)).shown()});
}

void EscLineSession::startAsking(NodeId node, const DeviceDescription &device)
{
    auto driver = m_makeDriver(device, EscLineAddress::of(node));
    driver->setFractionBits(m_fractionBits);
    post(line_command::AddDevice{std::move(driver), device.fullName()});
}

std::unique_ptr<AskedEncoder> EscLineSession::makeEncoder(std::size_t device, NodeId node,
                                                          const DeviceDescription &description)
{
    return std::make_unique<EscEncoderSession>(*this, device, node, description);
}

// All encoders of the line are made here.
EscEncoderSession *EscLineSession::its(NodeId node) const
{
    return static_cast<EscEncoderSession *>(encoderAt(node));
}

void EscLineSession::carryOver(const AskedEncoder &before)
{
    setSwapsWarningBytes(before.place(), static_cast<const EscEncoderSession &>(before).swapsWarningBytes());
}

const EscLineSnapshot::Device *EscLineSession::shown(Place place) const
{
    const AskedEncoder *encoder = encoderAt(place.node);
    return encoder != nullptr && encoder->index() < latest().devices.size()
               ? &latest().devices[encoder->index()]
               : nullptr;
}

Result<void> EscLineSession::mayStart(const Job &job, const QString &place) const
{
    return codewheel::mayStart(latest(), job, place, linkName());
}

DataChecks EscLineSession::dataChecks(NodeId node, const std::vector<Participant> &planned) const
{
    return lineChecks(*this, node, planned);
}

Result<void> EscLineSession::determineFractionBits(Place place)
{
    EscEncoderSession *encoder = its(place.node);
    if (encoder == nullptr)
        return refuse(RefusalKind::badInput, RefusalId::unknownDevice, {place.shown(), QString()});
    const auto job = encoder->start(fractionBitsJob(), Pace::byItself);
    if (!job)
        return tl::unexpected(job.error());
    auto *waiting = new QObject(encoder);
    connect(encoder, &EncoderSession::finished, waiting,
            [this, waiting, place, id = *job](const Outcome &outcome) {
                if (outcome.job != id)
                    return;
                waiting->deleteLater();
                Q_EMIT fractionBitsDetermined(place, fractionBitsOf(outcome));
            });
    return {};
}

void EscLineSession::setFractionBits(int bits)
{
    m_fractionBits = bits;
    post(line_command::SetFractionBits{bits});
    Q_EMIT explainOptionsChanged();
}

void EscLineSession::setSwapsWarningBytes(Place place, bool on)
{
    EscEncoderSession *encoder = its(place.node);
    if (encoder == nullptr || encoder->swapsWarningBytes() == on)
        return;
    encoder->m_swapsWarningBytes = on;
    post(line_command::SetSwapsWarningBytes{encoder->index(), on});
    Q_EMIT explainOptionsChanged();
}

esc::ExplainOptions EscLineSession::explainOptions() const
{
    esc::ExplainOptions options{.fractionBits = m_fractionBits};
    for (const Place place : places())
        if (its(place.node)->swapsWarningBytes())
            options.swapping.insert(EscLineAddress::of(place.node));
    return options;
}

void EscLineSession::alarmStop()
{
    BusSession::alarmStop();
    Q_EMIT alarmStopped();
}

// A write is accounted for before it is sent.
void EscLineSession::send(const esc::Request &request)
{
    if (isOpen() && esc::shapeOf(request.command).writes) {
        std::vector<TypedWrite> writes = writesOf(request);
        if (writes.empty() && request.to.isDevice())
            writes.push_back({placeOf(request.to.node()), request.text()});
        for (const TypedWrite &write : writes)
            Q_EMIT writeAboutToBeSent(write);
    }
    post(line_command::Send{request});
}

// For each encoder that may carry it out: at the master address that is whoever is there.
std::vector<TypedWrite> EscLineSession::writesOf(const esc::Request &request) const
{
    std::vector<TypedWrite> writes;
    for (const Place place : places()) {
        const EscLineAddress address = EscLineAddress::of(place.node);
        if (!request.to.isMaster() && address != request.to && !address.isMaster())
            continue;
        TypedWrite &write = writes.emplace_back(TypedWrite{place, request.text()});
        for (const ParameterDescription &parameter : encoder(place)->device().parameters)
            if (escWriteCommand(parameter) == request.command)
                write.values.push_back({parameter.parameter, request.data});
    }
    return writes;
}

// A write to an address where no encoder was known is reported with that address, whoever is there by now.
void EscLineSession::tellEnd(const TypedAnswered &answered)
{
    Q_EMIT typedAnswered(answered);
    const esc::Request &request = answered.request;
    const esc::ExchangeResult &result = answered.result;
    if (!esc::shapeOf(request.command).writes)
        return;
    const bool wasRefused = result.answer && result.answer->kind != esc::Answer::Kind::accepted;
    std::vector<TypedWrite> writes = writesOf(request);
    const Place addressed = placeOf(request.to.node());
    if (std::ranges::find(writes, addressed, &TypedWrite::place) == writes.end())
        writes.push_back({addressed, request.text()});
    const TypedEnd end = result.sent == 0 || wasRefused ? TypedEnd::notDone
                         : result.answer                ? TypedEnd::done
                                                        : TypedEnd::notKnown;
    for (const TypedWrite &write : writes) {
        if (end != TypedEnd::notDone)
            tellTyped(write.place, answered);
        Q_EMIT typedWriteEnded(write, end);
    }
}

void EscLineSession::tellTyped(Place place, const TypedAnswered &answered)
{
    const std::vector<RefusalArgument> typed = esc::typedArguments(answered.request, explainOptions());
    if (answered.result.answer) {
        tell({.at = now(), .place = place, .id = EscMessageId::typedWritten, .arguments = typed});
        return;
    }
    MessageItems items{std::int64_t{1}, std::int64_t{1}}; // one item, and perhaps one EEPROM write
    addItem(items, MessageItem::typed, typed);
    tell({.at = now(),
          .place = place,
          .severity = Severity::attention,
          .id = MessageId::inDoubt,
          .arguments = items});
}

} // namespace codewheel
