// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/project_step.h"

#include <algorithm>

namespace codewheel {

ProjectStep::ProjectStep(ProjectDocument &document, Project after, Ids ids,
                         std::map<Place, ProjectDevice> others, const QString &what,
                         ProjectDocument::Gesture gesture)
    : QUndoCommand(what)
    , m_document(document)
    , m_before{.content = document.content(), .devices = {}, .ids = {}}
    , m_gesture(gesture)
{
    const Devices &before = document.project().devices;
    const Ids &idsBefore = document.m_ids;
    const std::size_t shorter = std::min(before.size(), after.devices.size());
    const auto isSame = [&](std::size_t here, std::size_t there) {
        return idsBefore[here] == ids[there] && before[here] == after.devices[there];
    };
    while (m_first < shorter && isSame(m_first, m_first))
        ++m_first;
    std::size_t tail = 0;
    while (tail < shorter - m_first && isSame(before.size() - 1 - tail, after.devices.size() - 1 - tail))
        ++tail;
    const auto cut = [&](const auto &all) {
        return std::decay_t<decltype(all)>(all.begin() + static_cast<std::ptrdiff_t>(m_first),
                                           all.end() - static_cast<std::ptrdiff_t>(tail));
    };
    m_before.devices = cut(before);
    m_before.ids = cut(idsBefore);
    m_after.devices = cut(after.devices);
    m_after.ids = cut(ids);
    after.devices.clear();
    m_after.content = {.header = std::move(after), .others = std::move(others)};
}

void ProjectStep::undo()
{
    m_isNew = false;
    m_document.apply(m_before.content, m_first, m_after.devices.size(), m_before.devices, m_before.ids);
    Q_EMIT m_document.wentBackOrForth(places());
}

void ProjectStep::redo()
{
    m_document.apply(m_after.content, m_first, m_before.devices.size(), m_after.devices, m_after.ids);
    if (!m_isNew)
        Q_EMIT m_document.wentBackOrForth(places());
}

std::vector<Place> ProjectStep::places() const
{
    std::vector<Place> places;
    const auto take = [&places](Place place) {
        if (std::ranges::find(places, place) == places.end())
            places.push_back(place);
    };
    const auto takeUnlessThere = [&](const State &here, const State &there) {
        for (const ProjectDevice &device : here.devices)
            if (std::ranges::find(there.devices, device) == there.devices.end())
                take(device.place());
        for (const auto &[place, device] : here.content.others)
            if (const auto same = there.content.others.find(place);
                same == there.content.others.end() || same->second != device)
                take(place);
        for (const PlannedBus &bus : here.content.header.buses)
            if (std::ranges::find(there.content.header.buses, bus) == there.content.header.buses.end())
                take({bus.id});
    };
    takeUnlessThere(m_after, m_before);
    takeUnlessThere(m_before, m_after);
    std::stable_partition(places.begin(), places.end(), [](Place place) { return !place.isEmpty(); });
    return places;
}

void ProjectStep::nameAnew()
{
    const std::vector<Place> changed = places();
    const bool isOfOneDevice = changed.size() == 1 && !changed.front().isEmpty();
    setText(isOfOneDevice ? tr("Change of %1", "a device").arg(changed.front().shown())
                          : tr("Earlier change"));
}

// Merges only changes to the same devices in the same gesture, so that the two spans are the same.
bool ProjectStep::mergeWith(const QUndoCommand *next)
{
    const auto &later = static_cast<const ProjectStep &>(*next);
    const bool isSameSpan =
        later.m_first == m_first && later.m_before.ids == m_after.ids && later.m_after.ids == m_after.ids;
    if (later.m_gesture != m_gesture || !isSameSpan)
        return false;
    m_after = later.m_after;
    setObsolete(m_before == m_after);
    return true;
}

} // namespace codewheel
