// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/interbus/gateway_link_text.h"

#include "cli/bus/present_ports.h"
#include "cli/call/texts.h"
#include "links/port_access.h"

namespace codewheel {
namespace {

struct HostAndPort
{
    QString host;
    QString port; // empty: the usual one
};

Checked<HostAndPort> bracketed(const QString &where)
{
    const qsizetype end = where.indexOf(u']');
    const QString behind = end < 0 ? QString() : where.sliced(end + 1);
    const bool isOnlyHost = end > 1 && behind.isEmpty();
    if (isOnlyHost || (end > 1 && behind.size() > 1 && behind.startsWith(u':')))
        return HostAndPort{where.sliced(1, end - 1), behind.sliced(isOnlyHost ? 0 : 1)};
    return badInput("addressNotUnderstood",
                    CommandLine::tr("\"%1\" is not an address in brackets with a port. Write it as "
                                    "[fe80::1] or [fe80::1]:502."),
                    {where});
}

Checked<HostAndPort> hostAndPort(const QString &where)
{
    if (where.startsWith(u'['))
        return bracketed(where);
    const auto colons = where.count(u':');
    if (colons > 1)
        return badInput("addressNotInBrackets",
                        CommandLine::tr("Write the address %1 in brackets, as modbus-tcp:[%1], so that it "
                                        "can be told from a port."),
                        {where});
    const QString host = where.section(u':', 0, 0);
    const QString port = where.section(u':', 1);
    if (host.isEmpty())
        return badInput("hostMissing",
                        CommandLine::tr("Name the host of the gateway, as --link modbus-tcp:192.168.0.5."));
    if (colons == 1 && port.isEmpty())
        return badInput("portMissing",
                        CommandLine::tr("Name the port behind \"%1\", or leave the colon out for port 502."),
                        {where});
    return HostAndPort{host, port};
}

Checked<GatewaySettings> tcpGateway(const QString &where)
{
    return hostAndPort(where).and_then([](const HostAndPort &its) {
        std::map<QString, QString> texts{{QStringLiteral("host"), its.host}};
        if (!its.port.isEmpty())
            texts[QStringLiteral("port")] = its.port;
        return gatewaySettings(QString::fromLatin1(modbusTcpLink), texts).map_error(complaintAbout);
    });
}

Checked<GatewaySettings> rtuGateway(const QString &where)
{
    if (where.isEmpty())
        return badInput("portMissing",
                        CommandLine::tr("Name the port of the gateway, as --link modbus-rtu:ttyUSB0. %1"),
                        {presentPortsText()});
    GatewaySettings gateway;
    gateway.transport = GatewaySettings::Transport::rtu;
    gateway.serialPort = portPath(where);
    return gateway;
}

} // namespace

Checked<GatewaySettings> withSettings(GatewaySettings gateway, const QStringList &typed)
{
    std::map<QString, QString> texts;
    for (const QString &setting : typed)
        texts[setting.section(u'=', 0, 0)] = setting.section(u'=', 1);
    if (const auto applied = applySettings(gateway, texts); !applied)
        return tl::unexpected(complaintAbout(applied.error()));
    return gateway;
}

Checked<GatewaySettings> gatewayMeant(const LinkText &text)
{
    const bool isTcp = text.scheme == QLatin1String(modbusTcpLink);
    return (isTcp ? tcpGateway(text.where) : rtuGateway(text.where))
        .and_then([&](const GatewaySettings &gateway) { return withSettings(gateway, text.settings); });
}

} // namespace codewheel
