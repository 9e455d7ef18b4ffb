// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/bus/canopen_snapshot.h"

#include <QJsonValue>
#include <QStringList>

#include <span>

namespace codewheel {

class CanopenSession;

// What is known of a CAN bus with CANopen and of its nodes, said once: panels, the command line and JSON take
// it from here.

// One of the bus.
struct CanopenFact
{
    const char *key; // language-neutral: "errorFrames"
    const char *itsLabel;
    const char *itsToolTip;
    QString (*text)(const CanopenSession &bus); // with its unit; empty: not known
    QJsonValue (*json)(const CanopenSession &bus);

    QString label() const; // "Error frames"
    QString toolTip() const;
};
std::span<const CanopenFact> canopenFacts();
const CanopenFact &canopenFact(QLatin1String key); // one that there is

// One of a node that was heard.
struct CanopenNodeFact
{
    const char *key; // "heartbeat"
    const char *itsLabel;
    const char *itsToolTip;
    QString (*text)(const CanopenSnapshot::Node &node); // empty: nothing, or not known
    QJsonValue (*json)(const CanopenSnapshot::Node &node);

    QString label() const;
    QString toolTip() const;
};
std::span<const CanopenNodeFact> canopenNodeFacts();

QString nmtStateText(std::optional<canopen::NmtState> state); // "operational"; empty: not known
QString nodeStateText(const CanopenSnapshot::Node &node);     // with "as commanded" unless it has shown it
QJsonValue nmtStateJson(std::optional<canopen::NmtState> state);
// That the bus is nearly full, beside what does not come; empty: it is not.
QString highLoadText(const CanopenSnapshot &bus);
// What is wrong with a node: doubled, no heartbeat, EMCY; empty: nothing.
QStringList nodeTroubles(const CanopenSnapshot::Node &node);

} // namespace codewheel
