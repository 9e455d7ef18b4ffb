// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/form_fields.h"

#include "widgets/input/text_fields.h"

#include <QApplication>
#include <QLineEdit>

namespace codewheel {
namespace {

// For fields that only mark refused input, such as those in cells.
QString markedSentence(const QWidget &widget)
{
    const auto *field = qobject_cast<const QLineEdit *>(&widget);
    return field != nullptr && !field->hasAcceptableInput() ? field->accessibleDescription() : QString();
}

} // namespace

QString takeFields(const QWidget &form)
{
    if (const QWidget *focused = QApplication::focusWidget(); focused && form.isAncestorOf(focused))
        takeFocusedField();
    for (QWidget *widget : form.findChildren<QWidget *>()) {
        if (!widget->isVisibleTo(&form) || !widget->isEnabled())
            continue;
        auto *field = dynamic_cast<FormField *>(widget);
        QString wrong = field != nullptr ? field->takeTyped() : markedSentence(*widget);
        if (!wrong.isEmpty()) {
            widget->setFocus();
            return wrong;
        }
    }
    return {};
}

} // namespace codewheel
