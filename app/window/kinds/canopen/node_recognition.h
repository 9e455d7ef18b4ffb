// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/bus/canopen_session.h"
#include "kinds/canopen/protocol/described_node.h"
#include "kinds/canopen/protocol/objects_heard.h"

#include <QObject>
#include <QPointer>

#include <map>
#include <set>

namespace codewheel {

class ProjectDocument;

// Encoders that are described as of any make are described as of their make, once their identity (1018h) fits
// a description, such as one that was imported from an EDS. The identity is heard, whoever asks; in Operate
// they are asked for it once. Used by CanopenViews.
class NodeRecognition final : public QObject
{
    Q_OBJECT

public:
    explicit NodeRecognition(const ProjectDocument &project, QObject *parent = nullptr);

    void setBus(CanopenSession *bus); // null: none
    void goOn();                      // now and then

Q_SIGNALS:
    void recognised(codewheel::Place place, const QString &device);

private:
    struct Node
    {
        canopen::ToldIdentity identity{};
        bool isAsked = false;
        bool isComplete = false; // as far as it tells
        bool isDone = false;     // what the user says afterwards goes before it
    };

    void hear(const CanopenRow &row, Instant at);
    void forget();
    const EncoderSession *unnamed(int node) const; // null: there is none, or its make is known
    bool mayAsk(int node) const;
    void ask(int node);
    void describe(int node, const canopen::ToldIdentity &identity);

    const ProjectDocument &m_project;
    QPointer<CanopenSession> m_bus;
    bool m_canRecognise = false; // there are descriptions to recognise nodes by
    canopen::ObjectsHeard m_heard;
    std::map<int, Node> m_nodes;
};

} // namespace codewheel
