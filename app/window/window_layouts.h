// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/window_size.h"

#include <QByteArray>
#include <QObject>
#include <QTimer>

#include <functional>
#include <map>

class QMainWindow;

namespace codewheel {

// How the panels are arranged in each size of the window: what one made of a size is there again when the
// window has that size again, in this run or the next. A window that is being resized is left alone until its
// edge rests.
class WindowLayouts : public QObject
{
public:
    struct Means
    {
        std::function<QByteArray()> save;
        std::function<bool(const QByteArray &)> restore; // false: it is none, or of another version
        std::function<void(WindowSize)> arrange;         // as it is at first
    };
    WindowLayouts(QMainWindow &window, Means means);

    // From now on. `kept` are those of the run before.
    void begin(const std::map<WindowSize, QByteArray> &kept);
    std::map<WindowSize, QByteArray> toKeep() const;
    void useDefault(); // for the size that the window has

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Kept
    {
        QByteArray state;
        QSize in; // a window of this size
    };
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
    QByteArray m_settled; // as it came of the window's size: nobody has arranged anything since
    QTimer m_settling{this};
    bool m_hasBegun = false;
    bool m_wasShown = true; // or it is no matter as yet
};

} // namespace codewheel
