// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/device_names.h"

#include "catalog/catalog.h"
#include "encoder/encoder_session.h"
#include "project/project_take_over.h"
#include "ring/bus_session.h"
#include "widgets/project/project_document.h"

#include <QScopedValueRollback>

#include <algorithm>

namespace codewheel {
namespace {

// What a device is taken for: its make, and what its label tells of the resolution; 0: as described.
struct Name
{
    QString key;
    int turns = 0;
    int stepsPerTurn = 0;

    friend bool operator==(const Name &, const Name &) = default;
};

Name nameOnTheBus(const BusSession &bus, const Participant &participant)
{
    Name name{.key = participant.deviceKey};
    const EncoderSession *encoder = bus.encoder(participant.number);
    const DeviceDescription *described = bus.catalog().find(participant.deviceKey);
    if (encoder == nullptr || described == nullptr)
        return name;
    const auto ifOther = [](int is, int usual) { return is == usual ? 0 : is; };
    name.turns = ifOther(encoder->device().physicalTurns, described->physicalTurns);
    name.stepsPerTurn = ifOther(encoder->device().physicalStepsPerTurn, described->physicalStepsPerTurn);
    return name;
}

Name nameInTheProject(const Catalog &catalog, const ProjectDevice &device)
{
    Name name{.key = device.participant.deviceKey};
    if (const DeviceDescription *described = catalog.find(name.key)) {
        const auto ifOther = [](int is, int usual) { return is == usual ? 0 : is; };
        name.turns = ifOther(device.label.turns, described->physicalTurns);
        name.stepsPerTurn = ifOther(device.label.stepsPerTurn, described->physicalStepsPerTurn);
    }
    return name;
}

} // namespace

DeviceNames::DeviceNames(ProjectDocument &document, BusSession &bus, QObject *parent)
    : QObject(parent)
    , m_document(document)
    , m_bus(bus)
{
    connect(&document, &ProjectDocument::changed, this, &DeviceNames::nameRing);
    connect(&bus, &BusSession::named, this, &DeviceNames::takeName);
    connect(&bus, &BusSession::structureChanged, this, &DeviceNames::nameRing);
    nameRing();
}

void DeviceNames::nameRing()
{
    if (m_isNaming)
        return;
    const QScopedValueRollback naming(m_isNaming, true);
    const RingStructure ring = m_bus.structure();
    const RingStructure plan = structureOf(m_document.project(), m_bus.id());
    for (const ComparisonLine &line : certainLines(compareRings(plan, ring), plan, ring)) {
        const Participant &participant = ring[*line.connected];
        const ProjectDevice &planned = devicesOn(m_document.project(), m_bus.id())[*line.configured];
        if (planned.place() != m_bus.placeOf(participant.number))
            continue;
        const Name wanted = nameInTheProject(m_bus.catalog(), planned);
        // While a job runs it is refused, and done with the next change.
        if (wanted != nameOnTheBus(m_bus, participant))
            (void)m_bus.name(planned.place(), wanted.key, wanted.turns, wanted.stepsPerTurn);
    }
}

void DeviceNames::takeName(Place number)
{
    const RingStructure &ring = m_bus.structure();
    const auto participant = std::ranges::find(ring, number.node, &Participant::number);
    const ProjectDevice *planned = findDevice(m_document.project(), number);
    if (m_isNaming || planned == nullptr || participant == ring.end() ||
        planned->participant.deviceCode != participant->deviceCode)
        return;
    const QScopedValueRollback naming(m_isNaming, true);
    const Name name = nameOnTheBus(m_bus, *participant);
    m_document.editDevice(number, tr("Name %1").arg(number.shown()), [&](ProjectDevice &device) {
        device.participant.deviceKey = name.key;
        device.label.turns = name.turns;
        device.label.stepsPerTurn = name.stepsPerTurn;
    });
}

} // namespace codewheel
