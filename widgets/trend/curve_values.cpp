// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/curve_values.h"

#include "vocabulary/hex.h"
#include "widgets/trend/ticks.h"
#include "widgets/trend/track_text.h"

#include <QLocale>

#include <cmath>

namespace codewheel {
namespace {

constexpr double degreesPerTurn = 360;
constexpr double secondsPerMinute = 60;
constexpr double degreeResolution = 0.01;
constexpr double rateResolution = 0.01;

double secondsOf(const TimeSpan &span)
{
    return std::chrono::duration<double>(span.to - span.from).count();
}

QString signedText(const QString &text, double value)
{
    return value > 0 ? u'+' + text : text;
}

} // namespace

QString CurveValues::text(double value) const
{
    const Channel channel = m_curve.track.channel;
    if (bitCount(channel) > 0)
        return m_curve.track.bit ? QString::number(std::llround(value))
                                 : hexWord(static_cast<Word>(std::llround(value)));
    return valueText(value, resolution(), m_locale);
}

QString CurveValues::averageText(double value) const
{
    return valueText(value, resolution() / 10, m_locale);
}

QString CurveValues::text(const std::optional<Sample> &sample, Instant then) const
{
    return sample ? text(m_curve.valueOf(sample->value, then)) : QString(QChar(0x2013));
}

double CurveValues::resolution() const
{
    const Channel channel = m_curve.track.channel;
    return std::abs(m_curve.scale.factor(channel)) * (channel == Channel::speed ? speedUnits : 1);
}

QString CurveValues::now() const
{
    return text(m_curve.history == nullptr ? std::nullopt : m_curve.history->newest(), Instant::max());
}

QString CurveValues::at(Instant at) const
{
    return text(m_curve.history == nullptr ? std::nullopt : m_curve.history->at(at), at);
}

// Each end by what a step was then.
std::optional<double> CurveValues::way(const TimeSpan &span, const TrackScale &scale) const
{
    const Channel channel = m_curve.track.channel;
    if (m_curve.history == nullptr || bitCount(channel) > 0)
        return {};
    const auto from = m_curve.history->at(span.from);
    const auto to = m_curve.history->at(span.to);
    if (!from || !to)
        return {};
    return static_cast<double>(to->value) * scale.factor(channel, span.to) -
           static_cast<double>(from->value) * scale.factor(channel, span.from);
}

QString CurveValues::difference(const TimeSpan &span) const
{
    const auto its = way(span, m_curve.scale);
    return its ? signedText(text(*its), *its) : QString();
}

QString CurveValues::differenceInDegrees(const TimeSpan &span) const
{
    const auto turns =
        m_turns && m_curve.track.channel == Channel::position ? way(span, *m_turns) : std::nullopt;
    if (!turns)
        return {};
    const double degrees = *turns * degreesPerTurn;
    return signedText(valueText(degrees, degreeResolution, m_locale), degrees) + QChar(0xB0);
}

QString CurveValues::rate(const TimeSpan &span) const
{
    const double seconds = secondsOf(span);
    const auto its = way(span, m_turns.value_or(m_curve.scale));
    if (!its || seconds == 0 || m_curve.track.channel != Channel::position)
        return {};
    const double rate = *its / seconds * (m_turns ? secondsPerMinute : 1);
    const TrackScale scale{m_turns ? TrackUnit::turns : m_curve.scale.unit, 1};
    return QStringLiteral("%1 %2").arg(signedText(valueText(rate, rateResolution, m_locale), rate),
                                       unitSymbol(scale, Channel::speed));
}

} // namespace codewheel
