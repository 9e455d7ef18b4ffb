// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/places.h"
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/encoder/jobs.h"
#include "cli/project/transfer_call.h"
#include "transfer/value_store.h"

#include <array>

namespace codewheel {
namespace {

constexpr const char *cloneExamples[] = {"clone 1.0 6.1 --dry-run", "clone 1.0 6.1 --yes --trace"};

constexpr std::array cloneOptions{
    Option{"--cams", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "cam programs as well")},
    transferDryRun,
    transferStop,
    transferReport,
    traceOption,
    transferYes,
    beyondLimitOption,
    ledgerOption,
};

// Everything it reports, if it can be read.
Checked<void> readFirst(const Call &call, const EncoderSession &from)
{
    const EncoderJobs jobs = jobsToStore(from, call.arguments.has("--cams"));
    if (jobs.jobs.empty())
        return {};
    const auto allowed = eepromConsent(call, {jobs}, AsksAnyway::no);
    if (!allowed)
        return tl::unexpected(allowed.error());
    const FinishedRound round = runToEnd(call, *allowed, JobRound::AfterRefusal::stop);
    if (round.wasCancelled)
        return tl::unexpected(aboutCancelling());
    if (round.results.front().why)
        return tl::unexpected(complaintAboutJob(call, from.place(), *round.results.front().why));
    return {};
}

Checked<Answer> runClone(const Call &call)
{
    const auto from = encoderAt(call, call.arguments.rest.front());
    if (!from)
        return tl::unexpected(from.error());
    std::vector<EncoderSession *> targets;
    for (const QString &place : call.arguments.rest.sliced(1)) {
        const auto to = encoderAt(call, place);
        if (!to)
            return tl::unexpected(to.error());
        addOnce(targets, *to);
    }
    if (const auto read = readFirst(call, **from); !read)
        return tl::unexpected(read.error());
    std::vector<TransferWish> wishes;
    wishes.reserve(targets.size());
    for (const EncoderSession *to : targets)
        wishes.push_back(wishToClone(**from, *to, call.arguments.has("--cams")));
    if (wishes.front().values.empty())
        return badInput("nothingKnown",
                        CommandLine::tr("Nothing is known of %1: it cannot be read, and nothing was written "
                                        "to it from here."),
                        {call.arguments.rest.front()});
    return plan(call, wishes).map([&](const TransferPlan &planned) {
        return transfer(call, TransferKind::clone, (*from)->place().shown(), planned);
    });
}

} // namespace

const Subcommand cloneCommand{
    .name = "clone",
    .usage = "FROM TO... [--cams] [--dry-run] [--stop] [--report FILE] [--yes] [--trace]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "give other encoders the values of one"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Reads the encoder at FROM, which hides its position for some cycles, and writes its values to\n"
        "encoders of the same kind, as \"transfer\" does. The zero offset is not taken along: it belongs to\n"
        "the way an encoder is mounted. With --cams each cam program of FROM is read in the cam mode of its\n"
        "own; leaving one that was changed before costs an EEPROM write."),
    .examples = cloneExamples,
    .options = cloneOptions,
    .arguments = {2, ArgumentCount::any},
    .needsBus = true,
    .textIsAccount = true,
    .run = runClone,
};

} // namespace codewheel
