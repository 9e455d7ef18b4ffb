// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QKeySequence>

#include <map>

class QAction;
class QDockWidget;
class QMainWindow;
class QStackedWidget;

namespace codewheel {

enum class Panel {
    structure,
    training, // this and those from master on hold a page for each bus
    parameters,
    dial,
    messages,
    trace,
    sequence,
    device,
    master,
    terminal,
    line,
};

// The panels of the main window, in docks.
class Panels
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Panels)

public:
    explicit Panels(QMainWindow &window)
        : m_window(window)
    {}

    // Each is added once before all else. Gives the action that shows a panel and gives it the keys, also
    // when it is behind another one, and hides it when it is in sight.
    QAction *add(Panel panel, QWidget *content);
    QAction *addPaged(Panel panel);
    void addPage(Panel panel, QWidget *page);
    void showPage(Panel panel, QWidget *page);

    void show(Panel panel); // in front, with some rows of it in sight
    // Where they are at first in a window of this height.
    void arrange();
    // Brings those to the front that are looked at first.
    void raiseFirst();

private:
    QDockWidget *dock(Panel panel) const { return m_docks.at(panel); }
    void splitBelow(Panel above, Panel below);
    void stack(std::initializer_list<Panel> panels);

    QMainWindow &m_window;
    std::map<Panel, QDockWidget *> m_docks;
    std::map<Panel, QStackedWidget *> m_pages;
};

} // namespace codewheel
