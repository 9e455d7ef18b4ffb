// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/printed_view.h"

#include <QString>

class QAbstractItemView;
class QWidget;

namespace codewheel {

// The table or tree that contains the widget, or is visible in it; null: there is none, or it is empty.
const QAbstractItemView *tableToPrint(const QWidget *widget);

// Its name, from its panel or page: "Messages".
QString titleToPrint(const QWidget &widget);

// The picture that a widget is in, with its values; nothing: it is in none, or that shows nothing now.
std::optional<PrintedView> viewToPrint(const QWidget *widget);

// The parts of a sheet. `origin`: below the title.
QString printedHead(const QString &title, const QString &origin);
QString printedValues(const std::vector<std::pair<QString, QString>> &values);
// Columns and rows as they are shown, the last ones where there are thousands.
QString printedTable(const QAbstractItemView &table);

} // namespace codewheel
