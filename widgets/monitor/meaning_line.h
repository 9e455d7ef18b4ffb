// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace codewheel {

// The meaning of a word, below it: one line, elided where it is too long; the tooltip and screen readers get
// it in full. Painted, since a label would lay out its window again for each text. Also for other texts that
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
