// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QBoxLayout;

namespace codewheel {

// Two parts beside each other, and the second below the first where there is no room for both.
class FoldingRow : public QWidget
{
    Q_OBJECT

public:
    // The first has what is left over.
    FoldingRow(QWidget *first, QWidget *second, QWidget *parent = nullptr);

    QSize minimumSizeHint() const override; // as below each other

protected:
    bool event(QEvent *event) override;

private:
    void fold();
    int least(const QWidget &part) const;

    QWidget *m_first;
    QWidget *m_second;
    QBoxLayout *m_layout;
};

} // namespace codewheel
