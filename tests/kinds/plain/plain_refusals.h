// SPDX-License-Identifier: GPL-3.0-or-later
// What only the tests' own kind refuses: added to the families of the program by being linked.
#pragma once

#include "vocabulary/refusal.h"

namespace codewheel::test {

enum class PlainRefusalId : std::uint8_t {
    noSuchKey, // Parameter: the encoder answered "no KEY"
};
extern const RefusalFamily plainRefusals;
constexpr const RefusalFamily &familyOf(PlainRefusalId)
{
    return plainRefusals;
}

} // namespace codewheel::test
