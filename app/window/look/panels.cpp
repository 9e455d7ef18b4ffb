// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/look/panels.h"

#include "app/window/look/bottom_fold.h"
#include "widgets/help/help_topic.h"

#include <QAction>
#include <QDockWidget>
#include <QLocale>
#include <QMainWindow>
#include <QStackedWidget>
#include <QTimer>

#include <algorithm>
#include <functional>

namespace codewheel {
namespace {

constexpr int narrowColumn = 336; // so that a monitor beside it has its 32 bits in a row
constexpr int usualColumn = 370;
constexpr int wideColumn = 420;

// What gets the focus in a panel: itself, or the first control in it.
QWidget *firstFocus(QWidget &content)
{
    if (content.focusProxy() != nullptr || (content.focusPolicy() & Qt::TabFocus) != 0)
        return &content;
    for (QWidget *each = content.nextInFocusChain(); each != &content; each = each->nextInFocusChain())
        if (content.isAncestorOf(each) && each->isVisible() && each->isEnabled() &&
            (each->focusPolicy() & Qt::TabFocus) != 0)
            return each;
    return &content;
}

// A folded panel is not visible: its key brings it back.
QAction *makePanelAction(QDockWidget &panel, BottomFold &fold, const std::function<void()> &opened)
{
    auto *action = new QAction(panel.windowTitle(), &panel);
    action->setCheckable(true);
    QObject::connect(&panel, &QDockWidget::visibilityChanged, action, &QAction::setChecked);
    QObject::connect(action, &QAction::triggered, &panel, [&panel, &fold, action, opened](bool show) {
        if (!show && !fold.isFolded(panel)) {
            panel.close();
            return;
        }
        if (fold.isFolded(panel))
            fold.unfold();
        action->setChecked(true);
        const bool wasClosed = panel.isHidden();
        panel.show();
        panel.raise();
        if (wasClosed)
            opened();
        firstFocus(*panel.widget())->setFocus(Qt::ShortcutFocusReason);
    });
    return action;
}

} // namespace

Panels::Panels(QMainWindow &window)
    : m_window(window)
    , m_fold(*new BottomFold(window))
{}

const Panels::Dock &Panels::find(const Panel &panel) const
{
    return *std::ranges::find(m_docks, &panel, &Dock::panel);
}

QAction *Panels::add(const Panel &panel, QWidget *content)
{
    auto *dock = new QDockWidget(tr(panel.title), &m_window);
    dock->setObjectName(QLatin1String(panel.name));
    dock->setWidget(content);
    setHelpTopic(*dock, panel.topic);
    content->setAutoFillBackground(true); // so that a change in it does not repaint the dock
    m_docks.push_back({&panel, dock, qobject_cast<QStackedWidget *>(content)});
    QAction *toggle = makePanelAction(*dock, m_fold, [this, dock, &panel] {
        if (!panel.isShownAtFirst) // its place is as high as others need it
            giveHeight(*dock, m_window.height() / 2);
    });
    toggle->setToolTip(tr("Shows or hides the panel \"%1\"").arg(dock->windowTitle()));
    toggle->setShortcut(panel.key);
    return toggle;
}

QAction *Panels::addPaged(const Panel &panel)
{
    return add(panel, new QStackedWidget(&m_window));
}

void Panels::addPage(const Panel &panel, QWidget *page)
{
    find(panel).pages->addWidget(page);
}

void Panels::showPage(const Panel &panel, QWidget *page)
{
    find(panel).pages->setCurrentWidget(page);
}

void Panels::tellWhose(const Panel &panel, const QString &name)
{
    const QString title = tr(panel.title);
    dock(panel)->setWindowTitle(name.isEmpty() ? title : QStringLiteral("%1 (%2)").arg(title, name));
}

void Panels::setUnseen(const Panel &panel, int count)
{
    tellWhose(panel, count == 0 ? QString() : QLocale().toString(count));
}

void Panels::show(const QDockWidget &dock)
{
    for (const Dock &each : m_docks)
        if (each.dock == &dock)
            show(*each.panel);
}

void Panels::show(const Panel &panel)
{
    QDockWidget *its = dock(panel);
    if (m_fold.isFolded(*its))
        m_fold.unfold();
    its->show();
    its->raise();
    giveHeight(*its, m_window.height() / 3);
}

// At the bottom. One that is already higher stays so.
void Panels::giveHeight(QDockWidget &dock, int height)
{
    if (!dock.isFloating() && m_window.dockWidgetArea(&dock) == Qt::BottomDockWidgetArea &&
        dock.height() < height)
        m_window.resizeDocks({&dock}, {height}, Qt::Vertical);
}

void Panels::splitBelow(const Panel &above, const Panel &below)
{
    m_window.splitDockWidget(dock(above), dock(below), Qt::Vertical);
}

// Tabbed, the first one in front.
void Panels::stack(const Panel &front, std::initializer_list<const Panel *> panels)
{
    for (const Panel *behind : panels)
        m_window.tabifyDockWidget(dock(front), dock(*behind));
}

void Panels::stackBehind(const Panel &front, Panel::Behind which)
{
    for (const Dock &its : m_docks)
        if (its.panel->behind == which)
            m_window.tabifyDockWidget(dock(front), its.dock);
}

void Panels::setWidths(int left, int right)
{
    m_window.resizeDocks({dock(panel::structure), dock(panel::parameters)}, {left, right}, Qt::Horizontal);
}

void Panels::setHeights(const Panel &above, int height, const Panel &below, int belowHeight)
{
    m_window.resizeDocks({dock(above), dock(below)}, {height, belowHeight}, Qt::Vertical);
}

void Panels::arrange(WindowSize size)
{
    for (const Dock &its : m_docks) // while they move, the window would grow to fit them
        m_window.removeDockWidget(its.dock);
    m_window.addDockWidget(Qt::LeftDockWidgetArea, dock(panel::structure));
    m_window.addDockWidget(Qt::BottomDockWidgetArea, dock(panel::messages));
    switch (size) {
    case WindowSize::narrow:
        arrangeInOneColumn();
        break;
    case WindowSize::low:
        arrangeInLowColumns();
        break;
    case WindowSize::usual:
        arrangeInColumns(usualColumn);
        break;
    case WindowSize::wide:
        arrangeInColumns(wideColumn);
        break;
    }
    m_window.resizeDocks({dock(panel::trace)}, {size == WindowSize::wide ? 240 : 170}, Qt::Vertical);
}

// The tree stays in sight, with the panels of the chosen encoder below it. The state of a bus is wide enough
// at the bottom, where its tabs have room in any language.
void Panels::arrangeInOneColumn()
{
    using namespace panel;
    stack(messages, {&trace, &sequence});
    stackBehind(messages, Panel::Behind::messages);
    stackBehind(messages, Panel::Behind::state);
    splitBelow(structure, parameters);
    stack(parameters, {&dial, &device, &training});
    showAll();
    setWidths(narrowColumn, narrowColumn);
    setHeights(structure, 200, parameters, 340);
}

// What one watches all the time stays in sight: the dial below the tree.
void Panels::arrangeInLowColumns()
{
    using namespace panel;
    stack(messages, {&trace, &sequence});
    stackBehind(messages, Panel::Behind::messages);
    m_window.addDockWidget(Qt::RightDockWidgetArea, dock(parameters));
    splitBelow(structure, dial);
    stackBehind(dial, Panel::Behind::state);
    stack(parameters, {&device, &training});
    showAll();
    setWidths(300, 300);
    setHeights(structure, 300, dial, 240);
}

void Panels::arrangeInColumns(int width)
{
    using namespace panel;
    if (width == wideColumn) { // messages and trace are read side by side
        m_window.splitDockWidget(dock(messages), dock(trace), Qt::Horizontal);
        stack(messages, {&sequence});
        stackBehind(trace, Panel::Behind::messages);
    } else {
        stack(messages, {&trace, &sequence});
        stackBehind(messages, Panel::Behind::messages);
    }
    m_window.addDockWidget(Qt::RightDockWidgetArea, dock(parameters));
    splitBelow(structure, training);
    stackBehind(training, Panel::Behind::state);
    splitBelow(parameters, dial);
    stack(parameters, {&device});
    showAll();
    setWidths(width, width - 60);
    if (width == wideColumn)
        m_window.resizeDocks({dock(messages), dock(trace)}, {500, 500}, Qt::Horizontal);
    setHeights(parameters, 430, dial, 300);
    setHeights(structure, 320, training,
               420); // the devices of the training bus; the rest is for operating them
}

void Panels::showAll()
{
    for (const Dock &its : m_docks)
        its.dock->setVisible(its.panel->isShownAtFirst);
}

void Panels::raiseFirst()
{
    using namespace panel;
    // Parameters last: in a low or narrow window they share a place with other panels.
    for (const Panel *first : {&trace, &training, &dial, &parameters})
        raise(*first);
}

// Once there are tab bars.
void Panels::raise(const Panel &panel)
{
    QTimer::singleShot(0, dock(panel), [its = dock(panel)] { its->raise(); });
}

} // namespace codewheel
