// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

class ProtocolRules;

// For encoders with the serial protocol of Kübler (ESC commands overview).
const ProtocolRules &escRules();

} // namespace codewheel
