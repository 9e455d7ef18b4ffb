// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/palette/palette_action.h"

#include "other_language.h"
#include "widgets/look/describe.h"
#include "widgets/look/label_text.h"

#include <QAction>
#include <QPointer>

namespace codewheel {
namespace {

// What it does, or why it cannot be done now; empty: its text says it.
QString tipOf(const QAction &action)
{
    const QString tip = action.statusTip().isEmpty() ? action.toolTip() : action.statusTip();
    return plainLabel(tip) == plainLabel(action.text()) ? QString() : tip;
}

QString wordsOf(const QAction &action, OtherLanguage &otherLanguage)
{
    const QString more = action.property(alsoFoundBy).toString();
    QStringList words{otherLanguage.of(plainLabel(action.text())), otherLanguage.of(tipOf(action)), more,
                      otherLanguage.of(more)};
    words.removeAll(QString());
    return words.join(QStringLiteral("; "));
}

} // namespace

PaletteEntry paletteEntry(QAction &action, const QString &context, OtherLanguage &otherLanguage)
{
    const QPointer<QAction> its(&action); // its bus may go while the palette is open
    return {.title = plainLabel(action.text()),
            .context = context,
            .key = action.shortcut().toString(QKeySequence::NativeText),
            .does = tipOf(action),
            .words = wordsOf(action, otherLanguage),
            .icon = action.icon(),
            .run =
                [its] {
                    if (its)
                        its->trigger();
                },
            .state =
                [its] {
                    return its ? PaletteState{its->isEnabled(), tipOf(*its)} : PaletteState{false};
                }};
}

} // namespace codewheel
