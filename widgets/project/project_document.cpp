// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/project/project_document.h"

#include "widgets/project/project_step.h"

#include <algorithm>
#include <memory>

namespace codewheel {

ProjectDocument::ProjectDocument(QObject *parent)
    : QObject(parent)
{
    m_undo.setUndoLimit(mostSteps);
    connect(&m_undo, &QUndoStack::cleanChanged, this, [this] { Q_EMIT savedChanged(isSaved()); });
}

ProjectDocument::~ProjectDocument()
{
    m_undo.disconnect(this); // it would signal its destruction
}

std::span<const ProjectDocument::DeviceId> ProjectDocument::ids(BusId bus) const
{
    const std::span<const ProjectDevice> devices = devicesOn(m_project, bus);
    return std::span(m_ids).subspan(static_cast<std::size_t>(devices.data() - m_project.devices.data()),
                                    devices.size());
}

std::optional<ProjectDocument::DeviceId> ProjectDocument::idAt(Place place) const
{
    const ProjectDevice *planned = findDevice(m_project, place);
    return planned ? std::optional(m_ids[static_cast<std::size_t>(planned - m_project.devices.data())])
                   : std::nullopt;
}

const ProjectDevice *ProjectDocument::device(DeviceId id) const
{
    const auto found = std::ranges::find(m_ids, id);
    return found == m_ids.end() ? nullptr
                                : &m_project.devices[static_cast<std::size_t>(found - m_ids.begin())];
}

std::optional<std::size_t> ProjectDocument::indexOf(DeviceId id) const
{
    const ProjectDevice *planned = device(id);
    if (planned == nullptr)
        return std::nullopt;
    return static_cast<std::size_t>(planned - devicesOn(m_project, planned->bus).data());
}

const ProjectDevice &ProjectDocument::device(Place number) const
{
    static const ProjectDevice nothingPlanned;
    if (const ProjectDevice *planned = findDevice(m_project, number))
        return *planned;
    const auto other = m_others.find(number);
    return other == m_others.end() ? nothingPlanned : other->second;
}

std::vector<Place> ProjectDocument::notPlanned() const
{
    return others(false);
}

std::vector<Place> ProjectDocument::notKept() const
{
    return others(true);
}

// A line that the project plans takes its encoders.
bool ProjectDocument::isOfTrainingLine(Place place) const
{
    return place.isAddress() && findBus(m_project, place.bus) == nullptr;
}

std::vector<Place> ProjectDocument::others(bool areOfTrainingLine) const
{
    std::vector<Place> numbers;
    for (const auto &[number, device] : m_others)
        if (isOfTrainingLine(number) == areOfTrainingLine && !findDevice(m_project, number))
            numbers.push_back(number);
    return numbers;
}

void ProjectDocument::forEachDevice(const std::function<void(Place, const ProjectDevice &)> &visit) const
{
    for (const ProjectDevice &device : m_project.devices)
        visit(device.place(), device);
    for (const auto &[number, device] : m_others)
        if (!findDevice(m_project, number))
            visit(number, device);
}

void ProjectDocument::setProject(Project project, const QString &file, const QByteArray &fileMark)
{
    m_project = std::move(project);
    m_others.clear();
    m_ids.clear();
    for (std::size_t i = 0; i < m_project.devices.size(); ++i)
        m_ids.push_back(++m_lastId);
    m_isRecovered = false;
    m_undo.clear();
    m_file = file;
    m_fileMark = fileMark;
    Q_EMIT replaced();
    Q_EMIT changed();
    Q_EMIT fileChanged();
    Q_EMIT savedChanged(isSaved());
}

void ProjectDocument::setFile(const QString &file, const QByteArray &fileMark)
{
    m_file = file;
    m_fileMark = fileMark;
    m_isRecovered = false;
    m_undo.setClean();
    Q_EMIT fileChanged();
    Q_EMIT savedChanged(isSaved());
}

void ProjectDocument::takeLastPositions(const Project &saved)
{
    for (ProjectDevice &device : m_project.devices)
        if (const ProjectDevice *its = findDevice(saved, device.place()))
            device.lastPosition = its->lastPosition;
    Q_EMIT changed();
}

void ProjectDocument::setRecovered()
{
    m_isRecovered = true;
    Q_EMIT savedChanged(isSaved());
}

// If the number of devices is unchanged, each keeps its id; otherwise the unchanged ones at both ends do.
std::vector<ProjectDocument::DeviceId> ProjectDocument::keptIds(const Project &after)
{
    if (after.devices.size() == m_ids.size())
        return m_ids;
    const std::vector<ProjectDevice> &before = m_project.devices;
    const std::size_t shorter = std::min(before.size(), after.devices.size());
    std::size_t head = 0;
    while (head < shorter && before[head] == after.devices[head])
        ++head;
    std::size_t tail = 0;
    while (tail < shorter - head &&
           before[before.size() - 1 - tail] == after.devices[after.devices.size() - 1 - tail])
        ++tail;
    std::vector<DeviceId> ids(m_ids.begin(), m_ids.begin() + static_cast<std::ptrdiff_t>(head));
    while (ids.size() < after.devices.size() - tail)
        ids.push_back(++m_lastId);
    ids.insert(ids.end(), m_ids.end() - static_cast<std::ptrdiff_t>(tail), m_ids.end());
    return ids;
}

void ProjectDocument::edit(Project after, const QString &what, Gesture gesture)
{
    std::vector<DeviceId> ids = keptIds(after);
    pushPlanned(std::move(after), std::move(ids), what, gesture);
}

void ProjectDocument::edit(Project after, BusId bus, const Origins &origins, const QString &what)
{
    const std::span<const DeviceId> own = ids(bus);
    const auto behind = m_ids.begin() + (own.data() - m_ids.data()) + std::ssize(own);
    std::vector<DeviceId> kept(m_ids.begin(), behind - std::ssize(own));
    for (const auto &from : origins)
        kept.push_back(from ? own[*from] : ++m_lastId);
    kept.insert(kept.end(), behind, m_ids.end());
    pushPlanned(std::move(after), std::move(kept), what, noGesture);
}

// A device that is now planned takes over the values it was given before.
void ProjectDocument::pushPlanned(Project after, std::vector<DeviceId> ids, const QString &what,
                                  Gesture gesture)
{
    auto others = m_others;
    for (const auto &[number, device] : m_others) {
        ProjectDevice *planned = findDevice(after, number);
        if (!planned || findDevice(m_project, number))
            continue;
        ProjectDevice given = others.extract(number).mapped();
        given.bus = number.bus;
        given.participant = planned->participant;
        ProjectDevice blank;
        blank.bus = number.bus;
        blank.participant = planned->participant;
        if (*planned == blank)
            *planned = std::move(given);
    }
    push(std::move(after), std::move(ids), std::move(others), what, gesture);
}

void ProjectDocument::editDevice(Place number, const QString &what,
                                 const std::function<void(ProjectDevice &)> &edit, Gesture gesture)
{
    Project after = m_project;
    if (ProjectDevice *planned = findDevice(after, number)) {
        edit(*planned);
        push(std::move(after), m_ids, m_others, what, gesture);
        return;
    }
    auto others = m_others;
    edit(others[number]);
    if (others[number] == ProjectDevice())
        others.erase(number);
    push(m_project, m_ids, std::move(others), what, gesture);
}

void ProjectDocument::renumber(Place from, Place to, const QString &what,
                               const std::function<void(ProjectDevice &)> &edit)
{
    Project after = m_project;
    auto ids = m_ids;
    auto others = m_others;
    if (ProjectDevice *moved = findDevice(after, from)) {
        others.erase(to);
        edit(*moved);
        moved->standAt(to);
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < after.devices.size(); ++i)
            if (&after.devices[i] == moved || after.devices[i].place() != to)
                order.push_back(i);
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return after.devices[i].place(); });
        std::vector<ProjectDevice> devices;
        ids.clear();
        for (const std::size_t i : order) {
            devices.push_back(std::move(after.devices[i]));
            ids.push_back(m_ids[i]);
        }
        after.devices = std::move(devices);
    } else if (auto given = others.extract(from)) {
        others.erase(to);
        edit(given.mapped());
        given.key() = to;
        if (given.mapped() != ProjectDevice())
            others.insert(std::move(given));
    }
    push(std::move(after), std::move(ids), std::move(others), what, noGesture);
}

void ProjectDocument::push(Project after, std::vector<DeviceId> ids, std::map<Place, ProjectDevice> others,
                           const QString &what, Gesture gesture)
{
    auto step = std::make_unique<ProjectStep>(*this, std::move(after), std::move(ids), std::move(others),
                                              what, gesture);
    if (!step->changesNothing())
        m_undo.push(step.release());
}

void ProjectDocument::nameStepsAnew()
{
    for (int i = 0; i < m_undo.count(); ++i)
        static_cast<ProjectStep *>(const_cast<QUndoCommand *>(m_undo.command(i)))->nameAnew();
}

ProjectDocument::Content ProjectDocument::content() const
{
    Project header = m_project;
    header.devices.clear();
    return {.header = std::move(header), .others = m_others};
}

// It was seen, not edited.
void ProjectDocument::keepNewerPosition(ProjectDevice &device, DeviceId id) const
{
    const ProjectDevice *now = this->device(id);
    if (now != nullptr && now->lastPosition && device.lastPosition &&
        device.lastPosition->at < now->lastPosition->at)
        device.lastPosition = now->lastPosition;
}

void ProjectDocument::apply(const Content &content, std::size_t first, std::size_t count,
                            const std::vector<ProjectDevice> &devices, const std::vector<DeviceId> &ids)
{
    const auto replace = [&](auto &all, const auto &by) {
        const auto at = all.erase(all.begin() + static_cast<std::ptrdiff_t>(first),
                                  all.begin() + static_cast<std::ptrdiff_t>(first + count));
        all.insert(at, by.begin(), by.end());
    };
    std::vector<ProjectDevice> by = devices;
    for (std::size_t i = 0; i < by.size(); ++i)
        keepNewerPosition(by[i], ids[i]);
    std::vector<ProjectDevice> all = std::move(m_project.devices);
    replace(all, by);
    replace(m_ids, ids);
    m_project = content.header;
    m_project.devices = std::move(all);
    m_others = content.others;
    Q_EMIT changed();
}

} // namespace codewheel
