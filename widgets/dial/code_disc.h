// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/dial/dial_state.h"
#include "widgets/dial/disc_face.h"
#include "widgets/look/value_widget.h"

#include <utility>
#include <vector>

namespace codewheel {

// The dial: a code disc that turns with the shaft. Pointer and number show the position, the hub counts whole
// turns, the speed is an arc (clockwise to the right, logarithmic), the note is below. Used by the dial dock,
// the wizard and the training panel.
class CodeDisc : public ValueWidget
{
    Q_OBJECT

public:
    explicit CodeDisc(QWidget *parent = nullptr);

    void setPlace(const QString &place); // "1.0": for screen readers
    void setState(const DialState &state);
    // All lines are drawn anew, none is kept as a picture of the screen.
    void setForPaper() { m_isForPaper = true; }
    const DialState &state() const { return m_state; }
    // The speed at the full arc.
    static constexpr double fullSpeed = 10'000; // rpm

    QString valueText() const override;
    std::vector<std::pair<QString, QString>> values() const; // name and value of all it shows
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void arrange();
    void drawStill(QPainter &painter);
    void drawStillParts(QPainter &painter) const;
    void drawFace(QPainter &painter, int diameter);
    void drawSpeed(QPainter &painter) const;
    void drawScale(QPainter &painter) const;
    void drawDisc(QPainter &painter);
    void drawPointer(QPainter &painter, double radius) const;
    void drawThen(QPainter &painter) const;
    void drawNowAndThen(QPainter &painter) const;
    double discRadius() const;
    QColor pointerColor() const;
    void drawHub(QPainter &painter) const;
    void drawNumbers(QPainter &painter) const;
    QColor numberColor() const;
    QString numberText() const;
    QString speedText(const DialState &state) const;
    QString note() const;
    int linesOfNote() const;
    int textHeight(int noteLines) const;

    DialState m_state;
    bool m_isForPaper = false;
    DiscFace m_face; // twice as fine as the screen: turned edges stay smooth
    DiscFace m_coarseFace;
    QPixmap m_still; // speed arc, scale and hub
    QRect m_dial;    // square: speed arc, scale and disc
    QRect m_number;
    QRect m_speed;
    QRect m_note;
};

} // namespace codewheel
