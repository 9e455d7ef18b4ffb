// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

class Protocol;
class ProtocolRules;

// For encoders with the serial protocol of Kübler (ESC commands overview).
const Protocol &escProtocol();
const ProtocolRules &escRules();

} // namespace codewheel
