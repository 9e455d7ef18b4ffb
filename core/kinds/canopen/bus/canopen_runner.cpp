// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_bus_messages.h"
#include "kinds/canopen/bus/canopen_runner_private.h"
#include "kinds/canopen/protocol/canopen_address.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "kinds/canopen/protocol/encoder_objects.h"
#include "vocabulary/port_text.h"

namespace codewheel {
namespace {

constexpr Instant betweenSnapshots = std::chrono::milliseconds(30); // as often as a window looks
constexpr Instant justNow = std::chrono::milliseconds(2);

std::vector<canopen::KeptIdentifier> keptOf(const canopen::NodeDriver &driver)
{
    const auto kept = driver.keptIdentifiers();
    return {kept.begin(), kept.end()};
}

} // namespace

CanopenWork::CanopenWork(CanLink &usedLink, int usedRate, CanUse usedFirst, Mail &usedMail)
    : AskingWork(usedLink, usedMail)
    , rate(usedRate)
    , use(usedFirst)
    , load(usedRate)
{
    state.operate = usedFirst == CanUse::operate;
}

CanopenWork::Node &CanopenWork::nodeAt(int number)
{
    auto &node = nodes.at(static_cast<std::size_t>(number));
    if (!node)
        node = std::make_unique<Node>(number);
    return *node;
}

Place CanopenWork::placeOf(const canopen::NodeDriver &driver) const
{
    return {firstCanBus, CanopenAddress{driver.node()}.place()};
}

Result<void> CanopenWork::mayStart(const canopen::NodeDriver &driver, const Job & /*job*/) const
{
    auto allowed = codewheel::mayStart(state, placeOf(driver).toString());
    if (allowed && nodes.at(static_cast<std::size_t>(driver.node()))->watch.isDoubled())
        allowed = tl::unexpected(canopen::nodeIsDoubled(driver.node()));
    return allowed;
}

void CanopenWork::tellOfNode(int number, Severity severity, MessageCode id)
{
    tell({.place = Place{firstCanBus, CanopenAddress{number}.place()}, .severity = severity, .id = id});
}

void CanopenWork::tellRow(const CanFrame &frame, Instant at, CanopenRow row)
{
    row.frame = frame;
    mail.tell({.what = std::move(row), .at = at});
}

void CanopenWork::publishIfDue()
{
    if (isPublishDue && link.now() >= publishedAt + betweenSnapshots)
        publish();
}

void CanopenWork::show(std::size_t device, AskedDevice &shown) const
{
    if (shown.present)
        shown.answers = nodes.at(static_cast<std::size_t>(driver(device)->node()))->answers;
    if (shown.present)
        shown.whyNotAsked = whyNotAsked(*nodes.at(static_cast<std::size_t>(driver(device)->node())));
}

Freshness::Reason CanopenWork::whyNotAsked(const Node &node) const
{
    if (node.watch.isStopped())
        return Freshness::Reason::nodeStopped;
    if (!state.operate)
        return Freshness::Reason::watched;
    return state.isHeldBack() ? Freshness::Reason::heldBack : Freshness::Reason::notAsked;
}

void CanopenWork::complete(CanopenSnapshot &made)
{
    isPublishDue = false;
    publishedAt = link.now();
    made.status = status;
    made.figures = figures;
    made.sync = sync;
    for (int number = 1; number <= canopen::lastNode; ++number) {
        const auto &node = nodes.at(static_cast<std::size_t>(number));
        if (!node)
            continue;
        const canopen::NodeWatch &watch = node->watch;
        if (watch.isStopped() && node->heartbeat != canopen::Heartbeat::lost)
            made.stopped.push_back(number);
        if (!node->heardAt)
            continue;
        made.nodes.push_back(
            {.node = number,
             .state = watch.state(),
             .commanded = watch.commandedState(),
             .heartbeat = node->heartbeat,
             .isDoubled = watch.isDoubled(),
             .secondAnswers = watch.secondAnswers(),
             .sendsPdos = watch.pdoAt().has_value(),
             .hasBooted = watch.hasBooted(),
             .bootUps = watch.bootUps(),
             .unaskedBootUps = watch.unaskedBootUps(),
             .error = watch.standing().empty() ? std::nullopt : std::optional(watch.standing().back()),
             .position = node->device ? canopen::termsOf(driver(*node->device)->transmitPdos(),
                                                         canopen::object::position)
                                      : std::nullopt,
             .deviceType = node->device ? driver(*node->device)->deviceType() : std::nullopt,
             .heartbeatTime = watch.producerTime(),
             .kept = node->device ? keptOf(*driver(*node->device)) : std::vector<canopen::KeptIdentifier>(),
             .heardAt = *node->heardAt,
             .pdoAt = watch.pdoAt()});
    }
}

// Another master may be in what nobody has looked at, or what a command depends on.
void CanopenWork::step(Instant until)
{
    if (state.connected && (mail.hasCommands() || link.now() > lookedAt + justNow))
        receive(link.now());
    carryOutCommands();
    if (state.connected)
        useAsWanted();
    if (state.connected)
        send();
    if (state.connected)
        receive(until);
    lookAtScan();
    publishIfDue();
}

void CanopenWork::turn(Instant until)
{
    AskingWork::turn(until);
    publish();
}

void CanopenWork::slept(std::chrono::milliseconds duration)
{
    AskingWork::slept(duration);
    leaveOff();
    publish();
}

CanopenRunner::CanopenRunner(CanLink &link, int rate, CanUse use)
{
    m_work = std::make_unique<CanopenWork>(link, rate, use, m_mail);
}

QString linkArgument(const CanLink &link)
{
    return link.isSimulated() ? QString(trainingPort) : link.name();
}

} // namespace codewheel
