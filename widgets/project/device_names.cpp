// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/device_names.h"

#include "bus/encoder_bus.h"
#include "catalog/catalog.h"
#include "vocabulary/encoder_session.h"
#include "widgets/project/project_document.h"

#include <QScopedValueRollback>

namespace codewheel {
namespace {

// What a device is taken for: its make, and the resolution on its label; 0: as described.
struct Name
{
    QString key;
    int turns = 0;
    int stepsPerTurn = 0;

    friend bool operator==(const Name &, const Name &) = default;
};

Name nameOf(const Catalog &catalog, const QString &key, int turns, int stepsPerTurn)
{
    const DeviceDescription *described = catalog.find(key);
    if (described == nullptr)
        return {.key = key};
    return {.key = key,
            .turns = turns == described->physicalTurns ? 0 : turns,
            .stepsPerTurn = stepsPerTurn == described->physicalStepsPerTurn ? 0 : stepsPerTurn};
}

Name nameOnTheBus(const EncoderBus &bus, const Participant &participant)
{
    if (const EncoderSession *encoder = bus.encoder(participant.number))
        return nameOf(bus.catalog(), participant.deviceKey, encoder->device().physicalTurns,
                      encoder->device().physicalStepsPerTurn);
    return {.key = participant.deviceKey};
}

} // namespace

DeviceNames::DeviceNames(ProjectDocument &document, EncoderBus &bus, QObject *parent)
    : QObject(parent)
    , m_document(document)
    , m_bus(bus)
{
    connect(&document, &ProjectDocument::changed, this, &DeviceNames::nameDevices);
    connect(&bus, &EncoderBus::named, this, &DeviceNames::takeName);
    connect(&bus, &EncoderBus::nodesChanged, this, &DeviceNames::nameDevices);
    nameDevices();
}

void DeviceNames::nameDevices()
{
    if (m_isNaming || !m_bus.isOpen())
        return;
    const QScopedValueRollback naming(m_isNaming, true);
    const auto strangers = m_bus.strangers(participantsOn(m_document.project(), m_bus.id()));
    for (const ProjectDevice &planned : devicesOn(m_document.project(), m_bus.id())) {
        const auto found = m_bus.found(planned.place());
        if (!found || strangers.contains(planned.place().node))
            continue;
        const Name wanted = nameOf(m_bus.catalog(), planned.participant.deviceKey, planned.label.turns,
                                   planned.label.stepsPerTurn);
        // While a job runs it is refused, and tried again at the next change.
        if (wanted != nameOnTheBus(m_bus, *found))
            (void)m_bus.name(planned.place(), wanted.key, wanted.turns, wanted.stepsPerTurn);
    }
}

void DeviceNames::takeName(Place number)
{
    const auto found = m_bus.found(number);
    const ProjectDevice *planned = findDevice(m_document.project(), number);
    if (m_isNaming || planned == nullptr || !found || planned->participant.deviceCode != found->deviceCode)
        return;
    const QScopedValueRollback naming(m_isNaming, true);
    const Name name = nameOnTheBus(m_bus, *found);
    m_document.editDevice(number, tr("Name %1").arg(number.shown()), [&](ProjectDevice &device) {
        device.participant.deviceKey = name.key;
        device.label.turns = name.turns;
        device.label.stepsPerTurn = name.stepsPerTurn;
    });
}

} // namespace codewheel
