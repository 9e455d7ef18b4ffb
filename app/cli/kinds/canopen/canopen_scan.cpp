// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/canopen/canopen_scan.h"

#include "cli/call/json.h"
#include "cli/call/keys.h"
#include "cli/call/stop_signals.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/kinds/canopen/canopen_access.h"
#include "cli/kinds/canopen/device_on_node.h"
#include "kinds/canopen/bus/canopen_facts.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"
#include "vocabulary/serial_number_text.h"

#include <algorithm>
#include <map>

namespace codewheel {
namespace {

constexpr int usualListening = 3; // s; heartbeats come once a second
constexpr int longestListeningAsked = 3'600;
constexpr Instant canLookInterval = std::chrono::milliseconds(20);

// False: it was cancelled, or the link is gone.
bool listen(CanopenAccess &bus, StopSignals &stop, Instant duration)
{
    for (Instant passed{}; passed < duration; passed += canLookInterval)
        if (!bus.advance(canLookInterval) || stop.came())
            return false;
    return true;
}

// As far as they came.
struct AskedNodes
{
    std::optional<NodesScanned> scanned{}; // empty: not done
    bool wasStopped = false;               // by Ctrl+C
};

AskedNodes ask(const Call &call, CanopenAccess &bus, StopSignals &stop)
{
    AskedNodes asked;
    QObject scope;
    QObject::connect(&bus.session(), &CanopenSession::scanned, &scope, [&](const NodesScanned &some) {
        asked.scanned = some;
        if (!call.arguments.has("--json") && !some.isDone)
            call.terminal.showProgress(
                sentence(CommandLine::tr("Nodes asked: %1 of 127. Found: %2."),
                         {QString::number(some.asked), QString::number(some.found.size())}));
    });
    bus.session().scan();
    while ((!asked.scanned || !asked.scanned->isDone) && bus.advance(canLookInterval)) {
        asked.wasStopped = asked.wasStopped || stop.came();
        if (asked.wasStopped || bus.isAlone())
            bus.session().cancelScan();
    }
    call.terminal.showProgress({});
    return asked;
}

std::vector<NodeOnBus> together(const CanopenSnapshot &heard, const std::vector<canopen::FoundNode> &asked)
{
    std::map<int, NodeOnBus> nodes;
    for (const CanopenSnapshot::Node &one : heard.nodes)
        nodes[one.node].heard = one;
    for (const canopen::FoundNode &one : asked) {
        nodes[one.node].asked = one;
        nodes[one.node].heard.node = one.node;
    }
    std::vector<NodeOnBus> all;
    all.reserve(nodes.size());
    for (const auto &[number, node] : nodes)
        all.push_back(node);
    return all;
}

QString typeText(const Catalog &catalog, const NodeOnBus &node)
{
    if (!node.asked)
        return {};
    const QString device = deviceOfNode(catalog, node.asked->deviceType, node.asked->identity);
    return device.isEmpty() && node.asked->deviceType ? hexNumber(*node.asked->deviceType, 8) : device;
}

QString wordText(const NodeOnBus &node, std::size_t word)
{
    const auto number = node.asked ? node.asked->identity.at(word) : std::nullopt;
    return number ? hexNumber(*number) : QString();
}

QString tableOf(const Catalog &catalog, const std::vector<NodeOnBus> &nodes, bool wasAsked)
{
    TextTable table;
    QStringList head{CommandLine::tr("place"), CommandLine::tr("state"), QStringLiteral("PDO")};
    if (wasAsked)
        head << CommandLine::tr("device") << CommandLine::tr("vendor") << CommandLine::tr("product")
             << CommandLine::tr("revision") << CommandLine::tr("serial number");
    table.add(head << CommandLine::tr("errors"));
    for (const NodeOnBus &node : nodes) {
        QStringList cells{CanopenAddress{node.heard.node}.place().toString(),
                          orDash(nodeStateText(node.heard)),
                          node.heard.sendsPdos ? CommandLine::tr("sends") : orDash({})};
        if (wasAsked) {
            cells << orDash(typeText(catalog, node));
            for (std::size_t word = 0; word + 1 < canopen::NodeIdentity::size; ++word)
                cells << orDash(wordText(node, word));
            const auto serial = node.asked ? node.asked->identity.back() : std::nullopt;
            cells << orDash(serial ? serialNumberText(*serial) : QString());
        }
        table.add(cells << orDash(nodeTroubles(node.heard).join(QStringLiteral("; "))));
    }
    return table.toString();
}

QJsonObject nodeJson(const NodeOnBus &node)
{
    QJsonObject json{
        {QStringLiteral("place"), CanopenAddress{node.heard.node}.place().toString()},
        {QStringLiteral("answers"), node.asked.has_value()},
        {QStringLiteral("deviceType"),
         node.asked && node.asked->deviceType ? QJsonValue(qint64{*node.asked->deviceType}) : QJsonValue()},
    };
    for (const CanopenNodeFact &fact : canopenNodeFacts())
        json.insert(QString::fromLatin1(fact.key), fact.json(node.heard));
    constexpr std::array keys{"vendor", "product", "revision", "serialNumber"};
    for (std::size_t word = 0; word < keys.size(); ++word) {
        const auto number = node.asked ? node.asked->identity.at(word) : std::nullopt;
        json.insert(QString::fromLatin1(keys.at(word)), number ? QJsonValue(qint64{*number}) : QJsonValue());
    }
    return json;
}

QString aboutNobody(bool wasAsked, const CanopenFigures &figures)
{
    if (figures.isOnlyJ1939())
        return CommandLine::tr("Only frames of 29 bits are heard: what is there speaks J1939, not CANopen. "
                               "Another variant of the device is needed.");
    return wasAsked ? CommandLine::tr("No node answers. Check the rate of the bus, its terminators, wiring "
                                      "and supply; a node that was stopped does not answer.")
                    : CommandLine::tr("No node is heard. One that has not been started may tell nothing by "
                                      "itself: codewheel-cli scan --ask asks each.");
}

Answer answerOf(const Catalog &catalog, const CanopenAccess &bus, const std::vector<NodeOnBus> &nodes,
                bool wasAsked)
{
    const CanopenSnapshot &now = bus.session().latest();
    QJsonArray json;
    for (const NodeOnBus &node : nodes)
        json.append(nodeJson(node));
    Answer answer;
    answer.json = {{QStringLiteral("nodes"), json}, {QStringLiteral("link"), bus.linkKey()}};
    for (const char *key : {"load", "otherMaster", "errorFrames"})
        answer.json.insert(QString::fromLatin1(key), canopenFact(QLatin1String(key)).json(bus.session()));
    answer.text =
        nodes.empty() ? aboutNobody(wasAsked, now.figures) + u'\n' : tableOf(catalog, nodes, wasAsked);
    if (const QString load = highLoadText(now); !load.isEmpty())
        answer.text += load + u'\n';
    if (now.otherMaster.isHeard())
        answer.text += sentence(CommandLine::tr("Another master is at work (heard: %1)."),
                                {OtherMaster::textOf(now.otherMaster.argument())}) +
                       u'\n';
    if (now.figures.errorFrames > 0)
        answer.text += sentence(CommandLine::tr("Error frames: %1. The rate may be wrong, or the wiring."),
                                {QString::number(now.figures.errorFrames)}) +
                       u'\n';
    return answer;
}

} // namespace

Checked<Instant> timeToListen(const Call &call, const CanopenAccess &bus)
{
    const auto whole = call.arguments.has("--listen") ? std::nullopt : bus.length();
    return call.arguments.number("--listen", usualListening, 1, longestListeningAsked).map([&](int seconds) {
        return whole.value_or(std::chrono::seconds(seconds));
    });
}

Checked<ScannedCan> scanCan(const Call &call, CanopenAccess &bus)
{
    const auto time = timeToListen(call, bus);
    if (!time)
        return tl::unexpected(time.error());
    const bool asks = call.arguments.has("--ask");
    if (const auto opened = asks ? bus.openToSend(call) : bus.openToListen(call); !opened)
        return tl::unexpected(opened.error());
    StopSignals stop;
    bool isStuck = false; // nothing went out any more
    bool isWhole = listen(bus, stop, *time);
    std::vector<canopen::FoundNode> asked;
    if (const auto others = asks ? bus.whetherOnlyJ1939() : std::nullopt)
        return tl::unexpected(*others);
    if (isWhole && asks) {
        const AskedNodes result = ask(call, bus, stop);
        const bool isCancelled = result.scanned && result.scanned->isCancelled;
        isWhole = result.scanned && result.scanned->isDone && !isCancelled;
        isStuck = isCancelled && !result.wasStopped;
        asked = result.scanned ? result.scanned->found : asked;
    }
    if (!bus.isConnected() || bus.isAlone())
        return tl::unexpected(bus.whyNothingCame());
    const bool isHeard = bus.session().latest().figures.received > 0;
    if (isStuck && !isHeard)
        return tl::unexpected(bus.aboutNobody());
    ScannedCan scanned{.answer = {}, .nodes = together(bus.session().latest(), asked)};
    scanned.answer = answerOf(call.catalog, bus, scanned.nodes, asks);
    if (isStuck)
        scanned.answer.complaint =
            notDone("scanStuck",
                    CommandLine::tr("Nothing that is sent gets out, so not all nodes were asked: what was "
                                    "found until then is listed."));
    else if (!isWhole)
        scanned.answer.complaint =
            notDone("scanCancelled",
                    CommandLine::tr("The search was cancelled: what was found until then is listed."));
    return scanned;
}

} // namespace codewheel
