// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/panels.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QStackedWidget>
#include <QTimer>

namespace codewheel {
namespace {

constexpr int lowWindow = 720; // below, there is no room for all panels above each other

struct PanelRow
{
    Panel panel;
    const char *name; // by which settings and tests know its dock
    const char *title;
    QKeyCombination key;
};

constexpr PanelRow panelRows[] = {
    {Panel::structure, "structureDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Bus structure"),
     Qt::ALT | Qt::Key_1},
    {Panel::training, "trainingDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Training"),
     Qt::ALT | Qt::Key_2},
    {Panel::parameters, "parametersDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Parameters"),
     Qt::ALT | Qt::Key_3},
    {Panel::dial, "dialDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Encoder"), Qt::ALT | Qt::Key_4},
    {Panel::messages, "messagesDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Messages"),
     Qt::ALT | Qt::Key_5},
    {Panel::trace, "traceDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Handshake trace"),
     Qt::ALT | Qt::Key_6},
    {Panel::sequence, "sequenceDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Sequence"),
     Qt::ALT | Qt::Key_7},
    {Panel::device, "deviceDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Device"), Qt::ALT | Qt::Key_8},
    {Panel::master, "masterDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Master"), Qt::ALT | Qt::Key_9},
    {Panel::terminal, "terminalDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Line terminal"),
     Qt::ALT | Qt::Key_0},
    {Panel::line, "lineDock", QT_TRANSLATE_NOOP("codewheel::Panels", "Serial line"),
     Qt::ALT | Qt::SHIFT | Qt::Key_L},
};

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

} // namespace

QAction *Panels::add(Panel panel, QWidget *content)
{
    const PanelRow &row = panelRows[static_cast<std::size_t>(panel)];
    auto *dock = new QDockWidget(tr(row.title), &m_window);
    dock->setObjectName(QLatin1String(row.name));
    dock->setWidget(content);
    content->setAutoFillBackground(true); // so that what changes in it does not paint the dock
    m_docks[panel] = dock;
    QAction *toggle = makePanelAction(*dock);
    toggle->setToolTip(tr("Shows or hides the panel \"%1\"").arg(dock->windowTitle()));
    toggle->setShortcut(row.key);
    return toggle;
}

QAction *Panels::addPaged(Panel panel)
{
    m_pages[panel] = new QStackedWidget(&m_window);
    return add(panel, m_pages[panel]);
}

void Panels::addPage(Panel panel, QWidget *page)
{
    m_pages.at(panel)->addWidget(page);
}

void Panels::showPage(Panel panel, QWidget *page)
{
    m_pages.at(panel)->setCurrentWidget(page);
}

// Whoever has more room for it keeps that.
void Panels::show(Panel panel)
{
    QDockWidget *its = dock(panel);
    its->show();
    its->raise();
    const int wanted = m_window.height() / 3;
    if (!its->isFloating() && m_window.dockWidgetArea(its) == Qt::BottomDockWidgetArea &&
        its->height() < wanted)
        m_window.resizeDocks({its}, {wanted}, Qt::Vertical);
}

void Panels::splitBelow(Panel above, Panel below)
{
    m_window.splitDockWidget(dock(above), dock(below), Qt::Vertical);
}

// Behind each other, the first in front.
void Panels::stack(std::initializer_list<Panel> panels)
{
    for (const Panel *behind = panels.begin() + 1; behind != panels.end(); ++behind)
        m_window.tabifyDockWidget(dock(behind[-1]), dock(*behind));
}

void Panels::arrange()
{
    using enum Panel;
    const bool isLow = m_window.height() < lowWindow;
    for (const auto &[panel, its] : m_docks) // while they move, the window would grow to hold them
        m_window.removeDockWidget(its);
    m_window.addDockWidget(Qt::LeftDockWidgetArea, dock(structure));
    m_window.addDockWidget(Qt::RightDockWidgetArea, dock(parameters));
    m_window.addDockWidget(Qt::BottomDockWidgetArea, dock(messages));
    stack({messages, trace, sequence, terminal});
    if (isLow) { // what one looks at all the time stays in sight: the dial below the tree
        splitBelow(structure, dial);
        stack({dial, master, line});
        stack({parameters, device, training});
    } else {
        splitBelow(structure, training);
        stack({training, master, line});
        splitBelow(parameters, dial);
        stack({parameters, device});
    }
    for (const auto &[panel, its] : m_docks)
        its->show();

    // In a low window, which is narrow as well, a monitor between them has to have its 16 bits in a row.
    m_window.resizeDocks({dock(structure), dock(parameters)}, {isLow ? 210 : 370, isLow ? 290 : 310},
                         Qt::Horizontal);
    m_window.resizeDocks({dock(isLow ? structure : parameters), dock(dial)},
                         {isLow ? 300 : 430, isLow ? 240 : 300}, Qt::Vertical);
    if (!isLow) // the devices of the training bus, and all the rest for what one does with them
        m_window.resizeDocks({dock(structure), dock(training)}, {320, 420}, Qt::Vertical);
    m_window.resizeDocks({dock(trace)}, {170}, Qt::Vertical);
}

void Panels::raiseFirst()
{
    using enum Panel;
    // the parameters last: in a low window they share the place of the training panel
    for (const Panel first : {trace, training, dial, parameters})
        QTimer::singleShot(0, dock(first), [its = dock(first)] { its->raise(); }); // once there are tab bars
}

} // namespace codewheel
