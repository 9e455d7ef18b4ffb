// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"
#include "transfer/job_round.h"
#include "vocabulary/message.h"

namespace codewheel {

// The jobs for storing an encoder. Reading each value takes the position away for some cycles. Cams are read
// in the cam mode of each program, and leaving a program that was changed before costs an EEPROM write.
EncoderJobs jobsToStore(const EncoderSession &encoder, bool withCams);

// What is known of the encoder, by whatever evidence, with date and time in UTC. What nobody knows is left
// out, and so is the temperature, which is only of the moment.
std::vector<StoredValue> valuesToStore(const EncoderSession &encoder);
std::vector<StoredCams> camsToStore(const EncoderSession &encoder);

// What the project keeps after an encoder was read: what is known now takes precedence over what was stored,
// which stays where nothing is known now.
ProjectDevice withStored(ProjectDevice device, const EncoderSession &encoder);

// "valuesStored" for the message log.
Message valuesStoredMessage(const std::vector<ProjectDevice> &devices);

} // namespace codewheel
