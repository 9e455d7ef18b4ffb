// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/help/menu_list.h"
#include "app/window/look/page_place.h"
#include "app/window/palette/palette_action.h"
#include "app/window/palette/palette_entries.h"
#include "other_language.h"
#include "widgets/look/label_text.h"
#include "widgets/look/page.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>

#include <algorithm>

namespace codewheel {
namespace {

// Those that say what they do; the boxes and choices of a form are values, not commands.
std::vector<QAbstractButton *> commandsOf(const QWidget &part)
{
    std::vector<QAbstractButton *> commands;
    for (auto *button : part.findChildren<QAbstractButton *>()) {
        const bool isCommand =
            qobject_cast<QPushButton *>(button) != nullptr || qobject_cast<QToolButton *>(button) != nullptr;
        if (isCommand && !button->text().isEmpty() && button->isVisibleTo(&part))
            commands.push_back(button);
    }
    return commands;
}

const QMenu *menuOf(const QAbstractButton &button)
{
    if (const auto *push = qobject_cast<const QPushButton *>(&button))
        return push->menu();
    const auto *tool = qobject_cast<const QToolButton *>(&button);
    return tool != nullptr ? tool->menu() : nullptr;
}

bool isCommand(const QAction &action)
{
    return !action.isSeparator() && action.menu() == nullptr && action.isVisible() &&
           !action.text().isEmpty();
}

bool isIn(const std::vector<ListedMenu> &menus, QAction &action)
{
    return std::ranges::any_of(menus, [&action](const ListedMenu &menu) {
        return std::ranges::find(menu.actions, &action) != menu.actions.end();
    });
}

using ShowPanel = std::function<void(const QDockWidget &)>;

struct Where
{
    QString title;
    const QDockWidget *panel; // null: a page
};

PaletteEntry entryOf(QAbstractButton &button, const Where &where, const ShowPanel &show,
                     OtherLanguage &otherLanguage)
{
    const QPointer<QAbstractButton> its(&button); // it may go while the palette is open
    const QKeySequence letter = QKeySequence::mnemonic(button.text());
    const QKeySequence key = button.shortcut().isEmpty() ? letter : button.shortcut();
    return {.title = plainLabel(button.text()),
            .context = where.title,
            .key = key.toString(QKeySequence::NativeText),
            .does = button.toolTip(),
            .words = otherLanguage.of(plainLabel(button.text())),
            .icon = button.icon(),
            .run =
                [its, panel = QPointer<const QDockWidget>(where.panel), show] {
                    if (panel)
                        show(*panel);
                    if (!its)
                        return;
                    its->setFocus(Qt::ShortcutFocusReason);
                    its->click();
                },
            .state =
                [its] {
                    return its ? PaletteState{its->isEnabled(), its->toolTip()} : PaletteState{false};
                }};
}

PaletteEntry entryOf(QAction &action, const Where &where, const ShowPanel &show, OtherLanguage &otherLanguage)
{
    PaletteEntry entry = paletteEntry(action, where.title, otherLanguage);
    entry.run = [run = entry.run, panel = QPointer<const QDockWidget>(where.panel), show] {
        if (panel)
            show(*panel);
        run();
    };
    return entry;
}

} // namespace

std::vector<PaletteEntry> buttonEntries(const QMainWindow &window, const QStackedWidget &pages,
                                        const ShowPanel &show, OtherLanguage &otherLanguage)
{
    std::vector<PaletteEntry> entries;
    const std::vector<ListedMenu> menus = menusOf(window);
    // What is in the menus of the window, too, is found there.
    const auto add = [&](const QWidget &part, const Where &where) {
        for (QAbstractButton *button : commandsOf(part)) {
            entries.push_back(entryOf(*button, where, show, otherLanguage));
            const QMenu *menu = menuOf(*button);
            for (QAction *action : menu != nullptr ? menu->actions() : QList<QAction *>())
                if (isCommand(*action) && !isIn(menus, *action))
                    entries.push_back(entryOf(*action, where, show, otherLanguage));
        }
    };
    PagePlace::wantAll(window);
    if (const auto *page = qobject_cast<Page *>(pages.currentWidget()))
        add(*page, {page->title(), nullptr});
    for (const auto *panel : window.findChildren<QDockWidget *>(QString(), Qt::FindDirectChildrenOnly))
        add(*panel->widget(), {panel->windowTitle(), panel});
    return entries;
}

} // namespace codewheel
