// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/help/key_list.h"

#include "app/window/help/menu_list.h"
#include "app/window/kinds/window_kinds.h"
#include "app/window/look/page_place.h"
#include "app/window/main_window.h"
#include "widgets/cams/cam_program_strip.h"
#include "widgets/cams/cam_ruler.h"
#include "widgets/cams/cam_table.h"
#include "widgets/look/label_text.h"
#include "widgets/monitor/word_view.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/structure/tree_filter.h"
#include "widgets/trend/trend_chart.h"

#include <QAction>
#include <QDockWidget>

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

void addMenus(std::vector<KeyGroup> &groups, std::set<const QAction *> &seen, const QMainWindow &window)
{
    for (const ListedMenu &menu : menusOf(window)) {
        groups.push_back({menu.path, {}});
        for (const QAction *action : menu.actions) {
            seen.insert(action);
            addRow(groups.back(), *action);
        }
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

QList<KeyHelp> keysOfMonitors()
{
    return {{keyNames({Qt::CTRL | Qt::Key_Return, Qt::CTRL | Qt::Key_Enter}), MainWindow::tr("Writes OUT")},
            {keyNames({Qt::Key_Escape}), MainWindow::tr("Discards what is staged")},
            {keyNames({Qt::Key_Return}),
             MainWindow::tr("Selects the word that was typed, or sends it (At once)")},
            {keyNames({QKeySequence::Copy}), MainWindow::tr("Copies a number that has the focus")}};
}

QList<KeyHelp> keysOfFields()
{
    return {{keyNames({Qt::Key_Return}), MainWindow::tr("Takes what was typed")},
            {keyNames({Qt::Key_Escape}), MainWindow::tr("Brings back what stood there before")},
            {keyNames({Qt::Key_Up, Qt::Key_Down}), MainWindow::tr("Makes a number larger or smaller")}};
}

// Where no action answers them.
void addAnswered(std::vector<KeyGroup> &groups)
{
    const QString escape = keyNames({Qt::Key_Escape});
    const std::pair<QString, QList<KeyHelp>> answered[] = {
        {MainWindow::tr("Monitor"), keysOfMonitors()},
        {MainWindow::tr("Bits of a word"), WordView::keys()},
        {MainWindow::tr("Table of parameters"), ParameterTable::keys()},
        {MainWindow::tr("Ruler of the cams"), CamRuler::keys()},
        {MainWindow::tr("Table of the cams"), CamTable::keys()},
        {MainWindow::tr("Programs of the cams"), CamProgramStrip::keys()},
        {MainWindow::tr("Trend"), TrendChart::keys()},
        {MainWindow::tr("Filter of the bus structure"), TreeFilter::keys()},
        {MainWindow::tr("Messages, trace, terminal"),
         {{keyNames({Qt::SHIFT | Qt::Key_F10}), MainWindow::tr("Opens the menu of the row")}}},
        {MainWindow::tr("Structure editor"),
         {{keyNames({QKeySequence::Find}), MainWindow::tr("Finds a device")},
          {keyNames({Qt::Key_Return, Qt::SHIFT | Qt::Key_Return}),
           MainWindow::tr("The next one found, or the one before")},
          {escape, MainWindow::tr("Closes the insert panel")}}},
        {MainWindow::tr("Recent projects"),
         {{keyNames({Qt::Key_Return}), MainWindow::tr("Opens the project")},
          {keyNames({QKeySequence::Delete}), MainWindow::tr("Takes it off the list")}}},
        {MainWindow::tr("Fields"), keysOfFields()},
        {MainWindow::tr("Pages, reviews, questions"), {{escape, MainWindow::tr("Closes it, or goes back")}}}};
    for (const auto &[title, rows] : answered)
        groups.push_back({title, rows});
    for (const WindowKind *kind : windowKinds())
        if (kind->keys != nullptr)
            groups.push_back(kind->keys());
}

} // namespace

std::vector<KeyGroup> keysOf(const QMainWindow &window)
{
    std::vector<KeyGroup> groups;
    std::set<const QAction *> seen;
    PagePlace::wantAll(window);
    addMenus(groups, seen, window);
    addViews(groups, seen, window);
    addAnswered(groups);
    std::erase_if(groups, [](const KeyGroup &group) { return group.rows.isEmpty(); });
    return groups;
}

} // namespace codewheel
