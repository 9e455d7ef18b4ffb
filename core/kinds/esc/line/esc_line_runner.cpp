// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_runner_private.h"

#include <algorithm>

namespace codewheel {
namespace {

// 2 ms at a USB adapter, which collects for another 16 ms.
constexpr Instant withoutLowLatency = std::chrono::milliseconds(18);

} // namespace

EscLineRunner::Private::Private(ByteLink &usedLink, const SerialSettings &lineSettings,
                                const esc::Timing &lineTiming, Mail &usedMail)
    : link(usedLink)
    , settings(lineSettings)
    , timing(lineTiming)
    , baudRate(lineSettings.baudRate)
    , mail(usedMail)
{}

void EscLineRunner::Private::step(Instant until)
{
    carryOutCommands();
    if (underWay || begin()) {
        goOn(until);
        return;
    }
    const std::optional<Instant> wish = nextWish();
    listen(wish ? std::min(*wish, until) : until);
}

bool EscLineRunner::Private::begin()
{
    return beginTyped() || beginScanStep() || beginDevice();
}

bool EscLineRunner::Private::beginTyped()
{
    if (typed.empty())
        return false;
    const esc::Request request = typed.front();
    typed.pop_front();
    return ask(Asker::terminal, 0, request, baudRateAt(request.to));
}

// An encoder may use a different rate than its line.
int EscLineRunner::Private::baudRateAt(EscLineAddress address) const
{
    const auto there = std::ranges::find_if(
        devices, [&](const Device &device) { return device.driver && device.driver->address() == address; });
    const auto wanted = there != devices.end() ? there->driver->wantedBaudRate() : std::nullopt;
    return wanted.value_or(settings.baudRate);
}

bool EscLineRunner::Private::beginScanStep()
{
    if (!scan)
        return false;
    const auto next = scan->next();
    if (next)
        return ask(Asker::scan, 0, next->request, next->baudRate);
    endScan(false);
    return false;
}

bool EscLineRunner::Private::ask(Asker asker, std::size_t device, const esc::Request &request, int rate)
{
    if (!useBaudRate(rate))
        return false;
    esc::Timing asked = timing;
    SerialSettings used = settings;
    used.baudRate = baudRate;
    asked.character = used.timeOf(1);
    if (state.lowLatency == LowLatency::refused)
        asked.adapterDelay = std::max(timing.adapterDelay, withoutLowLatency);
    asked.longestAnswer = std::max(timing.longestAnswer, counter.longestAnswer());
    // Whoever types or scans can see the silence, and a silent device is asked again in its turn.
    if (asker != Asker::device || isSilent(device))
        asked.retries = 0;
    underWay.emplace(UnderWay{asker, device, link.now(), esc::Exchange(request, asked)});
    return true;
}

bool EscLineRunner::Private::useBaudRate(int wanted)
{
    if (wanted == baudRate)
        return true;
    if (const auto set = link.setBaudRate(wanted); !set) {
        portIsGone(set.error());
        return false;
    }
    baudRate = wanted;
    return true;
}

void EscLineRunner::Private::goOn(Instant until)
{
    const esc::Exchange::Action action = underWay->exchange.next(link.now());
    if (const auto *send = std::get_if<esc::Exchange::Send>(&action)) {
        if (const auto written = link.write(send->bytes); !written)
            portIsGone(written.error());
        else if (underWay->exchange.result().timeOuts > 0)
            publish(); // what was seen has grown old meanwhile
    } else if (const auto *wait = std::get_if<esc::Exchange::Wait>(&action)) {
        const auto bytes = link.read(std::min(wait->until, until));
        if (!bytes)
            portIsGone(bytes.error());
        else if (!bytes->isEmpty())
            underWay->exchange.received(*bytes, link.now());
    } else {
        UnderWay ended = std::move(*underWay);
        underWay.reset();
        end(std::move(ended));
    }
}

void EscLineRunner::Private::end(UnderWay ended)
{
    const esc::ExchangeResult &result = ended.exchange.result();
    tellRows(ended.exchange.takeRows());
    counter.note(result);
    switch (ended.asker) {
    case Asker::terminal:
        typedEnded(ended.exchange.request(), result);
        break;
    case Asker::scan:
        if (!scan) // cancelled meanwhile
            break;
        scan->answered(result);
        tellEvent(ScanProgress{scan->asked(), scan->total(), scan->found()});
        break;
    case Asker::device:
        if (!driver(ended.device)) // removed meanwhile
            break;
        devices[ended.device].counter.note(result);
        noteTurn(ended);
        deviceAnswered(ended.device, ended.exchange.request(), result);
        break;
    }
    publish();
}

void EscLineRunner::Private::deviceAnswered(std::size_t device, const esc::Request &request,
                                            const esc::ExchangeResult &result)
{
    const EscLineAddress before = driver(device)->address();
    driver(device)->answered(request, result, link.now());
    noteRound(device);
    collect(device);
    if (driver(device)->address() != before)
        tellTaken();
}

// The master address reaches whoever is there, and an encoder at that address is the only one.
static bool mayReach(EscLineAddress sentTo, EscLineAddress encoder)
{
    return sentTo == encoder || sentTo.isMaster() || encoder.isMaster();
}

// What was typed may have changed what the drivers know: they report that first, so that its end really is
// the end.
void EscLineRunner::Private::typedEnded(const esc::Request &request, const esc::ExchangeResult &result)
{
    for (std::size_t i = 0; i < devices.size(); ++i) {
        if (!driver(i) || !mayReach(request.to, driver(i)->address()))
            continue;
        driver(i)->observe(request, result, link.now());
        collect(i);
    }
    tellEvent(TypedAnswered{request, result});
}

void EscLineRunner::Private::listen(Instant until)
{
    auto bytes = link.read(until);
    if (!bytes) {
        portIsGone(bytes.error());
        return;
    }
    if (bytes->isEmpty())
        return;
    counter.noteGarbage(static_cast<std::size_t>(bytes->size()));
    tellRows({{.at = link.now(), .kind = esc::EscLineRow::Kind::garbage, .bytes = *bytes}});
    publish();
}

void EscLineRunner::Private::collect(std::size_t device)
{
    for (Event &event : driver(device)->takeEvents())
        tellEvent(std::move(event), device);
    for (Message &message : driver(device)->takeMessages()) {
        message.place = placeOnLine(driver(device)->address());
        tell(std::move(message));
    }
}

void EscLineRunner::Private::tellEvent(decltype(EscLineEvent::what) what, std::size_t device)
{
    mail.tell({.device = device, .what = std::move(what), .at = link.now()});
}

void EscLineRunner::Private::tellRows(std::vector<esc::EscLineRow> rows)
{
    for (esc::EscLineRow &row : rows) {
        const Instant at = row.at;
        mail.tell({.what = std::move(row), .at = at});
    }
}

void EscLineRunner::Private::tell(Message message)
{
    message.at = link.now();
    tellEvent(std::move(message));
}

void EscLineRunner::Private::publish()
{
    EscLineSnapshot made;
    made.at = link.now();
    static_cast<LineState &>(made) = state;
    made.awakeSince = awakeSince;
    made.scanning = scan.has_value();
    made.figures = counter.figures();
    made.droppedRows = mail.droppedRows();
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const Device &device = devices[i];
        EscLineSnapshot::Device shown{{}, device.counter.figures()};
        shown.present = device.driver != nullptr;
        if (device.driver) {
            shown.node = device.driver->address().node();
            shown.reading = device.driver->reading();
            shown.hasJob = device.driver->busy();
            shown.lateAfter = lateAfter(i);
            shown.answers = device.answers;
            tap.look(i, shown.reading, state.connected && state.running, made.at);
        }
        made.devices.push_back(shown);
    }
    mail.note(tap.noted());
    tap.clear();
    mail.publish(made);
}

EscLineRunner::EscLineRunner(ByteLink &link, const SerialSettings &settings, const esc::Timing &timing)
    : d(std::make_unique<Private>(link, settings, timing, m_mail))
{}

EscLineRunner::~EscLineRunner() = default;

Result<void> EscLineRunner::open(const std::stop_token &stop)
{
    auto opened = openUnlessStopped(stop, [this] { return d->link.open(d->settings); });
    d->tellEvent(LinkOpened{opened});
    if (opened)
        d->takeLowLatency();
    return opened;
}

void EscLineRunner::turn(Instant until)
{
    while (d->link.now() < until) {
        if (d->state.connected)
            d->step(until);
        else
            d->waitForPort(until);
    }
}

void EscLineRunner::slept(std::chrono::milliseconds duration)
{
    d->awakeSince = d->link.now();
    d->carryOutCommands(); // posted before
    d->dropTyped();
    d->endScan(true);
    d->stopJobs({RefusalKind::stopped, RefusalId::computerSlept, {}});
    d->state.operate = false;
    d->tap.interrupt();
    d->tellEvent(Slept{duration});
    d->publish();
}

void EscLineRunner::close()
{
    d->carryOutCommands();
    d->endScan(true);
    d->stopJobs({RefusalKind::stopped, RefusalId::busStopped, {}});
    d->tearOff();
    d->dropTyped();
    d->publish();
    d->link.close();
}

Instant EscLineRunner::now() const
{
    return d->link.now();
}

void EscLineRunner::interrupt()
{
    d->link.interrupt();
}

void EscLineRunner::post(EscLineCommand command)
{
    BusRunner::post(std::move(command));
    interrupt();
}

} // namespace codewheel
