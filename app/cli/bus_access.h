// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/allowed_jobs.h"
#include "cli/arguments.h"
#include "cli/complaint.h"
#include "cli/line_trace.h"

#include <QtGlobal>

#include <vector>

namespace codewheel {

class BusSession;
class LedgerKeeper;

struct Call;

// The encoder at the PLACE the call names, on the bus or on the serial line, so far that it shows where it
// stands. With --device it is named first, for this call.
Checked<EncoderSession *> encoderAt(const Call &call);

// The same on the bus, whatever --device says.
Checked<EncoderSession *> encoderMeant(const Call &call);

// --device of the commands that work on a PLACE.
inline constexpr Option deviceOption{
    "--device", "NAME",
    QT_TRANSLATE_NOOP("codewheel::CommandLine",
                      "take the encoder for this one: a name of \"devices\", or the key on its label")};

// What a name of the catalog, or the key on a label, means at a place of the bus. 0: the key does not tell.
struct NamedDevice
{
    QString key;
    int turns = 0;
    int stepsPerTurn = 0;
};
Checked<NamedDevice> deviceMeant(const Call &call, Place place, const QString &typed);

// The encoder at PLACE, with at least one bus cycle behind it, so that it shows where it stands.
Checked<EncoderSession *> encoderAt(BusSession &bus, const QString &place);

// The words of the last cycle, as a row of a trace.
Exchange currentRow(const BusSession &bus, const EncoderSession &encoder);

// How a job ended, and the trace of it, oldest row first.
struct FinishedJob
{
    Outcome outcome;
    std::vector<Exchange> rows;    // on the bus; begins with how the encoder stood before
    std::vector<PassedRow> passed; // on a serial line
    Progress lastStep;             // that was begun; on a serial line
};

// Runs a job to its end: cycle by cycle in virtual time on the bus, by the line's clock on a serial line,
// where Ctrl+C cancels it.
FinishedJob runToEnd(const Call &call, const AllowedJob &allowed);

// Whether that is on the serial line of the call.
bool isOfLine(const Call &call, Place place);

// About a job that was refused; of an encoder on a serial line about the port too, where it is gone.
Complaint complaintAboutJob(const Call &call, Place place, const Refusal &why);

// Lets some time pass on the bus at the place: a cycle of a ring, so much of a line as it is looked at.
void passTime(const Call &call, Place place);

// That counts EEPROM writes on the bus at the place; null: none does.
LedgerKeeper *ledgerOf(const Call &call, Place place);

// Of a job, for --trace.
QString traceText(const Call &call, const EncoderSession &encoder, const FinishedJob &job);
QJsonArray traceJson(const Call &call, const EncoderSession &encoder, const FinishedJob &job);

} // namespace codewheel
