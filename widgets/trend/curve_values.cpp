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

QString CurveValues::text(const std::optional<Sample> &sample) const
{
    return sample ? text(m_curve.valueOf(sample->value)) : QString(QChar(0x2013));
}

double CurveValues::resolution() const
{
    const Channel channel = m_curve.track.channel;
    return std::abs(m_curve.scale.factor(channel)) * (channel == Channel::speed ? speedUnits : 1);
}

QString CurveValues::now() const
{
    return text(m_curve.history == nullptr ? std::nullopt : m_curve.history->newest());
}

QString CurveValues::at(Instant at) const
{
    return text(m_curve.history == nullptr ? std::nullopt : m_curve.history->at(at));
}

std::optional<double> CurveValues::steps(const TimeSpan &span) const
{
    if (m_curve.history == nullptr || bitCount(m_curve.track.channel) > 0)
        return {};
    const auto from = m_curve.history->at(span.from);
    const auto to = m_curve.history->at(span.to);
    return from && to ? std::optional(static_cast<double>(to->value - from->value)) : std::nullopt;
}

QString CurveValues::difference(const TimeSpan &span) const
{
    const auto its = steps(span);
    if (!its)
        return {};
    const double value = *its * m_curve.scale.factor(m_curve.track.channel);
    return signedText(text(value), value);
}

QString CurveValues::differenceInDegrees(const TimeSpan &span) const
{
    const auto its = steps(span);
    if (!its || !m_stepsPerTurn || m_curve.track.channel != Channel::position)
        return {};
    const double degrees = *its / *m_stepsPerTurn * degreesPerTurn;
    return signedText(valueText(degrees, degreeResolution, m_locale), degrees) + QChar(0xB0);
}

QString CurveValues::rate(const TimeSpan &span) const
{
    const auto its = steps(span);
    const double seconds = secondsOf(span);
    if (!its || seconds == 0 || m_curve.track.channel != Channel::position)
        return {};
    const bool hasTurns = m_stepsPerTurn.has_value();
    const double rate = hasTurns ? *its / *m_stepsPerTurn * secondsPerMinute / seconds
                                 : *its * m_curve.scale.factor(Channel::position) / seconds;
    const TrackScale scale{hasTurns ? TrackUnit::turns : m_curve.scale.unit, 1};
    return QStringLiteral("%1 %2").arg(signedText(valueText(rate, rateResolution, m_locale), rate),
                                       unitSymbol(scale, Channel::speed));
}

} // namespace codewheel
