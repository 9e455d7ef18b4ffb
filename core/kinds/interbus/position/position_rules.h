// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

class ProtocolRules;

// For the descriptions of encoders that only tell their position.
const ProtocolRules &k1Rules();
const ProtocolRules &k2Rules();
const ProtocolRules &k4Rules();

} // namespace codewheel
