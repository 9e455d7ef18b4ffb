// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/quick_press.h"
#include "widgets/look/roles.h"
#include "widgets/look/trouble.h"

#include <QFrame>

class QAbstractButton;
class QBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace codewheel {

// A sentence shown where something went wrong: what happened and what to do, with an action if there is one.
// Whoever shows it withdraws it when the cause is gone; the user can close it earlier. Hidden until then.
// It may come, or move, just as the user clicks what was there before: for the time of a double click, its
// buttons take no click. Keys are taken at once, for what has the focus stays where it is.
class InlineMessage : public QFrame
{
    Q_OBJECT

public:
    explicit InlineMessage(QWidget *parent = nullptr);

    // An empty sentence withdraws it. actionText, otherActionText: on the buttons; no button if empty. Role:
    // attention or fault, or running for good news.
    void showMessage(Role role, const QString &sentence, const QString &actionText = {},
                     const QString &otherActionText = {});
    // A question: by the keyboard, what leaves all as it is comes next, the other action or closing it. The
    // focus goes back to what is before it once it is withdrawn.
    void focusSafe();
    // Its command is shown below the sentence, and can be copied.
    void showTrouble(Role role, const Trouble &trouble, const QString &actionText = {});
    QString command() const { return m_command; }
    // The same message in other words: screen readers are not alerted again.
    void rephrase(const QString &sentence);
    void withdraw(); // the cause is gone
    QString sentence() const;
    // In small type after the sentence; empty: nothing.
    void setDetail(const QString &detail);
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void actionTriggered();
    void otherActionTriggered();
    void closed(); // by the user

protected:
    void paintEvent(QPaintEvent *event) override;
    void moveEvent(QMoveEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

    void addButton(QAbstractButton *button); // after its actions
    void arrange();                          // after buttons were added or removed

private:
    void drawIcon();
    void showText();
    void setCommand(const QString &command);
    void copyCommand();
    void takeNoClickYet(QAbstractButton *button);
    bool hasActions() const;
    void giveFocusBack();

    Role m_role = Role::attention;
    QString m_text;
    QString m_detail;
    QString m_command;
    QuickPress m_press;  // came, moved, or became another message
    QBoxLayout *m_parts; // the sentence, and the buttons beside or, in a narrow panel, below it
    QBoxLayout *m_buttons;
    QLabel *m_icon;
    QLabel *m_sentence;
    QPushButton *m_action;
    QPushButton *m_otherAction;
    QPushButton *m_copy;
    QToolButton *m_close;
};

} // namespace codewheel
