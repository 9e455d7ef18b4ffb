// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/column_widths.h"

#include <algorithm>
#include <numeric>

namespace codewheel {

std::vector<qreal> columnWidths(const std::vector<qreal> &wanted, qreal room)
{
    std::vector<std::size_t> narrowFirst(wanted.size());
    std::iota(narrowFirst.begin(), narrowFirst.end(), std::size_t{0});
    std::ranges::stable_sort(narrowFirst, {}, [&](std::size_t column) { return wanted[column]; });

    std::vector<qreal> widths(wanted.size());
    qreal left = room;
    qreal columns = static_cast<qreal>(wanted.size());
    for (const std::size_t column : narrowFirst) {
        widths[column] = std::min(wanted[column], left / columns);
        left -= widths[column];
        columns -= 1;
    }
    const qreal taken = room - left;
    if (taken > 0)
        for (qreal &width : widths)
            width *= room / taken;
    return widths;
}

} // namespace codewheel
