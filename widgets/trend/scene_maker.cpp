// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/scene_maker.h"

#include "widgets/look/roles.h"
#include "widgets/trend/ticks.h"
#include "widgets/trend/track_text.h"

#include <QColor>
#include <QPalette>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace codewheel {
namespace {

// Colours that only tell curves apart, each beside its name: safe for colour-blind eyes, and none of those
// that mean running, attention or fault. They repeat after the last one.
QColor curveColor(std::size_t index, const QPalette &palette)
{
    static constexpr std::array<QRgb, 6> onLight{0xFF0072B2, 0xFF882255, 0xFF6B6100,
                                                 0xFF332288, 0xFF117A8B, 0xFF8C4A10};
    static constexpr std::array<QRgb, 6> onDark{0xFF56B4E9, 0xFFE68FC0, 0xFFDDCC77,
                                                0xFFA99CF0, 0xFF6FD3D0, 0xFFDDA36A};
    const auto &colors = shadeOf(palette) == Shade::light ? onLight : onDark;
    return QColor::fromRgb(colors[index % colors.size()]);
}

constexpr double margin = 1.02; // of an axis that fits
constexpr int stepsOfAxis = 10; // an axis that fits begins and ends at whole ones: it does not tremble

bool isWord(const TrendLane &lane)
{
    return bitCount(lane.curves.front().track.channel) > 0;
}

// Between which values a curve lies.
struct ValueRange
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;

    bool isEmpty() const { return low > high; }
    void include(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

// With what the curve has in the span, and on both sides of it.
void include(ValueRange &range, const TrendCurve &curve, const TimeSpan &span)
{
    if (curve.history == nullptr)
        return;
    for (const ScaledSpan &part : scaledSpans(curve.scale, span))
        if (const auto extent = curve.history->extent(part.span))
            for (const std::int64_t sample : {extent->least, extent->greatest})
                range.include(curve.valueOf(sample, part.span.from));
    for (const auto &beside :
         {curve.history->at(span.from - Instant(1)), curve.history->after(span.to - Instant(1))})
        if (beside)
            range.include(curve.valueOf(*beside));
}

} // namespace

TrendCurve SceneMaker::curve(const TrendTracks::Shown &shown) const
{
    TrendCurve curve{.track = shown.track,
                     .scale = m_scales.of(shown),
                     .history = m_histories.of(shown.track.place, shown.track.channel),
                     .name = {}};
    curve.name = nameOf(curve);
    return curve;
}

// "2.0 Hoist position, °"
QString SceneMaker::nameOf(const TrendCurve &curve) const
{
    QStringList words{curve.track.place.shown()};
    if (const QString station = m_station(curve.track.place); !station.isEmpty())
        words << station;
    words << trackText(curve.track);
    const QString unit = unitSymbol(curve.scale, curve.track.channel);
    return unit.isEmpty() ? words.join(u' ') : QStringLiteral("%1, %2").arg(words.join(u' '), unit);
}

TrendScene SceneMaker::make(const TimeSpan &span, const QPalette &palette) const
{
    TrendScene scene{.lanes = {}, .span = span, .marks = {}};
    const TrendTracks::Shown *above = nullptr;
    std::size_t index = 0;
    for (const TrendTracks::Shown &shown : m_tracks.shown()) {
        TrendCurve its = curve(shown);
        its.color = curveColor(index++, palette);
        const bool shares = above != nullptr && shown.sharesAxis && canShareAxis(*above, shown) &&
                            scene.lanes.back().curves.back().scale.unit == its.scale.unit;
        if (!shares)
            scene.lanes.push_back({.curves = {}, .unit = unitSymbol(its.scale, its.track.channel)});
        scene.lanes.back().curves.push_back(std::move(its));
        above = &shown;
    }
    for (TrendLane &lane : scene.lanes)
        if (!lane.isLogic())
            fitAxis(lane, span);
    for (const Mark &mark : m_histories.marks())
        if (mark.at >= span.from && mark.at < span.to)
            scene.marks.push_back(mark);
    return scene;
}

SceneMaker::Axis SceneMaker::axisOf(const TrendLane &lane)
{
    return {lane.curves.front().track, lane.curves.front().scale.unit};
}

void SceneMaker::fixAxis(const TrendLane &lane, double low, double high)
{
    if (high > low)
        m_fixed[axisOf(lane)] = {low, high};
}

void SceneMaker::fitAxis(TrendLane &lane, const TimeSpan &span) const
{
    if (const auto fixed = m_fixed.find(axisOf(lane)); fixed != m_fixed.end()) {
        std::tie(lane.low, lane.high) = fixed->second;
        return;
    }
    ValueRange range;
    double least = 0; // how much of the unit a step is
    for (const TrendCurve &curve : lane.curves) {
        const double unit =
            curve.track.channel == Channel::speed ? speedUnits : 1; // a step, or one per second
        least = std::max(least, unit * std::abs(curve.scale.factor(curve.track.channel)));
        include(range, curve, span);
    }
    const auto [low, high] = range.isEmpty() ? ValueRange{0, 1} : range;
    const double spread = std::max(high - low, 10 * least);
    const double middle = (low + high) / 2;
    const double step = isWord(lane) ? hexStep(spread, stepsOfAxis) : tickStep(spread, stepsOfAxis);
    lane.low = std::floor((middle - spread / 2 * margin) / step) * step;
    lane.high = std::ceil((middle + spread / 2 * margin) / step) * step;
}

} // namespace codewheel
