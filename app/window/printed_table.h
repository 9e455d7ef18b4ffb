// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QAbstractItemView;
class QTextDocument;
class QWidget;

namespace codewheel {

// The table or tree that contains the widget, or is visible in it; null: there is none, or it is empty.
const QAbstractItemView *tableToPrint(const QWidget *widget);

// Its name, from its panel or page: "Messages".
QString titleToPrint(const QWidget &widget);

// Its columns and rows as shown, only the last ones if there are thousands. `origin`: below the title.
QString printedTable(const QAbstractItemView &table, const QString &title, const QString &origin);

} // namespace codewheel
