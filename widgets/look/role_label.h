// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/roles.h"

#include <QWidget>

class QLabel;

namespace codewheel {

// A state as it is always shown: an icon in the role's colour, with a word beside it. Used by the status
// line, panels and pages.
class RoleLabel : public QWidget
{
    Q_OBJECT

public:
    explicit RoleLabel(QWidget *parent = nullptr);

    void setWrapping(); // for a sentence: it takes as many lines as it needs
    void setState(Role role, const QString &word);
    void setState(Role role) { setState(role, roleWord(role)); }
    Role role() const { return m_role; }
    QString word() const;

private:
    void drawIcon();

    Role m_role = Role::inactive;
    QLabel *m_icon;
    QLabel *m_word;
};

} // namespace codewheel
