// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/input_rules.h"

#include "widgets/look/quick_press.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPointer>
#include <QScrollBar>
#include <QTextEdit>

namespace codewheel {
namespace {

QWidget *fieldIn(QObject *watched)
{
    const bool isField = qobject_cast<QAbstractSpinBox *>(watched) != nullptr ||
                         qobject_cast<QComboBox *>(watched) != nullptr ||
                         (qobject_cast<QAbstractSlider *>(watched) != nullptr &&
                          qobject_cast<QScrollBar *>(watched) == nullptr);
    return isField ? static_cast<QWidget *>(watched) : nullptr;
}

// No field changes by the wheel unless it has the focus, and the wheel gives no focus, so that scrolling over
// a form only scrolls.
class WheelRule final : public QObject
{
public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override;
};

bool WheelRule::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::Wheel && event->type() != QEvent::Polish)
        return false;
    QWidget *field = fieldIn(watched);
    if (field == nullptr)
        return false;
    if (event->type() == QEvent::Polish) {
        if (field->focusPolicy() == Qt::WheelFocus)
            field->setFocusPolicy(Qt::StrongFocus);
        return false;
    }
    if (field->hasFocus())
        return false;
    event->ignore(); // so that the surroundings of the field scroll
    return true;
}

// Ctrl+Z in a field in which nothing is being typed undoes the last step of the project, as it does
// everywhere else; Qt's fields would do nothing then.
class UndoRule final : public QObject
{
public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override;
};

bool UndoRule::eventFilter(QObject *watched, QEvent *event)
{
    const auto *field = qobject_cast<QLineEdit *>(watched);
    if (event->type() != QEvent::ShortcutOverride || field == nullptr)
        return false;
    const auto *key = static_cast<QKeyEvent *>(event);
    const bool isOfProject = (key->matches(QKeySequence::Undo) && !field->isUndoAvailable()) ||
                             (key->matches(QKeySequence::Redo) && !field->isRedoAvailable());
    if (isOfProject)
        event->ignore();
    return isOfProject;
}

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

// A key that is held presses once: what it opens is not agreed to by the same press, and nothing is sent or
// written once more. This goes for Enter, for Alt with the letter of a button, and for a letter alone in
// questions and menus. In texts of several lines Enter goes on making lines.
class HeldKeyRule final : public QObject
{
public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    bool m_isHeld = false; // the key that a shortcut event is about
};

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

// Enter, Space, a letter.
bool mayAnswer(const QKeyEvent &key)
{
    return key.key() != Qt::Key_Escape && !key.text().isEmpty() && !(key.modifiers() & Qt::ControlModifier);
}

// The second of two quick clicks, or of two quick presses of a key, does not answer the question that the
// first one has opened. ALARM STOP and Esc work at once.
class NewQuestionRule final : public QObject
{
public:
    using QObject::QObject;

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void noteShown(QObject *watched);
    bool isAnswer(const QObject *watched) const;

    QPointer<QDialog> m_question; // the one that came last
    QuickPress m_press;
};

bool NewQuestionRule::eventFilter(QObject *watched, QEvent *event)
{
    switch (event->type()) {
    case QEvent::Show:
        noteShown(watched);
        return false;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::Shortcut:
        return isAnswer(watched) && m_press.isSecond();
    case QEvent::KeyPress:
        return mayAnswer(*static_cast<QKeyEvent *>(event)) && isAnswer(watched) && m_press.isSecond();
    default:
        return false;
    }
}

void NewQuestionRule::noteShown(QObject *watched)
{
    auto *dialog = qobject_cast<QDialog *>(watched);
    if (dialog == nullptr || !dialog->isModal())
        return;
    m_question = dialog;
    m_press.begin();
}

bool NewQuestionRule::isAnswer(const QObject *watched) const
{
    if (!m_question || !watched->isWidgetType())
        return false;
    if (watched == m_question)
        return true;
    const auto *button = qobject_cast<const QAbstractButton *>(watched);
    return button != nullptr && button->window() == m_question &&
           button->objectName() != QStringLiteral("alarmStop");
}

} // namespace

void installInputRules(QObject *parent)
{
    for (QObject *rule :
         std::initializer_list<QObject *>{new WheelRule(parent), new UndoRule(parent),
                                          new HeldKeyRule(parent), new NewQuestionRule(parent)})
        qApp->installEventFilter(rule);
}

} // namespace codewheel
