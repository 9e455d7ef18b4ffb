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

constexpr int nameCharacters = 16;
constexpr int leastNameCharacters = 12; // before the position goes
constexpr int wideNameCharacters = 23;  // before there are more columns
constexpr int stateCharacters = 10;
constexpr int leastStateCharacters = 6;     // of less nothing could be read
constexpr int detailCharacters = 9;         // "37h = 55"
constexpr int largestPosition = 33'554'431; // of 25 bit

struct Room
{
    const QTreeView &tree;

    int of(int characters) const { return widthOfCharacters(tree.fontMetrics(), characters); }
    int name(int levels, int characters) const
    {
        return levels * tree.indentation() + grid::smallIcon + 2 * grid::margin + of(characters);
    }
    int position() const
    {
        return tree.fontMetrics().horizontalAdvance(QLocale().toString(largestPosition)) + grid::margin +
               grid::unit;
    }
};

} // namespace

int widthOfCharacters(const QFontMetrics &font, int characters)
{
    static const QString usual =
        QStringLiteral("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789");
    const auto all = static_cast<int>(usual.size());
    return (font.horizontalAdvance(usual) * characters + all - 1) / all;
}

int stateIconWidth()
{
    return grid::smallIcon + 2 * grid::margin;
}

void placeColumns(QTreeView &tree, int levels)
{
    const Room room{tree};
    const int all = tree.viewport()->width();
    const int name = room.name(levels, nameCharacters);
    const int state = stateIconWidth() + room.of(stateCharacters);
    const int detail = room.of(detailCharacters) + 2 * grid::margin;
    const bool hasPosition =
        all >= room.name(levels, leastNameCharacters) + stateIconWidth() + room.position();
    const int forState = std::min(state, all - name - (hasPosition ? room.position() : 0));
    const bool hasWord = forState >= stateIconWidth() + room.of(leastStateCharacters);
    tree.setColumnWidth(StructureModel::stateColumn, hasWord ? forState : stateIconWidth());
    tree.setColumnWidth(StructureModel::positionColumn, room.position());
    tree.setColumnHidden(StructureModel::positionColumn, !hasPosition);
    int left = all - room.name(levels, wideNameCharacters) - state - room.position();
    for (int column = StructureModel::profileColumn; column < StructureModel::columns; ++column) {
        left -= detail;
        tree.setColumnWidth(column, detail);
        tree.setColumnHidden(column, left < 0);
    }
}

} // namespace codewheel
