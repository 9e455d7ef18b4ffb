// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/interbus/gateway/gateway_link.h"
#include "kinds/interbus/gateway/own_word.h"
#include "kinds/interbus/gateway/word_gate.h"

#include <span>
#include <vector>

namespace codewheel {

// What the files of GatewayLink share: what it knows of one device.
struct GatewayLink::Device
{
    WordGate in;
    WordGate out;          // in Watch: what somebody else writes may be torn too
    bool believed = false; // the last exchange gave a word
    int doubts = 0;        // exchanges in a row without a word that could be believed
    OwnWord own{};
    bool isClaimed = false; // somebody asked for words in its OUT, since the link is open
};

namespace gateway {
inline constexpr int readHolding = 3; // functions
inline constexpr int writeHolding = 16;
inline constexpr int writeAndReadHolding = 23;
// The part of an image that begins at register `first`.
inline std::span<Register> part(std::vector<Register> &image, const RegisterBlock &block, int first)
{
    return std::span(image).subspan(static_cast<std::size_t>(block.first - first),
                                    static_cast<std::size_t>(block.count));
}
inline bool holds(const RegisterBlock &block, const RegisterBlock &device)
{
    return device.count > 0 && device.first >= block.first && device.end() <= block.end();
}
} // namespace gateway

} // namespace codewheel
