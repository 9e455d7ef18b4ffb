// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/palette_words.h"

#include "other_language.h"
#include "widgets/look/describe.h"
#include "widgets/look/label_text.h"

#include <QAction>

namespace codewheel {

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

} // namespace codewheel
