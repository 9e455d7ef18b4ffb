// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/help/menu_list.h"
#include "app/window/palette/palette_action.h"
#include "app/window/palette/palette_entries.h"
#include "widgets/look/label_text.h"

#include <QAction>

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

std::vector<PaletteEntry> actionEntries(const QMainWindow &window, const QList<QAction *> &usual,
                                        OtherLanguage &otherLanguage)
{
    std::vector<PaletteEntry> entries;
    for (const ListedMenu &menu : menusOf(window)) {
        for (QAction *action : menu.actions) {
            if (!action->isVisible() || action->text().isEmpty())
                continue;
            PaletteEntry entry = paletteEntry(*action, placeOf(*action, menu.path), otherLanguage);
            entry.id = idOf(*action);
            entry.isUsual = usual.contains(action);
            entries.push_back(entry);
        }
    }
    return entries;
}

} // namespace codewheel
