// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/protocol/octets.h"
#include "vocabulary/value.h"

#include <vector>

namespace codewheel::canopen {

// How the octets of an object are read. Makes disagree about the width of an object, so that of the answer
// goes before that of the type; the sign is nowhere on the wire.
enum class ObjectType : std::uint8_t { u8, u16, u32, i8, i16, i32, text };

std::size_t widthOf(ObjectType type); // in octets; 0: any
bool isSigned(ObjectType type);

// `isSizeTold`: the octets are as many as the object has; otherwise the type says how many count.
Value objectValue(ObjectType type, Octets octets, bool isSizeTold = true);
// The lowest octet first. A text has its own length, whatever the width.
std::vector<std::uint8_t> octetsOf(const Value &value, std::size_t width);

} // namespace codewheel::canopen
