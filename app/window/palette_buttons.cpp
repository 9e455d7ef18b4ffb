// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/palette_buttons.h"

#include "widgets/look/label_text.h"
#include "widgets/look/page.h"

#include <QCheckBox>
#include <QDockWidget>
#include <QPointer>
#include <QPushButton>
#include <QStackedWidget>
#include <QToolButton>

#include <utility>

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

} // namespace

PaletteButtons::PaletteButtons(const QMainWindow &window, const QStackedWidget &pages, ShowPanel show)
    : m_window(window)
    , m_pages(pages)
    , m_show(std::move(show))
{}

void PaletteButtons::begin()
{
    m_isGiven = false;
}

std::vector<PaletteEntry> PaletteButtons::next()
{
    std::vector<PaletteEntry> entries;
    if (std::exchange(m_isGiven, true))
        return entries;
    if (const auto *page = qobject_cast<Page *>(m_pages.currentWidget()))
        for (QAbstractButton *button : commandsOf(*page))
            entries.push_back(entryOf(*button, page->title(), nullptr));
    for (const auto *panel : m_window.findChildren<QDockWidget *>(QString(), Qt::FindDirectChildrenOnly))
        for (QAbstractButton *button : commandsOf(*panel->widget()))
            entries.push_back(entryOf(*button, panel->windowTitle(), panel));
    return entries;
}

PaletteEntry PaletteButtons::entryOf(QAbstractButton &button, const QString &where,
                                     const QDockWidget *panel) const
{
    const QPointer<QAbstractButton> its(&button); // it may go while the palette is open
    const QKeySequence letter = QKeySequence::mnemonic(button.text());
    const QKeySequence key = button.shortcut().isEmpty() ? letter : button.shortcut();
    return {.title = plainLabel(button.text()),
            .context = where,
            .key = key.toString(QKeySequence::NativeText),
            .words = button.toolTip(),
            .icon = button.icon(),
            .run =
                [its, panel = QPointer<const QDockWidget>(panel), show = m_show] {
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

} // namespace codewheel
