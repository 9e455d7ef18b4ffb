// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace codewheel {

// Whether the rows of a table are in the order of the enumeration whose value each holds in `id`, so that the
// value is the index of its row. Checked at compile time by the tables of keys and texts.
template <typename Rows, typename Row, typename Id>
constexpr bool areInOrder(const Rows &rows, Id Row::*id)
{
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (static_cast<std::size_t>(rows[i].*id) != i)
            return false;
    return true;
}

// And whether there is one for each value up to the last.
template <typename Rows, typename Row, typename Id, typename Last>
constexpr bool areInOrder(const Rows &rows, Id Row::*id, Last last)
{
    return areInOrder(rows, id) && rows.size() == static_cast<std::size_t>(last) + 1;
}

} // namespace codewheel
