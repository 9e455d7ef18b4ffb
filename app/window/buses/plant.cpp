// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/plant.h"

#include "app/window/kinds/window_kinds.h"
#include "app/window/recording/recordings.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "vocabulary/bus_names.h"
#include "widgets/project/project_document.h"

#include <algorithm>

namespace codewheel {

Plant::Plant(BusAtWork::Surroundings surroundings, QObject *parent)
    : QObject(parent)
    , m_surroundings(std::move(surroundings))
    , m_recordings(new Recordings(*this, m_surroundings))
{
    connect(&m_surroundings.project, &ProjectDocument::changed, this, &Plant::followProject);
    connect(&m_sessions, &Buses::changed, this, &Plant::nameBuses);
    connect(&m_recording, &RecordingAtWork::messaged, this,
            [this](const Message &message) { Q_EMIT messaged(message, wallClock()); });
    followProject();
}

QDateTime Plant::wallClock() const
{
    const QDateTime ofBus = m_surroundings.byThread ? QDateTime() : m_sessions.now({});
    return ofBus.isValid() ? ofBus : m_surroundings.clock();
}

Plant::~Plant()
{
    setBusNames({});
}

std::vector<BusAtWork *> Plant::all() const
{
    std::vector<BusAtWork *> all;
    for (const auto &bus : m_buses)
        all.push_back(bus.get());
    return all;
}

QString Plant::nameOf(BusId bus) const
{
    const auto called = m_called.find(bus);
    return called == m_called.end() ? QString() : called->second;
}

// A bus no longer in the project keeps its name, unless another bus has it now.
void Plant::callBuses()
{
    const Names before = std::exchange(m_called, {});
    for (const PlannedBus &planned : m_surroundings.project.project().buses) {
        m_called[planned.id] = planned.name;
        m_named.insert(planned.id);
    }
    const auto isTaken = [this](const QString &name) {
        return std::ranges::find(m_called, name, &Names::value_type::second) != m_called.end();
    };
    for (const auto &bus : m_buses) {
        const auto last = before.find(bus->id());
        const QString name = last == before.end() ? bus->nameOfNew() : last->second;
        if (!m_called.contains(bus->id()))
            m_called[bus->id()] = freeName(name, isTaken);
    }
}

void Plant::nameAnew()
{
    std::erase_if(m_called, [this](const auto &called) { return !m_named.contains(called.first); });
    nameBuses();
}

BusAtWork *Plant::find(BusId bus) const
{
    const auto found = std::ranges::find(m_buses, bus, [](const auto &its) { return its->id(); });
    return found == m_buses.end() ? nullptr : found->get();
}

std::vector<const LedgerKeeper *> Plant::ledgers() const
{
    std::vector<const LedgerKeeper *> ledgers;
    for (const auto &bus : m_buses)
        if (bus->ledger() != nullptr)
            ledgers.push_back(bus->ledger());
    return ledgers;
}

void Plant::pump()
{
    m_recordings->passTime();
    m_sessions.pump();
}

void Plant::openTraining()
{
    for (const auto &bus : m_buses)
        if (bus->isTraining())
            bus->openTraining();
}

void Plant::start()
{
    for (const auto &bus : m_buses)
        if (bus->isOpen())
            bus->start();
}

// A bus without a link in this program stays planned.
void Plant::make(const QString &kind, BusId id)
{
    if (const WindowKind *its = windowKind(kind); its != nullptr && its->make != nullptr)
        add(its->make(id, m_surroundings));
}

void Plant::add(std::unique_ptr<BusAtWork> bus)
{
    connect(bus.get(), &BusAtWork::messaged, this, &Plant::messaged);
    BusAtWork *its = bus.get();
    const auto takeSession = [this, its] {
        if (EncoderBus *session = its->bus())
            m_sessions.add(*session);
    };
    connect(its, &BusAtWork::aboutToChange, this, [this, its] { m_sessions.remove(its->bus()); });
    connect(its, &BusAtWork::changed, this, takeSession);
    takeSession();
    const auto behind =
        std::ranges::upper_bound(m_buses, its->id(), {}, [](const auto &other) { return other->id(); });
    m_buses.insert(behind, std::move(bus));
    nameBuses();
    Q_EMIT added(its);
}

// A number stands for one bus: the project's, if it plans another kind there. The training buses always
// exist.
bool Plant::isNeeded(const BusAtWork &bus) const
{
    if (const PlannedBus *planned = findBus(m_surroundings.project.project(), bus.id()))
        return planned->kind == bus.kind();
    return bus.isOpen() || bus.isTraining();
}

void Plant::removeUnneeded()
{
    for (BusAtWork *bus : all())
        if (!isNeeded(*bus)) {
            m_sessions.remove(bus->bus());
            Q_EMIT aboutToRemove(bus);
            m_called.erase(bus->id());
            m_named.erase(bus->id());
            std::erase_if(m_buses, [bus](const auto &its) { return its.get() == bus; });
        }
    nameBuses();
}

void Plant::followProject()
{
    removeUnneeded();
    for (const PlannedBus &planned : m_surroundings.project.project().buses)
        if (find(planned.id) == nullptr)
            make(planned.kind, planned.id);
    for (const QString &kind : busKindKeys())
        if (const auto training = busKind(kind)->trainingBus(); training && find(*training) == nullptr)
            make(kind, *training);
    nameBuses();
}

// If there are several buses of a kind, their places are shown with the names of the buses; those of a
// recording always are.
void Plant::nameBuses()
{
    callBuses();
    const Project &project = m_surroundings.project.project();
    std::vector<NamedBus> all;
    std::vector<NamedBus> withPlaces;
    for (const auto &bus : m_buses) {
        all.push_back({bus->id(), bus->kind(), nameOf(bus->id())});
        if (bus->isOpen() || findBus(project, bus->id()) != nullptr)
            withPlaces.push_back(all.back());
    }
    std::pair names(namesOfSeveral(withPlaces), namesOf(all));
    for (const auto &bus : m_buses)
        if (bus->bus() != nullptr && bus->bus()->isReplay())
            names.first[bus->id()] = nameOf(bus->id());
    if (std::exchange(m_names, names) == names)
        return;
    setBusNames(std::move(names.first), std::move(names.second));
    Q_EMIT m_sessions.changed();
}

} // namespace codewheel
