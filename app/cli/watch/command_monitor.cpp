// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/encoder_bus.h"
#include "cli/bus/bus_access.h"
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/json_list.h"
#include "cli/call/stop_signals.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/trace.h"
#include "vocabulary/hex.h"

#include <array>
#include <memory>
#include <optional>

namespace codewheel {
namespace {

constexpr const char *monitorExamples[] = {"monitor 2.0", "monitor 2.0 --for 60 --every 1000",
                                           "monitor 1.0 --for 1 --json", "monitor 05 --for 5"};

constexpr int longestWatch = 3'600;     // s
constexpr int longestInterval = 60'000; // ms
constexpr int usualTime = 10;           // s
constexpr int usualInterval = 100;      // ms

constexpr std::array monitorOptions{
    deviceOption,
    Option{"--for", "SECONDS", QT_TRANSLATE_NOOP("codewheel::CommandLine", "how long to look (10)")},
    Option{"--every", "MS", QT_TRANSLATE_NOOP("codewheel::CommandLine", "how often to look (100)")},
};

struct WatchTime
{
    Instant duration;
    Instant interval; // from look to look
};

// Ends early on Ctrl+C, if the link is gone, and when nobody reads any more.
template <typename Look>
void watch(const Call &call, BusAccess &bus, const WatchTime &time, Look look)
{
    StopSignals stop;
    look();
    bool isConnected = true;
    const auto goesOn = [&] { return isConnected && call.terminal.canPrint() && !stop.came(); };
    const Instant begin = bus.bus().now(); // a slow link takes longer than the interval
    for (Instant passed = time.interval;
         passed <= time.duration && bus.bus().now() - begin < time.duration && goesOn();
         passed += time.interval) {
        isConnected = bus.advance(time.interval);
        look();
    }
}

bool isInJson(const Call &call)
{
    return call.arguments.has("--json");
}

// Empty unless the answer is in JSON.
std::unique_ptr<JsonList> samplesOf(const Call &call)
{
    return isInJson(call) ? std::make_unique<JsonList>(call.terminal, QStringLiteral("samples")) : nullptr;
}

// One row for each sample that differs from the previous one.
void watchWords(const Call &call, BusAccess &bus, const EncoderSession &encoder, const WatchTime &time)
{
    const DeviceDescription &device = encoder.device();
    TextTable table = traceTable();
    const auto samples = samplesOf(call);
    table.add(traceHead(device));
    std::optional<Exchange> last;
    watch(call, bus, time, [&] {
        const Exchange row = *bus.currentRow(encoder);
        if (last && row.in == last->in && row.out == last->out)
            return;
        const Exchange *before = last ? &*last : nullptr;
        if (samples) {
            samples->add(traceRowJson(device, row, before, rodScale(encoder)));
        } else if (!last) { // the head is as wide as the first row
            table.add(traceCells(device, row, before, rodScale(encoder)));
            call.terminal.print(table.toString());
        } else {
            call.terminal.print(table.next(traceCells(device, row, before, rodScale(encoder))));
        }
        last = row;
    });
}

QString readingRow(const QString &time, const QString &hex, const QString &position, const QString &more)
{
    constexpr int timeWidth = 9;
    constexpr int positionWidth = 8;
    const QString gap = QStringLiteral("  ");
    return time.rightJustified(timeWidth) + gap + hex.leftJustified(positionWidth) + gap +
           position.rightJustified(positionWidth) + (more.isEmpty() ? QString() : gap + more) + u'\n';
}

QString readingText(const BusAccess &bus, Instant at, const Reading &reading)
{
    const QString hex = reading.position ? hexWord(static_cast<Word>(*reading.position)) : QString();
    const QString position = reading.position ? QString::number(*reading.position) : QStringLiteral("-");
    return readingRow(rowTime(at), hex, position, bus.remarks(reading).join(QStringLiteral(", ")));
}

QJsonObject readingJson(const BusAccess &bus, Instant at, const Reading &reading)
{
    QJsonObject json = bus.remarksJson(reading);
    json.insert(QStringLiteral("microseconds"), static_cast<qint64>(at.count()));
    json.insert(QStringLiteral("state"), stateKey(reading.state));
    json.insert(QStringLiteral("position"), numberJson(reading.position));
    json.insert(QStringLiteral("suspect"), reading.suspect);
    return json;
}

// What says the same as the previous reading is no row, whenever it came.
void watchReadings(const Call &call, BusAccess &bus, const EncoderSession &encoder, const WatchTime &time)
{
    const Instant begin = bus.bus().now();
    const auto samples = samplesOf(call);
    QString shownBefore;
    QJsonObject toldBefore;
    if (!samples)
        call.terminal.print(readingRow(QStringLiteral("ms"), QStringLiteral("hex"),
                                       CommandLine::tr("position"), CommandLine::tr("alarms and warnings")));
    watch(call, bus, time, [&] {
        const Reading &reading = encoder.latest();
        const Instant at = bus.bus().now() - begin;
        if (const QJsonObject told = readingJson(bus, {}, reading);
            samples && std::exchange(toldBefore, told) != told)
            samples->add(readingJson(bus, at, reading));
        if (const QString shown = readingText(bus, {}, reading);
            !samples && std::exchange(shownBefore, shown) != shown)
            call.terminal.print(readingText(bus, at, reading));
    });
}

Checked<Answer> runMonitor(const Call &call, EncoderSession &encoder)
{
    const auto seconds = call.arguments.number("--for", usualTime, 1, longestWatch);
    if (!seconds)
        return tl::unexpected(seconds.error());
    const auto interval = call.arguments.number("--every", usualInterval, 1, longestInterval);
    if (!interval)
        return tl::unexpected(interval.error());

    BusAccess &bus = call.busOf(encoder.place());
    const auto watched = bus.currentRow(encoder) ? watchWords : watchReadings;
    const bool isWhole = bus.length() && !call.arguments.has("--for");
    const Instant duration = isWhole ? *bus.length() : std::chrono::seconds(*seconds);
    watched(call, bus, encoder, {duration, std::chrono::milliseconds(*interval)});
    Answer answer{.hasBegunJson = isInJson(call)};
    bus.addFigures(call, encoder, answer);
    if (!bus.isConnected())
        answer.complaint = bus.linkLost();
    else
        answer.complaint = bus.whyItStands();
    return answer;
}

} // namespace

const Subcommand monitorCommand{
    .name = "monitor",
    .usage = "PLACE [--for SECONDS] [--every MS]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "watch the words of an encoder, or its position"),
    .details =
        QT_TRANSLATE_NOOP("codewheel::CommandLine",
                          "Looks at the words of an encoder every 100 ms and prints a row when they differ "
                          "from the last look.\n"
                          "Each row is printed as it comes. Sends nothing. The time is the bus's own: on "
                          "the training bus a\n"
                          "cycle is 1 ms, and as it runs without waiting, the answer comes at once.\n\n"
                          "Of an encoder on a serial line (PLACE 05) it looks at position, alarms and "
                          "warnings, which are polled, "
                          "and\ntells at the end how the line has done. Nothing is written. Ctrl+C ends it."),
    .examples = monitorExamples,
    .options = monitorOptions,
    .arguments = {1},
    .needsBus = true,
    .run = atPlace<runMonitor>,
};

} // namespace codewheel
