// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

namespace codewheel {

class MainWindow;

// Has a window take its frames: 30 a second, or as many as are set, while any window of the program can be
// seen or a job runs, else 5, so that messages are kept. What comes in sight again is of now.
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
    int m_left = 0; // frames left out since the last one
};

} // namespace codewheel
