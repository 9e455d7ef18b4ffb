// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/curve_painter.h"

#include <QPainter>
#include <QPolygonF>

#include <cmath>
#include <tuple>

namespace codewheel {
namespace {

constexpr double thickness = 1.25; // of a curve, in logical pixels
constexpr double reach = 1e6;      // further outside than this, Qt draws a line wrongly

// A curve in pieces: a gap ends one.
class Strokes
{
public:
    explicit Strokes(QPainter &painter)
        : m_painter(painter)
    {}
    void to(double x, double y)
    {
        if (m_points.isEmpty() || m_points.back() != QPointF(x, y))
            m_points.push_back({x, y});
    }
    void end()
    {
        if (m_points.size() == 1)
            m_points.push_back(m_points.front() + QPointF(thickness, 0)); // a single sample is seen as well
        if (!m_points.isEmpty())
            m_painter.drawPolyline(m_points);
        m_points.clear();
    }

private:
    QPainter &m_painter;
    QPolygonF m_points;
};

// Upright bars side by side. Those that look alike are painted as one: a bar a pixel wide goes through the
// memory of the picture line by line, which is slow.
class Bars
{
public:
    Bars(QPainter &painter, const QColor &color)
        : m_painter(painter)
        , m_color(color)
    {}
    void add(const QRectF &bar)
    {
        constexpr double unseen = 0.5;
        const auto isNear = [](double one, double other) { return std::abs(one - other) < unseen; };
        if (isNear(m_bar.right(), bar.left()) && isNear(m_bar.top(), bar.top()) &&
            isNear(m_bar.bottom(), bar.bottom())) {
            m_bar.setRight(bar.right());
            return;
        }
        end();
        m_bar = bar;
    }
    void end()
    {
        if (!m_bar.isEmpty())
            m_painter.fillRect(m_bar, m_color);
        m_bar = {};
    }

private:
    QPainter &m_painter;
    QColor m_color;
    QRectF m_bar;
};

} // namespace

CurvePainter::CurvePainter(QPainter &painter, const QRectF &area, const TimeSpan &span, int columns)
    : m_painter(painter)
    , m_area(area)
    , m_span(span)
    , m_columns(static_cast<std::size_t>(std::max(columns, 1)))
{}

double CurvePainter::x(Instant at) const
{
    const double part = static_cast<double>((at - m_span.from).count()) /
                        static_cast<double>((m_span.to - m_span.from).count());
    return m_area.left() + std::clamp(part * m_area.width(), -reach, reach);
}

double CurvePainter::x(std::size_t column) const
{
    return m_area.left() +
           m_area.width() * (static_cast<double>(column) + 0.5) / static_cast<double>(m_columns);
}

Instant CurvePainter::edge(std::size_t column) const
{
    return m_span.from + (m_span.to - m_span.from) * static_cast<std::int64_t>(column) /
                             static_cast<std::int64_t>(m_columns);
}

void CurvePainter::forEachPiece(const TrendCurve &curve, const Height &y, const WithPiece &with) const
{
    const auto sample = before(curve);
    auto scale = sample ? std::optional(curve.scale.at(sample->at).perStep) : std::nullopt;
    const auto tell = [&](Piece piece, Instant then) {
        const double its = curve.scale.at(then).perStep;
        piece.isApart = piece.isApart || (scale && *scale != its);
        scale = its;
        with(piece);
    };
    std::size_t index = 0;
    for (const auto &column : curve.history->columns(m_span, m_columns)) {
        const std::size_t its = index++;
        if (hasChange(curve, its)) {
            const bool isApart = column && column->hasGap;
            for (const ScaledSpan &part : scaledSpans(curve.scale, {edge(its), edge(its + 1)}))
                if (auto piece = exactPiece(curve, part.span, y))
                    tell({x(its), piece->first, piece->top, piece->bottom, piece->last, isApart},
                         part.span.from);
        } else if (column) {
            tell(pieceOf(*column, its, y), edge(its));
        }
    }
}

// Samples of a recording may be found half a column before their place.
bool CurvePainter::hasChange(const TrendCurve &curve, std::size_t column) const
{
    const Instant end = edge(column + 1);
    return curve.scale.changesIn({edge(column) - Instant(1), end + (end - edge(column)) / 2 + Instant(1)});
}

CurvePainter::Piece CurvePainter::pieceOf(const History::Column &column, std::size_t index,
                                          const Height &y) const
{
    const Instant then = edge(index);
    const auto [top, bottom] =
        std::minmax({y({then, column.summary.extent.least}), y({then, column.summary.extent.greatest})});
    return {x(index), y({then, column.first}), top, bottom, y({then, column.last}), column.hasGap};
}

std::optional<CurvePainter::Piece> CurvePainter::exactPiece(const TrendCurve &curve, const TimeSpan &span,
                                                            const Height &y)
{
    std::optional<Piece> piece;
    const auto include = [&](const Sample &sample) {
        const double height = y(sample);
        if (!piece)
            piece = {0, height, height, height, height, false};
        piece->top = std::min(piece->top, height);
        piece->bottom = std::max(piece->bottom, height);
        piece->last = height;
    };
    const auto includeStanding = [&](Instant at) {
        if (const auto sample = curve.history->at(at))
            include({at, sample->value});
    };
    includeStanding(span.from);
    curve.history->forEach(span, include);
    includeStanding(span.to - Instant(1));
    return piece;
}

// What stands on the other side of a change of the scale is taken where the area begins or ends.
std::optional<Sample> CurvePainter::before(const TrendCurve &curve) const
{
    const Instant last = m_span.from - Instant(1);
    auto sample = curve.history->at(last);
    if (sample && curve.scale.changesIn({sample->at, m_span.from}))
        sample->at = last;
    return sample;
}

std::optional<Sample> CurvePainter::after(const TrendCurve &curve) const
{
    const Instant last = m_span.to - Instant(1);
    const auto next = curve.history->after(last);
    if (!next || !curve.scale.changesIn({last, next->at + Instant(1)}))
        return next;
    auto standing = curve.history->at(last);
    if (standing)
        standing->at = last;
    return standing;
}

void CurvePainter::draw(const TrendCurve &curve, double low, double high)
{
    if (curve.history == nullptr || high <= low)
        return;
    const double scale = m_area.height() / (high - low);
    const auto y = [&](const Sample &sample) {
        return std::clamp(m_area.bottom() - (curve.valueOf(sample) - low) * scale, -reach, reach);
    };
    if (curve.history->count(m_span) > m_columns)
        drawDense(curve, y);
    else
        drawLine(curve, y);
}

// A column with several samples goes from its first one over both extremes to its last one. One with a gap
// inside is drawn as an upright line: between which of its samples the gap is cannot be seen.
void CurvePainter::drawLine(const TrendCurve &curve, const Height &y)
{
    m_painter.setRenderHint(QPainter::Antialiasing, true);
    m_painter.setPen(QPen(curve.color, thickness));
    Strokes strokes(m_painter);
    if (const auto sample = before(curve))
        strokes.to(x(sample->at), y(*sample));
    forEachPiece(curve, y, [&strokes](const Piece &piece) {
        if (piece.isApart)
            strokes.end();
        strokes.to(piece.x, piece.first);
        strokes.to(piece.x, piece.bottom);
        strokes.to(piece.x, piece.top);
        strokes.to(piece.x, piece.last);
    });
    if (const auto sample = after(curve))
        strokes.to(x(sample->at), y(*sample));
    strokes.end();
}

// A column is a bar over its extremes, and on to where the one beside it ended: so no pixel is painted twice,
// which costs most where each column is as high as the lane.
void CurvePainter::drawDense(const TrendCurve &curve, const Height &y)
{
    m_painter.setRenderHint(QPainter::Antialiasing, false);
    m_painter.setPen(QPen(curve.color, 1));
    const double width = m_area.width() / static_cast<double>(m_columns);
    Bars bars(m_painter, curve.color);
    std::optional<QPointF> end;
    if (const auto sample = before(curve))
        end = {x(sample->at), y(*sample)};
    forEachPiece(curve, y, [&](const Piece &piece) {
        double top = piece.top;
        double bottom = piece.bottom;
        if (end && !piece.isApart) {
            if (end->x() < piece.x - 1.5 * width)
                m_painter.drawLine(*end, QPointF(piece.x, piece.first));
            else
                std::tie(top, bottom) = std::minmax({top, bottom, end->y()});
        }
        bars.add({piece.x - width / 2, top - 0.5, width, bottom - top + 1});
        end = {piece.x, piece.last};
    });
    bars.end();
    if (const auto sample = after(curve); sample && end)
        m_painter.drawLine(*end, QPointF(x(sample->at), y(*sample)));
}

// As a logic analyser does: two levels, and an upright line where it changed, however often.
void CurvePainter::drawBit(const TrendCurve &curve)
{
    if (curve.history == nullptr || !curve.track.bit)
        return;
    m_painter.setRenderHint(QPainter::Antialiasing, false);
    m_painter.setPen(QPen(curve.color, 1));
    const std::uint32_t mask = 1U << *curve.track.bit;
    const auto isOn = [&](std::int64_t sample) { return curve.track.of(sample) != 0; };
    std::optional<Level> level;
    if (const auto sample = before(curve))
        level = {m_area.left(), m_area.left(), isOn(sample->value)};
    std::size_t index = 0;
    for (const auto &column : curve.history->columns(m_span, m_columns)) {
        const double at = x(index++);
        if (!column)
            continue;
        const bool goesOn = level && !column->hasGap;
        const bool changedInside = (column->summary.ever & ~column->summary.always & mask) != 0;
        const bool changed = changedInside || (goesOn && level->isOn != isOn(column->first));
        if (goesOn)
            level->until = at;
        if (goesOn && !changed)
            continue;
        if (level)
            drawLevel(*level, curve.color);
        if (changed)
            m_painter.drawLine(QPointF(at, m_area.top()), QPointF(at, m_area.bottom()));
        level = {at, at, isOn(column->last)};
    }
    if (!level)
        return;
    // A sample that stands alone is seen as well.
    level->until = after(curve) ? m_area.right() : std::max(level->until, level->since + 1);
    drawLevel(*level, curve.color);
}

void CurvePainter::drawLevel(const Level &level, const QColor &color)
{
    QColor fill = color;
    fill.setAlphaF(0.25F);
    const double y = level.isOn ? m_area.top() : m_area.bottom();
    if (level.isOn)
        m_painter.fillRect(QRectF(QPointF(level.since, m_area.top()), QPointF(level.until, m_area.bottom())),
                           fill);
    m_painter.drawLine(QPointF(level.since, y), QPointF(level.until, y));
}

} // namespace codewheel
