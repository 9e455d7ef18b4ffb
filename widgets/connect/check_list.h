// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/role.h"

#include <QWidget>

class QGridLayout;

namespace codewheel {

// The steps of a test of a link, as they are made: what was tried, whether it went well, and a sentence.
class CheckList : public QWidget
{
    Q_OBJECT

public:
    explicit CheckList(QWidget *parent = nullptr);

    void clear();
    void add(Role role, const QString &what, const QString &sentence);
    int count() const { return m_rows; }
    QString text() const; // all of it, line by line

private:
    QGridLayout *m_grid;
    int m_rows = 0;
    QStringList m_lines;
};

} // namespace codewheel
