// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/icons.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace codewheel {

// Shown where a view has nothing to show yet: what belongs here, how to get it, and the button that does it.
class EmptyState : public QWidget
{
    Q_OBJECT

public:
    EmptyState(Icon icon, const QString &what, const QString &how, QWidget *parent = nullptr);

    void setTexts(const QString &what, const QString &how);
    void setAction(const QString &text); // empty: no button

Q_SIGNALS:
    void actionTriggered();

private:
    void drawIcon();
    void setFonts();

    Icon m_name;
    QLabel *m_icon;
    QLabel *m_what;
    QLabel *m_how;
    QPushButton *m_action;
};

} // namespace codewheel
