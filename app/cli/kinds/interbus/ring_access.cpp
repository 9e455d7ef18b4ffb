// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/interbus/ring_access.h"

#include "bus/data_check.h"
#include "bus/word_channel.h"
#include "catalog/catalog.h"
#include "catalog/hex_code.h"
#include "cli/bus/places.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "cli/encoder/trace.h"
#include "cli/kinds/interbus/link_figures_text.h"
#include "cli/kinds/interbus/master_text.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/ring/id_code.h"
#include "kinds/interbus/simulator/fault_plan.h"
#include "kinds/interbus/words/device_number.h"
#include "transfer/project_places.h"
#include "vocabulary/sentence.h"

#include <QJsonArray>

#include <algorithm>
#include <numeric>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

// The words of each encoder.
class WordTrace final : public JobTrace
{
public:
    WordTrace(const RingAccess &ring, const std::vector<const EncoderSession *> &encoders)
        : m_ring(ring)
    {
        for (const EncoderSession *encoder : encoders) {
            std::vector<Exchange> &rows = m_rows[encoder->place()];
            QObject::connect(encoder, &EncoderSession::exchanged, &m_scope,
                             [&rows](const Exchange &row) { rows.push_back(row); });
        }
    }

    void begin(const EncoderSession &encoder) override
    {
        if (const auto row = m_ring.currentRow(encoder))
            m_rows[encoder.place()].push_back(*row);
    }
    QString text(Place place) const override { return traceText(deviceAt(place), m_rows.at(place)); }
    QJsonArray json(Place place) const override { return traceJson(deviceAt(place), m_rows.at(place)); }

private:
    const DeviceDescription &deviceAt(Place place) const { return m_ring.bus().encoder(place)->device(); }

    const RingAccess &m_ring;
    std::map<Place, std::vector<Exchange>> m_rows;
    QObject m_scope;
};

// Naming it again would forget what is known of the encoder.
bool isNamedSo(const RingDevice &connected, const DeviceDescription &device, const DeviceLabel &label)
{
    return connected.deviceKey == device.key && (label.turns == 0 || label.turns == device.physicalTurns) &&
           (label.stepsPerTurn == 0 || label.stepsPerTurn == device.physicalStepsPerTurn);
}

void nameAs(const Call &call, EncoderBus &ring, const ProjectDevice &planned, const RingDevice &connected)
{
    const QString &key = planned.participant.deviceKey;
    const DeviceDescription *device = call.catalog.find(key);
    if (device != nullptr && isNamedSo(connected, *device, planned.label))
        return;
    if (device != nullptr && device->deviceCode == connected.deviceCode &&
        ring.name(planned.place(), key, planned.label.turns, planned.label.stepsPerTurn))
        return;
    call.terminal.complain(sentence(CommandLine::tr("%1 is not treated as \"%2\" of the project: there is no "
                                                    "such description, or it is for another device code."),
                                    {planned.place().shown(), key}));
}

// The ID code gives the profile, never the make of an encoder; that is for the plan to name.
QString makeOf(const RingDevice &participant, const DeviceDescription *named)
{
    return named || participant.idCode() == busTerminalIdCode ? nameOrTerminal(participant, named)
                                                              : CommandLine::tr("make not known");
}

} // namespace

RingAccess::RingAccess(RingSession &ring)
    : BusAccess(ring, QString::fromLatin1(interbusKind))
    , m_ring(ring)
{}

RingAccess::RingAccess(TrainingSession training)
    : BusAccess(*training.bus, QString::fromLatin1(interbusKind))
    , m_owned(std::move(training))
    , m_ring(*m_owned.bus)
{}

RingAccess::RingAccess(std::unique_ptr<RingSession> ring)
    : RingAccess(TrainingSession{nullptr, std::move(ring)})
{}

Checked<void> RingAccess::followFaultPlan(const QString &file)
{
    auto plan = loadFaultPlan(file, m_owned.controls->places());
    if (!plan)
        return tl::unexpected(complaintAbout(plan.error()));
    m_owned.controls->startFaultPlan(*std::move(plan));
    return {};
}

std::optional<NodeId> RingAccess::placeTyped(const QString &text) const
{
    const auto number = DeviceNumber::parse(text);
    return number ? std::optional(number->node()) : std::nullopt;
}

Checked<void> RingAccess::checkStation(const Project &project, const QString &station) const
{
    if (areSame(compareRings(structureOf(project, m_ring.id()), m_ring.structure())))
        return {};
    return tl::unexpected(notDone(
        "busDiffers",
        sentence(CommandLine::tr("The bus \"%1\" differs from the project, so \"%2\" may be elsewhere. See "
                                 "codewheel-cli compare, or give the device number."),
                 {name(), station}),
        {station}));
}

Checked<EncoderSession *> RingAccess::encoder(const Call &call, NodeId node, bool namesIt)
{
    const Place place = m_ring.placeOf(node);
    const ProjectDevice *planned = call.project != nullptr ? findDevice(*call.project, place) : nullptr;
    const auto connected = m_ring.found(place);
    if (planned != nullptr && connected &&
        !isSameKind(ringDevice(planned->participant), ringDevice(*connected)))
        return tl::unexpected(complaintAbout({RefusalKind::link,
                                              RefusalId::ringDiffers,
                                              {place.shown(), hexCode(planned->participant.deviceCode, 4),
                                               hexCode(connected->deviceCode, 4)}}));
    return BusAccess::encoder(call, node, namesIt);
}

void RingAccess::useProject(const Call &call, const Project &project)
{
    if (call.command.needsLinks) // the command asks nothing of the ring itself
        return;
    const RingStructure connected = m_ring.structure();
    const ProjectPlaces places(project, call.buses);
    for (const ProjectDevice &planned : devicesOn(project, m_ring.id())) {
        const auto found = std::ranges::find(connected, planned.place().node, &RingDevice::number);
        if (places.isAtItsPlace(planned.place()) && !planned.participant.deviceKey.isEmpty())
            nameAs(call, m_ring, planned, *found);
    }
    if (!areSame(compareRings(structureOf(project, m_ring.id()), connected)))
        call.terminal.complain(
            sentence(CommandLine::tr("The bus \"%1\" differs from the project. See codewheel-cli compare."),
                     {name()}));
}

Refusal RingAccess::whatIsLost() const
{
    return m_ring.latest().whyLost.value_or(BusAccess::whatIsLost());
}

std::optional<Complaint> RingAccess::whyItStands() const
{
    const auto &told = m_ring.latest().told;
    return told && told->stands() ? std::optional(complaintAbout(told->whyItStands())) : std::nullopt;
}

Instant RingAccess::lookInterval() const
{
    return 1ms;
}

std::unique_ptr<JobTrace> RingAccess::trace(const std::vector<const EncoderSession *> &encoders)
{
    return std::make_unique<WordTrace>(*this, encoders);
}

std::optional<Exchange> RingAccess::currentRow(const EncoderSession &encoder) const
{
    const WordChannel &channel = *m_ring.channel(encoder.place());
    const Reading &reading = encoder.latest();
    return Exchange{m_ring.latest().cycle, m_ring.latest().at, channel.out(),       channel.in(),
                    reading.mode,          reading.coding,     channel.outIsKnown()};
}

// What the encoder cannot have sent is of other registers.
QString RingAccess::doubtOfRegisters(const EncoderSession &encoder) const
{
    const RingStructure &devices = m_ring.structure();
    const auto its = std::ranges::find(devices, encoder.place().node, &RingDevice::number);
    const auto check = m_ring.checkWord(static_cast<std::size_t>(its - devices.begin()));
    return check && check->outcome == DataCheck::Outcome::differs
               ? check->remedy + u' ' +
                     CommandLine::tr("Test the registers of the gateway with codewheel-cli gateway.") + u'\n'
               : QString();
}

void RingAccess::addFigures(const Call &, const EncoderSession &encoder, Answer &answer) const
{
    const auto counted = figures();
    if (!counted)
        return;
    answer.text += doubtOfRegisters(encoder);
    answer.text += u'\n' + figuresText(*counted);
    answer.json.insert(QStringLiteral("figures"), figuresJson(*counted));
    const auto &told = m_ring.latest().told;
    answer.json.insert(QStringLiteral("ringRuns"), told ? QJsonValue(!told->stands()) : QJsonValue());
    if (!told)
        answer.text +=
            CommandLine::tr("Whether the ring runs behind the gateway is not known: the settings do not "
                            "say which status bits tell it.") +
            u'\n';
}

Checked<Answer> RingAccess::scan(const Call &call)
{
    using enum TextTable::Align;
    TextTable table({left, left, left, right, right});
    table.add({CommandLine::tr("place"), CommandLine::tr("ID code"), CommandLine::tr("device code"),
               CommandLine::tr("IN words"), CommandLine::tr("OUT words"), CommandLine::tr("profile"),
               CommandLine::tr("device")});
    QJsonArray devices;
    for (const RingDevice &participant : m_ring.structure()) {
        const DeviceDescription *named = call.catalog.find(participant.deviceKey);
        const DeviceDescription *known = named ? named : call.catalog.generic(participant.deviceCode);
        const QString profile = known ? profileName(known->profile) : QStringLiteral("-");
        table.add({participant.number.toString(),
                   QStringLiteral("%1 (%2)").arg(hexCode(participant.idCode(), 2)).arg(participant.idCode()),
                   hexCode(participant.deviceCode, 4), QString::number(participant.inWords),
                   QString::number(participant.outWords), profile, makeOf(participant, named)});
        QJsonObject json = participantJson(participant);
        json.insert(QStringLiteral("profile"), known ? QJsonValue(profile) : QJsonValue());
        devices.append(json);
    }
    return Answer{
        table.toString() + u'\n' + masterLines(m_ring),
        {{QStringLiteral("participants"), devices}, {QStringLiteral("master"), masterJson(m_ring)}}};
}

QJsonObject RingAccess::participantJson(const Participant &device) const
{
    const RingDevice its = ringDevice(device);
    QJsonObject json = BusAccess::participantJson(device);
    json[u"idCode"] = static_cast<int>(its.idCode());
    json[u"inWords"] = its.inWords;
    json[u"outWords"] = its.outWords;
    json[u"level"] = its.level;
    return json;
}

void RingAccess::keepFound(const Call &, Project &project) const
{
    const Comparison comparison = compareRings(structureOf(project, m_ring.id()), m_ring.structure());
    std::vector<std::size_t> lines(comparison.size());
    std::iota(lines.begin(), lines.end(), std::size_t{0});
    project = takenOver(std::move(project), m_ring.structure(), comparison, lines, m_ring.id());
}

} // namespace codewheel
