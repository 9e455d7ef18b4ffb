// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_bus_messages.h"
#include "kinds/canopen/bus/canopen_runner_private.h"
#include "kinds/canopen/protocol/canopen_address.h"
#include "kinds/canopen/protocol/encoder_objects.h"
#include "vocabulary/port_text.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr Instant betweenSnapshots = std::chrono::milliseconds(10); // on a bus that is full

} // namespace

CanopenRunner::Private::Private(CanLink &usedLink, int usedRate, CanUse usedFirst, Mail &usedMail)
    : link(usedLink)
    , rate(usedRate)
    , use(usedFirst)
    , load(usedRate)
    , mail(usedMail)
{
    state.operate = usedFirst == CanUse::operate;
}

CanopenRunner::Private::Node &CanopenRunner::Private::nodeAt(int number)
{
    auto &node = nodes.at(static_cast<std::size_t>(number));
    if (!node)
        node = std::make_unique<Node>(number);
    return *node;
}

void CanopenRunner::Private::collect(std::size_t device)
{
    std::vector<Event> events = driver(device)->takeEvents();
    isPublishDue = isPublishDue || !events.empty();
    for (Event &event : events)
        tellEvent(std::move(event), device);
    for (Message &message : driver(device)->takeMessages()) {
        message.place = Place{firstCanBus, CanopenAddress{driver(device)->node()}.place()};
        tell(std::move(message));
    }
    if (!events.empty())
        publish();
}

void CanopenRunner::Private::look(std::size_t device)
{
    tap.look(device, driver(device)->reading(), state.connected && state.running, link.now());
}

void CanopenRunner::Private::tellEvent(decltype(CanopenEvent::what) what, std::size_t device)
{
    mail.tell({.device = device, .what = std::move(what), .at = link.now()});
}

void CanopenRunner::Private::tell(Message message)
{
    message.at = link.now();
    tellEvent(std::move(message));
}

void CanopenRunner::Private::tellOfNode(int number, Severity severity, MessageCode id)
{
    tell({.place = Place{firstCanBus, CanopenAddress{number}.place()}, .severity = severity, .id = id});
}

void CanopenRunner::Private::tellRow(const CanFrame &frame, Instant at, CanopenRow row)
{
    row.frame = frame;
    mail.tell({.what = std::move(row), .at = at});
}

void CanopenRunner::Private::publishIfDue()
{
    if (isPublishDue && link.now() >= publishedAt + betweenSnapshots)
        publish();
}

void CanopenRunner::Private::publish()
{
    isPublishDue = false;
    publishedAt = link.now();
    CanopenSnapshot made;
    static_cast<CanopenState &>(made) = state;
    made.at = link.now();
    made.awakeSince = awakeSince;
    made.status = status;
    made.figures = figures;
    made.droppedRows = mail.droppedRows();
    for (std::size_t device = 0; device < drivers.size(); ++device) {
        CanopenSnapshot::Device &shown = made.devices.emplace_back();
        const canopen::NodeDriver *its = driver(device);
        shown.present = its != nullptr;
        if (its == nullptr)
            continue;
        shown = {.node = CanopenAddress{its->node()}.place(),
                 .reading = its->reading(),
                 .hasJob = its->busy(),
                 .answers = nodeAt(its->node()).answers};
        look(device);
    }
    for (int number = 1; number <= canopen::lastNode; ++number) {
        const auto &node = nodes.at(static_cast<std::size_t>(number));
        if (!node || !node->heardAt)
            continue;
        const canopen::NodeWatch &watch = node->watch;
        made.nodes.push_back(
            {.node = number,
             .state = watch.state(),
             .heartbeat = node->heartbeat,
             .isDoubled = watch.isDoubled(),
             .secondAnswers = watch.secondAnswers(),
             .sendsPdos = node->sendsPdos,
             .bootUps = watch.bootUps(),
             .error = watch.standing().empty() ? std::nullopt : std::optional(watch.standing().back()),
             .position = node->device ? canopen::termsOf(driver(*node->device)->transmitPdos(),
                                                         canopen::object::position)
                                      : std::nullopt,
             .heardAt = *node->heardAt});
    }
    mail.note(tap.noted());
    tap.clear();
    mail.publish(made);
}

CanopenRunner::CanopenRunner(CanLink &link, int rate, CanUse use)
    : d(std::make_unique<Private>(link, rate, use, m_mail))
{}

CanopenRunner::~CanopenRunner() = default;

Result<void> CanopenRunner::open(const std::stop_token &stop)
{
    auto opened = openUnlessStopped(stop, [this] { return d->link.open(d->use); });
    d->tellEvent(LinkOpened{opened});
    return opened;
}

void CanopenRunner::turn(Instant until)
{
    while (d->link.now() < until) {
        if (!d->state.connected) {
            d->waitForLink(until);
            continue;
        }
        d->carryOutCommands();
        if (d->state.connected)
            d->useAsWanted();
        if (d->state.connected)
            d->send();
        if (d->state.connected)
            d->receive(until);
        d->lookAtScan();
        d->publishIfDue();
    }
    d->publish();
}

void CanopenRunner::slept(std::chrono::milliseconds duration)
{
    d->awakeSince = d->link.now();
    d->carryOutCommands(); // posted before
    d->stopJobs({RefusalKind::stopped, RefusalId::computerSlept, {}});
    d->dropTyped();
    d->endScan(true);
    d->leaveOff();
    d->state.operate = false;
    d->tap.interrupt();
    d->tellEvent(Slept{duration});
    d->publish();
}

void CanopenRunner::close()
{
    d->carryOutCommands();
    d->stopJobs({RefusalKind::stopped, RefusalId::busStopped, {}});
    d->dropTyped();
    d->endScan(true);
    d->sendLastStops();
    d->leaveOff();
    if (d->state.stopsWait)
        d->tell({.severity = Severity::fault, .id = CanopenBusMessageId::stopsNotSent});
    d->publish();
    d->link.close();
}

Instant CanopenRunner::now() const
{
    return d->link.now();
}

void CanopenRunner::interrupt()
{
    d->link.interrupt();
}

void CanopenRunner::post(CanopenCommand command)
{
    BusRunner::post(std::move(command));
    interrupt();
}

QString linkArgument(const CanLink &link)
{
    return link.isSimulated() ? QString(trainingPort) : link.name();
}

} // namespace codewheel
