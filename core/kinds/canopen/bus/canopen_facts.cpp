// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_facts.h"

#include "can/can_state.h"
#include "kinds/canopen/bus/canopen_bus_messages.h"
#include "kinds/canopen/bus/canopen_session.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace codewheel {
namespace {

using canopen::Heartbeat;
using canopen::NmtState;
using Node = CanopenSnapshot::Node;

// The translation context of these texts.
struct CanopenFactText
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanopenFacts)
};

struct StateKey
{
    NmtState state;
    const char *key;
};
constexpr auto stateKeys = std::to_array<StateKey>({
    {NmtState::bootUp, "bootUp"},
    {NmtState::stopped, "stopped"},
    {NmtState::operational, "operational"},
    {NmtState::preOperational, "preOperational"},
});

constexpr auto heartbeatRows = std::to_array<KeyedText<Heartbeat>>({
    {Heartbeat::notHeard, "notHeard", ""},
    {Heartbeat::heard, "heard", QT_TRANSLATE_NOOP("codewheel::CanopenFacts", "comes")},
    {Heartbeat::present, "present", QT_TRANSLATE_NOOP("codewheel::CanopenFacts", "comes")},
    {Heartbeat::late, "late", QT_TRANSLATE_NOOP("codewheel::CanopenFacts", "late")},
    {Heartbeat::lost, "lost", QT_TRANSLATE_NOOP("codewheel::CanopenFacts", "lost")},
});
static_assert(areInOrder(heartbeatRows, &KeyedText<Heartbeat>::id, Heartbeat::lost));

QString translated(const char *text)
{
    return *text == '\0' ? QString() : CanopenFactText::tr(text);
}

const CanopenFigures &figuresOf(const CanopenSession &bus)
{
    return bus.latest().figures;
}

// A count of CanopenFigures.
template <std::uint64_t CanopenFigures::*Count>
QString countText(const CanopenSession &bus)
{
    return QLocale().toString(qulonglong{figuresOf(bus).*Count});
}
template <std::uint64_t CanopenFigures::*Count>
QJsonValue countJson(const CanopenSession &bus)
{
    return static_cast<qint64>(figuresOf(bus).*Count);
}

// One of the counters of the controller.
template <std::optional<int> CanStatus::*Counter>
QString counterText(const CanopenSession &bus)
{
    const auto &counter = bus.latest().status.*Counter;
    return counter ? QLocale().toString(*counter) : QString();
}
template <std::optional<int> CanStatus::*Counter>
QJsonValue counterJson(const CanopenSession &bus)
{
    const auto &counter = bus.latest().status.*Counter;
    return counter ? QJsonValue(*counter) : QJsonValue();
}

QString loadText(const CanopenSession &bus)
{
    constexpr double hundred = 100;
    return sentence(CanopenFactText::tr("%1 %", "percent"),
                    {QLocale().toString(figuresOf(bus).load * hundred, 'f', 1)});
}

QString rateText(const CanopenSession &bus)
{
    return sentence(CanopenFactText::tr("%1 kBit/s"), {inKilobits(bus.rate())});
}

QString listensText(const CanopenSession &bus)
{
    const auto &listens = bus.latest().status.listensOnly;
    if (!listens)
        return {};
    return *listens ? CanopenFactText::tr("acknowledges nothing")
                    : CanopenFactText::tr("acknowledges frames");
}

QString masterText(const CanopenSession &bus)
{
    const OtherMaster &master = bus.latest().otherMaster;
    return master.isHeard() ? OtherMaster::textOf(master.argument()) : CanopenFactText::tr("none is heard");
}

struct FactRows
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CanopenFacts)

public:
    static constexpr auto all = std::to_array<CanopenFact>({
        {"link", QT_TR_NOOP("Adapter"), QT_TR_NOOP("The interface or the port of this bus"),
         [](const CanopenSession &bus) { return bus.linkName(); },
         [](const CanopenSession &bus) { return QJsonValue(bus.linkName()); }},
        {"rate", QT_TR_NOOP("Rate"), QT_TR_NOOP("Of the bus, as far as the adapter tells it"), rateText,
         [](const CanopenSession &bus) { return QJsonValue(bus.rate()); }},
        {"load", QT_TR_NOOP("Load"), QT_TR_NOOP("How much of the last second frames were on the bus"),
         loadText, [](const CanopenSession &bus) { return QJsonValue(figuresOf(bus).load); }},
        {"controller", QT_TR_NOOP("Controller"),
         QT_TR_NOOP("The error state of our adapter: error passive from 128 errors on, bus off at 256"),
         [](const CanopenSession &bus) { return canStateText(bus.latest().status.state); },
         [](const CanopenSession &bus) { return QJsonValue(canStateKey(bus.latest().status.state)); }},
        {"listensOnly", QT_TR_NOOP("Acknowledging"),
         QT_TR_NOOP("Whether our adapter acknowledges what others send. One that only listens does not"),
         listensText,
         [](const CanopenSession &bus) {
             const auto &listens = bus.latest().status.listensOnly;
             return listens ? QJsonValue(*listens) : QJsonValue();
         }},
        {"otherMaster", QT_TR_NOOP("Another master"),
         QT_TR_NOOP("Who commands or asks nodes and is not this program, such as a PLC"), masterText,
         [](const CanopenSession &bus) { return QJsonValue(bus.latest().otherMaster.isHeard()); }},
        {"received", QT_TR_NOOP("Received"), QT_TR_NOOP("Frames, since the bus was connected"),
         countText<&CanopenFigures::received>, countJson<&CanopenFigures::received>},
        {"sent", QT_TR_NOOP("Sent"), QT_TR_NOOP("Frames of this program that the adapter has not refused"),
         countText<&CanopenFigures::sent>, countJson<&CanopenFigures::sent>},
        {"notSent", QT_TR_NOOP("Not sent"), QT_TR_NOOP("Frames that the adapter has refused"),
         countText<&CanopenFigures::notSent>, countJson<&CanopenFigures::notSent>},
        {"errorFrames", QT_TR_NOOP("Error frames"),
         QT_TR_NOOP("As far as the adapter reports them. Many: the rate or the wiring is wrong"),
         countText<&CanopenFigures::errorFrames>, countJson<&CanopenFigures::errorFrames>},
        {"notAcknowledged", QT_TR_NOOP("Not acknowledged"),
         QT_TR_NOOP("Error frames since a frame was last received, because nobody acknowledges: no other "
                    "node is there, or none at this rate"),
         countText<&CanopenFigures::notAcknowledged>, countJson<&CanopenFigures::notAcknowledged>},
        {"transmitErrors", QT_TR_NOOP("Transmit errors"), QT_TR_NOOP("The counter of the controller"),
         counterText<&CanStatus::transmitErrors>, counterJson<&CanStatus::transmitErrors>},
        {"receiveErrors", QT_TR_NOOP("Receive errors"), QT_TR_NOOP("The counter of the controller"),
         counterText<&CanStatus::receiveErrors>, counterJson<&CanStatus::receiveErrors>},
        {"extended", QT_TR_NOOP("With 29 bits"),
         QT_TR_NOOP("Frames with extended identifiers, which CANopen does not use: J1939, say"),
         countText<&CanopenFigures::extended>, countJson<&CanopenFigures::extended>},
        {"answersOfOthers", QT_TR_NOOP("Answers to others"),
         QT_TR_NOOP("SDO answers that this program did not ask for. They are never taken"),
         countText<&CanopenFigures::answersOfOthers>, countJson<&CanopenFigures::answersOfOthers>},
        {"lateAnswers", QT_TR_NOOP("Late answers"), QT_TR_NOOP("SDO answers that came after their time-out"),
         countText<&CanopenFigures::lateAnswers>, countJson<&CanopenFigures::lateAnswers>},
    });
};

QString pdoText(const Node &node)
{
    return node.sendsPdos ? CanopenFactText::tr("sends") : QString();
}

QString doubledText(const Node &node)
{
    return node.isDoubled ? CanopenFactText::tr("two nodes have this number") : QString();
}

constexpr auto nodeFactRows = std::to_array<CanopenNodeFact>({
    {"node", QT_TRANSLATE_NOOP("codewheel::CanopenFacts", "Node"),
     QT_TRANSLATE_NOOP("codewheel::CanopenFacts",
                       "Its number, in decimal as on switches, and in hexadecimal"),
     [](const Node &node) { return CanopenAddress{node.node}.shown(); },
     [](const Node &node) { return QJsonValue(node.node); }},
    {"state", QT_TRANSLATE_NOOP("codewheel::CanopenFacts", "State"),
     QT_TRANSLATE_NOOP(
         "codewheel::CanopenFacts",
         "The NMT state that the node has told last. Only an operational one sends PDOs, and a "
         "stopped one answers nothing. Behind its boot-up a node waits to be started, or starts "
         "by itself"),
     nodeStateText, [](const Node &node) { return nmtStateJson(node.state); }},
    {"heartbeat", QT_TRANSLATE_NOOP("codewheel::CanopenFacts", "Heartbeat"),
     QT_TRANSLATE_NOOP("codewheel::CanopenFacts", "Whether it comes in time. A node may have none"),
     [](const Node &node) { return translated(rowOf(heartbeatRows, node.heartbeat).text); },
     [](const Node &node) {
         return QJsonValue(QString::fromLatin1(rowOf(heartbeatRows, node.heartbeat).key));
     }},
    {"sendsPdos", QT_TRANSLATE_NOOP("codewheel::CanopenFacts", "PDO"),
     QT_TRANSLATE_NOOP("codewheel::CanopenFacts", "Whether it sends process data"), pdoText,
     [](const Node &node) { return QJsonValue(node.sendsPdos); }},
    {"doubled", QT_TRANSLATE_NOOP("codewheel::CanopenFacts", "Doubled"),
     QT_TRANSLATE_NOOP("codewheel::CanopenFacts", "Two devices have this number"), doubledText,
     [](const Node &node) { return QJsonValue(node.isDoubled); }},
    {"error", QT_TRANSLATE_NOOP("codewheel::CanopenFacts", "Error"),
     QT_TRANSLATE_NOOP("codewheel::CanopenFacts", "The newest emergency message (EMCY) that stands"),
     [](const Node &node) { return node.error ? node.error->text() : QString(); },
     [](const Node &node) { return node.error ? QJsonValue(node.error->code) : QJsonValue(); }},
});

} // namespace

QString CanopenFact::label() const
{
    return CanopenFactText::tr(itsLabel);
}

QString CanopenFact::toolTip() const
{
    return CanopenFactText::tr(itsToolTip);
}

QString CanopenNodeFact::label() const
{
    return CanopenFactText::tr(itsLabel);
}

QString CanopenNodeFact::toolTip() const
{
    return CanopenFactText::tr(itsToolTip);
}

std::span<const CanopenFact> canopenFacts()
{
    return FactRows::all;
}

const CanopenFact &canopenFact(QLatin1String key)
{
    return *std::ranges::find_if(FactRows::all,
                                 [key](const CanopenFact &fact) { return key == QLatin1String(fact.key); });
}

std::span<const CanopenNodeFact> canopenNodeFacts()
{
    return nodeFactRows;
}

QString nmtStateText(std::optional<NmtState> state)
{
    return state ? canopen::NodeState{.state = *state}.text() : QString();
}

QString nodeStateText(const Node &node)
{
    if (node.hasBooted)
        return nmtStateText(NmtState::bootUp);
    return node.state || !node.commanded ? nmtStateText(node.state)
                                         : sentence(CanopenFactText::tr("%1 (as commanded)", "a state"),
                                                    {nmtStateText(node.commanded)});
}

// One that is none of the standard's has no key.
QJsonValue nmtStateJson(std::optional<NmtState> state)
{
    const auto row = state ? std::ranges::find(stateKeys, *state, &StateKey::state) : stateKeys.end();
    return row == stateKeys.end() ? QJsonValue() : QJsonValue(QString::fromLatin1(row->key));
}

QString highLoadText(const CanopenSnapshot &bus)
{
    if (bus.figures.load < CanopenFigures::highLoad)
        return {};
    return messageText({.id = CanopenBusMessageId::loadHigh,
                        .arguments = {static_cast<std::int64_t>(std::lround(bus.figures.load * 100))}});
}

QStringList nodeTroubles(const Node &node)
{
    QStringList texts;
    if (const QString doubled = doubledText(node); !doubled.isEmpty())
        texts << doubled;
    if (node.heartbeat == Heartbeat::lost)
        texts << CanopenFactText::tr("no heartbeat any more");
    if (node.error)
        texts << node.error->text();
    return texts;
}

} // namespace codewheel
