// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace codewheel {

// The first row of which this member is `value`; null: there is none. The rows outlive it.
template <typename Rows, typename Value, typename Member>
constexpr auto *findBy(Rows &rows, const Value &value, Member member)
{
    const auto found = std::ranges::find(rows, value, member);
    return found == std::ranges::end(rows) ? nullptr : &*found;
}

} // namespace codewheel
