// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>

class QLabel;

namespace codewheel {

// The pages of the wizard, quietly at the side: those done, the present one, and those to come.
class StepList : public QWidget
{
    Q_OBJECT

public:
    explicit StepList(const QStringList &titles, QWidget *parent = nullptr);

    void setCurrent(int step);

private:
    void draw();

    QStringList m_titles;
    QList<QLabel *> m_icons;
    QList<QLabel *> m_labels;
    int m_current = 0;
};

} // namespace codewheel
