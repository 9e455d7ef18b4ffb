// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/roles.h"

#include <QFrame>

class QBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace codewheel {

// A sentence that stands where something went wrong: what happened and what to do, with one action if there
// is one. Whoever shows it withdraws it when the cause is gone; the user can close it before. Hidden until
// then.
class InlineMessage : public QFrame
{
    Q_OBJECT

public:
    explicit InlineMessage(QWidget *parent = nullptr);

    // actionText, otherActionText: on the buttons, none without. Role: attention or fault, or running for
    // good news.
    void showMessage(Role role, const QString &sentence, const QString &actionText = {},
                     const QString &otherActionText = {});
    void withdraw(); // the cause is gone
    QString sentence() const;
    QSize minimumSizeHint() const override;

Q_SIGNALS:
    void actionTriggered();
    void otherActionTriggered();
    void closed(); // by the user

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void drawIcon();
    void arrange();

    Role m_role = Role::attention;
    QBoxLayout *m_parts; // the sentence, and the buttons beside or, in a narrow panel, below it
    QBoxLayout *m_buttons;
    QLabel *m_icon;
    QLabel *m_sentence;
    QPushButton *m_action;
    QPushButton *m_otherAction;
    QToolButton *m_close;
};

} // namespace codewheel
