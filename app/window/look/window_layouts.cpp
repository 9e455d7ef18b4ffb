// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/look/window_layouts.h"

#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QPointer>
#include <QResizeEvent>
#include <QScopedValueRollback>
#include <QScreen>

#include <algorithm>
#include <utility>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr auto restOfTheEdge = 150ms; // longer than the pauses of a hand dragging the edge
constexpr QSize smallestWindow(960, 560);
constexpr int mostGivenBack = 3;          // of growth that comes again and again
constexpr int leastOfPanel = 20;          // pixels; anything smaller shows nothing
constexpr QSize handleOfFloating(80, 20); // by which it can be dragged

std::vector<QDockWidget *> panelsOf(const QMainWindow &window)
{
    const auto found = window.findChildren<QDockWidget *>(QString(), Qt::FindDirectChildrenOnly);
    return {found.begin(), found.end()};
}

bool isInSight(const QWidget &floating)
{
    return std::ranges::any_of(QGuiApplication::screens(), [&](const QScreen *screen) {
        const QRect seen = screen->availableGeometry() & floating.frameGeometry();
        return seen.width() >= handleOfFloating.width() && seen.height() >= handleOfFloating.height();
    });
}

} // namespace

WindowLayouts::WindowLayouts(QMainWindow &window, Means means)
    : QObject(&window)
    , m_window(window)
    , m_means(std::move(means))
{
    m_settling.setObjectName(QStringLiteral("settling"));
    m_settling.setSingleShot(true);
    m_settling.setInterval(restOfTheEdge);
    connect(&m_settling, &QTimer::timeout, this, &WindowLayouts::settle);
    qApp->installEventFilter(
        this); // one on the window would come after its layout, which has moved the panels by then
}

void WindowLayouts::begin(const std::map<WindowSize, QByteArray> &kept)
{
    for (const auto &[size, state] : kept)
        m_kept[size] = {state, {}};
    m_hasBegun = true;
    m_wasShown = m_window.isVisible();
    enterAnew();
}

void WindowLayouts::enterAnew()
{
    enter(windowSizeOf(m_window.size()));
    m_settled = m_means.save();
}

std::map<WindowSize, QByteArray> WindowLayouts::toKeep() const
{
    std::map<WindowSize, QByteArray> states;
    for (const auto &[size, kept] : m_kept)
        states[size] = kept.state;
    // While the edge moves from one size to another, the layout before is still the user's.
    if (!m_settling.isActive() || windowSizeOf(m_window.size()) == m_size)
        states[m_size] = m_means.save();
    return states;
}

void WindowLayouts::useDefault()
{
    m_settling.stop();
    m_kept.erase(windowSizeOf(m_window.size()));
    enterAnew();
}

bool WindowLayouts::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == &m_window && event->type() == QEvent::Resize)
        noteSize(*static_cast<QResizeEvent *>(event));
    if (watched == &m_window && event->type() == QEvent::LayoutRequest && hasGrown())
        m_settling.start();
    if (watched == &m_window && event->type() == QEvent::Resize && m_hasBegun && m_window.isVisible() &&
        !m_isEntering) {
        if (!m_settling.isActive())
            rememberIfChanged(static_cast<QResizeEvent *>(event)->oldSize());
        m_settling.start();
    }
    // Before it is shown, its tool bar does not have its final height.
    if (watched == &m_window && event->type() == QEvent::Show && !std::exchange(m_wasShown, true))
        QTimer::singleShot(0, this, &WindowLayouts::enterAnew);
    return QObject::eventFilter(watched, event);
}

// A layout that results only from shrinking the window must not replace the user's arrangement.
void WindowLayouts::rememberIfChanged(QSize in)
{
    QByteArray now = m_means.save();
    if (now != m_settled || !m_kept.contains(m_size))
        m_kept[m_size] = {std::move(now), in};
}

// A window also grows to hold a page or panel that asks, for a moment, for more than it needs.
void WindowLayouts::noteSize(const QResizeEvent &event)
{
    const bool isGrowth = event.size() == event.oldSize().expandedTo(m_window.minimumSize());
    if (!isGrowth)
        m_asked = event.size();
    else if (!m_asked.isValid()) // it was asked for before anybody watched
        m_asked = event.oldSize();
}

bool WindowLayouts::hasGrown() const
{
    return m_hasBegun && m_window.isVisible() && !m_window.isMaximized() && !m_window.isFullScreen() &&
           m_asked.isValid() && m_window.size() != m_asked;
}

void WindowLayouts::giveBackGrowth()
{
    if (!hasGrown())
        m_givenBack = 0;
    else if (m_window.minimumSizeHint().boundedTo(m_asked) == m_window.minimumSizeHint() &&
             ++m_givenBack <= mostGivenBack)
        m_window.resize(m_asked);
}

void WindowLayouts::settle()
{
    giveBackGrowth();
    const QPointer<QWidget> focused = m_window.focusWidget();
    const WindowSize size = windowSizeOf(m_window.size());
    const auto kept = m_kept.find(size);
    if (size != m_size)
        enter(size);
    else if (kept != m_kept.end() && kept->second.in == m_window.size())
        m_means.restore(kept->second.state);
    m_settled = m_means.save();
    if (focused != nullptr && focused->isVisible()) // panels that moved have lost it
        focused->setFocus();
}

void WindowLayouts::enter(WindowSize size)
{
    const QScopedValueRollback entering(m_isEntering, true);
    const QSize before = m_window.size();
    m_size = size;
    // An explicit minimum lets a full window shrink: once it is small, it holds less.
    const bool holdsLittle = size == WindowSize::narrow;
    m_window.setMinimumSize(holdsLittle ? 0 : smallestWindow.width(),
                            holdsLittle || size == WindowSize::low ? 0 : smallestWindow.height());
    const auto kept = m_kept.find(size);
    if (kept == m_kept.end() || !tryRestore(kept->second)) {
        m_kept.erase(size);
        m_means.arrange(size);
    }
    if (m_window.size() != before) // while its panels moved, it grew to hold them
        m_window.resize(before);
}

bool WindowLayouts::tryRestore(const Kept &kept)
{
    if (!m_means.restore(kept.state) || !isUsable())
        return false;
    bringIntoSight();
    return true;
}

bool WindowLayouts::isUsable() const
{
    return !m_window.isVisible() || std::ranges::none_of(panelsOf(m_window), [](const QDockWidget *panel) {
        const bool isSeen = panel->isVisible() && !panel->isFloating();
        return isSeen && (panel->width() < leastOfPanel || panel->height() < leastOfPanel);
    });
}

// The screen it floated on may be gone.
void WindowLayouts::bringIntoSight() const
{
    for (QDockWidget *panel : panelsOf(m_window))
        if (panel->isFloating() && !panel->isHidden() && !isInSight(*panel))
            panel->move(m_window.geometry().center() - panel->rect().center());
}

} // namespace codewheel
