// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/look/bottom_fold.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QMouseEvent>
#include <QStyle>
#include <QTabBar>

#include <algorithm>
#include <utility>

namespace codewheel {

BottomFold::BottomFold(QMainWindow &window)
    : QObject(&window)
    , m_window(window)
{}

void BottomFold::fold()
{
    if (std::exchange(m_isFolded, true))
        return;
    for (auto *panel : m_window.findChildren<QDockWidget *>(QString(), Qt::FindDirectChildrenOnly))
        if (!panel->isFloating() && m_window.dockWidgetArea(panel) == Qt::BottomDockWidgetArea)
            foldPanel(*panel);
    for (auto *tabs : m_window.findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly))
        tabs->installEventFilter(this);
    Q_EMIT foldedChanged(true);
}

// A panel on its own has no tab: its title stays, and its content takes no height.
void BottomFold::foldPanel(QDockWidget &panel)
{
    m_folded[&panel] = panel.isVisible() ? panel.height() : 0;
    const auto beside = m_window.tabifiedDockWidgets(&panel);
    const bool hasTab =
        std::ranges::any_of(beside, [](const QDockWidget *other) { return !other->isHidden(); });
    panel.widget()->setVisible(hasTab);
    panel.widget()->setEnabled(false); // nor does a key reach it
    panel.setMaximumHeight(hasTab ? 0 : panel.style()->pixelMetric(QStyle::PM_TitleBarHeight));
    panel.installEventFilter(this);
}

void BottomFold::unfold()
{
    if (!std::exchange(m_isFolded, false))
        return;
    QList<QDockWidget *> panels;
    QList<int> heights;
    const auto folded = std::exchange(m_folded, {});
    for (auto *panel : m_window.findChildren<QDockWidget *>(QString(), Qt::FindDirectChildrenOnly)) {
        const auto height = folded.constFind(panel);
        if (height == folded.constEnd())
            continue;
        panel->removeEventFilter(this);
        panel->setMaximumHeight(QWIDGETSIZE_MAX);
        panel->widget()->setEnabled(true);
        panel->widget()->show();
        if (*height > 0 && !panel->isFloating()) {
            panels << panel;
            heights << *height;
        }
    }
    m_window.resizeDocks(panels, heights, Qt::Vertical);
    Q_EMIT foldedChanged(false);
}

bool BottomFold::eventFilter(QObject *watched, QEvent *event)
{
    if (!m_isFolded || event->type() != QEvent::MouseButtonPress)
        return QObject::eventFilter(watched, event);
    const auto *tabs = qobject_cast<QTabBar *>(watched);
    if (tabs == nullptr || isOfFolded(*tabs, static_cast<QMouseEvent *>(event)->position().toPoint()))
        unfold();
    return QObject::eventFilter(watched, event);
}

bool BottomFold::isOfFolded(const QTabBar &tabs, const QPoint &pressed) const
{
    const int tab = tabs.tabAt(pressed);
    return tab >= 0 && std::ranges::any_of(m_folded.keys(), [&](const QDockWidget *panel) {
               return panel->windowTitle() == tabs.tabText(tab);
           });
}

} // namespace codewheel
