// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/faults/desktop_notice.h"
#include "vocabulary/message.h"

#include <QTimer>

namespace codewheel {

// Tells the desktop of faults that arrive while no window of the program is in front: the first at once, then
// all since then together, with some seconds between.
class UnseenFaults : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::milliseconds usualPause{5'000};

    explicit UnseenFaults(std::chrono::milliseconds pause = usualPause, QObject *parent = nullptr);

    void setWishes(bool notifies, bool withSound);
    void take(const Message &message);

Q_SIGNALS:
    void told();         // a sign in the task bar is due, too
    void windowWanted(); // the user clicked on the notice
    void beepWanted();   // the desktop makes no sound

private:
    void tell();
    void forget(); // a window is in front: they are seen there

    DesktopNotice m_notice;
    QTimer m_pause;
    bool m_notifies = true;
    bool m_withSound = false;
    int m_unseen = 0;
    bool m_isDue = false; // more have come since the desktop was told
    Message m_last;
};

} // namespace codewheel
