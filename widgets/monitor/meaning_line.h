// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace codewheel {

// What a word means, below it: one line, elided where it is too long, whole in the tooltip and for screen
// readers. Painted, since a label would lay out its window anew with every text.
class MeaningLine : public QWidget
{
    Q_OBJECT

public:
    explicit MeaningLine(QWidget *parent = nullptr);

    void setText(const QString &text);
    QString text() const { return m_text; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    QString m_text;
};

} // namespace codewheel
