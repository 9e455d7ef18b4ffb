// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/look/typed_texts.h"

#include <QLineEdit>
#include <QStackedWidget>
#include <QStringList>

namespace codewheel {
namespace {

// Among its siblings of the same class; in a stack, whose pages are raised in turn, by its page.
qsizetype placeOf(const QWidget &part)
{
    QWidget *around = part.parentWidget();
    if (const auto *pages = qobject_cast<const QStackedWidget *>(around))
        return pages->indexOf(const_cast<QWidget *>(&part));
    qsizetype before = 0;
    for (const QObject *sibling : around->children()) {
        if (sibling == &part)
            break;
        before += sibling->metaObject() == part.metaObject() ? 1 : 0;
    }
    return before;
}

// "QWidget:0/QDockWidget:3/...": names are of the language, or none.
QString pathOf(const QWidget &part, const QWidget &window)
{
    QStringList path;
    for (const QWidget *its = &part; its != &window && its->parentWidget() != nullptr;
         its = its->parentWidget()) {
        path.prepend(
            QStringLiteral("%1:%2").arg(QLatin1String(its->metaObject()->className())).arg(placeOf(*its)));
    }
    return path.join(u'/');
}

} // namespace

TypedTexts typedTexts(const QWidget &window)
{
    TypedTexts texts;
    for (const auto *field : window.findChildren<QLineEdit *>())
        if (field->isVisible() && field->isModified())
            texts[pathOf(*field, window)] = field->text();
    return texts;
}

void typeAgain(QWidget &window, const TypedTexts &texts)
{
    for (auto *field : window.findChildren<QLineEdit *>())
        if (const auto typed = texts.find(pathOf(*field, window));
            typed != texts.end() && !field->isReadOnly()) {
            field->selectAll();
            field->insert(typed->second); // as if it were typed
        }
}

} // namespace codewheel
