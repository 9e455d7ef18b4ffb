// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

class Protocol;
class ProtocolRules;
class WordMeanings;

// For encoders of ENCOM profile K3, and for K1, K2 and K4, which have no jobs.
const Protocol &k3Protocol();
// For the rods of the type LA-66.
const Protocol &la66Protocol();

// For the descriptions of encoders with these protocols, and of those that only tell their position.
const ProtocolRules &k3Rules();
const ProtocolRules &la66Rules();
const ProtocolRules &k1Rules();
const ProtocolRules &k2Rules();
const ProtocolRules &k4Rules();

const WordMeanings &k3Meanings();
const WordMeanings &la66Meanings();
const WordMeanings &positionMeanings(); // K1, K2, K4

} // namespace codewheel
