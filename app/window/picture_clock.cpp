// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/picture_clock.h"

#include "app/window/main_window.h"

#include <QGuiApplication>
#include <QWindow>

#include <algorithm>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr auto period = 33ms;
constexpr int leftOutUnseen = 5; // of six

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
    m_timer.setInterval(period);
    connect(&m_timer, &QTimer::timeout, this, &PictureClock::tick);
    qApp->installEventFilter(this);
}

void PictureClock::tick()
{
    if (isAnythingSeen() || m_window->hasJob() || m_left == leftOutUnseen)
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
