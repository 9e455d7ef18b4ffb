// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/recording/record_news.h"

#include "bus/encoder_bus.h"
#include "cli/bus/bus_access.h"
#include "cli/call/texts.h"
#include "history/rough_duration.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QLocale>

namespace codewheel {
namespace {

constexpr std::chrono::seconds betweenProgress{1};

} // namespace

void RecordNews::look(Instant passed)
{
    const RecordingStatus status = m_recorder.status();
    if (std::exchange(m_state, m_recorder.state()) == BusRecorder::State::waiting &&
        m_state == BusRecorder::State::recording)
        tell(CommandLine::tr("The trigger has come. It is recorded now."));
    lookAtFile(status);
    lookAtBuses();
    if (m_call.arguments.has("--json") || Clock::now() < m_nextProgress)
        return;
    m_nextProgress = Clock::now() + betweenProgress;
    m_call.terminal.showProgress(progress(status, passed));
}

void RecordNews::tell(const QString &text) const
{
    m_call.terminal.showProgress({});
    m_call.terminal.complain(text);
}

// The numbers in a problem change each second, so that it is told once. What could not be sent until the end
// is said by the answer.
void RecordNews::lookAtFile(const RecordingStatus &status)
{
    if (status.problem && status.problem->id == RefusalId::notAllSent)
        return;
    const auto now = status.problem ? std::optional(status.problem->id) : std::nullopt;
    const auto before = std::exchange(m_problem, now);
    if (now && now != before)
        tell(refusalText(*status.problem));
    if (before && !now)
        tell(CommandLine::tr("The recording is written again."));
    // Whoever knows that it has ended expects no more of it.
    if (status.lost > 0 && !status.hasEnded && !std::exchange(m_hasLost, true))
        tell(CommandLine::tr("Values are lost from now on: more wait to be written than there is memory for. "
                             "The recording has a gap in their place."));
}

void RecordNews::lookAtBuses()
{
    for (const BusAccess *bus : m_call.links) {
        if (!bus->bus().isOpen())
            continue;
        if (!bus->isConnected() && m_gone.insert(bus).second)
            tell(bus->linkLost().text + u' ' +
                 CommandLine::tr("The recording goes on, with a gap until the link is back."));
        else if (bus->isConnected() && m_gone.erase(bus) > 0)
            tell(sentence(CommandLine::tr("The link to the bus \"%1\" is back."), {bus->name()}));
    }
}

QString RecordNews::progress(const RecordingStatus &status, Instant passed) const
{
    const QLocale locale;
    const QString time = roughDurationText(passed, locale);
    if (m_state == BusRecorder::State::waiting)
        return sentence(CommandLine::tr("Waiting for the trigger: %1"), {time});
    QStringList parts{sentence(CommandLine::tr("Recorded: %1"), {time}),
                      locale.formattedDataSize(status.bytes, 1, QLocale::DataSizeSIFormat)};
    if (status.timeUntilFull)
        parts << sentence(m_recorder.plan().settings.largestSize > 0 ? CommandLine::tr("limit reached in %1")
                                                                     : CommandLine::tr("disk full in %1"),
                          {roughDurationText(*status.timeUntilFull, locale)});
    if (status.server && status.server->waitingBytes > 0)
        parts << sentence(
            CommandLine::tr("%1 wait for the server"),
            {locale.formattedDataSize(status.server->waitingBytes, 1, QLocale::DataSizeSIFormat)});
    if (status.lost > 0)
        parts << sentence(CommandLine::tr("lost values: %1"), {locale.toString(qulonglong{status.lost})});
    if (status.problem)
        parts << CommandLine::tr("cannot be written");
    return parts.join(QStringLiteral(", "));
}

} // namespace codewheel
