// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/word_channel.h"
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/encoder/consent.h"
#include "cli/kinds/interbus/alarm_stop.h"
#include "cli/kinds/interbus/gateway_access.h"
#include "cli/kinds/interbus/master_text.h"
#include "cli/kinds/interbus/ring_access.h"
#include "cli/kinds/interbus/ring_link_kind.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/ring/numbering.h"
#include "kinds/interbus/ring/ring_refusals.h"
#include "vocabulary/hex.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/sentence.h"

#include <QJsonArray>

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>

namespace codewheel {
namespace {

constexpr const char *masterExamples[] = {"master", "master segment 6 off --yes",
                                          "master --after 31000 --fault-plan resources/examples/faults.json"};

constexpr int longestTrial = 86'400'000; // ms
constexpr int afterwards = 10;           // cycles, for faults that come back at once
constexpr int usualPatience = 10;        // s
constexpr int longestPatience = 3'600;   // s

constexpr std::array masterOptions{
    busOption,
    Option{"--after", "MS",
           QT_TRANSLATE_NOOP("codewheel::CommandLine", "let so many milliseconds pass on the bus first")},
    Option{"--yes", nullptr, QT_TRANSLATE_NOOP("codewheel::CommandLine", "do it without asking")},
    Option{"--patience", "SECONDS",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "how long an alarm-stop tries to get its zeros to a gateway (10)")},
};

constexpr const char *actions = "status, start, stop, alarm-stop, read-in, confirm, segment N on|off";

// What is asked of the master, and the question before it if it changes what the ring does: made once the bus
// is ready.
struct Action
{
    std::function<void(RingSession &)> carryOut;
    std::function<QString(const RingSession &)> question{}; // empty: nothing has to be asked
    bool isForAllRings = false;                             // unless one is named
    bool needsMaster = true;
    bool sendsZeros = false;
};

// What was asked for besides the action.
struct MasterWish
{
    Action action;
    int after = 0; // ms
    std::chrono::seconds patience{};
    bool isForSeveral = false; // rings
};

tl::unexpected<Complaint> unknownAction(const QString &text)
{
    return badInput("unknownAction", CommandLine::tr("\"%1\" is not an action of the master. There are: %2."),
                    {text, QString::fromLatin1(actions)});
}

// The devices that go with the segment, and the words they have now.
QString segmentQuestion(const RingSession &bus, int segment, bool on)
{
    if (on)
        return sentence(CommandLine::tr("Put segment %1 back into the data cycles?"),
                        {QString::number(segment)});
    QStringList devices;
    for (const std::size_t place : placesBehindSegment(bus.structure(), segment)) {
        const NodeId number = bus.structure()[place].number;
        const WordChannel *channel = bus.channel(number);
        devices << (channel && channel->out() != 0 ? sentence(CommandLine::tr("%1 (OUT %2)"),
                                                              {number.toString(), hexWord(channel->out())})
                                                   : number.toString());
    }
    return sentence(
        CommandLine::tr("Switch segment %1 off? Out of the data cycles go, with outputs at 0: %2."),
        {QString::number(segment), devices.join(QStringLiteral(", "))});
}

Checked<Action> segmentAction(const QStringList &words)
{
    bool isNumber = false;
    const int segment = words.value(1).toInt(&isNumber);
    const QString how = words.value(2);
    if (words.size() != 3 || !isNumber || (how != QStringLiteral("on") && how != QStringLiteral("off")))
        return unknownAction(words.join(u' '));
    const bool on = how == QStringLiteral("on");
    return Action{[segment, on](RingSession &bus) { bus.switchSegment(segment, on); },
                  [segment, on](const RingSession &bus) { return segmentQuestion(bus, segment, on); }};
}

Action asking(void (RingSession::*service)(), const QString &question)
{
    return {[service](RingSession &bus) { (bus.*service)(); },
            [question](const RingSession &) { return question; }};
}

Checked<Action> actionOf(const QStringList &words)
{
    const QString name = words.value(0, QStringLiteral("status"));
    if (name == QStringLiteral("segment"))
        return segmentAction(words);
    if (words.size() > 1)
        return unknownAction(words.join(u' '));
    if (name == QStringLiteral("status"))
        return Action{[](RingSession &) {}};
    if (name == QStringLiteral("start"))
        return Action{[](RingSession &bus) { bus.setRunning(true); }};
    if (name == QStringLiteral("stop"))
        return Action{[](RingSession &bus) { bus.setRunning(false); }};
    if (name == QStringLiteral("alarm-stop"))
        return Action{.carryOut = &RingSession::alarmStop,
                      .isForAllRings = true,
                      .needsMaster = false,
                      .sendsZeros = true};
    if (name == QStringLiteral("read-in"))
        return asking(&RingSession::readIn, CommandLine::tr("Read in the ring? Data cycles stop meanwhile."));
    if (name == QStringLiteral("confirm"))
        return asking(&RingSession::confirmDiagnostics, CommandLine::tr("Confirm diagnostics?"));
    return unknownAction(name);
}

// What the bus has reported since, with its time in ms.
struct Told
{
    std::vector<Message> messages;
    std::optional<Refusal> refusal{}; // of the action
};

std::int64_t millisecondsOf(const Message &message)
{
    return std::chrono::duration_cast<std::chrono::milliseconds>(message.at).count();
}

QString messageLines(const std::vector<Message> &messages)
{
    using enum TextTable::Align;
    TextTable table({right, left, left});
    for (const Message &message : messages)
        table.add({CommandLine::tr("%1 ms").arg(millisecondsOf(message)),
                   message.place->isEmpty() ? QStringLiteral("-") : message.place->toString(),
                   messageText(message)});
    return table.toString();
}

QJsonArray messagesJson(const std::vector<Message> &messages)
{
    QJsonArray rows;
    for (const Message &message : messages) {
        const QJsonObject what =
            errorJson({.key = messageKey(message.id), .text = {}, .arguments = message.arguments});
        rows.append(
            QJsonObject{{QStringLiteral("milliseconds"), static_cast<qint64>(millisecondsOf(message))},
                        {QStringLiteral("bus"), message.place->bus.number},
                        {QStringLiteral("place"), textJson(message.place->toString())},
                        {QStringLiteral("key"), what[QStringLiteral("key")]},
                        {QStringLiteral("arguments"), what[QStringLiteral("arguments")]}});
    }
    return rows;
}

Checked<void> agreed(const Call &call, const RingSession &bus, const Action &action)
{
    if (!action.question)
        return {};
    return consent(call, action.question(bus),
                   CommandLine::tr("Nothing was sent: there is nobody to ask. Add --yes to do it."));
}

Checked<Told> carryOutAction(const Call &call, RingSession &bus, const MasterWish &wish)
{
    const Action &action = wish.action;
    Told told;
    QObject scope;
    QObject::connect(&bus, &RingSession::messaged, &scope,
                     [&](const Message &message) { told.messages.push_back(message); });
    bus.advance(std::max(wish.after, 1));
    if (const auto may = agreed(call, bus, action); !may)
        return tl::unexpected(may.error());
    QObject::connect(&bus, &RingSession::refused, &scope,
                     [&](const Refusal &why) { told.refusal = told.refusal.value_or(why); });
    action.carryOut(bus);
    do
        bus.advance(afterwards);
    while (bus.isReadingIn());
    bus.advance(afterwards); // of the ring that was read in
    return told;
}

Checked<std::vector<BusAccess *>> ringsMeant(const Call &call, const Action &action)
{
    const QString kind = QString::fromLatin1(interbusKind);
    if (const auto rings = busesOf(call, kind);
        action.isForAllRings && !call.arguments.has("--bus") && rings.size() > 1)
        return rings;
    return busMeant(call, kind).map([](BusAccess *ring) { return std::vector{ring}; });
}

// A link that reaches no master says so before it is opened. ALARM STOP needs none.
Checked<void> openFor(const Call &call, RingAccess &access, const Action &action)
{
    if (access.mayReachMaster() || !action.needsMaster)
        return access.open();
    const QString service =
        call.arguments.rest.isEmpty() ? QStringLiteral("status") : call.arguments.rest.join(u' ');
    return tl::unexpected(
        complaintAbout({RefusalKind::notSupported, RingRefusalId::masterServiceNotSupported, {service}}));
}

Checked<Told> toldAfter(const Call &call, RingAccess &access, const MasterWish &wish)
{
    if (const auto opened = openFor(call, access, wish.action); !opened)
        return tl::unexpected(opened.error());
    return carryOutAction(call, access.ring(), wish);
}

Checked<Answer> stopBehindGateway(const Call &call, GatewayAccess &access, const MasterWish &wish)
{
    const auto stop = alarmStopBehindGateway(call, access, wish.patience, wish.isForSeveral);
    if (!stop)
        return tl::unexpected(stop.error());
    const QString told = stop->unsaid.empty() ? QString() : messageLines(stop->unsaid) + u'\n';
    Answer answer{told + stop->text + masterLines(access.ring()),
                  {{QStringLiteral("master"), masterJson(access.ring())},
                   {QStringLiteral("messages"), messagesJson(stop->messages)},
                   {QStringLiteral("zeros"), stop->json}}};
    addBus(answer.json, access);
    answer.complaint = stop->complaint;
    return answer;
}

Checked<Answer> answerOf(const Call &call, BusAccess &access, const MasterWish &wish)
{
    if (auto *gateway = dynamic_cast<GatewayAccess *>(&access); gateway != nullptr && wish.action.sendsZeros)
        return stopBehindGateway(call, *gateway, wish);
    auto &ringAccess = static_cast<RingAccess &>(access); // of its kind
    const auto told = toldAfter(call, ringAccess, wish);
    if (!told)
        return tl::unexpected(told.error());
    RingSession &ring = ringAccess.ring();
    Answer answer{messageLines(told->messages) + u'\n' + masterLines(ring),
                  {{QStringLiteral("master"), masterJson(ring)},
                   {QStringLiteral("messages"), messagesJson(told->messages)}}};
    addBus(answer.json, access);
    if (told->refusal)
        answer.complaint = complaintAbout(*told->refusal);
    return answer;
}

// All at once: one that is mute keeps the zeros from no other.
void sendZerosUnheard(const std::vector<BusAccess *> &rings)
{
    std::vector<std::jthread> sending;
    for (BusAccess *ring : rings)
        sending.emplace_back([ring] { static_cast<RingAccess *>(ring)->ring().sendZerosUnheard(); });
}

// Each with its heading. A refusal by one ring does not keep the others from it.
Checked<Answer> answerOfAll(const Call &call, const std::vector<BusAccess *> &rings, const MasterWish &wish)
{
    Answer all;
    if (wish.action.sendsZeros)
        sendZerosUnheard(rings);
    QJsonArray buses;
    for (BusAccess *ring : rings) {
        const auto its = answerOf(call, *ring, wish);
        if (auto why = its ? its->complaint : std::optional(its.error()); why && !all.complaint) {
            why->text.prepend(ring->name() + QStringLiteral(": "));
            all.complaint = std::move(why);
        }
        if (!its)
            continue;
        all.text += (all.text.isEmpty() ? QString() : QStringLiteral("\n")) + ring->name() +
                    QStringLiteral(":\n") + its->text;
        buses.append(its->json);
    }
    all.json.insert(QStringLiteral("buses"), buses);
    return all;
}

Checked<Answer> runMaster(const Call &call)
{
    const auto action = actionOf(call.arguments.rest);
    if (!action)
        return tl::unexpected(action.error());
    const auto after = call.arguments.number("--after", 0, 0, longestTrial);
    if (!after)
        return tl::unexpected(after.error());
    const auto patience = call.arguments.number("--patience", usualPatience, 1, longestPatience);
    if (!patience)
        return tl::unexpected(patience.error());
    MasterWish wish{*action, *after, std::chrono::seconds(*patience)};
    return ringsMeant(call, *action).and_then([&](const std::vector<BusAccess *> &rings) {
        wish.isForSeveral = rings.size() > 1;
        return wish.isForSeveral ? answerOfAll(call, rings, wish) : answerOf(call, *rings.front(), wish);
    });
}

} // namespace

const Subcommand masterCommand{
    .name = "master",
    .usage =
        "[status|start|stop|alarm-stop|read-in|confirm|segment N on|off] [--bus BUS] [--after MS] [--yes] "
        "[--patience SECONDS]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine", "what the master says, and its services"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Lets time pass, does what is asked for, and prints what the bus told meanwhile and how the "
        "master stands\nthen. What changes what the ring does (read-in, confirm, segment) is asked for "
        "first; "
        "where nobody can\nbe asked, --yes is needed. As each call has a new training bus, this makes most "
        "sense with a fault plan."),
    .examples = masterExamples,
    .options = masterOptions,
    .arguments = {0, 3},
    .needsBus = true,
    .textIsAccount = true,
    .run = runMaster,
};

} // namespace codewheel
