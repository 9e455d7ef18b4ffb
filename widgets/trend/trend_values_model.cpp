// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/trend_values_model.h"

#include "history/moments.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/trend/curve_values.h"
#include "widgets/trend/encoder_scales.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QPixmap>

#include <limits>

namespace codewheel {
namespace {

constexpr QChar figureSpace(0x2007); // as wide as a digit: the column keeps its width

QPixmap sampleOf(const QColor &color)
{
    QPixmap sample(grid::smallIcon, grid::smallIcon);
    sample.fill(QApplication::palette().color(QPalette::Base)); // also where the row is selected
    QPainter painter(&sample);
    painter.fillRect(0, grid::smallIcon / 2 - 1, grid::smallIcon, 3, color);
    return sample;
}

// In the unit of a curve.
struct ScaledStatistics
{
    double least = std::numeric_limits<double>::infinity();
    double greatest = -least;
    Moments moments{};

    double mean() const { return moments.stood() == Instant(0) ? least : moments.mean(); }
    void add(const History::Statistics &its, double factor)
    {
        for (const std::int64_t sample : {its.extent.least, its.extent.greatest}) {
            least = std::min(least, static_cast<double>(sample) * factor);
            greatest = std::max(greatest, static_cast<double>(sample) * factor);
        }
        const auto stood = static_cast<double>(its.known.count());
        const double deviation = its.deviation * factor;
        moments.add({its.mean * factor, stood, 0, deviation * deviation * stood});
    }
};

std::optional<ScaledStatistics> statisticsOf(const TrendCurve &curve, const TimeSpan &span)
{
    std::optional<ScaledStatistics> all;
    for (const ScaledSpan &part : scaledSpans(curve.scale, span))
        if (const auto its = curve.history->statistics(part.span)) {
            if (!all)
                all.emplace();
            all->add(*its, part.scale.factor(curve.track.channel));
        }
    return all;
}

std::optional<TimeSpan> betweenCursors(const TrendScene &scene)
{
    const auto &[a, b] = scene.cursors;
    return a && b ? std::optional(TimeSpan{*a, *b}) : std::nullopt;
}

} // namespace

void TrendValuesModel::show(const TrendScene &scene, const EncoderScales &scales, bool withStatistics)
{
    std::vector<TrendRow> fresh;
    const auto between = betweenCursors(scene);
    for (const TrendLane &lane : scene.lanes)
        for (const TrendCurve &curve : lane.curves) {
            TrendRow &row = fresh.emplace_back(rowOf(curve, scene, scales.turns(curve.track.place)));
            if (withStatistics && between)
                addStatistics(row, curve,
                              {std::min(between->from, between->to), std::max(between->from, between->to)});
        }
    update(std::move(fresh));
}

void TrendValuesModel::showNow(const TrendScene &scene)
{
    int row = 0;
    for (const TrendLane &lane : scene.lanes)
        for (const TrendCurve &curve : lane.curves) {
            if (row >= rowCount())
                return;
            TrendRow its = rowAt(row);
            its.now = CurveValues(curve, {}, m_locale).now().rightJustified(its.now.size(), figureSpace);
            if (its != rowAt(row))
                replace(row, its);
            ++row;
        }
}

void TrendValuesModel::update(std::vector<TrendRow> fresh)
{
    if (std::ssize(fresh) != rowCount()) {
        setRows(std::move(fresh));
        return;
    }
    for (int row = 0; row < rowCount(); ++row)
        if (fresh[static_cast<std::size_t>(row)] != rowAt(row))
            replace(row, fresh[static_cast<std::size_t>(row)]);
}

TrendRow TrendValuesModel::rowOf(const TrendCurve &curve, const TrendScene &scene,
                                 const std::optional<TrackScale> &turns) const
{
    const CurveValues values(curve, turns, m_locale);
    TrendRow row{.name = curve.name, .color = curve.color, .now = values.now()};
    for (std::size_t cursor = 0; cursor < row.atCursors.size(); ++cursor)
        if (scene.cursors[cursor])
            row.atCursors[cursor] = values.at(*scene.cursors[cursor]);
    if (const auto between = betweenCursors(scene)) {
        row.difference = values.difference(*between);
        row.degrees = values.differenceInDegrees(*between);
        row.rate = values.rate(*between);
    }
    return row;
}

// Words and bits have none.
void TrendValuesModel::addStatistics(TrendRow &row, const TrendCurve &curve, const TimeSpan &span) const
{
    if (curve.history == nullptr || bitCount(curve.track.channel) > 0)
        return;
    const auto statistics = statisticsOf(curve, span);
    if (!statistics)
        return;
    const CurveValues values(curve, {}, m_locale);
    row.least = values.text(statistics->least);
    row.greatest = values.text(statistics->greatest);
    row.mean = values.averageText(statistics->mean());
    row.deviation = values.averageText(statistics->moments.deviation());
}

std::span<const ColumnHead> TrendValuesModel::heads() const
{
    static constexpr ColumnHead all[] = {
        {QT_TR_NOOP("Curve"), Qt::AlignLeft, QT_TR_NOOP("The encoder, what is shown of it, and its unit")},
        {QT_TR_NOOP("Now"), Qt::AlignRight, QT_TR_NOOP("The newest value; a dash where none is shown")},
        {"A", Qt::AlignRight, QT_TR_NOOP("The value at cursor A")},
        {"B", Qt::AlignRight, QT_TR_NOOP("The value at cursor B")},
        {"B \u2212 A", Qt::AlignRight, QT_TR_NOOP("From cursor A to cursor B")},
        {QT_TR_NOOP("Angle"), Qt::AlignRight,
         QT_TR_NOOP("From cursor A to cursor B, in degrees of the shaft")},
        {QT_TR_NOOP("Rate"), Qt::AlignRight, QT_TR_NOOP("The mean speed from cursor A to cursor B")},
        {QT_TR_NOOP("Min"), Qt::AlignRight, QT_TR_NOOP("The least value between the cursors")},
        {QT_TR_NOOP("Max"), Qt::AlignRight, QT_TR_NOOP("The greatest value between the cursors")},
        {QT_TR_NOOP("Mean"), Qt::AlignRight, QT_TR_NOOP("The mean over time between the cursors")},
        {QT_TR_NOOP("Std. dev."), Qt::AlignRight, QT_TR_NOOP("The standard deviation between the cursors")},
    };
    return all;
}

QString TrendValuesModel::text(const TrendRow &row, int column) const
{
    switch (column) {
    case name:
        return row.name;
    case now:
        return row.now;
    case cursorA:
        return row.atCursors[0];
    case cursorB:
        return row.atCursors[1];
    case difference:
        return row.difference;
    case degrees:
        return row.degrees;
    case rate:
        return row.rate;
    case least:
        return row.least;
    case greatest:
        return row.greatest;
    case mean:
        return row.mean;
    case deviation:
        return row.deviation;
    default:
        return {};
    }
}

QVariant TrendValuesModel::cell(const TrendRow &row, int column, int role) const
{
    if (role == Qt::DecorationRole && column == name)
        return sampleOf(row.color);
    if (role == Qt::ToolTipRole && column != name)
        return {};
    return TableModelBase::cell(row, column, role);
}

} // namespace codewheel
