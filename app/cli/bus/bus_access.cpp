// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bus/bus_access.h"

#include "bus/bus_outline.h"
#include "bus/encoder_bus.h"
#include "cli/bus/places.h"
#include "cli/call/json.h"
#include "cli/call/subcommand.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/encoder/jobs.h"
#include "journal/ledger_keeper.h"
#include "journal_files.h"
#include "project/bus_kind.h"

#include <QJsonArray>

#include <algorithm>

namespace codewheel {

BusAccess::BusAccess(EncoderBus &bus, QString kind)
    : m_bus(bus)
    , m_kind(std::move(kind))
{}

BusAccess::~BusAccess() = default;

QString BusAccess::name() const
{
    if (!m_name.isEmpty())
        return m_name;
    const BusKind *kind = busKind(m_kind);
    return kind != nullptr ? kind->usualName() : QString::number(m_bus.id().number);
}

void BusAccess::keepLedger(const std::optional<QString> &file, const std::vector<BusAccess *> &others)
{
    const DatabasePlace place = file ? DatabasePlace::file(*file) : ledgerPlace(m_bus, userJournalFolder());
    const auto other = std::ranges::find_if(others, [&](const BusAccess *bus) {
        return bus->ledger() != nullptr && bus->ledger()->place() == place;
    });
    setLedger(other == others.end() ? std::make_unique<LedgerKeeper>(m_bus, place)
                                    : std::make_unique<LedgerKeeper>(m_bus, *(*other)->ledger()));
}

void BusAccess::setLedger(std::unique_ptr<LedgerKeeper> ledger)
{
    m_ledger = std::move(ledger);
}

std::optional<NodeId> BusAccess::placeTyped(const QString &text) const
{
    const auto places = knownPlaces();
    const auto found = std::ranges::find(places, text, [](Place place) { return place.toString(); });
    return found == places.end() ? std::nullopt : std::optional(found->node);
}

bool BusAccess::mayHave(NodeId node) const
{
    if (knowsItsPlaces())
        return std::ranges::count(knownPlaces(), m_bus.placeOf(node)) > 0;
    return !m_planned || std::ranges::count(*m_planned, node) > 0 || m_bus.encoder(node) != nullptr;
}

std::vector<Place> BusAccess::knownPlaces() const
{
    return m_bus.places();
}

Complaint BusAccess::notAPlace(const QString &typed) const
{
    return complaintAbout({RefusalKind::badInput, RefusalId::unknownDevice, {typed, somePlaces()}});
}

QString BusAccess::somePlaces() const
{
    return listed(knownPlaces(), &Place::toString);
}

Checked<EncoderSession *> BusAccess::encoder(const Call &call, NodeId node, bool namesIt)
{
    const Place place = m_bus.placeOf(node);
    if (!mayHave(node))
        return tl::unexpected(notAPlace(place.shown()));
    if (namesIt)
        if (const auto named = nameDevice(call, place); !named)
            return tl::unexpected(named.error());
    EncoderSession *encoder = m_bus.encoder(node);
    if (encoder == nullptr)
        return badInput(
            "noEncoder",
            CommandLine::tr(
                "The device at %1 is not an encoder this program can drive. See codewheel-cli scan."),
            {place.shown()});
    if (encoder->latest().state == EncoderState::notSeen)
        advance(lookInterval());
    return encoder;
}

Checked<void> BusAccess::contact(const Call &, const ProjectDevice &)
{
    advance(lookInterval());
    return {};
}

void BusAccess::useProject(const Call &, const Project &project)
{
    std::vector<NodeId> planned;
    for (const ProjectDevice &device : devicesOn(project, m_bus.id()))
        planned.push_back(device.place().node);
    if (!planned.empty())
        m_planned = std::move(planned);
}

bool BusAccess::isConnected() const
{
    return m_bus.state() == BusState::open;
}

Complaint BusAccess::linkLost() const
{
    return complaintAbout(whatIsLost());
}

Refusal BusAccess::whatIsLost() const
{
    return {RefusalKind::link, RefusalId::notConnected, {name()}};
}

bool BusAccess::advance(Instant duration)
{
    m_bus.advance(duration);
    return isConnected();
}

std::unique_ptr<JobTrace> BusAccess::trace(const std::vector<const EncoderSession *> &)
{
    return std::make_unique<JobTrace>();
}

std::unique_ptr<WriteAccount> BusAccess::account(const EncoderSession &encoder, const ParameterValues &wanted,
                                                 const FinishedJob &job) const
{
    return std::make_unique<WriteAccount>(encoder, wanted, job);
}

QStringList BusAccess::remarks(const Reading &reading) const
{
    QStringList texts;
    if (reading.state == EncoderState::silent)
        texts << CommandLine::tr("does not answer");
    if (reading.suspect)
        texts << CommandLine::tr("suspect: asked for again");
    return texts;
}

QJsonObject BusAccess::participantJson(const Participant &device) const
{
    return {{QStringLiteral("place"), device.number.toString()},
            {QStringLiteral("idCode"), 0},
            {QStringLiteral("deviceCode"), static_cast<int>(device.deviceCode)},
            {QStringLiteral("inWords"), 0},
            {QStringLiteral("outWords"), 0},
            {QStringLiteral("level"), 0},
            {QStringLiteral("device"), textJson(device.deviceKey)}};
}

Checked<Answer> BusAccess::scan(const Call &)
{
    TextTable table;
    table.add({CommandLine::tr("place"), CommandLine::tr("code"), CommandLine::tr("profile"),
               CommandLine::tr("device")});
    QJsonArray devices;
    for (const BusNode &node : m_bus.outline().nodes()) {
        table.add({node.node.toString(), node.code, node.profile, node.name});
        devices.append(QJsonObject{{QStringLiteral("place"), node.node.toString()},
                                   {QStringLiteral("code"), textJson(node.code)},
                                   {QStringLiteral("device"), textJson(node.name)}});
    }
    return Answer{table.toString(), {{QStringLiteral("devices"), devices}}};
}

void BusAccess::keepFound(const Call &, Project &project) const
{
    std::vector<ProjectDevice> devices;
    for (const Place place : m_bus.places()) {
        const ProjectDevice *before = findDevice(project, place);
        ProjectDevice device = before != nullptr ? *before : ProjectDevice();
        device.participant = m_bus.found(place).value_or(device.participant);
        device.standAt(place);
        devices.push_back(std::move(device));
    }
    setDevicesOn(project, m_bus.id(), std::move(devices));
}

} // namespace codewheel
