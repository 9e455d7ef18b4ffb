// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/look/window_size.h"

#include <QCoreApplication>
#include <QKeySequence>

#include <vector>

class QAction;
class QDockWidget;
class QMainWindow;
class QStackedWidget;

namespace codewheel {

class BottomFold;

// A panel of the main window; there is one object for each.
struct Panel
{
    enum class Behind { none, messages, state }; // the panels it is initially tabbed behind

    const char *name; // identifies its dock in settings and tests
    const char *title;
    QKeyCombination key;
    const char *topic; // in the manual, see setHelpTopic()
    Behind behind = Behind::none;
    bool isShownAtFirst = true; // otherwise once something asks for it
};

// The panels of the window whatever the buses; a kind of bus adds its own (WindowKind).
namespace panel {

inline constexpr Panel structure{"structureDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Bus structure"),
                                 Qt::ALT | Qt::Key_1, "README.md#the-window"};
inline constexpr Panel training{// with a page for each bus
                                "trainingDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Training"),
                                Qt::ALT | Qt::Key_2, "training.md"};
inline constexpr Panel parameters{"parametersDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Parameters"),
                                  Qt::ALT | Qt::Key_3, "parameters.md"};
inline constexpr Panel dial{"dialDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Encoder"),
                            Qt::ALT | Qt::Key_4, "dial.md"};
inline constexpr Panel messages{"messagesDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Messages"),
                                Qt::ALT | Qt::Key_5, "messages.md"};
inline constexpr Panel trace{"traceDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Handshake trace"),
                             Qt::ALT | Qt::Key_6, "sequence-and-trace.md#handshake-trace"};
inline constexpr Panel sequence{"sequenceDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Sequence"),
                                Qt::ALT | Qt::Key_7, "sequence-and-trace.md#sequence"};
inline constexpr Panel device{"deviceDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Device"),
                              Qt::ALT | Qt::Key_8, "device.md"};

} // namespace panel

// The panels of the main window, in docks.
class Panels
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::Panels)

public:
    explicit Panels(QMainWindow &window);

    // Each is added once, before anything else. Returns the action that shows a panel and gives it the focus,
    // even if it is behind another one, and hides it if it is visible.
    QAction *add(const Panel &panel, QWidget *content);
    QAction *addPaged(const Panel &panel);
    void addPage(const Panel &panel, QWidget *page);
    void showPage(const Panel &panel, QWidget *page);
    void tellWhose(const Panel &panel, const QString &name); // in its title; empty: only one bus

    // The number of unseen items, in its title; 0: none.
    void setUnseen(const Panel &panel, int count);
    void show(const Panel &panel); // in front, with some of its rows in sight
    void show(const QDockWidget &dock);
    BottomFold &fold() { return m_fold; }
    // The initial arrangement in a window of this size.
    void arrange(WindowSize size);
    // Brings the panels one looks at first to the front.
    void raiseFirst();
    void raise(const Panel &panel); // in front of all that were before

private:
    struct Dock
    {
        const Panel *panel;
        QDockWidget *dock;
        QStackedWidget *pages; // null: one panel for all buses
    };
    const Dock &find(const Panel &panel) const;
    QDockWidget *dock(const Panel &panel) const { return find(panel).dock; }
    void arrangeInOneColumn();
    void arrangeInLowColumns();
    void arrangeInColumns(int width);
    void giveHeight(QDockWidget &dock, int height);
    void splitBelow(const Panel &above, const Panel &below);
    void showAll();
    void setWidths(int left, int right);
    void setHeights(const Panel &above, int height, const Panel &below, int belowHeight);
    void stack(const Panel &front, std::initializer_list<const Panel *> panels);
    void stackBehind(const Panel &front, Panel::Behind which);

    QMainWindow &m_window;
    BottomFold &m_fold;
    std::vector<Dock> m_docks; // in the order in which they were added
};

} // namespace codewheel
