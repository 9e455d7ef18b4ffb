// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

namespace codewheel {

class MainWindow;

// Makes a window take its frames: 30 a second, or the set rate, while any window of the program is visible or
// a job runs, otherwise 5, so that messages are kept. A window that becomes visible again is up to date.
class FrameClock : public QObject
{
public:
    explicit FrameClock(QObject *parent = nullptr);

    void setWindow(MainWindow &window) { m_window = &window; } // before start()
    void setRate(int framesPerSecond);                         // 5 or more
    void start() { m_timer.start(); }
    void stop()
    {
        m_timer.stop();
        m_left = 0;
    }

    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void tick();
    void takeFrame();

    MainWindow *m_window = nullptr;
    QTimer m_timer;
    int m_leftOutUnseen = 0;
    int m_left = 0; // skipped since the last one
};

} // namespace codewheel
