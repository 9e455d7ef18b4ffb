// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QHeaderView;

namespace codewheel {

// The least width of a column for its heading. Qt's hint is for a bold one, as in the column of the current
// cell, which our tables do not have.
int headingWidth(const QHeaderView &header, int column);

} // namespace codewheel
