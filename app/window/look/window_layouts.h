// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/look/window_size.h"

#include <QByteArray>
#include <QObject>
#include <QTimer>

#include <functional>
#include <map>

class QMainWindow;
class QResizeEvent;

namespace codewheel {

// The arrangement of the panels for each size of the window: what the user made of a size comes back when the
// window has that size again, in this run or the next. A window being resized is left alone until its edge
// rests.
class WindowLayouts : public QObject
{
public:
    struct Means
    {
        std::function<QByteArray()> save;
        std::function<bool(const QByteArray &)> restore; // false: invalid, or of another version
        std::function<void(WindowSize)> arrange;         // the initial arrangement
    };
    WindowLayouts(QMainWindow &window, Means means);

    // Starts working. `kept` are the layouts of the previous run.
    void begin(const std::map<WindowSize, QByteArray> &kept);
    std::map<WindowSize, QByteArray> toKeep() const;
    void useDefault(); // for the present size of the window

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Kept
    {
        QByteArray state;
        QSize in; // for a window of this size
    };
    void noteSize(const QResizeEvent &event);
    bool hasGrown() const;
    void giveBackGrowth();
    void rememberIfChanged(QSize in);
    void settle();
    void enterAnew();
    void enter(WindowSize size);
    bool tryRestore(const Kept &kept);
    bool isUsable() const;
    void bringIntoSight() const;

    QMainWindow &m_window;
    const Means m_means;
    std::map<WindowSize, Kept> m_kept;
    WindowSize m_size = WindowSize::usual;
    QByteArray m_settled; // as it followed from the window's size, before any rearranging
    QTimer m_settling{this};
    QSize m_asked; // of the window; to hold what is in it, it may be larger
    int m_givenBack = 0;
    bool m_hasBegun = false;
    bool m_isEntering = false; // what it makes of the window is not what anybody arranged
    bool m_wasShown = true;    // or it is no matter as yet
};

} // namespace codewheel
