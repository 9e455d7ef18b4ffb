// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QAbstractItemView;
class QTextDocument;
class QWidget;

namespace codewheel {

// The table or tree that a widget is in, or the one that is seen in it; null: there is none, or it is empty.
const QAbstractItemView *tableToPrint(const QWidget *widget);

// What it is called, of the panel or page it is in: "Messages".
QString titleToPrint(const QWidget &widget);

// Its columns and rows as they are shown, the last ones where there are thousands. `origin`: below the title.
QString printedTable(const QAbstractItemView &table, const QString &title, const QString &origin);

} // namespace codewheel
