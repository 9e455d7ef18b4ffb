// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/trend/ticks.h"

#include "vocabulary/hex.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr std::array timeSteps{Instant(1us),   Instant(2us),   Instant(5us),   Instant(10us),  Instant(20us),
                               Instant(50us),  Instant(100us), Instant(200us), Instant(500us), Instant(1ms),
                               Instant(2ms),   Instant(5ms),   Instant(10ms),  Instant(20ms),  Instant(50ms),
                               Instant(100ms), Instant(200ms), Instant(500ms), Instant(1s),    Instant(2s),
                               Instant(5s),    Instant(10s),   Instant(15s),   Instant(30s),   Instant(1min),
                               Instant(2min),  Instant(5min),  Instant(10min), Instant(15min), Instant(30min),
                               Instant(1h),    Instant(2h),    Instant(3h),    Instant(6h),    Instant(12h),
                               Instant(24h),   Instant(48h),   Instant(168h)};

QDateTime localTime(Instant at)
{
    using std::chrono::floor;
    return QDateTime::fromMSecsSinceEpoch(floor<std::chrono::milliseconds>(at).count());
}

int decimalsFor(double resolution)
{
    return resolution <= 0 ? 0 : std::clamp(static_cast<int>(std::ceil(-std::log10(resolution))), 0, 9);
}

Instant stepFor(Instant length, int most)
{
    const auto *step = std::ranges::find_if(timeSteps, [=](Instant each) { return length / each <= most; });
    return step == timeSteps.end() ? timeSteps.back() * (length / timeSteps.back() / most + 1) : *step;
}

// How many digits behind the second tell times this far apart: 0, 3 or 6.
int secondDigits(Instant step)
{
    return step >= 1s ? 0 : step >= 1ms ? 3 : 6;
}

QString clockText(Instant at, Instant step, const QLocale &locale)
{
    const QDateTime time = localTime(at);
    QString text = time.toString(step >= 1min ? QStringLiteral("HH:mm") : QStringLiteral("HH:mm:ss"));
    const int digits = secondDigits(step);
    if (digits == 0)
        return text;
    const auto micros = ((at % 1s) + 1s) % 1s;
    const QString part = QStringLiteral("%1").arg(micros.count(), 6, 10, QLatin1Char('0')).left(digits);
    return text + locale.decimalPoint() + part;
}

} // namespace

double tickStep(double range, int most)
{
    if (range <= 0 || most < 1)
        return 1;
    const double least = range / most;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least)
            return factor * power;
    return 10 * power;
}

std::vector<Tick> valueTicks(double low, double high, int most, const QLocale &locale)
{
    std::vector<Tick> ticks;
    const double step = tickStep(high - low, most);
    for (double index = std::ceil(low / step - 1e-9); index * step <= high + step * 1e-9; ++index)
        ticks.push_back({(index * step - low) / (high - low), valueText(index * step, step, locale)});
    return ticks;
}

double hexStep(double range, int most)
{
    double step = 1;
    for (int digit = 0; digit < 8; ++digit, step *= 16)
        for (const double factor : {1, 2, 4, 8})
            if (range / (factor * step) <= most)
                return factor * step;
    return step;
}

std::vector<Tick> hexTicks(double low, double high, int most)
{
    std::vector<Tick> ticks;
    const double step = hexStep(high - low, most);
    for (double at = std::ceil(low / step) * step; at <= high; at += step)
        if (at >= 0 && at < std::exp2(32))
            ticks.push_back({(at - low) / (high - low), hexWord(static_cast<Word>(at))});
    return ticks;
}

std::vector<Tick> timeTicks(const TimeSpan &span, int most, const QLocale &locale)
{
    const Instant length = span.to - span.from;
    const Instant step = stepFor(length, most);
    const Instant offset = std::chrono::seconds(localTime(span.from).offsetFromUtc());
    std::vector<Tick> ticks;
    Instant at = (span.from + offset) / step * step - offset;
    for (; at < span.to; at += step) {
        if (at < span.from)
            continue;
        const bool isMidnight = step >= 1min && localTime(at).time() == QTime(0, 0);
        ticks.push_back({static_cast<double>((at - span.from).count()) / static_cast<double>(length.count()),
                         isMidnight || step >= 24h ? dayText(at, locale) : clockText(at, step, locale)});
    }
    return ticks;
}

QString timeText(Instant at, Instant length, const QLocale &locale)
{
    return clockText(at, std::clamp(length / 1'000, Instant(1us), Instant(1s)), locale);
}

QString dayText(Instant at, const QLocale &locale)
{
    return locale.toString(localTime(at).date(), QLocale::ShortFormat);
}

QString spanDayText(const TimeSpan &span, const QLocale &locale)
{
    const QString from = dayText(span.from, locale);
    const QString to = dayText(span.to - Instant(1), locale);
    return from == to ? from : QStringLiteral("%1 \u2013 %2").arg(from, to);
}

QString durationText(Instant duration, const QLocale &locale)
{
    const double seconds = std::chrono::duration<double>(duration).count();
    const double size = std::abs(seconds);
    const auto text = [&](double factor, int decimals, const char *unit) {
        return QStringLiteral("%1 %2").arg(locale.toString(seconds * factor, 'f', decimals),
                                           QLatin1String(unit));
    };
    if (size < 1)
        return text(1e3, 3, "ms");
    if (size < 600)
        return text(1, size < 10 ? 6 : 3, "s");
    if (size < 36'000)
        return text(1 / 60.0, 2, "min");
    return text(1 / 3'600.0, 2, "h");
}

QString valueText(double value, double resolution, const QLocale &locale)
{
    const QString text = locale.toString(value, 'f', decimalsFor(resolution));
    const bool isZero = std::abs(value) < resolution * 1e-6;
    return isZero ? locale.toString(0.0, 'f', decimalsFor(resolution)) : text;
}

} // namespace codewheel
