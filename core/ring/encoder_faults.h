// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/fault.h"

#include <optional>

namespace codewheel {

class EncoderSession;
class RingSession;
struct Reading;

// What an encoder of a running ring shows, or leaves in doubt; by its index in the ring.
std::optional<Fault> encoderFault(const RingSession &bus, std::size_t device);
// "error 13"; "invalid": it has no valid position.
StateWord errorWord(const EncoderSession *encoder, const Reading &reading);

} // namespace codewheel
