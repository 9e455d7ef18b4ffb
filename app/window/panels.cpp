// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QTimer>

#include <array>

namespace codewheel {
namespace {

constexpr int lowWindow = 720; // below, there is no room for all panels above each other

struct Panels
{
    explicit Panels(const QMainWindow &window)
        : structure(window.findChild<QDockWidget *>(QStringLiteral("structureDock")))
        , training(window.findChild<QDockWidget *>(QStringLiteral("trainingDock")))
        , parameters(window.findChild<QDockWidget *>(QStringLiteral("parametersDock")))
        , device(window.findChild<QDockWidget *>(QStringLiteral("deviceDock")))
        , dial(window.findChild<QDockWidget *>(QStringLiteral("dialDock")))
        , messages(window.findChild<QDockWidget *>(QStringLiteral("messagesDock")))
        , trace(window.findChild<QDockWidget *>(QStringLiteral("traceDock")))
        , sequence(window.findChild<QDockWidget *>(QStringLiteral("sequenceDock")))
        , master(window.findChild<QDockWidget *>(QStringLiteral("masterDock")))
        , terminal(window.findChild<QDockWidget *>(QStringLiteral("terminalDock")))
        , line(window.findChild<QDockWidget *>(QStringLiteral("lineDock")))
    {}

    std::array<QDockWidget *, 11> all() const
    {
        return {structure, training, parameters, device,   dial, messages,
                trace,     sequence, master,     terminal, line};
    }

    QDockWidget *structure;
    QDockWidget *training;
    QDockWidget *parameters;
    QDockWidget *device;
    QDockWidget *dial;
    QDockWidget *messages;
    QDockWidget *trace;
    QDockWidget *sequence;
    QDockWidget *master;
    QDockWidget *terminal;
    QDockWidget *line;
};

void arrangeSides(QMainWindow &window, const Panels &panels)
{
    window.splitDockWidget(panels.structure, panels.training, Qt::Vertical);
    window.tabifyDockWidget(panels.training, panels.master);
    window.tabifyDockWidget(panels.master, panels.line);
    window.splitDockWidget(panels.parameters, panels.dial, Qt::Vertical);
    window.tabifyDockWidget(panels.parameters, panels.device);
}

// What one looks at all the time stays in sight: the dial below the tree, the parameters in all the height.
void arrangeLowSides(QMainWindow &window, const Panels &panels)
{
    window.splitDockWidget(panels.structure, panels.dial, Qt::Vertical);
    window.tabifyDockWidget(panels.dial, panels.master);
    window.tabifyDockWidget(panels.master, panels.line);
    window.tabifyDockWidget(panels.parameters, panels.device);
    window.tabifyDockWidget(panels.device, panels.training);
}

// Where the keys go in a panel: to itself, or to the first control in it.
QWidget *firstFocus(QWidget &content)
{
    if (content.focusProxy() != nullptr || content.focusPolicy() != Qt::NoFocus)
        return &content;
    for (QWidget *each = content.nextInFocusChain(); each != &content; each = each->nextInFocusChain())
        if (content.isAncestorOf(each) && each->isVisible() && each->isEnabled() &&
            (each->focusPolicy() & Qt::TabFocus) != 0)
            return each;
    return &content;
}

} // namespace

void arrangePanels(QMainWindow &window)
{
    const Panels panels(window);
    const bool isLow = window.height() < lowWindow;
    for (QDockWidget *panel : panels.all()) // while they move, the window would grow to hold them
        window.removeDockWidget(panel);
    window.addDockWidget(Qt::LeftDockWidgetArea, panels.structure);
    window.addDockWidget(Qt::RightDockWidgetArea, panels.parameters);
    window.addDockWidget(Qt::BottomDockWidgetArea, panels.messages);
    window.tabifyDockWidget(panels.messages, panels.trace);
    window.tabifyDockWidget(panels.trace, panels.sequence);
    window.tabifyDockWidget(panels.sequence, panels.terminal);
    if (isLow)
        arrangeLowSides(window, panels);
    else
        arrangeSides(window, panels);
    for (QDockWidget *panel : panels.all())
        panel->show();

    // In a low window, which is narrow as well, a monitor between them has to have its 16 bits in a row.
    window.resizeDocks({panels.structure, panels.parameters}, {isLow ? 210 : 370, isLow ? 290 : 310},
                       Qt::Horizontal);
    window.resizeDocks({isLow ? panels.structure : panels.parameters, panels.dial},
                       {isLow ? 300 : 430, isLow ? 240 : 300}, Qt::Vertical);
    if (!isLow) // the devices of the training bus, and all the rest for what one does with them
        window.resizeDocks({panels.structure, panels.training}, {320, 420}, Qt::Vertical);
    window.resizeDocks({panels.trace}, {170}, Qt::Vertical);
}

void raiseFirstPanels(QMainWindow &window)
{
    QTimer::singleShot(0, &window, [panels = Panels(window)] { // once there are tab bars
        // the parameters last: in a low window they share the place of the training panel
        for (QDockWidget *first : {panels.trace, panels.training, panels.dial, panels.parameters})
            first->raise();
    });
}

QAction *makePanelAction(QDockWidget &panel)
{
    auto *action = new QAction(panel.windowTitle(), &panel);
    action->setCheckable(true);
    QObject::connect(&panel, &QDockWidget::visibilityChanged, action, &QAction::setChecked);
    QObject::connect(action, &QAction::triggered, &panel, [&panel](bool show) {
        if (!show) {
            panel.close();
            return;
        }
        panel.show();
        panel.raise();
        firstFocus(*panel.widget())->setFocus(Qt::ShortcutFocusReason);
    });
    return action;
}

} // namespace codewheel
