// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/message.h"

#include <QObject>

#include <map>

namespace codewheel {

class RingSession;
class InlineMessage;
class Leaving;
class ProjectDocument;
class RingAtWork;

// Offline and online: connects to the ring and leaves it, has it read in, and says whether it is as the
// project has it. What it does to the views is up to the window.
class RingConnection : public QObject
{
    Q_OBJECT

public:
    // All must outlive it. The notice stands in the window.
    RingConnection(RingAtWork &ring, ProjectDocument &project, Leaving &leaving, InlineMessage &notice,
                   QObject *parent = nullptr);

    void connectRing();
    void disconnectRing();     // asks first for handshakes on their way and OUT words that are not 0
    void readIn();             // likewise: the data cycles stop meanwhile; needs Operate
    void confirmDiagnostics(); // needs Operate
    // Says whether the ring is as it is configured.
    void tellComparison();

Q_SIGNALS:
    void ringChanged(); // another one was read in
    void changed();     // what can be done with it
    void told(const codewheel::Message &message);

private:
    void ringConnected();
    void rememberTold();
    void tellAgain();
    bool mayChangeRing(); // else it says why not

    RingAtWork &m_ring;
    RingSession &m_bus; // of the ring
    ProjectDocument &m_project;
    Leaving &m_leaving;
    InlineMessage &m_notice;
    bool m_isRefused = false; // as the notice says
    // What the user told of each device, with the make it was taken for.
    struct Told
    {
        QString deviceKey;
        ParameterValues values;
    };
    std::map<NodeId, Told> m_told;
};

} // namespace codewheel
