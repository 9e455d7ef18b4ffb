// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/bus/bus_access.h"
#include "cli/call/subcommand.h"
#include "cli/encoder/allowed_jobs.h"
#include "project/project.h"
#include "transfer/transfer_account.h"

#include <QJsonArray>

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

namespace codewheel {

// What the commands for several encoders have in common.

// Anything named twice counts once.
template <typename T>
void addOnce(std::vector<T> &all, const T &one)
{
    if (std::ranges::find(all, one) == all.end())
        all.push_back(one);
}

// The devices of the project on the buses that the link leads to.
std::vector<ProjectDevice> devicesOfLink(const Call &call, const Project &project);
// That none of these, which the project has, is what was typed.
Complaint noSuchDevice(const QString &typed, const std::vector<ProjectDevice> &devices);
// Lets each encoder show its position, or finds out whether it is there (BusAccess::lookFor). A bus that
// cannot be reached, or not to the end, is reported and returned; refused if none can be reached.
Checked<std::set<BusId>>
contactAll(const Call &call, const std::vector<ProjectDevice> &devices,
           Checked<void> (BusAccess::*how)(const Call &, const ProjectDevice &) = &BusAccess::contact);

// The devices of the project named in the call by place or station, from its second argument on; without any,
// everything the link leads to; each once, and showing its position. Refuses a place that the project does
// not have. Takes the encoders of the buses for those of the project.
Checked<std::vector<ProjectDevice>> devicesMeant(const Call &call, const Project &project,
                                                 const QString &file);

// What went over its bus for an encoder.
struct TracedEncoder
{
    Place place;
    QString text;
    QJsonArray json;
};

// A round of jobs, by the time of the buses. Ctrl+C ends it: the answer to what was sent is awaited.
struct FinishedRound
{
    std::vector<EncoderResult> results;
    std::vector<TracedEncoder> traces{}; // with --trace
    bool wasCancelled = false;           // by a signal, whatever came of it
};
FinishedRound runToEnd(const Call &call, const AllowedRound &allowed, JobRound::AfterRefusal afterRefusal);
void addTrace(const Call &call, const FinishedRound &round, Answer &answer); // with --trace

// What is to be written, switching to Operate if the link does not start in it. An encoder that shows its
// position while it is read is read first: so what is shown is what is sent. A signal ends it, and nothing is
// planned. An encoder whose bus is gone has that as its hindrance.
Checked<TransferPlan> plan(const Call &call, std::vector<TransferWish> wishes);

// Shows the plan, asks, writes, accounts. With --dry-run only the plan; with --stop the rest is not started
// after a refusal; with --report FILE the account is saved. `agreed` is called before anything is written; if
// it complains, the transfer ends there.
Answer transfer(const Call &call, TransferKind kind, const QString &source, const TransferPlan &plan,
                const std::function<Checked<void>()> &agreed = {});

// The options of all of them except deviceOption.
inline constexpr Option transferYes{"--yes", nullptr,
                                    QT_TRANSLATE_NOOP("codewheel::CommandLine", "write without asking")};
inline constexpr Option transferDryRun{
    "--dry-run", nullptr,
    QT_TRANSLATE_NOOP("codewheel::CommandLine", "show what would be written, and write nothing")};
inline constexpr Option transferStop{
    "--stop", nullptr,
    QT_TRANSLATE_NOOP("codewheel::CommandLine", "start no other encoder after one has refused")};
inline constexpr Option transferReport{
    "--report", "FILE",
    QT_TRANSLATE_NOOP("codewheel::CommandLine",
                      "save what was written where: HTML where the name ends in .html, else text; a "
                      "FILE that is there is replaced with --yes only")};

} // namespace codewheel
