// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/texts.h"
#include "cli/recording/export_wish.h"
#include "vocabulary/local_time.h"

namespace codewheel {
namespace {

constexpr double longestSeconds = 1e9;

enum class Which { first, last };

// Of the times of the recording at which its computer said this; of an hour that was left out, when it was.
Instant recordedAt(const WallClock &clock, Instant wall, Which which)
{
    const std::vector<RecordedClock> &changes = clock.changes();
    std::optional<Instant> found;
    std::optional<Instant> leftOut;
    for (std::size_t i = 0; i < changes.size(); ++i) {
        const Instant at = changes[i].at + (wall - changes[i].wall);
        const bool isBefore = i > 0 && at < changes[i].at;
        const bool isBehind = i + 1 < changes.size() && at >= changes[i + 1].at;
        if (isBefore && !leftOut)
            leftOut = changes[i].at;
        if (!isBefore && !isBehind && (which == Which::last || !found))
            found = at;
    }
    return found ? *found : leftOut.value_or(wall);
}

std::optional<Instant> secondsOf(const QString &text)
{
    bool isNumber = false;
    const double seconds = text.toDouble(&isNumber);
    if (!isNumber || !(std::abs(seconds) <= longestSeconds))
        return std::nullopt;
    return std::chrono::round<Instant>(std::chrono::duration<double>(seconds));
}

Checked<Instant> timeMeant(const QString &text, const RecordingFacts &facts, Which which)
{
    if (text.startsWith(u'+') || text.startsWith(u'-')) {
        if (const auto seconds = secondsOf(text))
            return (text.startsWith(u'+') ? facts.span->from : facts.span->to) + *seconds;
    } else if (const auto at = TypedTime::parse(text, QTimeZone::systemTimeZone())) {
        const QDateTime &moment = which == Which::first ? at->first : at->last;
        return recordedAt(facts.clock, std::chrono::milliseconds(moment.toMSecsSinceEpoch()), which);
    }
    return badInput(
        "badTime",
        CommandLine::tr("\"%1\" is not a time. Write it as 2026-03-01T14:02:05.250, as +60 (seconds "
                        "from the beginning) or as -60 (before the end)."),
        {text});
}

} // namespace

Checked<TimeSpan> spanMeant(const Arguments &arguments, const RecordingFacts &facts)
{
    TimeSpan span{facts.span->from, facts.span->to - Instant(1)};
    if (const auto text = arguments.value("--from")) {
        const auto from = timeMeant(*text, facts, Which::first);
        if (!from)
            return tl::unexpected(from.error());
        span.from = std::max(span.from, *from);
    }
    if (const auto text = arguments.value("--to")) {
        const auto to = timeMeant(*text, facts, Which::last);
        if (!to)
            return tl::unexpected(to.error());
        span.to = std::min(span.to, *to);
    }
    if (span.from < span.to)
        return span;
    const bool isOneMoment = facts.span->to - facts.span->from == Instant(1);
    if (isOneMoment && span.from == span.to)
        return *facts.span;
    return badInput(
        "nothingThen", CommandLine::tr("Nothing was recorded then. The recording is from %1 to %2."),
        {recordedTimeText(facts.clock, facts.span->from), recordedTimeText(facts.clock, facts.span->to)});
}

} // namespace codewheel
