// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/freshness.h"

#include <QDateTime>
#include <QTimer>

#include <algorithm>
#include <chrono>

namespace codewheel {

// Ticks while what a view shows is old, each time its age changes by a second, so that all views show the
// same age. Used by the dials, the monitors, the cam editor and the wizard.
class AgeTimer : public QTimer
{
public:
    explicit AgeTimer(QObject *parent)
        : QTimer(parent)
    {
        setSingleShot(true);
        setTimerType(Qt::PreciseTimer);
        connect(this, &QTimer::timeout, this, &AgeTimer::waitForNextSecond);
    }

    template <typename Shown> // EncoderSession, WordChannel
    void follow(const Shown &shown)
    {
        follow(shown.freshness().isOld() ? shown.dateTime(shown.freshness().seen()) : QDateTime());
    }
    void follow(const QDateTime &seen) // not valid: it is live, or was never seen
    {
        m_seen = seen;
        if (!seen.isValid())
            stop();
        else if (!isActive())
            waitForNextSecond();
    }

    static std::chrono::milliseconds untilNextSecond(const QDateTime &seen, const QDateTime &now)
    {
        constexpr qint64 second = 1000;
        return std::chrono::milliseconds(second - std::max<qint64>(0, seen.msecsTo(now)) % second);
    }

private:
    void waitForNextSecond() { start(untilNextSecond(m_seen, QDateTime::currentDateTime())); }

    QDateTime m_seen;
};

} // namespace codewheel
