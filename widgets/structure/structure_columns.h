// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QFontMetrics;
class QTreeView;

namespace codewheel {

// The widths of the columns of the bus structure. They depend only on the font and the width of the panel,
// never on the content: the name takes what is left over. In a narrow panel the state shrinks to its icon,
// then the position goes; in a wide one, other facts about the devices have their own columns.
void placeColumns(QTreeView &tree, int levels);
int stateIconWidth(); // of a column of states that have no room for their words

// So many characters as they are in names: letters and digits alike.
int widthOfCharacters(const QFontMetrics &font, int characters);

} // namespace codewheel
