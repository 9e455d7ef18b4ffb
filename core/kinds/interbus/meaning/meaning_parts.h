// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/meaning.h"
#include "vocabulary/word.h"

#include <QStringList>

namespace codewheel {

// Whether the device, a K3, may have a parameter with this number (D28..D25): if its make is unknown, any
// that some manual has.
bool hasNumber(const DeviceDescription &device, unsigned number);
// Whether the parameter with this number, or the service, accepts the value in the word; true if it is not
// described.
bool takesValue(const DeviceDescription &device, unsigned number, std::int64_t value);

// The parts of a meaning's sentence (vocabulary/meaning_text.h) as this device calls them.
QStringList meaningParts(const DeviceDescription &device, const Meaning &meaning);

// What a single bit of a word means, 0..31: "D28..D25: parameter number".
QString k3BitText(const DeviceDescription &device, WordDirection direction, int bit);
QString la66BitText(WordDirection direction, int bit);
QString positionBitText(const DeviceDescription &device, WordDirection direction, int bit);

} // namespace codewheel
