// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QAction;
class QLineEdit;

namespace codewheel {

// The mark at the end of a field while what stands in it is no good; its sentence is tooltip and description
// for screen readers.
class InputMark
{
public:
    explicit InputMark(QLineEdit &field);

    void show(const QString &wrong); // empty: all is well

private:
    QLineEdit &m_field;
    QAction *m_mark;
};

} // namespace codewheel
