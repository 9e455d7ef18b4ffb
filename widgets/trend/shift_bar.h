// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "history/archive.h"
#include "widgets/input/number_fields.h"

#include <QPointer>
#include <QWidget>

class QAction;
class QMenu;
class QToolButton;

namespace codewheel {

// Where a recording lies beside other curves: how much later it is shown than it was. Hidden without one.
class ShiftBar : public QWidget
{
    Q_OBJECT

public:
    explicit ShiftBar(QWidget *parent = nullptr);

    void setArchive(Archive *archive); // null: none
    Archive *archive() const { return m_archive; }
    // Which of the cursors there are.
    void setCursors(bool any, bool both);
    void showAnew(); // after it was shifted elsewhere

Q_SIGNALS:
    void beginWanted();  // where the other curves begin
    void cursorWanted(); // what is at cursor A, at cursor B
    void momentWanted(); // its encoders are to show the one at the cursor

private:
    QAction *add(QMenu &menu, const char *id, const QString &text, const QString &tip);

    QPointer<Archive> m_archive;
    DecimalField *m_shift;
    QToolButton *m_ways;
    QToolButton *m_moment;
    QAction *m_begin;
    QAction *m_cursor;
    QAction *m_asRecorded;
};

} // namespace codewheel
