// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QAction;
class QLineEdit;
class QWidget;

namespace codewheel {

// The mark at the end of a field while its input is no good; its sentence is the tooltip and the description
// for screen readers.
class InputMark
{
public:
    explicit InputMark(QLineEdit &field);

    void show(const QString &wrong); // empty: all is well
    // Shows the sentence also below the box the field is in, while it has the focus.
    static void tellBelow(QWidget &box, const QString &wrong);

private:
    QLineEdit &m_field;
    QAction *m_mark;
};

} // namespace codewheel
