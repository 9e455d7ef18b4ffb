// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/look/focus_rules.h"

#include "widgets/look/bring_into_sight.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLabel>
#include <QShortcutEvent>
#include <QStackedWidget>

namespace codewheel {

FocusRules::FocusRules(QStackedWidget &pages, QObject *parent)
    : QObject(parent)
    , m_pages(pages)
{
    qApp->installEventFilter(this);
    connect(qApp, &QApplication::focusChanged, this, [](QWidget *, QWidget *now) { showFocus(now); });
}

namespace {

bool takesLetters(const QObject &object)
{
    const auto *widget = qobject_cast<const QWidget *>(&object);
    return widget != nullptr && (widget->testAttribute(Qt::WA_InputMethodEnabled) ||
                                 qobject_cast<const QComboBox *>(widget) != nullptr);
}

// Alt and a letter that no button has at the moment, or only one that is disabled: a field would take the
// letter as typed.
bool isLetterOfNoButton(const QObject &watched, const QEvent &event)
{
    if (event.type() != QEvent::KeyPress || !takesLetters(watched))
        return false;
    const auto &key = static_cast<const QKeyEvent &>(event);
    const bool isAlt = (key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::AltModifier;
    return isAlt && !key.text().isEmpty() && key.text().front().isPrint();
}

} // namespace

// Qt would give each in turn only the focus.
bool FocusRules::eventFilter(QObject *watched, QEvent *event)
{
    if (isLetterOfNoButton(*watched, *event))
        return true;
    if (event->type() != QEvent::Shortcut || !static_cast<QShortcutEvent *>(event)->isAmbiguous())
        return QObject::eventFilter(watched, event);
    const QWidget *part = partWithFocus();
    return part != nullptr && press(*part, static_cast<QShortcutEvent *>(event)->key());
}

QWidget *FocusRules::partWithFocus() const
{
    for (QWidget *its = QApplication::focusWidget(); its != nullptr; its = its->parentWidget())
        if (its == m_pages.currentWidget() || qobject_cast<QDockWidget *>(its) != nullptr)
            return its;
    return nullptr;
}

// False: it has no such letter.
bool FocusRules::press(const QWidget &part, const QKeySequence &letter)
{
    const auto isMeant = [&letter](const QWidget &widget, const QString &text) {
        return widget.isVisible() && widget.isEnabled() && QKeySequence::mnemonic(text) == letter;
    };
    for (auto *button : part.findChildren<QAbstractButton *>())
        if (isMeant(*button, button->text())) {
            button->setFocus(Qt::ShortcutFocusReason);
            button->animateClick();
            return true;
        }
    for (const auto *label : part.findChildren<QLabel *>())
        if (label->buddy() != nullptr && isMeant(*label, label->text())) {
            label->buddy()->setFocus(Qt::ShortcutFocusReason);
            return true;
        }
    return false;
}

// Not under a pressed mouse button, which would then be released elsewhere.
void FocusRules::showFocus(QWidget *widget)
{
    if (widget != nullptr && QApplication::mouseButtons() == Qt::NoButton)
        bringIntoSight(*widget);
}

} // namespace codewheel
