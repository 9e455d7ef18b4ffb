// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/help/key_help.h"
#include "widgets/input/checked_delegate.h"

#include <QTableView>

namespace codewheel {

class CamSheet;
class CamTableModel;

// Edits the positions of the cam table. Bad input keeps its field open, so that nothing typed is lost; Escape
// gives it up.
class CamDelegate final : public CheckedDelegate
{
    Q_OBJECT

public:
    CamDelegate(const CamSheet &sheet, QObject *parent);

    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                          const QModelIndex &index) const override;
    void setEditorData(QWidget *editor, const QModelIndex &index) const override;
    void setModelData(QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const override;

private:
    const CamSheet &m_sheet;
};

// The cams as a table whose rows are as high as those of the ruler beside it. Enter or a double click edits,
// Tab goes from start to stop and on to the next cam, Space toggles active, Delete clears.
class CamTable : public QTableView
{
    Q_OBJECT

public:
    CamTable(CamSheet &sheet, QWidget *parent = nullptr);

    // False while what is typed is bad; the focus is then back in its field.
    bool finishEditing();
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }
    static QList<KeyHelp> keys(); // that it handles

Q_SIGNALS:
    void inputChecked(const QString &wrong); // empty: good, or given up

protected:
    QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    void fit();

    CamSheet &m_sheet;
    CamTableModel *m_model;
};

} // namespace codewheel
