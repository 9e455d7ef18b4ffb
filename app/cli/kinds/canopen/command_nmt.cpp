// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/places.h"
#include "cli/call/keys.h"
#include "cli/call/texts.h"
#include "cli/encoder/consent.h"
#include "cli/kinds/canopen/canopen_link_kind.h"
#include "cli/kinds/canopen/canopen_scan.h"
#include "cli/kinds/canopen/object_argument.h"
#include "kinds/canopen/protocol/canopen_refusals.h"
#include "vocabulary/sentence.h"

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using canopen::NmtCommand;
using canopen::NmtState;

constexpr const char *nmtExamples[] = {"nmt start can:5 --link canopen:training", "nmt stop --yes",
                                       "nmt reset can:5 --json"};

constexpr std::array nmtOptions{
    busOption,
    Option{"--yes", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "send it without asking")},
};

constexpr Instant longestWaitForState = 1'500ms; // a heartbeat comes once a second
constexpr std::chrono::seconds longestBoot{3};
constexpr Instant longestSecondBoot = 500ms; // of another one with this number

struct CommandRow
{
    const char *key;
    NmtCommand command;
    NmtState leadsTo;
    const char *question;      // for one node
    const char *questionToAll; // for all
};
constexpr auto commandRows = std::to_array<CommandRow>({
    {"start", NmtCommand::start, NmtState::operational,
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "Start node %1?"),
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "Start all nodes?")},
    {"stop", NmtCommand::stop, NmtState::stopped,
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "Stop node %1? It answers nothing then."),
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "Stop all nodes? They answer nothing then.")},
    {"pre-operational", NmtCommand::preOperational, NmtState::preOperational,
     QT_TRANSLATE_NOOP("codewheel::CommandLine", "Set node %1 to pre-operational? It sends no PDOs then."),
     QT_TRANSLATE_NOOP("codewheel::CommandLine",
                       "Set all nodes to pre-operational? They send no PDOs then.")},
    {"reset", NmtCommand::resetNode, NmtState::preOperational,
     QT_TRANSLATE_NOOP("codewheel::CommandLine",
                       "Reset node %1? What is not stored is lost, and it has to be started again."),
     QT_TRANSLATE_NOOP("codewheel::CommandLine",
                       "Reset all nodes? What is not stored is lost, and they have to be started again.")},
});

const CommandRow *rowOf(const QString &typed)
{
    const auto row = std::ranges::find(commandRows, typed,
                                       [](const CommandRow &one) { return QString::fromLatin1(one.key); });
    return row == commandRows.end() ? nullptr : &*row;
}

// What a node tells of itself, before and after.
struct Watched
{
    int bootUps = 0;
    std::optional<NmtState> state{};
};

Watched watched(const CanopenAccess &bus, int node)
{
    const auto *heard = bus.session().latest().heard(node);
    return heard != nullptr ? Watched{heard->bootUps, heard->state} : Watched();
}

Complaint aboutState(int node, std::optional<NmtState> state)
{
    return notDone("nmtNotTaken",
                   sentence(CommandLine::tr("Node %1 has not done it: it is %2."),
                            {CanopenAddress{node}.shown(), nmtStateText(state)}),
                   {std::int64_t{node}});
}

Complaint aboutUntoldState(int node)
{
    return notDone(
        "nmtStateNotKnown",
        sentence(CommandLine::tr("Sent. Node %1 does not tell its state, so whether it has done it is not "
                                 "known."),
                 {CanopenAddress{node}.shown()}),
        {std::int64_t{node}});
}

Complaint aboutSending(CanFate fate)
{
    return fate == CanFate::refused
               ? notDone("nmtNotSent",
                         CommandLine::tr("The command could not be sent. Check the CAN bus, then send it "
                                         "again."))
               : notDone("nmtNotKnown",
                         CommandLine::tr("Whether the command has gone out is not known: the adapter does "
                                         "not tell."));
}

// Where the node does not show it.
Complaint aboutDoubt(const CanopenAccess &bus, const CommandRow &row, int node, CanFate fate)
{
    if (fate == CanFate::notKnown)
        return aboutSending(fate);
    if (row.command != NmtCommand::resetNode)
        return aboutUntoldState(node);
    return bus.complaint({RefusalKind::device,
                          CanopenRefusalId::notBackAfterReset,
                          {std::int64_t{node}, std::int64_t{longestBoot.count()}}});
}

// What is known of the node afterwards. The command itself is answered by nobody.
void tellNode(CanopenAccess &bus, const CommandRow &row, int node, const Watched &before, CanFate fate,
              Answer &answer)
{
    const bool resets = row.command == NmtCommand::resetNode;
    const auto isDone = [&] {
        const Watched now = watched(bus, node);
        return resets ? now.bootUps > before.bootUps : now.state == row.leadsTo;
    };
    const bool isSeen = bus.waitUntil(isDone, resets ? Instant(longestBoot) : longestWaitForState);
    if (isSeen && resets)
        bus.waitUntil([&] { return watched(bus, node).bootUps > before.bootUps + 1; }, longestSecondBoot);
    const std::optional<NmtState> state = watched(bus, node).state;
    answer.json.insert(QStringLiteral("state"), nmtStateJson(state));
    if (!bus.isConnected()) {
        answer.complaint = bus.linkLost();
    } else if (const auto doubled = bus.whetherDoubled(node)) {
        answer.complaint = doubled;
    } else if (resets && isSeen) {
        answer.text += sentence(CommandLine::tr("Node %1 is back."), {CanopenAddress{node}.shown()}) + u'\n';
    } else if (isSeen) {
        answer.text +=
            sentence(CommandLine::tr("Node %1 is %2."), {CanopenAddress{node}.shown(), nmtStateText(state)}) +
            u'\n';
    } else if (state && !resets) {
        answer.complaint = aboutState(node, state);
    } else {
        answer.complaint = aboutDoubt(bus, row, node, fate);
    }
}

Checked<Answer> command(const Call &call, CanopenAccess &bus, const CommandRow &row, int node)
{
    if (const auto opened = bus.openToSend(call); !opened)
        return tl::unexpected(opened.error());
    const QString question = node == 0
                                 ? CommandLine::tr(row.questionToAll)
                                 : sentence(CommandLine::tr(row.question), {CanopenAddress{node}.shown()});
    if (const auto agreed =
            consent(call, question, CommandLine::tr("Nothing was sent: there is nobody to ask. Add --yes."));
        !agreed)
        return tl::unexpected(agreed.error());
    if (const auto may = bus.listenAgain(); !may)
        return tl::unexpected(may.error());
    const CanopenAccess::ByHand byHand(bus);
    const Watched before = watched(bus, node);
    const auto fate = bus.send(canopen::NmtRequest{row.command, node}.frame());
    if (!fate)
        return tl::unexpected(fate.error());
    Answer answer{
        .json = {{QStringLiteral("nmt"), QString::fromLatin1(row.key)}, {QStringLiteral("node"), node}}};
    addBus(answer.json, bus);
    if (*fate != CanFate::refused && node != 0)
        tellNode(bus, row, node, before, *fate, answer);
    else if (*fate != CanFate::done)
        answer.complaint = aboutSending(*fate);
    else
        answer.text += CommandLine::tr("Sent to all nodes.") + u'\n';
    return answer;
}

Checked<Answer> runNmt(const Call &call)
{
    const QStringList &words = call.arguments.rest;
    const CommandRow *row = rowOf(words[0]);
    if (row == nullptr)
        return badInput("nmtCommandWrong", CommandLine::tr("\"%1\" is not possible. Write one of: %2."),
                        {words[0], listed(commandRows, [](const CommandRow &one) {
                             return QString::fromLatin1(one.key);
                         })});
    if (words.size() < 2)
        return canBusMeant(call).and_then([&](CanopenAccess *bus) { return command(call, *bus, *row, 0); });
    return nodeMeant(call, words[1]).and_then([&](const NodeMeant &where) {
        return command(call, *where.bus, *row, where.node()).map([&](Answer answer) {
            addPlace(answer.json, call, where.place);
            return answer;
        });
    });
}

} // namespace

const Subcommand nmtCommand{
    .name = "nmt",
    .usage = "start|stop|pre-operational|reset [PLACE] [--bus BUS] [--yes]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "start, stop or reset nodes on CANopen"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Sends the command to the node at PLACE, or to all nodes. A node that is started sends its PDOs; "
        "one\n"
        "that is stopped answers nothing. It is asked for first; where nobody can be asked, --yes is "
        "needed.\n"
        "\n"
        "Nodes do not answer it. What the node tells afterwards by its heartbeat or boot-up is shown: exit\n"
        "code 1 if it is in another state, does not tell its state, or does not report after a reset."),
    .examples = nmtExamples,
    .options = nmtOptions,
    .arguments = {1, 2},
    .needsBus = true,
    .textIsAccount = true,
    .run = runNmt,
};

} // namespace codewheel
