// SPDX-License-Identifier: GPL-3.0-or-later
// The protocol of the second kind of encoder of the tests' own (telegram_node.h): one line gives it all its
// values, which it can neither tell nor keep.
#pragma once

#include "tests/kinds/plain/plain_protocol.h"

namespace codewheel::test {

struct PlainKnowledge;

inline constexpr Profile telegramProfile{"telegram"};

// What nobody wants is given as it is known, otherwise as from the factory.
std::vector<PlainStep> telegramSteps(const DeviceDescription &device, const Job &job,
                                     const ParameterValues &known);

// What it answers when it is asked for its position.
void takeTelegramPosition(const QByteArray &answer, PlainKnowledge &encoder);

} // namespace codewheel::test
