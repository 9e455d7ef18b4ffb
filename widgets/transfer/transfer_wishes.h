// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "transfer/transfer_wish.h"

namespace codewheel {

class Buses;
class Catalog;
class ProjectDocument;
class TransferChoice;

// Which values each encoder is to get by what was chosen: restored, cloned, written from the project.
std::vector<TransferWish> transferWishes(const TransferChoice &choice, const Buses &buses,
                                         const Catalog &catalog, const ProjectDocument &project);

} // namespace codewheel
