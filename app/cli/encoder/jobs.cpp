// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/encoder/jobs.h"

#include "bus/buses.h"
#include "cli/bus/bus_access.h"
#include "cli/call/stop_signals.h"
#include "cli/call/subcommand.h"
#include "cli/call/texts.h"
#include "cli/encoder/position_text.h"
#include "cli/encoder/value_lines.h"
#include "jobs/job_report.h"
#include "jobs/step_text.h"
#include "jobs/values_to_write.h"
#include "jobs/what_run_makes_valid.h"
#include "journal/eeprom_cost.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"
#include "vocabulary/shell_command.h"

#include <chrono>

namespace codewheel {
namespace {

// What a terminal shows of a job that takes long, as behind a slow gateway.
class JobProgress
{
public:
    JobProgress(const Terminal &terminal, const DeviceDescription &device)
        : m_terminal(terminal)
        , m_device(device)
    {}
    ~JobProgress()
    {
        if (!m_shown.isEmpty())
            m_terminal.showProgress({});
    }
    JobProgress(const JobProgress &) = delete;
    JobProgress &operator=(const JobProgress &) = delete;

    void at(const Progress &progress)
    {
        if (static_cast<std::size_t>(progress.index) < progress.steps.size())
            m_text = sentence(CommandLine::tr("Step %1 of %2: %3. Ctrl+C cancels."),
                              {QString::number(progress.index + 1), QString::number(progress.steps.size()),
                               stepText(m_device, progress.steps[static_cast<std::size_t>(progress.index)])});
    }
    void cancelled()
    {
        m_text = CommandLine::tr("Cancelled: what is under way is ended first.");
        if (!m_terminal.isInteractive)
            m_terminal.complain(m_text);
    }
    void look()
    {
        if (m_text == m_shown || std::chrono::steady_clock::now() < m_begun + std::chrono::seconds(1))
            return;
        m_shown = m_text;
        m_terminal.showProgress(m_shown);
    }

private:
    const Terminal &m_terminal;
    const DeviceDescription &m_device;
    const std::chrono::steady_clock::time_point m_begun = std::chrono::steady_clock::now();
    QString m_text;
    QString m_shown;
};

// A bus is in Watch until something has to be sent.
Result<JobId> startOn(BusAccess &bus, const AllowedJob &allowed)
{
    auto started = allowed.encoder().start(allowed.job());
    if (started || started.error().id != RefusalId::watchOnly)
        return started;
    bus.prepare(allowed.job());
    return allowed.encoder().start(allowed.job());
}

void noteSent(std::vector<Parameter> &sent, const Progress &progress)
{
    const auto index = static_cast<std::size_t>(progress.index);
    if (progress.waitsForUser || index >= progress.steps.size() || !takesValue(progress.steps[index]))
        return;
    const std::vector<Parameter> &now = progress.steps[index].parameters;
    sent.insert(sent.end(), now.begin(), now.end());
}

// Until it has ended.
void carryOut(const Terminal &terminal, BusAccess &bus, const AllowedJob &allowed, FinishedJob &finished)
{
    EncoderSession &encoder = allowed.encoder();
    bus.listenBefore(encoder, allowed.job());
    const auto started = startOn(bus, allowed);
    if (!started) {
        finished.outcome.result = tl::unexpected(started.error());
        return;
    }
    bool running = true;
    JobProgress shown(terminal, encoder.device());
    QObject scope;
    QObject::connect(&encoder, &EncoderSession::progressed, &scope, [&](const Progress &progress) {
        finished.lastStep = progress;
        noteSent(finished.sent, progress);
        shown.at(progress);
    });
    QObject::connect(&encoder, &EncoderSession::finished, &scope, [&](const Outcome &ended) {
        running = ended.job != *started;
        finished.outcome = ended;
    });
    StopSignals stop;
    while (running) {
        if (stop.came()) {
            finished.wasCancelled = true;
            encoder.cancel(OnCancel::leaveAsIs);
            shown.cancelled();
        }
        shown.look();
        bus.advance(bus.lookInterval());
    }
}

// The options by which this call reaches the encoder, for another one.
QString wayToBus(const Call &call)
{
    const auto project = call.named != nullptr ? std::optional(call.arguments.rest.front())
                                               : call.arguments.value("--project");
    QString way;
    if (const auto link = call.arguments.value("--link"))
        way += shellCommand(QStringLiteral(" --link %1"), {*link});
    if (project)
        way += shellCommand(QStringLiteral(" --project %1"), {*project});
    return way;
}

// Ends a parameterization. Empty: not by words.
QString commandOfRun(const Call &call, const EncoderSession &encoder)
{
    const auto steps = encoder.planned({EndParameterization{}});
    if (!steps)
        return {};
    QStringList words;
    for (const Step &step : *steps)
        words << (step.line.isEmpty() ? hexWord(step.out) : QString());
    return words.contains(QString())
               ? QString()
               : shellCommand(QStringLiteral("codewheel-cli words %1 "), {encoder.place().shown()}) +
                     words.join(u' ') + wayToBus(call);
}

bool endsWithRun(const Refusal &why)
{
    return why.id == RefusalId::inParameterization || why.id == RefusalId::modeNotSwitched;
}

FinishedJob run(const Call &call, const AllowedJob &allowed, JobTrace &trace)
{
    const EncoderSession &encoder = allowed.encoder();
    BusAccess &bus = call.busOf(encoder.place());
    trace.begin(encoder);
    FinishedJob finished;
    carryOut(call.terminal, bus, allowed, finished);
    bus.rest();
    bus.lookAgain(encoder);
    return finished;
}

} // namespace

FinishedJob runToEnd(const Call &call, const AllowedJob &allowed)
{
    const EncoderSession &encoder = allowed.encoder();
    const std::shared_ptr<JobTrace> trace = call.busOf(encoder.place()).trace({&encoder});
    FinishedJob finished = run(call, allowed, *trace);
    finished.trace = trace;
    return finished;
}

Outcome runToEnd(const Call &call, const AllowedJob &allowed, JobTrace &trace)
{
    return run(call, allowed, trace).outcome;
}

void addTrace(const Call &call, Place place, const JobTrace &trace, Answer &answer)
{
    if (!call.arguments.has("--trace"))
        return;
    answer.text += trace.text(place) + u'\n';
    answer.json.insert(QStringLiteral("trace"), trace.json(place));
}

QString eepromWritesLine(int writes, int perhaps)
{
    return sentence(CommandLine::tr("EEPROM writes:   %1"), {eepromWritesText(writes, perhaps)}) + u'\n';
}

QString eepromWritesLine(const Outcome &outcome)
{
    return eepromWritesLine(outcome.eepromWrites, outcome.inDoubt.eepromWrites);
}

bool mayHaveWritten(const Outcome &outcome)
{
    return outcome.eepromWrites + outcome.inDoubt.eepromWrites > 0;
}

QString doubtLines(const EncoderSession &encoder, const InDoubt &doubt)
{
    QString text;
    for (const QString &one : doubtSentences(doubt, encoder.device()))
        text += one + u'\n';
    return text;
}

void addDoubt(QJsonObject &json, const EncoderSession &encoder, const InDoubt &doubt)
{
    if (!doubt.hasSomething())
        return;
    QJsonArray programs;
    for (const unsigned program : doubt.camPrograms)
        programs.append(static_cast<int>(program));
    QJsonArray words;
    for (const Word out : doubt.out)
        words.append(hexWord(out));
    json.insert(QStringLiteral("inDoubt"),
                QJsonObject{{QStringLiteral("values"), valuesJson(encoder, doubt.values)},
                            {QStringLiteral("reset"), doubt.reset},
                            {QStringLiteral("position"), doubt.position},
                            {QStringLiteral("camPrograms"), programs},
                            {QStringLiteral("eepromWrites"), doubt.eepromWrites},
                            {QStringLiteral("out"), words}});
}

Complaint aboutCancelling()
{
    return complaintAbout({RefusalKind::stopped, RefusalId::cancelled, {}});
}

std::optional<Complaint> foundInParameterization(const Call &call, const EncoderSession &encoder)
{
    if (encoder.latest().state != EncoderState::parameterization)
        return std::nullopt;
    const QString place = encoder.place().shown();
    return notDone(
        "foundInParameterization",
        sentence(CommandLine::tr("%1 is in parameterization and gives no position; what was read of it "
                                 "holds until run. %2"),
                 {place, whatRunMakesValid(encoder)}),
        {place}, commandOfRun(call, encoder));
}

Complaint complaintAboutJob(const Call &call, Place place, const Refusal &why)
{
    Complaint complaint = call.busOf(place).complaint(why);
    const EncoderSession *encoder = call.buses.encoder(place);
    if (encoder != nullptr && endsWithRun(why))
        complaint.command = commandOfRun(call, *encoder);
    return complaint;
}

Complaint complaintAboutEnd(const Call &call, const EncoderSession &encoder, const Outcome &outcome)
{
    Complaint complaint = complaintAboutJob(call, encoder.place(), outcome.result.error());
    const bool isUnseen = endedOutOfSight(outcome) && outcome.leftIn == EncoderState::unknown;
    if (isUnseen || outcome.leftIn == EncoderState::error)
        complaint.text += u' ' + whereItWasLeft(outcome, encoder.latest());
    if (const auto left = leftModeReport(outcome))
        complaint.text += u' ' + messageText(*left);
    return complaint;
}

} // namespace codewheel
