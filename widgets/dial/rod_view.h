// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/dial/rod_picture.h"
#include "widgets/look/value_widget.h"

#include <utility>
#include <vector>

namespace codewheel {

// The dial of a linear encoder: a rod with its magnet, below it the position in steps and in mm, the speed,
// the resolution and the note. Used by the dial dock and the wizard.
class RodView : public ValueWidget
{
    Q_OBJECT

public:
    explicit RodView(QWidget *parent = nullptr);

    void setPlace(const QString &place); // "5.0": for screen readers
    void setState(const RodState &state);
    const RodState &state() const { return m_state; }
    const RodPicture &picture() const { return m_picture; }

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
    void drawNumbers(QPainter &painter) const;
    void drawNumbersOfNow(QPainter &painter) const;
    void drawNowAndThen(QPainter &painter) const;
    QString inBoth(std::optional<qint64> position, const std::optional<RodScale> &scale) const;
    QString thenText() const;
    QString positionText() const;
    QString shownPosition() const;
    QString millimetreText() const;
    QString speedText() const;
    QString resolutionText() const;
    QString note() const;
    int linesOfNote() const;
    int textHeight(int noteLines) const;

    RodState m_state;
    RodPicture m_picture;
    QRect m_number;
    QRect m_millimetres;
    QRect m_speed;
    QRect m_resolution;
    QRect m_note;
};

} // namespace codewheel
