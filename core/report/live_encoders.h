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

// Adds what the connected buses tell: who is there, what is known of their encoders now, and EEPROM writes.
// Of an encoder that neither told nor confirmed anything in this session nothing is known: what the project
// has stored of it says more.
void addConnected(ReportInput &input, const Buses &buses);

} // namespace codewheel
