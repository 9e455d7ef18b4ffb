// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/place.h"
#include "words/k3_word.h"

namespace codewheel {

// What a monitor shows of its device.
enum class MonitorKind : std::uint8_t { in32, out32, in16 };

// As the field writes it, in every language: "IN 32".
QString monitorKindText(MonitorKind kind);
std::optional<MonitorKind> monitorKindFromText(QStringView text);

WordDirection directionOf(MonitorKind kind);
int bitsOf(MonitorKind kind);

// "OUT 1.0": names word, bits and fields, on the screen and for screen readers.
QString wordPlace(MonitorKind kind, Place number);

} // namespace codewheel
