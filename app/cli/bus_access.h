// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/complaint.h"
#include "encoder/encoder_session.h"

#include <vector>

namespace codewheel {

class BusSession;

// The encoder at PLACE, with at least one bus cycle behind it, so that it shows where it stands.
Checked<EncoderSession *> encoderAt(BusSession &bus, const QString &place);

// The words of the last cycle, as a row of a trace.
Exchange currentRow(const BusSession &bus, const EncoderSession &encoder);

// How a job ended, and the trace of it, oldest row first.
struct FinishedJob
{
    Outcome outcome;
    std::vector<Exchange> rows;
};

// Runs a job to its end, cycle by cycle in virtual time. `rows` begins with how the encoder stood before.
FinishedJob runToEnd(BusSession &bus, EncoderSession &encoder, const Job &job);

} // namespace codewheel
