// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/stop_signals.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/encoder/jobs.h"
#include "cli/kinds/interbus/ring_link_kind.h"
#include "kinds/interbus/gateway/gateway_check_text.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/gateway/register_refusal.h"
#include "kinds/interbus/links/modbus_port.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <QJsonArray>

#include <algorithm>
#include <array>

namespace codewheel {
namespace {

constexpr const char *gatewayExamples[] = {
    "gateway --link modbus-tcp:192.168.0.5 --project crane.codewheel",
    "gateway 3.0 --link modbus-tcp:192.168.0.5,order=low --project crane.codewheel",
    "gateway --link modbus-rtu:ttyUSB0,baud=9600,unit=3 --project crane.codewheel --json"};

constexpr std::array gatewayOptions{
    busOption,
    Option{"--acknowledge-watchdog", nullptr,
           QT_TRANSLATE_NOOP(
               "codewheel::CommandLine",
               "write the register that acknowledges the watchdog of the gateway, and nothing else")},
};

constexpr int textColumn = 18; // behind the name of a step
constexpr int outcomeColumn = 16;

QString outcomeText(CheckOutcome outcome)
{
    switch (outcome) {
    case CheckOutcome::passed:
        return CommandLine::tr("ok");
    case CheckOutcome::failed:
        return CommandLine::tr("failed");
    case CheckOutcome::skipped:
        break;
    }
    return CommandLine::tr("not tested");
}

QString outcomeKey(CheckOutcome outcome)
{
    constexpr std::array keys{"passed", "failed", "skipped"};
    return QString::fromLatin1(keys.at(static_cast<std::size_t>(outcome)));
}

QString registersNow(const std::vector<Register> &registers)
{
    QStringList texts;
    for (const Register word : registers)
        texts << registerText(word);
    return texts.isEmpty() ? QStringLiteral("-") : texts.join(u' ');
}

QString areaText(const QString &name, const RegisterBlock &block, const std::vector<Register> &now)
{
    if (block.count == 0)
        return sentence(CommandLine::tr("%1: none"), {name});
    return sentence(CommandLine::tr("%1 from register %2: %3"),
                    {name, QString::number(block.first), registersNow(now)});
}

QString readingLines(const DeviceRegisters &shown, const GatewaySettings &gateway)
{
    TextTable table;
    const WordOrder set = wordOrderOf(gateway.highWordFirst);
    for (const WordReading &reading : shown.readings)
        table.add({reading.order == set ? QStringLiteral("*") : QString(), wordOrderName(reading.order),
                   hexWord(reading.word), plausibilityText(reading.plausibility), reading.meaning});
    return table.toString(4);
}

// "status=8192,run-bit=5".
QString settingsText(const std::map<QString, QString> &settings)
{
    QStringList texts;
    for (const auto &[name, text] : settings)
        texts << name + u'=' + text;
    return texts.join(u',');
}

QString findingText(const QString &name, const GatewayFinding &finding, const GatewaySettings &gateway)
{
    QString text = name.leftJustified(textColumn) +
                   outcomeText(finding.outcome).leftJustified(outcomeColumn) + finding.sentence + u'\n';
    if (!finding.proposed.empty())
        text += QStringLiteral("    ") +
                sentence(CommandLine::tr("Add to the link: %1"), {settingsText(finding.proposed)}) + u'\n';
    if (!finding.shown)
        return text;
    const DeviceRegisters &shown = *finding.shown;
    return text + QStringLiteral("    ") + areaText(QStringLiteral("IN"), shown.in, shown.inNow) +
           QStringLiteral("; ") + areaText(QStringLiteral("OUT"), shown.out, shown.outNow) + u'\n' +
           readingLines(shown, gateway);
}

QJsonObject blockJson(const RegisterBlock &block, const std::vector<Register> &now)
{
    QJsonArray registers;
    for (const Register word : now)
        registers.append(word);
    return {{QStringLiteral("first"), block.count > 0 ? QJsonValue(block.first) : QJsonValue()},
            {QStringLiteral("count"), block.count},
            {QStringLiteral("registers"), registers}};
}

void addShown(QJsonObject &json, const DeviceRegisters &shown, const GatewaySettings &gateway)
{
    QJsonArray readings;
    for (const WordReading &reading : shown.readings)
        readings.append(
            QJsonObject{{QStringLiteral("order"), wordOrderName(reading.order)},
                        {QStringLiteral("word"), hexWord(reading.word)},
                        {QStringLiteral("plausibility"), plausibilityKey(reading.plausibility)},
                        {QStringLiteral("isSet"), reading.order == wordOrderOf(gateway.highWordFirst)}});
    json.insert(QStringLiteral("in"), blockJson(shown.in, shown.inNow));
    json.insert(QStringLiteral("out"), blockJson(shown.out, shown.outNow));
    json.insert(QStringLiteral("stoodStill"), shown.stoodStill);
    json.insert(QStringLiteral("readings"), readings);
}

QJsonObject findingJson(const Call &call, const GatewayAccess &ring, const GatewayFinding &finding)
{
    QJsonObject json{{QStringLiteral("step"), gatewayStepKey(finding.step)},
                     {QStringLiteral("outcome"), outcomeKey(finding.outcome)},
                     {QStringLiteral("error"),
                      finding.why ? QJsonValue(errorJson(complaintAbout(*finding.why))) : QJsonValue()}};
    if (!finding.proposed.empty())
        json.insert(QStringLiteral("proposed"), settingsText(finding.proposed));
    if (finding.shown) {
        addPlace(json, call, ring.bus().placeOf(finding.shown->place));
        addShown(json, *finding.shown, ring.gateway());
    }
    return json;
}

// The one that the link leads to, or that --bus names.
Checked<const GatewayAccess *> gatewayOf(const BusAccess *bus)
{
    const auto *gateway = dynamic_cast<const GatewayAccess *>(bus);
    if (gateway != nullptr)
        return gateway;
    return badInput("noGateway",
                    CommandLine::tr("The bus \"%1\" is not behind a gateway. Name one, as --link "
                                    "modbus-tcp:192.168.0.5, or use --link project."),
                    {bus->name()});
}

struct CheckWish
{
    const GatewayAccess *gateway = nullptr;
    std::optional<NodeId> only{}; // "read now"
};

Checked<CheckWish> wishOf(const Call &call)
{
    if (call.arguments.rest.isEmpty())
        return busMeant(call, QString::fromLatin1(interbusKind))
            .and_then([](const BusAccess *bus) { return gatewayOf(bus); })
            .map([](const GatewayAccess *gateway) { return CheckWish{gateway}; });
    const auto place = placeMeant(call, call.project, call.arguments.rest.front());
    if (!place)
        return tl::unexpected(place.error());
    const BusAccess &bus = call.busOf(*place);
    if (!bus.mayHave(place->node))
        return tl::unexpected(bus.notAPlace(place->shown()));
    return gatewayOf(&bus).map([&](const GatewayAccess *gateway) { return CheckWish{gateway, place->node}; });
}

// Of words that cannot be, the map as a whole says what to change.
std::optional<Complaint> complaintAboutCheck(const std::vector<GatewayFinding> &findings)
{
    auto failed = std::ranges::find(findings, CheckOutcome::failed, &GatewayFinding::outcome);
    if (failed == findings.end())
        return std::nullopt;
    if (failed->why)
        return complaintAbout(*failed->why);
    const auto map = std::ranges::find(findings, GatewayStep::map, &GatewayFinding::step);
    const bool isOfMap = map != findings.end() && map->outcome == CheckOutcome::failed;
    if (isOfMap)
        failed = map;
    return notDone(isOfMap ? "mapNotPlausible" : "wordNotPlausible", failed->sentence,
                   {failed->shown ? failed->shown->place.toString() : QString()});
}

// Never into the image: a value there would be a word.
Checked<Answer> acknowledgeWatchdog(const GatewayAccess &ring)
{
    const GatewaySettings &gateway = ring.gateway();
    if (!gateway.watchdogRegister)
        return tl::unexpected(
            complaintAbout({RefusalKind::notSupported, GatewayRefusalId::watchdogNotSet, {}}));
    if (const auto map = mapOf(ring.devices(), gateway); !map)
        return tl::unexpected(complaintAbout(map.error()));
    ModbusPort port(gateway);
    if (const auto opened = port.open(); !opened)
        return tl::unexpected(complaintAbout(opened.error()));
    const auto value = static_cast<Register>(gateway.watchdogValue);
    if (const auto done = port.write(*gateway.watchdogRegister, std::span(&value, 1)); !done)
        return tl::unexpected(complaintAbout(
            registerRefusal(done.error(), port.name(), 16, {*gateway.watchdogRegister, 1}, 1)));
    return Answer{sentence(CommandLine::tr("%1 was written to register %2."),
                           {registerText(value), QString::number(*gateway.watchdogRegister)}) +
                      u'\n',
                  {{QStringLiteral("gateway"), gatewayUnit(gateway)},
                   {QStringLiteral("register"), *gateway.watchdogRegister},
                   {QStringLiteral("value"), value}}};
}

Checked<Answer> runGateway(const Call &call)
{
    const auto wish = wishOf(call);
    if (!wish)
        return tl::unexpected(wish.error());
    const GatewayAccess &ring = *wish->gateway;
    if (call.arguments.has("--acknowledge-watchdog"))
        return acknowledgeWatchdog(ring);
    const bool isShown = !call.arguments.has("--json");
    StopSignals stop;
    ModbusPort port(ring.gateway());
    GatewayCheck check(port, ring.gateway(), ring.devices(), wish->only);
    std::vector<GatewayFinding> findings;
    QJsonArray steps;
    while (!check.isDone() && !stop.came()) {
        const QString name = check.nextText();
        findings.push_back(check.next());
        steps.append(findingJson(call, ring, findings.back()));
        if (isShown)
            call.terminal.print(findingText(name, findings.back(), ring.gateway()));
    }
    Answer answer{
        .json = {{QStringLiteral("gateway"), gatewayUnit(ring.gateway())}, {QStringLiteral("steps"), steps}}};
    addBus(answer.json, ring);
    answer.complaint = check.isDone() ? complaintAboutCheck(findings) : std::optional(aboutCancelling());
    return answer;
}

} // namespace

const Subcommand gatewayCommand{
    .name = "gateway",
    .usage = "[PLACE] [--bus BUS] [--acknowledge-watchdog]",
    .summary = QT_TRANSLATE_NOOP("codewheel::CommandLine",
                                 "test a gateway step by step, and show the registers of its devices"),
    .details = QT_TRANSLATE_NOOP(
        "codewheel::CommandLine",
        "Tests whether the gateway is there, its unit answers, and its registers are long enough for the "
        "ring "
        "of\nthe project. Then it reads the registers of each device, or of the one at PLACE, and shows the "
        "word in the\nfour orders that its bytes can have, and which of them the encoder can have sent. The "
        "one "
        "that is set\nhas a *. Writes nothing. Exit code 1 if anything failed."),
    .examples = gatewayExamples,
    .options = gatewayOptions,
    .arguments = {0, 1},
    .needsLinks = true,
    .run = runGateway,
};

} // namespace codewheel
