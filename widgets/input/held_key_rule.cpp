// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/held_key_rule.h"

#include <QKeyEvent>
#include <QMenu>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QTextEdit>

namespace codewheel {
namespace {

bool makesLines(const QObject *watched)
{
    return qobject_cast<const QPlainTextEdit *>(watched) != nullptr ||
           qobject_cast<const QTextEdit *>(watched) != nullptr;
}

// There a letter alone presses what has it underlined.
bool takesLetters(const QObject *watched)
{
    return qobject_cast<const QMessageBox *>(watched) != nullptr ||
           qobject_cast<const QMenu *>(watched) != nullptr;
}

bool presses(const QObject *watched, const QKeyEvent &key)
{
    const bool isEnter = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    return isEnter ? !makesLines(watched) : takesLetters(watched) && !key.text().isEmpty();
}

} // namespace

bool HeldKeyRule::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::ShortcutOverride: // always comes before the shortcut, which does not tell it
        m_isHeld = static_cast<QKeyEvent *>(event)->isAutoRepeat();
        return false;
    case QEvent::Shortcut: // of a widget: a letter that is underlined
        return m_isHeld && watched->isWidgetType();
    case QEvent::KeyPress: {
        const auto &key = *static_cast<QKeyEvent *>(event);
        return key.isAutoRepeat() && watched->isWidgetType() && presses(watched, key);
    }
    default:
        return false;
    }
}

} // namespace codewheel
