// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace codewheel {

// What a word means, below it: one line, elided where it is too long, whole in the tooltip and for screen
// readers. Painted, since a label would lay out its window anew with every text. Also for other texts that
// change 30 times a second.
class MeaningLine : public QWidget
{
    Q_OBJECT

public:
    explicit MeaningLine(QWidget *parent = nullptr, Qt::Alignment side = Qt::AlignLeft);

    void setText(const QString &text);
    QString text() const { return m_text; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    const Qt::Alignment m_side;
    QString m_text;
};

} // namespace codewheel
