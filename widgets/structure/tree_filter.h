// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

class QTreeView;

namespace codewheel {

// Shows of a tree the rows in which each word of it stands, in any column, with those they hang on. There
// once the tree has so many rows that one looks for a device. Esc shows all of them again.
class TreeFilter : public QLineEdit
{
    Q_OBJECT

public:
    static constexpr int fromDevices = 12;

    explicit TreeFilter(QTreeView &tree, QWidget *parent = nullptr); // its model stays the same one

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void followRows();
    void apply();
    bool keep(const QModelIndex &parent, int row, const QStringList &words);

    QTreeView &m_tree;
};

} // namespace codewheel
