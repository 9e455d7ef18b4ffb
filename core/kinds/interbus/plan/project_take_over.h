// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/ring/comparison.h"
#include "project/project.h"

namespace codewheel {

// The planned ring of a project, to be compared with a connected one.
RingStructure structureOf(const Project &project, BusId ring = firstBus);

// A project with this ring and nothing else.
Project projectOf(const RingStructure &ring, BusId id = firstBus);

// The project with these lines of the comparison taken over from the connected ring. A device that stayed or
// moved keeps everything planned and known of it. If another device is in its place, station, group, note and
// addresses stay, since they belong to the place; values, cams and label go with the device. Devices are
// numbered by their places.
Project takenOver(Project project, const RingStructure &connected, const Comparison &comparison,
                  std::span<const std::size_t> lines, BusId ring = firstBus);

} // namespace codewheel
