// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/help/key_help.h"

#include <QLineEdit>

class QTreeView;

namespace codewheel {

// Filters a tree: shows only rows that contain all the words typed, in any column, and their parents. Appears
// once the tree has so many rows that one has to search. Esc shows all of them again.
class TreeFilter : public QLineEdit
{
    Q_OBJECT

public:
    static constexpr int fromDevices = 12;

    explicit TreeFilter(QTreeView &tree, QWidget *parent = nullptr); // its model stays the same one
    static QList<KeyHelp> keys();                                    // that it answers

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void followRows();
    void apply();
    bool keep(const QModelIndex &parent, int row, const QStringList &words);

    QTreeView &m_tree;
};

} // namespace codewheel
