// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLineEdit;
class QMainWindow;
class QTreeWidget;

namespace codewheel {

// Help > Keys: all keys of the window in groups, and a field that filters them.
class KeySheet : public QDialog
{
    Q_OBJECT

public:
    // Shows it beside the window, which stays usable; there is only one.
    static void show(QMainWindow &window);

private:
    explicit KeySheet(QMainWindow &window);
    void fill(const QMainWindow &window);
    void filter();

    QLineEdit *m_search;
    QTreeWidget *m_keys;
};

} // namespace codewheel
