// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace codewheel {

class WordMeanings;

const WordMeanings &k3Meanings();
const WordMeanings &la66Meanings();
const WordMeanings &positionMeanings(); // K1, K2, K4

} // namespace codewheel
