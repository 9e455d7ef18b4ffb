// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/message.h"
#include "vocabulary/refusal.h"

#include <QObject>

namespace codewheel {

class RingSession;
class InlineMessage;
class Leaving;
class ProjectDocument;
class RingAtWork;

// Connects to the ring and disconnects from it, has it read in, and says whether it matches the project. What
// that does to the views is up to the window.
class RingConnection : public QObject
{
    Q_OBJECT

public:
    // All must outlive it. The notice is part of the window.
    RingConnection(RingAtWork &ring, ProjectDocument &project, Leaving &leaving, InlineMessage &notice,
                   QObject *parent = nullptr);

    void connectRing();
    void disconnectRing();     // first asks about running handshakes and OUT words that are not 0
    void readIn();             // likewise, as the data cycles stop meanwhile; needs Operate
    void confirmDiagnostics(); // needs Operate
    void startAfresh();        // a simulated ring that is connected; nothing told of its encoders stays
    // Says whether the ring matches its configuration.
    void tellComparison();

Q_SIGNALS:
    void ringChanged();                          // another one was read in
    void changed();                              // what is possible with it
    void refused(const codewheel::Refusal &why); // to connect it
    void told(const codewheel::Message &message);

private:
    void ringConnected();
    bool mayChangeRing(); // if not, it says why

    RingAtWork &m_ring;
    RingSession &m_bus; // of the ring
    ProjectDocument &m_project;
    Leaving &m_leaving;
    InlineMessage &m_notice;
    bool m_isConnecting = false;
    bool m_isRefused = false; // the notice is a refusal
    // What the user entered for each device, with the make it was then.
};

} // namespace codewheel
