// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/value_widget.h"

#include <QStyleOptionFrame>

namespace codewheel {

// A number in a monitor, to be read and copied. Looks like a field, but paints only the digits that have
// changed, since a monitor updates four of them 30 times a second.
//
// Keys: Ctrl+C copies the number.
class NumberField : public ValueWidget
{
    Q_OBJECT

public:
    // widest: the longest text it will show.
    explicit NumberField(const QString &widest, QWidget *parent = nullptr);

    void showText(const QString &text);
    QString text() const { return m_text; }
    QString valueText() const override { return m_text; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    QRect textRect() const;
    QRectF cells(int first, int end) const;
    QStyleOptionFrame frame() const;
    void copy() const;

    QString m_widest;
    QString m_text;
};

} // namespace codewheel
