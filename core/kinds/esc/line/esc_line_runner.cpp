// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_runner_private.h"

#include <algorithm>

namespace codewheel {
namespace {

// 2 ms at a USB adapter, which collects for another 16 ms.
constexpr Instant withoutLowLatency = std::chrono::milliseconds(18);

} // namespace

EscLineWork::EscLineWork(ByteLink &usedLink, const SerialSettings &lineSettings,
                         const esc::Timing &lineTiming, Mail &usedMail)
    : AskingWork(usedLink, usedMail)
    , settings(lineSettings)
    , timing(lineTiming)
    , baudRate(lineSettings.baudRate)
{}

void EscLineWork::step(Instant until)
{
    carryOutCommands();
    if (underWay || begin()) {
        goOn(until);
        return;
    }
    const std::optional<Instant> wish = nextWish();
    listen(wish ? std::min(*wish, until) : until);
}

bool EscLineWork::begin()
{
    return beginTyped() || beginScanStep() || beginDevice();
}

bool EscLineWork::beginTyped()
{
    if (typed.empty())
        return false;
    const esc::Request request = typed.front();
    typed.pop_front();
    return ask(Asker::terminal, 0, request, baudRateAt(request.to));
}

// An encoder may use a different rate than its line.
int EscLineWork::baudRateAt(EscLineAddress address) const
{
    const auto there =
        std::ranges::find_if(drivers, [&](const auto &its) { return its && its->address() == address; });
    const auto wanted = there != drivers.end() ? (*there)->wantedBaudRate() : std::nullopt;
    return wanted.value_or(settings.baudRate);
}

bool EscLineWork::beginScanStep()
{
    if (!scan)
        return false;
    const auto next = scan->next();
    if (next)
        return ask(Asker::scan, 0, next->request, next->baudRate);
    endScan(false);
    return false;
}

bool EscLineWork::ask(Asker asker, std::size_t device, const esc::Request &request, int rate)
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

bool EscLineWork::useBaudRate(int wanted)
{
    if (wanted == baudRate)
        return true;
    if (const auto set = link.setBaudRate(wanted); !set) {
        linkIsGone(set.error());
        return false;
    }
    baudRate = wanted;
    return true;
}

void EscLineWork::goOn(Instant until)
{
    const esc::Exchange::Action action = underWay->exchange.next(link.now());
    if (const auto *send = std::get_if<esc::Exchange::Send>(&action)) {
        if (const auto written = link.write(send->bytes); !written)
            linkIsGone(written.error());
        else if (underWay->exchange.result().timeOuts > 0)
            publish(); // what was seen has grown old meanwhile
    } else if (const auto *wait = std::get_if<esc::Exchange::Wait>(&action)) {
        const auto bytes = link.read(std::min(wait->until, until));
        if (!bytes)
            linkIsGone(bytes.error());
        else if (!bytes->isEmpty())
            underWay->exchange.received(*bytes, link.now());
    } else {
        UnderWay ended = std::move(*underWay);
        underWay.reset();
        end(std::move(ended));
    }
}

void EscLineWork::end(UnderWay ended)
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

void EscLineWork::deviceAnswered(std::size_t device, const esc::Request &request,
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
void EscLineWork::typedEnded(const esc::Request &request, const esc::ExchangeResult &result)
{
    for (std::size_t i = 0; i < devices.size(); ++i) {
        if (!driver(i) || !mayReach(request.to, driver(i)->address()))
            continue;
        driver(i)->observe(request, result, link.now());
        collect(i);
    }
    tellEvent(TypedAnswered{request, result});
}

void EscLineWork::listen(Instant until)
{
    auto bytes = link.read(until);
    if (!bytes) {
        linkIsGone(bytes.error());
        return;
    }
    if (bytes->isEmpty())
        return;
    counter.noteGarbage(static_cast<std::size_t>(bytes->size()));
    tellRows({{.at = link.now(), .kind = esc::EscLineRow::Kind::garbage, .bytes = *bytes}});
    publish();
}

void EscLineWork::tellRows(std::vector<esc::EscLineRow> rows)
{
    for (esc::EscLineRow &row : rows) {
        const Instant at = row.at;
        mail.tell({.what = std::move(row), .at = at});
    }
}

void EscLineWork::show(std::size_t device, EscLineDevice &shown) const
{
    shown.figures = devices[device].counter.figures();
    shown.answers = devices[device].answers;
    if (shown.present)
        shown.lateAfter = lateAfter(device);
}

void EscLineWork::complete(EscLineSnapshot &made)
{
    made.scanning = scan.has_value();
    made.figures = counter.figures();
}

EscLineRunner::EscLineRunner(ByteLink &link, const SerialSettings &settings, const esc::Timing &timing)
{
    m_work = std::make_unique<EscLineWork>(link, settings, timing, m_mail);
}

} // namespace codewheel
