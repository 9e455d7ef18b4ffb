// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure/structure_columns.h"

#include "widgets/look/grid.h"
#include "widgets/structure/structure_model.h"

#include <QHeaderView>
#include <QLocale>
#include <QTreeView>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int nameCharacters = 16;     // at least
constexpr int wideNameCharacters = 28; // before there are more columns
constexpr int stateCharacters = 11;
constexpr int detailCharacters = 11;        // "37h = 55"
constexpr int largestPosition = 33'554'431; // of 25 bits

struct Room
{
    const QTreeView &tree;

    int of(int characters) const { return characters * tree.fontMetrics().averageCharWidth(); }
    int name(int levels, int characters) const
    {
        return levels * tree.indentation() + grid::smallIcon + 2 * grid::margin + of(characters);
    }
    static int icon() { return grid::smallIcon + 2 * grid::margin; }
    int position() const
    {
        return tree.fontMetrics().horizontalAdvance(QLocale().toString(largestPosition)) + 2 * grid::margin;
    }
};

} // namespace

void placeColumns(QTreeView &tree, int levels)
{
    const Room room{tree};
    const int all = tree.viewport()->width();
    const int name = room.name(levels, nameCharacters);
    const int state = room.icon() + room.of(stateCharacters);
    const int detail = room.of(detailCharacters) + 2 * grid::margin;
    const bool hasWord = all >= name + state + room.position();
    const bool hasPosition = all >= name + room.icon() + room.position();
    int left = all - room.name(levels, wideNameCharacters) - state - room.position();
    tree.setColumnWidth(StructureModel::stateColumn, hasWord || !hasPosition
                                                         ? std::min(state, std::max(all - name, room.icon()))
                                                         : all - name - room.position());
    tree.setColumnWidth(StructureModel::positionColumn, room.position());
    tree.setColumnHidden(StructureModel::positionColumn, !hasPosition);
    for (int column = StructureModel::profileColumn; column < StructureModel::columns; ++column) {
        left -= detail;
        tree.setColumnWidth(column, detail);
        tree.setColumnHidden(column, left < 0);
    }
}

} // namespace codewheel
