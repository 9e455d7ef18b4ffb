// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/palette/palette_actions.h"

#include "app/window/help/menu_list.h"
#include "app/window/palette/palette_action.h"
#include "widgets/look/label_text.h"

#include <QAction>

#include <utility>

namespace codewheel {
namespace {

// In every language: its text is only taken where it has neither name nor key.
QString idOf(const QAction &action)
{
    const QString key = action.shortcut().toString(QKeySequence::PortableText);
    return QStringLiteral("action:") + (!action.objectName().isEmpty() ? action.objectName()
                                        : !key.isEmpty()               ? key
                                                                       : plainLabel(action.text()));
}

// One that can be checked says whether it is.
QString placeOf(const QAction &action, const QString &menu)
{
    if (!action.isCheckable() || !action.isChecked())
        return menu;
    return QStringLiteral("%1 \u2713").arg(menu);
}

} // namespace

PaletteActions::PaletteActions(const QMainWindow &window, QList<QAction *> usual,
                               OtherLanguage &otherLanguage)
    : m_window(window)
    , m_usual(std::move(usual))
    , m_otherLanguage(otherLanguage)
{}

void PaletteActions::begin()
{
    m_isGiven = false;
}

std::vector<PaletteEntry> PaletteActions::next()
{
    std::vector<PaletteEntry> entries;
    if (std::exchange(m_isGiven, true))
        return entries;
    for (const ListedMenu &menu : menusOf(m_window))
        for (QAction *action : menu.actions)
            if (action->isVisible() && !action->text().isEmpty())
                entries.push_back(entryOf(*action, menu.path));
    return entries;
}

PaletteEntry PaletteActions::entryOf(QAction &action, const QString &menu) const
{
    PaletteEntry entry = paletteEntry(action, placeOf(action, menu), m_otherLanguage);
    entry.id = idOf(action);
    entry.isUsual = m_usual.contains(&action);
    return entry;
}

} // namespace codewheel
