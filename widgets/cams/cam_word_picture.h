// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/value_widget.h"

#include <optional>

namespace codewheel {

// The IN word in cam mode: which bits of the position are in D24..D8 after the shift, the cams in D7..D0, not
// valid in D31 (FRABA manual 5.4.4).
class CamWordPicture : public ValueWidget
{
    Q_OBJECT

public:
    explicit CamWordPicture(QWidget *parent = nullptr);

    // largest: the largest position; bits it never has are shown as 0.
    void setShift(unsigned shift, std::int64_t largest);

    QString valueText() const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    // The bit of the position shown in this bit of D24..D8; nothing: always 0.
    std::optional<int> positionBit(int bit) const;
    void drawBit(QPainter &painter, int bit, const QRect &cell) const;
    void drawBrace(QPainter &painter, int highest, int lowest, const QString &text) const;
    QRect cellOf(int bit) const;
    int cellWidth() const;

    unsigned m_shift = 0;
    int m_positionBits = 25; // that the largest position needs
};

} // namespace codewheel
