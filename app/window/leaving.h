// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/encoder_session.h"

#include <QObject>
#include <QPointer>

#include <functional>
#include <map>

class QWidget;

namespace codewheel {

class Buses;
class EncoderBus;

// What has to be asked before the bus is stopped, left, or the window is closed: how to end a handshake that
// is on its way, and whether OUT words that are not 0 shall be set to 0. Nothing is lost by saying "no".
class Leaving : public QObject
{
    Q_OBJECT

public:
    enum class Why { stop, disconnect, quit };

    explicit Leaving(QWidget &window);

    // They outlive it. Once, before anything is asked.
    void setBuses(Buses &buses);
    // Calls `then` once all is answered and done; not at all if the user stays. `left` are the buses that are
    // meant; null is none.
    void ask(Why why, const std::vector<EncoderBus *> &left, std::function<void()> then);

private:
    void goOn();
    bool endJob(EncoderSession &encoder);
    bool askForOut(const std::vector<Place> &devices);
    EncoderSession *busyEncoder() const;
    std::vector<EncoderBus *> buses() const; // that are left, and still open
    bool canSend() const;                    // on all of them
    void watch();
    void takeProgress(const EncoderSession &encoder, const Progress &progress);
    void stay();

    QWidget &m_window;
    Buses *m_buses = nullptr;
    std::vector<QPointer<EncoderSession>> m_watched;
    std::map<Place, Progress> m_progress; // of the jobs on their way
    QPointer<EncoderSession> m_cancelled; // as long as nothing was taken
    Why m_why = Why::stop;
    std::vector<EncoderBus *> m_left; // only to be looked for: they may be gone
    std::function<void()> m_then;
    bool m_outAnswered = false;
    bool m_waitsForZero = false;
};

} // namespace codewheel
