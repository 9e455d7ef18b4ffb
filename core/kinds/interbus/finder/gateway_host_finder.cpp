// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/finder/gateway_host_finder.h"

#include "finder/finder_texts.h"
#include "kinds/interbus/gateway/modbus_request.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "vocabulary/sentence.h"

namespace codewheel {
namespace {

// The one of nearly every gateway, one that nobody gives to a device, that of a device which is the host
// itself, and some more. A host that answers for the first two does not look at the unit.
const std::vector<int> usualUnits{1, 247, 255, 0, 2, 3, 4};
constexpr int nearlyAlways = 1;
constexpr int nearlyNever = 247;

constexpr int gatewayHasNoPath = 10; // Modbus Application Protocol V1.1b3, 7

// A gateway answers for a unit that is not there.
bool isNobody(const RegisterError &error)
{
    return error.kind != RegisterError::Kind::exception || error.exception == gatewayHasNoPath ||
           error.exception == static_cast<int>(ModbusException::noSuchUnit);
}

} // namespace

GatewayHostFinder::GatewayHostFinder(GatewaySettings where, MakePort makePort)
    : m_where(std::move(where))
    , m_makePort(std::move(makePort))
    , m_units(usualUnits)
{
    m_where.transport = GatewaySettings::Transport::tcp;
    m_where.retries = 0;
}

GatewayHostFinder::~GatewayHostFinder() = default;

QString GatewayHostFinder::announcement()
{
    return FinderTexts::tr(
        "Modbus/TCP: the host is connected, and the units 1, 247, 255, 0, 2, 3 and 4 are each asked for one "
        "input register, or else for one holding register.");
}

void GatewayHostFinder::interrupt()
{
    m_isStopped = true;
    const std::scoped_lock lock(m_mutex);
    if (m_port)
        m_port->interrupt();
}

void GatewayHostFinder::use(std::unique_ptr<RegisterPort> port)
{
    const std::scoped_lock lock(m_mutex);
    m_port = std::move(port);
}

FinderNews GatewayHostFinder::end(FinderNews::Kind kind, const QString &sentence)
{
    return end({.kind = kind, .place = gatewayAddress(m_where), .sentence = sentence});
}

FinderNews GatewayHostFinder::end(FinderNews news)
{
    m_isDone = true;
    use(nullptr);
    return news;
}

FinderNews GatewayHostFinder::next()
{
    FinderNews its;
    if (!m_isStopped)
        its = m_port ? askNext() : connect();
    if (m_isStopped && its.kind != FinderNews::Kind::found)
        return end(FinderNews::Kind::nobody, FinderTexts::tr("The search was cancelled."));
    return its;
}

// A unit is part of the port's settings, so each has a port of its own.
FinderNews GatewayHostFinder::connect()
{
    use(m_makePort(m_where));
    if (const auto opened = m_port->open(); !opened)
        return end(refusedNews(gatewayAddress(m_where), opened.error()));
    return {FinderNews::Kind::heard, gatewayAddress(m_where),
            FinderTexts::tr("The host takes the connection.")};
}

FinderNews GatewayHostFinder::askNext()
{
    if (m_units.empty())
        return end(m_lastFound ? FinderNews::Kind::looking : FinderNews::Kind::nobody,
                   m_lastFound ? FinderTexts::tr("All were asked.")
                               : FinderTexts::tr("The host takes the connection, but no unit answers."));
    const int unit = m_units.front();
    m_units.erase(m_units.begin());
    auto found = ask(unit);
    if (!found)
        return {FinderNews::Kind::looking, gatewayAddress(m_where),
                sentence(FinderTexts::tr("The Modbus unit %1 does not answer."), {QString::number(unit)})};
    if (unit == nearlyNever && m_lastFound == nearlyAlways) {
        m_units.clear();
        return {
            FinderNews::Kind::looking, gatewayAddress(m_where),
            sentence(FinderTexts::tr("The Modbus unit %1 answers too: the host does not look at the unit."),
                     {QString::number(unit)})};
    }
    m_lastFound = unit;
    return {FinderNews::Kind::found, found->place, found->sentence, found};
}

std::optional<Found> GatewayHostFinder::ask(int unit)
{
    GatewaySettings settings = m_where;
    settings.unit = unit;
    m_port->close();
    use(m_makePort(settings));
    if (!m_port->open())
        return std::nullopt;
    std::vector<Register> one(1);
    const auto input = m_port->read(RegisterArea::input, 0, one);
    if (!input && isNobody(input.error()))
        return std::nullopt;
    if (!input && m_port->read(RegisterArea::holding, 0, one))
        settings.inArea = RegisterArea::holding;
    settings.retries = GatewaySettings().retries;
    return Found{.kind = QString::fromLatin1(interbusKind),
                 .place = gatewayAddress(settings),
                 .sentence =
                     sentence(FinderTexts::tr("The Modbus unit %1 answers. Whether it shows a ring, its "
                                              "register map says: test it."),
                              {QString::number(unit)}),
                 .plan = KindData(ProjectLink{linkKindOf(settings), linkTexts(settings)}),
                 .link = QStringLiteral("modbus-tcp:") + gatewayAddress(settings) + settingsText(settings)};
}

QString settingsText(const GatewaySettings &settings)
{
    QString text;
    for (const auto &[name, value] : settingTexts(settings))
        text += QStringLiteral(",%1=%2").arg(name, value);
    return text;
}

} // namespace codewheel
