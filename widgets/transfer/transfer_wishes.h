// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"
#include "transfer/transfer_wish.h"

namespace codewheel {

class BusSession;
class ProjectDocument;
class TransferChoice;

// All that is planned or known of devices, those that the project does not have too, by number.
std::vector<ProjectDevice> plannedDevices(const ProjectDocument &project);

// Which values each encoder is to get by what was chosen: restored, cloned, written from the project.
std::vector<TransferWish> transferWishes(const TransferChoice &choice, const BusSession &bus,
                                         const ProjectDocument &project);

} // namespace codewheel
