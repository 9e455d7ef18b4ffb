// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/jobs.h"

#include "cli/bus_access.h"
#include "cli/stop_signals.h"
#include "cli/subcommand.h"
#include "cli/texts.h"
#include "encoder/sentence.h"

namespace codewheel {
namespace {

// A bus is in Watch until something has to be sent.
Result<JobId> startOn(BusAccess &bus, const AllowedJob &allowed)
{
    auto started = allowed.encoder().start(allowed.job());
    if (started || started.error().id != RefusalId::watchOnly)
        return started;
    bus.prepare(allowed.job());
    return allowed.encoder().start(allowed.job());
}

// Until it has ended.
void carryOut(BusAccess &bus, const AllowedJob &allowed, FinishedJob &finished)
{
    EncoderSession &encoder = allowed.encoder();
    const auto started = startOn(bus, allowed);
    if (!started) {
        finished.outcome.result = tl::unexpected(started.error());
        return;
    }
    bool running = true;
    QObject scope;
    QObject::connect(&encoder, &EncoderSession::progressed, &scope,
                     [&](const Progress &progress) { finished.lastStep = progress; });
    QObject::connect(&encoder, &EncoderSession::finished, &scope, [&](const Outcome &ended) {
        running = ended.job != *started;
        finished.outcome = ended;
    });
    StopSignals stop;
    while (running) {
        if (stop.came()) {
            finished.wasCancelled = true;
            encoder.cancel(OnCancel::leaveAsIs);
        }
        bus.advance(bus.lookInterval());
    }
}

FinishedJob run(const Call &call, const AllowedJob &allowed, JobTrace &trace)
{
    const EncoderSession &encoder = allowed.encoder();
    BusAccess &bus = call.busOf(encoder.place());
    trace.begin(encoder);
    FinishedJob finished;
    carryOut(bus, allowed, finished);
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

QString eepromWritesLine(int writes)
{
    return sentence(CommandLine::tr("EEPROM writes:   %1"), argumentTexts({std::int64_t{writes}})) + u'\n';
}

Complaint aboutCancelling()
{
    return complaintAbout({RefusalKind::stopped, RefusalId::cancelled, {}});
}

Complaint complaintAboutJob(const Call &call, Place place, const Refusal &why)
{
    return call.busOf(place).complaint(why);
}

} // namespace codewheel
