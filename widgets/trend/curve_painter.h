// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/trend/trend_scene.h"

#include <QRectF>

#include <functional>

class QPainter;

namespace codewheel {

// Draws one curve into the area of its lane, from the columns of its history: whatever the zoom, each column
// of pixels reaches from the least to the greatest sample in it.
class CurvePainter
{
public:
    // `columns`: of pixels, over the width of the area.
    CurvePainter(QPainter &painter, const QRectF &area, const TimeSpan &span, int columns);

    void draw(const TrendCurve &curve, double low, double high); // between these values of its axis
    void drawBit(const TrendCurve &curve);

private:
    using Height = std::function<double(const Sample &)>; // where it is
    // What is drawn of a column, or of the part of it that has one scale.
    struct Piece
    {
        double x = 0;
        double first = 0;
        double top = 0;
        double bottom = 0;
        double last = 0;
        bool isApart = false; // from the piece before: there is a gap, or the scale changed
    };
    using WithPiece = std::function<void(const Piece &)>;
    struct Level
    {
        double since = 0; // where it begins and ends
        double until = 0;
        bool isOn = false;
    };

    void drawLine(const TrendCurve &curve, const Height &y);
    void drawDense(const TrendCurve &curve, const Height &y); // with more samples than columns
    void forEachPiece(const TrendCurve &curve, const Height &y, const WithPiece &with) const;
    bool hasChange(const TrendCurve &curve, std::size_t column) const; // of its scale
    Piece pieceOf(const History::Column &column, std::size_t index, const Height &y) const;
    // From sample to sample, of a span that has one scale, with what stands where it begins and ends.
    static std::optional<Piece> exactPiece(const TrendCurve &curve, const TimeSpan &span, const Height &y);
    void drawLevel(const Level &level, const QColor &color);
    double x(Instant at) const;
    double x(std::size_t column) const;
    Instant edge(std::size_t column) const; // where it begins
    // The samples beside the area: the curve goes on to them. Nothing: there is a gap.
    std::optional<Sample> before(const TrendCurve &curve) const;
    std::optional<Sample> after(const TrendCurve &curve) const;

    QPainter &m_painter;
    QRectF m_area;
    TimeSpan m_span;
    std::size_t m_columns;
};

} // namespace codewheel
