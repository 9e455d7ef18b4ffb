// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus_access.h"
#include "cli/commands.h"
#include "cli/json.h"
#include "cli/places.h"
#include "cli/texts.h"
#include "cli/trace.h"
#include "cli/watch_readings.h"

#include <array>

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

// One row for each sample that differs from the one before.
Answer watchWords(const Call &call, const EncoderSession &encoder, Instant duration, Instant interval)
{
    BusAccess &bus = call.busOf(encoder.place());
    std::vector<Exchange> rows{*bus.currentRow(encoder)};
    for (Instant passed = interval; passed <= duration; passed += interval) {
        bus.advance(interval);
        const Exchange row = *bus.currentRow(encoder);
        if (row.in != rows.back().in || row.out != rows.back().out)
            rows.push_back(row);
    }
    return {traceText(encoder.device(), rows, rodScale(encoder)),
            {{QStringLiteral("samples"), traceJson(encoder.device(), rows, rodScale(encoder))}}};
}

Checked<Answer> runMonitor(const Call &call)
{
    const auto encoder = encoderAt(call);
    if (!encoder)
        return tl::unexpected(encoder.error());
    const auto seconds = call.arguments.number("--for", usualTime, 1, longestWatch);
    if (!seconds)
        return tl::unexpected(seconds.error());
    const auto interval = call.arguments.number("--every", usualInterval, 1, longestInterval);
    if (!interval)
        return tl::unexpected(interval.error());

    const auto watch = call.busOf((*encoder)->place()).currentRow(**encoder) ? watchWords : watchReadings;
    Answer answer =
        watch(call, **encoder, std::chrono::seconds(*seconds), std::chrono::milliseconds(*interval));
    addPlace(answer.json, call, (*encoder)->place());
    answer.json.insert(QStringLiteral("device"), (*encoder)->device().key);
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
                          "Sends nothing. The time is the bus's own: on the training bus a cycle is 1 ms, "
                          "and as it runs without\n"
                          "waiting, the answer comes at once.\n\n"
                          "Of an encoder on a serial line (PLACE 05) it looks at position, alarms and "
                          "warnings, which are polled, "
                          "and\ntells at the end how the line has done. Nothing is written. Ctrl+C ends it."),
    .examples = monitorExamples,
    .options = monitorOptions,
    .minimumArguments = 1,
    .maximumArguments = 1,
    .needsBus = true,
    .run = runMonitor,
};

} // namespace codewheel
