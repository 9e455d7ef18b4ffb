// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

class Protocol;
class ProtocolRules;

// For encoders on CANopen (CiA 406): their parameters are objects.
const Protocol &canopenProtocol();
const ProtocolRules &canopenRules();

} // namespace codewheel
