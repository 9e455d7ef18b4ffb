// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report_input.h"

#include <utility>
#include <vector>

namespace codewheel {

class Buses;
class EncoderSession;

// The devices of the project that are encoders and are connected where the project has them.
using ConnectedEncoder = std::pair<const ProjectDevice *, EncoderSession *>;
std::vector<ConnectedEncoder> connectedEncoders(const Project &project, const Buses &buses);

// Adds what the connected buses report: who is there, what is known of their encoders now, and EEPROM writes.
// An encoder that reported and confirmed nothing in this session is left out: what the project has stored of
// it says more.
void addConnected(ReportInput &input, const Buses &buses);

} // namespace codewheel
