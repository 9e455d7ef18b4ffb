// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "kinds/interbus/words/cyclic_driver.h"

#include <memory>

namespace codewheel {

// The driver for a device of this description; null if there is none. The description must outlive the
// driver.
std::unique_ptr<CyclicDriver> makeDriver(const DeviceDescription &device);

// What one would read in these words that has seen none before.
std::optional<Reading> readingOfWords(const DeviceDescription &device, const std::vector<Known> &known,
                                      Word in, Word out, Instant at);

} // namespace codewheel
