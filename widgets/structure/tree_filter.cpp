// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/structure/tree_filter.h"

#include "widgets/look/describe.h"
#include "widgets/look/icons.h"

#include <QKeyEvent>
#include <QTreeView>

#include <algorithm>

namespace codewheel {
namespace {

int rowsBelow(const QAbstractItemModel &model, const QModelIndex &parent)
{
    int rows = 0;
    for (int row = 0; row < model.rowCount(parent); ++row)
        rows += 1 + rowsBelow(model, model.index(row, 0, parent));
    return rows;
}

bool holds(const QAbstractItemModel &model, const QModelIndex &row, const QStringList &words)
{
    QString text;
    for (int column = 0; column < model.columnCount(row.parent()); ++column)
        text += row.siblingAtColumn(column).data().toString() + u' ';
    return std::ranges::all_of(
        words, [&text](const QString &word) { return text.contains(word, Qt::CaseInsensitive); });
}

} // namespace

TreeFilter::TreeFilter(QTreeView &tree, QWidget *parent)
    : QLineEdit(parent)
    , m_tree(tree)
{
    describe(this, "structureFilter", tr("Filter devices"),
             tr("Shows the devices whose station, place, make or state contains these words; Esc shows all"));
    setPlaceholderText(tr("Filter devices"));
    addAction(lineIcon(Icon::search), QLineEdit::LeadingPosition);
    setClearButtonEnabled(true);
    connect(this, &QLineEdit::textChanged, this, &TreeFilter::apply);
    const QAbstractItemModel *model = tree.model();
    connect(model, &QAbstractItemModel::modelReset, this, &TreeFilter::followRows);
    connect(model, &QAbstractItemModel::rowsInserted, this, &TreeFilter::followRows);
    connect(model, &QAbstractItemModel::rowsRemoved, this, &TreeFilter::followRows);
    followRows();
}

void TreeFilter::followRows()
{
    const QAbstractItemModel &model = *m_tree.model();
    setVisible(rowsBelow(model, {}) - model.rowCount() >= fromDevices);
    if (isHidden() && !text().isEmpty())
        clear();
    else
        apply();
}

void TreeFilter::apply()
{
    const QStringList words = text().split(u' ', Qt::SkipEmptyParts);
    for (int row = 0; row < m_tree.model()->rowCount(); ++row)
        keep({}, row, words);
}

// The row of a bus stays, to show which bus the remaining devices are on.
bool TreeFilter::keep(const QModelIndex &parent, int row, const QStringList &words)
{
    const QAbstractItemModel &model = *m_tree.model();
    const QModelIndex index = model.index(row, 0, parent);
    bool isKept = !parent.isValid() || holds(model, index, words);
    for (int child = 0; child < model.rowCount(index); ++child)
        isKept = keep(index, child, words) || isKept;
    m_tree.setRowHidden(row, parent, !isKept);
    return isKept;
}

QList<KeyHelp> TreeFilter::keys()
{
    return {{keyNames({Qt::Key_Down, Qt::Key_Return}), tr("To the devices that are left")},
            {keyNames({Qt::Key_Escape}), tr("Shows all devices")}};
}

void TreeFilter::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape && !text().isEmpty())
        clear();
    else if (event->key() == Qt::Key_Down || event->key() == Qt::Key_Return)
        m_tree.setFocus();
    else
        QLineEdit::keyPressEvent(event);
}

} // namespace codewheel
