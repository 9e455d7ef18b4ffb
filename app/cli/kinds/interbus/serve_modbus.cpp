// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/pseudo_terminal_link.h"
#include "cli/call/json.h"
#include "cli/call/stop_signals.h"
#include "cli/call/texts.h"
#include "cli/kinds/interbus/register_table.h"
#include "cli/kinds/interbus/ring_link_kind.h"
#include "cli/kinds/interbus/rings_to_offer.h"
#include "kinds/interbus/gateway/served_clients.h"
#include "kinds/interbus/links/modbus_rtu_server.h"
#include "kinds/interbus/links/modbus_tcp_server.h"
#include "links/serial_port_link.h"
#include "vocabulary/sentence.h"

#include <QJsonObject>

#include <array>
#include <functional>
#include <poll.h>

namespace codewheel {
namespace {

QString counts(const ServedClient &client)
{
    return sentence(
        CommandLine::tr("%1 requests, %2 of them refused; %3 writes"),
        {QString::number(client.requests), QString::number(client.refused), QString::number(client.writes)});
}

// A line for a client that comes, goes, or is refused.
QString newsLine(const ClientNews &news)
{
    switch (news.what) {
    case ClientNews::What::came:
        return sentence(CommandLine::tr("%1 is connected."), {news.client.address}) + u'\n';
    case ClientNews::What::left:
        return sentence(CommandLine::tr("%1 has left: %2."), {news.client.address, counts(news.client)}) +
               u'\n';
    case ClientNews::What::refused:
        break;
    }
    return sentence(CommandLine::tr("%1 was refused: there are as many clients as can be served."),
                    {news.client.address}) +
           u'\n';
}

// What was done for all of them.
QString servedText(const ServedClients &clients)
{
    return sentence(CommandLine::tr("Clients: %1, and %2 that were refused. %3."),
                    {QString::number(clients.everCame()), QString::number(clients.refusedConnections()),
                     counts(clients.total())}) +
           u'\n';
}

QJsonObject servedJson(const ServedClients &clients)
{
    const ServedClient total = clients.total();
    const auto number = [](std::uint64_t count) { return static_cast<qint64>(count); };
    return {{QStringLiteral("clients"), number(clients.everCame())},
            {QStringLiteral("refusedClients"), number(clients.refusedConnections())},
            {QStringLiteral("requests"), number(total.requests)},
            {QStringLiteral("refusedRequests"), number(total.refused)},
            {QStringLiteral("writes"), number(total.writes)}};
}

constexpr int usualPort = 1'502; // the standard's 502 is for administrators
constexpr int lastPort = 65'535;
constexpr int waitForNews = 20; // ms

constexpr Option portOption{
    "--port", "PORT",
    QT_TRANSLATE_NOOP("codewheel::CommandLine",
                      "modbus-tcp: its number, 0 for a free one (1502); modbus-rtu: a serial port, with "
                      "settings behind it, as ttyUSB0,baud=9600,unit=5 (a pseudo terminal)")};
constexpr Option seatsOption{
    "--seats", "N",
    QT_TRANSLATE_NOOP("codewheel::CommandLine",
                      "a ring of its own for each seat: unit 1 to N (one ring for all units)")};
constexpr Option readOnlyOption{"--read-only", nullptr,
                                QT_TRANSLATE_NOOP("codewheel::CommandLine", "clients may write nothing")};
constexpr std::array tcpOptions{
    Option{"--address", "ADDRESS",
           QT_TRANSLATE_NOOP("codewheel::CommandLine",
                             "of this computer, where others reach it; 0.0.0.0: all it has (127.0.0.1, for "
                             "programs on this computer only)")},
    portOption,
    seatsOption,
    readOnlyOption,
};
constexpr std::array rtuOptions{portOption, seatsOption, readOnlyOption};

ServedUnits::Writing writingOf(const Call &call)
{
    return call.arguments.has("--read-only") ? ServedUnits::Writing::refused : ServedUnits::Writing::allowed;
}

// What stands before the clients: which ring is which unit, and its registers.
QString offerText(const Call &call, const OfferedRings &rings, const QString &allUnits)
{
    QString text;
    const RingStructure *before = nullptr;
    for (std::size_t i = 0; i < rings.rings().size(); ++i) {
        const OfferedRings::Ring &ring = rings.rings()[i];
        text += sentence(CommandLine::tr("%1: %2"),
                         {rings.rings().size() == 1
                              ? allUnits
                              : sentence(CommandLine::tr("Unit %1"), {QString::number(i + 1)}),
                          ring.name}) +
                u'\n';
        const RingStructure &structure = ring.training.bus->structure();
        if (before == nullptr || *before != structure)
            text += registerTable(structure, call.catalog);
        before = &structure;
    }
    text +=
        sentence(CommandLine::tr("Status register: %1. Diagnostic parameter: %2."),
                 {QString::number(served_registers::status), QString::number(served_registers::parameter)}) +
        u'\n';
    if (writingOf(call) == ServedUnits::Writing::refused)
        text += CommandLine::tr("Nothing can be written.") + u'\n';
    return text + CommandLine::tr("Ctrl+C ends it.") + u'\n';
}

QJsonArray ringsJson(const OfferedRings &rings)
{
    QJsonArray json;
    for (std::size_t i = 0; i < rings.rings().size(); ++i) {
        const OfferedRings::Ring &ring = rings.rings()[i];
        const bool isAlone = rings.rings().size() == 1;
        json.append(QJsonObject{
            {QStringLiteral("unit"), isAlone ? QJsonValue() : QJsonValue(static_cast<int>(i) + 1)},
            {QStringLiteral("bus"), ring.name},
            {QStringLiteral("registers"), registerJson(ring.training.bus->structure())}});
    }
    return json;
}

// Until a signal comes, nobody reads what is printed, or it has ended by itself.
void watchClients(const Call &call, OfferedRings &rings, ServedClients &clients, StopSignals &stop,
                  const std::function<bool()> &hasEnded)
{
    pollfd waited{stop.descriptor(), POLLIN, 0};
    while (!stop.came() && call.terminal.canPrint() && !hasEnded()) {
        ::poll(&waited, 1, waitForNews);
        rings.pump();
        for (const ClientNews &news : clients.takeNews())
            if (!call.arguments.has("--json"))
                call.terminal.print(newsLine(news));
    }
}

Answer servedAnswer(const OfferedRings &rings, const ServedClients &clients, QJsonObject json)
{
    json.insert(QStringLiteral("rings"), ringsJson(rings));
    merge(json, servedJson(clients));
    return {.text = servedText(clients), .json = json};
}

// The serial line of the call, its settings and its unit.
struct LineOffer
{
    std::unique_ptr<ByteLink> line;
    GatewaySettings settings;
};

// PORT,setting=value,... as in --link modbus-rtu:PORT.
Checked<LineOffer> lineOffer(const Arguments &arguments)
{
    LineOffer offer{nullptr, {.transport = GatewaySettings::Transport::rtu}};
    const QStringList typed = arguments.value("--port").value_or(QString()).split(u',');
    std::map<QString, QString> texts;
    for (const QString &setting : typed.sliced(1))
        texts[setting.section(u'=', 0, 0)] = setting.section(u'=', 1);
    if (const auto applied = applySettings(offer.settings, texts); !applied)
        return tl::unexpected(complaintAbout(applied.error()));
    if (!typed.front().isEmpty()) {
        offer.line = std::make_unique<SerialPortLink>(typed.front());
        return offer;
    }
    auto terminal = PseudoTerminal::make();
    if (!terminal)
        return tl::unexpected(noPseudoTerminal());
    offer.line = std::make_unique<PseudoTerminalLink>(*std::move(terminal));
    return offer;
}

Checked<Answer> serveModbusTcp(const Call &call)
{
    const auto port = call.arguments.number("--port", usualPort, 0, lastPort);
    if (!port)
        return tl::unexpected(port.error());
    auto rings = ringsToOffer(call);
    if (!rings)
        return tl::unexpected(rings.error());
    StopSignals stop; // before there is a thread that could get them
    rings->start();
    ServerPlace place{.port = *port};
    place.host = call.arguments.value("--address").value_or(place.host);
    const auto server = ModbusTcpServer::start(place, unitsOf(*rings, writingOf(call)));
    if (!server)
        return tl::unexpected(complaintAbout(server.error()));
    const ServerPlace served = (*server)->place();
    call.terminal.print(shownAddress(served) + u'\n');
    if (!call.arguments.has("--json"))
        call.terminal.print(offerText(call, *rings, CommandLine::tr("All units")));
    watchClients(call, *rings, (*server)->clients(), stop, [] { return false; });
    return servedAnswer(*rings, (*server)->clients(),
                        {{QStringLiteral("address"), served.host}, {QStringLiteral("port"), served.port}});
}

Checked<Answer> serveModbusRtu(const Call &call)
{
    auto offer = lineOffer(call.arguments);
    if (!offer)
        return tl::unexpected(offer.error());
    auto rings = ringsToOffer(call);
    if (!rings)
        return tl::unexpected(rings.error());
    StopSignals stop;
    rings->start();
    const GatewaySettings &settings = offer->settings;
    const auto server = ModbusRtuServer::start(std::move(offer->line), settings.serial,
                                               unitsOf(*rings, writingOf(call)), settings.unit);
    if (!server)
        return tl::unexpected(complaintAbout(server.error()));
    call.terminal.print((*server)->port() + u'\n');
    if (!call.arguments.has("--json"))
        call.terminal.print(
            offerText(call, *rings, sentence(CommandLine::tr("Unit %1"), {QString::number(settings.unit)})));
    watchClients(call, *rings, (*server)->clients(), stop, [&] { return (*server)->whyEnded().has_value(); });
    Answer answer = servedAnswer(*rings, (*server)->clients(), {{QStringLiteral("port"), (*server)->port()}});
    if (const auto why = (*server)->whyEnded())
        answer.complaint = complaintAbout(*why);
    return answer;
}

} // namespace

std::span<const Service> modbusServices()
{
    static constexpr std::array services{Service{modbusTcpLink, tcpOptions, serveModbusTcp},
                                         Service{modbusRtuLink, rtuOptions, serveModbusRtu}};
    return services;
}

} // namespace codewheel
