// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/key_list.h"
#include "app/window/main_window.h"
#include "widgets/cams/cam_ruler.h"
#include "widgets/cams/cam_table.h"
#include "widgets/look/label_text.h"
#include "widgets/monitor/word_view.h"
#include "widgets/parameters/parameter_table.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>

#include <algorithm>
#include <map>
#include <set>

namespace codewheel {
namespace {

void addRow(KeyGroup &group, const QAction &action)
{
    QStringList keys;
    for (const QKeySequence &key : action.shortcuts())
        keys << key.toString(QKeySequence::NativeText);
    if (keys.isEmpty() || action.text().isEmpty())
        return;
    const KeyHelp row{keys.join(QStringLiteral(", ")), plainLabel(action.text())};
    const auto isSame = [&](const KeyHelp &other) {
        return other.keys == row.keys && other.what == row.what;
    };
    if (std::ranges::none_of(group.rows, isSame)) // there may be several views of the same kind
        group.rows.push_back(row);
}

void addMenu(std::vector<KeyGroup> &groups, std::set<const QAction *> &seen, const QMenu &menu,
             const QString &title)
{
    const std::size_t own = groups.size();
    groups.push_back({title, {}});
    for (const QAction *action : menu.actions()) {
        seen.insert(action);
        if (action->menu() != nullptr)
            addMenu(groups, seen, *action->menu(),
                    QStringLiteral("%1 > %2").arg(title, plainLabel(action->text())));
        else
            addRow(groups[own], *action);
    }
}

// Where a key that is in no menu works: in a panel, or on a page.
QString viewOf(const QAction &action)
{
    for (const QObject *each = action.parent(); each != nullptr; each = each->parent())
        if (const auto *dock = qobject_cast<const QDockWidget *>(each))
            return dock->windowTitle();
    const auto *view = qobject_cast<const QWidget *>(action.parent());
    if (view == nullptr || view->isWindow())
        return MainWindow::tr("The whole window");
    return view->accessibleName().isEmpty() ? MainWindow::tr("Pages in the middle") : view->accessibleName();
}

void addViews(std::vector<KeyGroup> &groups, const std::set<const QAction *> &seen, const QMainWindow &window)
{
    std::map<QString, KeyGroup> views;
    for (const QAction *action : window.findChildren<QAction *>())
        if (!seen.contains(action) && !action->shortcut().isEmpty()) {
            const QString view = viewOf(*action);
            views[view].title = view;
            addRow(views[view], *action);
        }
    for (auto &[name, group] : views)
        groups.push_back(std::move(group));
}

} // namespace

std::vector<KeyGroup> keysOf(const QMainWindow &window)
{
    std::vector<KeyGroup> groups;
    std::set<const QAction *> seen;
    for (const QAction *menu : window.menuBar()->actions())
        addMenu(groups, seen, *menu->menu(), plainLabel(menu->text()));
    addViews(groups, seen, window);
    const std::pair<QString, QList<KeyHelp>> answered[] = {
        {MainWindow::tr("Monitor"),
         {{keyNames({Qt::CTRL | Qt::Key_Return, Qt::CTRL | Qt::Key_Enter}), MainWindow::tr("Writes OUT")},
          {keyNames({Qt::Key_Escape}), MainWindow::tr("Discards what is staged")}}},
        {MainWindow::tr("Bits of a word"), WordView::keys()},
        {MainWindow::tr("Table of parameters"), ParameterTable::keys()},
        {MainWindow::tr("Ruler of the cams"), CamRuler::keys()},
        {MainWindow::tr("Table of the cams"), CamTable::keys()},
        {MainWindow::tr("Structure editor"),
         {{keyNames({QKeySequence::Find}), MainWindow::tr("Finds a device")},
          {keyNames({Qt::Key_Return, Qt::SHIFT | Qt::Key_Return}),
           MainWindow::tr("The next one found, or the one before")}}}};
    for (const auto &[title, rows] : answered)
        groups.push_back({title, rows});
    std::erase_if(groups, [](const KeyGroup &group) { return group.rows.isEmpty(); });
    return groups;
}

} // namespace codewheel
