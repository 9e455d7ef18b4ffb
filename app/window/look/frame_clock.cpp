// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/look/frame_clock.h"

#include "app/window/main_window.h"

#include <QGuiApplication>
#include <QWindow>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int usualRate = 30; // frames a second
constexpr int unseenRate = 5;

// Neither minimized nor on another desktop, as far as the desktop reports it.
bool isAnythingSeen()
{
    return std::ranges::any_of(QGuiApplication::topLevelWindows(), &QWindow::isExposed);
}

} // namespace

FrameClock::FrameClock(QObject *parent)
    : QObject(parent)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    setRate(usualRate);
    connect(&m_timer, &QTimer::timeout, this, &FrameClock::tick);
    qApp->installEventFilter(this);
}

void FrameClock::setRate(int framesPerSecond)
{
    m_timer.setInterval(1'000 / framesPerSecond);
    m_leftOutUnseen = framesPerSecond / unseenRate - 1;
    m_left = 0;
}

void FrameClock::tick()
{
    if (isAnythingSeen() || m_window->hasJob() || m_left == m_leftOutUnseen)
        takeFrame();
    else
        ++m_left;
}

void FrameClock::takeFrame()
{
    m_left = 0;
    m_window->showFrame();
}

// Takes a frame before a window that is seen again paints.
bool FrameClock::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Expose && m_left > 0 && isAnythingSeen())
        takeFrame();
    return QObject::eventFilter(watched, event);
}

} // namespace codewheel
