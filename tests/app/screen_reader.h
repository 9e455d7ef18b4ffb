// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAccessible>
#include <QString>

class QWidget;

namespace codewheel::test {

// Uses a window as a screen reader does: finds what is there by name only, presses, toggles, types, reads.
// Anything that cannot be found or done fails the test.
class ScreenReader
{
public:
    explicit ScreenReader(QWidget &window);

    QAccessibleInterface *find(QAccessible::Role role, const QString &name) const;
    void press(const QString &name) const;
    void toggle(const QString &name) const;
    bool isChecked(const QString &name) const;
    void type(const QString &name, const QString &text) const;
    QString read(const QString &name) const;

private:
    QWidget &m_window;
};

} // namespace codewheel::test
