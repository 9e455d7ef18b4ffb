// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/parameter.h"
#include "widgets/help/key_help.h"

#include <QTableView>

#include <optional>

namespace codewheel {

class ParameterModel;

// The view of a ParameterModel: one click or Enter edits a wanted value, and from there Tab goes on to the
// next one. One click or Enter on the heading of a folded group opens it.
class ParameterTable : public QTableView
{
    Q_OBJECT

public:
    explicit ParameterTable(ParameterModel &model, QWidget *parent = nullptr);

    // False while what is typed is bad; the focus is then back in its field.
    bool finishEditing();
    // In a field that is open, and not taken; empty: nothing.
    struct Typed
    {
        Parameter parameter;
        QString text;
    };
    std::optional<Typed> typed() const;
    void goOn(const Typed &typed); // opens the field again
    static QList<KeyHelp> keys();  // that it handles

Q_SIGNALS:
    void inputChecked(const QString &wrong); // empty: good, or given up

protected:
    QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override;
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void activateCell(const QModelIndex &index);
    void leaveSelectedAlone();
    void spanColumns();
    void fitColumns();
    bool hasWantedValue(int row) const;
    int longestName(const QFont &font) const;
    int widest(int column, int (*widthOf)(const QModelIndex &)) const;

    ParameterModel &m_model;
};

} // namespace codewheel
