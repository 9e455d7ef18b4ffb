// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/paper/printed_table.h"

#include <QAbstractItemView>
#include <QCoreApplication>
#include <QDockWidget>
#include <QHeaderView>
#include <QLocale>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QTreeView>

#include <algorithm>
#include <vector>

namespace codewheel {
namespace {

constexpr int mostRows = 2000; // about forty sheets

struct Printed
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Printing)
};

const QHeaderView *headerOf(const QAbstractItemView &view)
{
    if (const auto *table = qobject_cast<const QTableView *>(&view))
        return table->horizontalHeader();
    const auto *tree = qobject_cast<const QTreeView *>(&view);
    return tree != nullptr ? tree->header() : nullptr;
}

bool canBePrinted(const QAbstractItemView &view)
{
    return headerOf(view) != nullptr && view.model() != nullptr && view.model()->rowCount() > 0;
}

// In their visual order.
std::vector<int> shownColumns(const QAbstractItemView &view)
{
    const QHeaderView &header = *headerOf(view);
    std::vector<int> columns;
    for (int i = 0; i < header.count(); ++i)
        if (const int column = header.logicalIndex(i); !header.isSectionHidden(column))
            columns.push_back(column);
    return columns;
}

struct ShownRow
{
    QModelIndex first;
    int depth = 0;
};

void addRows(std::vector<ShownRow> &rows, const QAbstractItemView &view, const QModelIndex &parent, int depth)
{
    const auto *tree = qobject_cast<const QTreeView *>(&view);
    const auto *table = qobject_cast<const QTableView *>(&view);
    const int count = view.model()->rowCount(parent);
    for (int row = std::max(0, count - mostRows); row < count; ++row) {
        if (tree != nullptr ? tree->isRowHidden(row, parent) : table->isRowHidden(row))
            continue;
        const QModelIndex first = view.model()->index(row, 0, parent);
        rows.push_back({first, depth});
        if (tree != nullptr && tree->isExpanded(first))
            addRows(rows, view, first, depth + 1);
    }
}

QString withTick(const QModelIndex &index, const QString &text)
{
    const QVariant state = index.data(Qt::CheckStateRole);
    if (state.isNull())
        return text;
    const QChar box(state.toInt() == Qt::Checked ? 0x2611 : 0x2610);
    return text.isEmpty() ? QString(box) : QStringLiteral("%1 %2").arg(box).arg(text);
}

QString cell(const QAbstractItemView &view, const QModelIndex &index, int indent)
{
    const auto *delegate = qobject_cast<const QStyledItemDelegate *>(view.itemDelegateForIndex(index));
    const QString shown =
        delegate != nullptr ? delegate->displayText(index.data(), view.locale()) : index.data().toString();
    const QString text = withTick(index, shown);
    const auto alignment = Qt::Alignment(index.data(Qt::TextAlignmentRole).toInt());
    return QStringLiteral("<td align=\"%1\">%2%3</td>")
        .arg(QLatin1String(alignment.testFlag(Qt::AlignRight) ? "right" : "left"),
             QStringLiteral("&nbsp;").repeated(qsizetype{4} * indent), text.toHtmlEscaped());
}

QString heads(const QAbstractItemView &view, const std::vector<int> &columns)
{
    QString html;
    for (const int column : columns)
        html += QStringLiteral("<th align=\"left\">%1</th>")
                    .arg(view.model()->headerData(column, Qt::Horizontal).toString().toHtmlEscaped());
    return QStringLiteral("<thead><tr>%1</tr></thead>").arg(html); // on each sheet
}

// What the widget is in, or is visible beside it, up to the edge of its panel.
template <class Wanted, class Accepts>
const Wanted *nearest(const QWidget *widget, Accepts accepts)
{
    for (const QWidget *each = widget; each != nullptr && !each->isWindow(); each = each->parentWidget()) {
        if (const auto *found = dynamic_cast<const Wanted *>(each); found != nullptr && accepts(*found))
            return found;
        for (const QWidget *child : each->findChildren<QWidget *>())
            if (const auto *found = dynamic_cast<const Wanted *>(child);
                found != nullptr && child->isVisible() && accepts(*found))
                return found;
        if (qobject_cast<const QDockWidget *>(each) != nullptr)
            return nullptr;
    }
    return nullptr;
}

} // namespace

const QAbstractItemView *tableToPrint(const QWidget *widget)
{
    return nearest<QAbstractItemView>(widget, canBePrinted);
}

std::optional<PrintedView> viewToPrint(const QWidget *widget)
{
    const auto *picture = nearest<PrintsPicture>(widget, [](const PrintsPicture &) { return true; });
    return picture != nullptr ? picture->printedView() : std::nullopt;
}

QString titleToPrint(const QWidget &widget)
{
    for (const QWidget *each = &widget; each != nullptr && !each->isWindow(); each = each->parentWidget())
        if (const auto *dock = qobject_cast<const QDockWidget *>(each))
            return dock->windowTitle();
    return widget.accessibleName();
}

QString printedHead(const QString &title, const QString &origin)
{
    return QStringLiteral("<h2>%1</h2><p>%2</p>").arg(title.toHtmlEscaped(), origin.toHtmlEscaped());
}

QString printedValues(const std::vector<std::pair<QString, QString>> &values)
{
    QString html = QStringLiteral("<table cellspacing=\"0\" cellpadding=\"3\">");
    for (const auto &[name, value] : values)
        html += QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
                    .arg(name.toHtmlEscaped(), value.toHtmlEscaped());
    return html + QStringLiteral("</table>");
}

QString printedTable(const QAbstractItemView &table)
{
    std::vector<ShownRow> rows;
    addRows(rows, table, table.rootIndex(), 0);
    const std::vector<int> columns = shownColumns(table);
    QString html;
    if (const int all = table.model()->rowCount(table.rootIndex()); all > mostRows)
        html += QStringLiteral("<p>%1</p>")
                    .arg(Printed::tr("The last %1 of %2 rows.")
                             .arg(QLocale().toString(mostRows), QLocale().toString(all)));
    html += QStringLiteral("<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\" width=\"100%\" "
                           "style=\"border-collapse: collapse\">") +
            heads(table, columns);
    for (const ShownRow &row : rows) {
        html += QStringLiteral("<tr>");
        for (const int column : columns)
            html += cell(table, row.first.siblingAtColumn(column), column == columns.front() ? row.depth : 0);
        html += QStringLiteral("</tr>");
    }
    return html + QStringLiteral("</table>");
}

} // namespace codewheel
