// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/device_choice.h"

#include "bus/buses.h"
#include "catalog/catalog.h"
#include "project/project.h"
#include "widgets/structure/structure_view.h"
#include "widgets/structure_editor/structure_editor.h"

#include <QScopedValueRollback>

#include <algorithm>

namespace codewheel {

DeviceChoice::DeviceChoice(const Buses &buses, const Catalog &catalog, const ProjectDocument &project,
                           StructureView &tree, StructureEditor &editor, QObject *parent)
    : QObject(parent)
    , m_buses(buses)
    , m_catalog(catalog)
    , m_project(project)
    , m_tree(tree)
    , m_editor(editor)
{
    connect(&tree, &StructureView::chosen, this, &DeviceChoice::choose);
    connect(&editor, &StructureEditor::chosen, this, [this](Place number) {
        if (m_editor.isVisible()) // otherwise it was not the user
            choose(number);
    });
    connect(&project, &ProjectDocument::changed, this, &DeviceChoice::followPlan);
    connect(&buses, &Buses::changed, this, &DeviceChoice::show);
}

void DeviceChoice::choose(std::optional<Place> number)
{
    if (m_isChoosing)
        return;
    const QScopedValueRollback choosing(m_isChoosing, true);
    const bool isThere = number && (m_project.idAt(*number) || m_buses.isConnected(*number));
    m_place = isThere ? number : otherwise();
    m_planned = m_place ? m_project.idAt(*m_place) : std::nullopt;
    if (m_place) {
        m_tree.choose(*m_place);
        m_editor.choose(*m_place);
    }
    show();
}

void DeviceChoice::keep(std::optional<Place> before)
{
    choose(before && m_buses.isConnected(*before) ? before : otherwise());
}

// The choice in the bus structure panel, or the first device of the bus, or the first one there is.
std::optional<Place> DeviceChoice::otherwise() const
{
    if (const auto current = m_tree.current())
        return current;
    const std::vector<Place> places = m_buses.places();
    const auto near = m_tree.row() ? m_tree.row() : m_place;
    const auto onBus = near ? std::ranges::find(places, near->bus, &Place::bus) : places.end();
    if (onBus != places.end())
        return *onBus;
    return places.empty() ? std::nullopt : std::optional(places.front());
}

ShownEncoder DeviceChoice::find() const
{
    if (m_place && m_buses.isConnected(*m_place))
        return m_buses.encoder(*m_place);
    if (m_place && m_planned)
        if (const auto description = plannedDescription(m_project.device(*m_place), m_catalog))
            return {*m_place, *description};
    return {};
}

// The rows of the bus structure may have been rebuilt, and places may have changed. A bus that is planned
// from nothing has no row until its first device is there.
void DeviceChoice::followPlan()
{
    const bool isBusPlanned = m_editor.isVisible() && findBus(m_project.project(), m_editor.bus()) != nullptr;
    if (m_place && m_buses.isConnected(*m_place) && (m_tree.row() || isBusPlanned)) {
        show();
        return;
    }
    const ProjectDevice *planned = m_planned ? m_project.device(*m_planned) : nullptr;
    if (planned && planned->place() == m_place && m_tree.currentBus())
        show(); // the choice stays
    else
        choose(planned ? std::optional(planned->place()) : m_place);
}

void DeviceChoice::show()
{
    ShownEncoder now = find();
    if (now == m_encoder && m_place == m_told)
        return;
    m_encoder = std::move(now);
    m_told = m_place;
    Q_EMIT changed();
}

} // namespace codewheel
