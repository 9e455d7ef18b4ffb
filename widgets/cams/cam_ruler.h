// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/cams/cam_drag.h"
#include "widgets/cams/cam_sheet.h"
#include "widgets/help/key_help.h"
#include "widgets/look/painted_parts.h"

#include <QWidget>

namespace codewheel {

// Eight rows over a ruler of the positions: each cam is a bar that can be dragged as a whole or by an edge,
// and that goes on at the other end where it passes zero. A line shows the shaft. Painted as one widget.
//
// Keys: Up, Down, Tab and Shift+Tab choose the cam; Home its start, End its stop, Escape the whole bar; Left
// and Right move what is chosen by 1, with Shift by a tick; Space switches active, Delete clears; + - and 0
// zoom. Wheel: zoom; with Shift: scroll.
class CamRuler : public QWidget, public PaintedParts
{
    Q_OBJECT

public:
    explicit CamRuler(CamSheet &sheet, QWidget *parent = nullptr);

    const CamSheet &sheet() const { return m_sheet; }
    const RulerScale &scale() const { return m_scale; }
    CamGrip grip() const { return m_grip; }
    void setGrip(CamGrip grip);

    QRect rowRect(std::size_t cam) const;

    // A cam is checked when it is active.
    int partCount() const override { return static_cast<int>(CamProgram::cams); }
    QString partName(int part) const override;
    QString partDescription(int part) const override;
    QRect partRect(int part) const override { return rowRect(static_cast<std::size_t>(part)); }
    bool isPartChecked(int part) const override;
    int focusedPart() const override { return static_cast<int>(m_sheet.current()); }
    void focusPart(int part) override { m_sheet.setCurrent(static_cast<std::size_t>(part)); }
    void togglePart(int part) override;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    void zoomIn();
    void zoomOut();
    void zoomToAll();
    void scrollTo(double first);
    static QList<KeyHelp> keys(); // that it handles

Q_SIGNALS:
    void viewChanged(); // different positions are in sight

protected:
    bool event(QEvent *event) override;
    bool focusNextPrevChild(bool next) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    struct Hit
    {
        std::size_t cam = 0;
        std::optional<CamGrip> grip; // nothing: beside the bar
        bool canCreate = false;

        friend bool operator==(const Hit &, const Hit &) = default;
    };
    std::optional<Hit> hitAt(QPointF point) const;
    void showCursor(const std::optional<Hit> &hit);
    void dragTo(double x);
    void endDrag(bool keep);
    void moveByKey(std::int64_t by);
    bool zoomByKey(int key);
    void chooseCam(std::size_t cam);
    void takeRange();
    void showView();
    double tickDistance() const;

    CamSheet &m_sheet;
    RulerScale m_scale;
    CamGrip m_grip = CamGrip::bar;
    std::optional<CamDrag> m_drag;
    std::optional<Hit> m_hovered;
    CamSheet::Gesture m_keyGesture = CamDocument::noGesture; // while the same thing is moved by keys
};

} // namespace codewheel
