// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QTreeView;

namespace codewheel {

// The widths of the columns of the bus structure. They depend only on the font and the width of the panel,
// never on the content: the name takes what is left over. In a narrow panel the state shrinks to its icon,
// then the position goes; in a wide one, other facts about the devices have their own columns.
void placeColumns(QTreeView &tree, int levels);

} // namespace codewheel
