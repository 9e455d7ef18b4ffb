// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QTreeView;

namespace codewheel {

// The widths of the columns of the bus structure. They follow from the font and the width of the panel alone,
// never from what stands in them: the name takes what is left over. In a narrow panel the state is its icon,
// then the position goes; in a wide one what else is known of the devices has columns of its own.
void placeColumns(QTreeView &tree, int levels);

} // namespace codewheel
