// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/picture_clock.h"

#include "app/window/main_window.h"

#include <QGuiApplication>
#include <QWindow>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int usualRate = 30; // pictures a second
constexpr int unseenRate = 5;

// Not minimized, not on another desktop: as far as the desktop tells.
bool isAnythingSeen()
{
    return std::ranges::any_of(QGuiApplication::topLevelWindows(), &QWindow::isExposed);
}

} // namespace

PictureClock::PictureClock(QObject *parent)
    : QObject(parent)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    setRate(usualRate);
    connect(&m_timer, &QTimer::timeout, this, &PictureClock::tick);
    qApp->installEventFilter(this);
}

void PictureClock::setRate(int picturesPerSecond)
{
    m_timer.setInterval(1'000 / picturesPerSecond);
    m_leftOutUnseen = picturesPerSecond / unseenRate - 1;
    m_left = 0;
}

void PictureClock::tick()
{
    if (isAnythingSeen() || m_window->hasJob() || m_left == m_leftOutUnseen)
        takePicture();
    else
        ++m_left;
}

void PictureClock::takePicture()
{
    m_left = 0;
    m_window->showPicture();
}

// Before the window paints.
bool PictureClock::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::Expose && m_left > 0 && isAnythingSeen())
        takePicture();
    return QObject::eventFilter(watched, event);
}

} // namespace codewheel
