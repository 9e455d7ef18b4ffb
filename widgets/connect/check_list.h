// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/role.h"

#include <QWidget>

#include <vector>

class QGridLayout;
class QLabel;

namespace codewheel {

class RoleLabel;

// The steps of a test of a link, as they are made: what was tried, whether it went well, and a sentence.
class CheckList : public QWidget
{
    Q_OBJECT

public:
    explicit CheckList(QWidget *parent = nullptr);

    void clear();
    // Steps in a row that were not made, for the same reason, are one line.
    void add(Role role, const QString &what, const QString &sentence);
    int count() const { return static_cast<int>(m_rows.size()); }
    QString text() const; // all of it, line by line

private:
    struct Row
    {
        RoleLabel *step;
        QLabel *told;
    };
    void addRow();

    QGridLayout *m_grid;
    std::vector<Row> m_rows;
};

} // namespace codewheel
