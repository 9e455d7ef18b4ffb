// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/texts.h"
#include "cli/commands.h"
#include "cli/encoder/eeprom_consent.h"
#include "cli/encoder/jobs.h"
#include "cli/encoder/told_mode.h"
#include "cli/project/transfer_call.h"
#include "transfer/project_places.h"
#include "vocabulary/sentence.h"

#include <array>

namespace codewheel {
namespace {

constexpr const char *transferExamples[] = {"transfer crane.codewheel --dry-run",
                                            "transfer crane.codewheel 1.0 2.0",
                                            "transfer crane.codewheel --stored --yes --report account.html"};

constexpr std::array transferOptions{
    Option{"--stored", nullptr,
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "write what was stored of the encoders, not what is wanted")},
    inPositionModeOption,
    transferDryRun,
    transferStop,
    transferReport,
    traceOption,
    transferYes,
    beyondLimitOption,
    ledgerOption,
};

Checked<Answer> runTransfer(const Call &call)
{
    const QString &file = call.arguments.rest.front();
    const auto devices = devicesMeant(call, *call.named, file);
    if (!devices)
        return tl::unexpected(devices.error());
    const bool all = call.arguments.rest.size() == 1;
    const ProjectPlaces places(*call.named, call.buses);
    std::vector<TransferWish> wishes;
    for (const ProjectDevice &device : *devices) {
        TransferWish wish =
            wishOf(device, call.arguments.has("--stored") ? TransferSource::stored : TransferSource::wanted,
                   places, call.catalog);
        const bool isEmpty = wish.values.empty() && wish.cams.empty();
        if (!all || !isEmpty)
            wishes.push_back(std::move(wish));
    }
    if (wishes.empty() && !call.arguments.has("--json")) {
        const bool isStored = call.arguments.has("--stored");
        call.terminal.print(
            sentence(
                isStored
                    ? CommandLine::tr("%1 has nothing stored of its encoders: there is nothing to write.")
                    : CommandLine::tr("%1 wants nothing of its encoders: there is nothing to write."),
                {file}) +
            u'\n');
    }
    return plan(call, wishes).map([&](const TransferPlan &planned) {
        return transfer(call, TransferKind::write, file, planned);
    });
}

} // namespace

const Subcommand transferCommand{
    .name = "transfer",
    .usage = "PROJECT [PLACE...] [--stored] [--in-position-mode] [--dry-run] [--stop] [--report FILE] "
             "[--yes] [--trace]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "write the values of a project to its encoders"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Shows what the encoders named, or all, are known to have beside what the project wants, with the\n"
        "words; asks; writes to one after the other, and tells what became of each value. What is already\n"
        "there is not written: an encoder that can be read is read first. An encoder of which one value\n"
        "cannot be written is not written at all, nor is one that is not the project's: its place may have\n"
        "another number now (see \"compare\"). Exit code 1 if an encoder has not got all of it."),
    .examples = transferExamples,
    .options = transferOptions,
    .arguments = {1, ArgumentCount::any},
    .needsBus = true,
    .namesProject = true,
    .textIsAccount = true,
    .run = runTransfer,
};

} // namespace codewheel
