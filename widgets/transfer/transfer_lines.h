// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"
#include "transfer/transfer_plan.h"
#include "widgets/eeprom/eeprom_gate.h"
#include "widgets/job/review_table.h"

namespace codewheel {

class Buses;
class ProjectPlaces;

// What a plan costs the EEPROMs, for EepromGate.
std::vector<EepromWrites> writesOf(const Buses &buses, const TransferPlan &plan);

// The lines of the table of a transfer (TransferModel): an encoder, and below it its values, its cam
// programs, and sentences.
std::vector<ReviewRow> linesOf(const Buses &buses, const TransferPlan &plan);
// What would be read, and what the project has stored so far.
std::vector<ReviewRow> linesToStore(const Buses &buses, const ProjectPlaces &places,
                                    const std::vector<ProjectDevice> &devices, bool withCams);

} // namespace codewheel
