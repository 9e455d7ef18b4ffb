// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/call/arguments.h"
#include "cli/call/complaint.h"
#include "cli/encoder/allowed_jobs.h"
#include "cli/encoder/job_trace.h"

#include <QtGlobal>

#include <memory>
#include <optional>
#include <vector>

namespace codewheel {

struct Answer;
struct Call;

inline constexpr Option traceOption{
    "--trace", nullptr,
    QT_TRANSLATE_NOOP("codewheel::CommandLine", "print the words that went over the bus")};

// How a job ended.
struct FinishedJob
{
    Outcome outcome;
    Progress lastStep;             // that was started
    std::vector<Parameter> sent{}; // of which a value was sent
    std::shared_ptr<const JobTrace> trace;
    bool wasCancelled = false; // by a signal, whatever came of it
};

// Runs a job to its end, by the clock of its bus. Ctrl+C cancels it: the answer to what was sent is awaited
// and read.
FinishedJob runToEnd(const Call &call, const AllowedJob &allowed);
// The same, adding what goes over the bus to a trace.
Outcome runToEnd(const Call &call, const AllowedJob &allowed, JobTrace &trace);

// With --trace: the words or requests that went over the bus, before what the answer already says.
void addTrace(const Call &call, Place place, const JobTrace &trace, Answer &answer);

QString eepromWritesLine(int writes, int perhaps); // "EEPROM writes:   1"
QString eepromWritesLine(const Outcome &outcome);
bool mayHaveWritten(const Outcome &outcome); // to the EEPROM
// What was sent and not answered, in lines; empty: nothing.
QString doubtLines(const EncoderSession &encoder, const InDoubt &doubt);
// Adds it as "inDoubt", where there is something.
void addDoubt(QJsonObject &json, const EncoderSession &encoder, const InDoubt &doubt);
Complaint aboutCancelling();
// An encoder that shows that it is in parameterization: it gives no position, and run makes valid what nobody
// has read. Empty: it is not.
std::optional<Complaint> foundInParameterization(const Call &call, const EncoderSession &encoder);
// About a job that was refused, and about its link if that is gone.
Complaint complaintAboutJob(const Call &call, Place place, const Refusal &why);
// About a job without success; if it was cut, the state of its encoder is not known.
Complaint complaintAboutEnd(const Call &call, const EncoderSession &encoder, const Outcome &outcome);

} // namespace codewheel
