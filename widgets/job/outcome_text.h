// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"
#include "widgets/job/done_jobs.h"
#include "widgets/look/roles.h"

namespace codewheel {

// "1, 2, 5"
QString programList(const std::vector<CamProgram> &programs);

// How a job ended, where it was started: short, since the tables show the values and the messages keep them.
struct JobEnd
{
    Role role = Role::running;
    QString text;
    QString wayBack; // on a button, if the encoder was left in a state it can be brought back from
};
// `before`: the jobs of the same handshake, which are told along with it. `isReset`: it was the reset to
// factory settings.
JobEnd endOf(const EncoderSession &encoder, const Outcome &outcome, const DoneJobs &before = {},
             bool isReset = false);

} // namespace codewheel
