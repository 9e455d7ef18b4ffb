// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/shown_encoder.h"
#include "widgets/project/project_document.h"

#include <QObject>

namespace codewheel {

class Buses;
class Catalog;
class StructureEditor;
class StructureView;

// Which device the panels of the window show: the one chosen in the bus structure panel or in the structure
// editor; each follows the other. On a connected bus it is the device at that place. One that is only planned
// stays chosen while the plan is edited, whatever its place becomes.
class DeviceChoice : public QObject
{
    Q_OBJECT

public:
    // All must outlive it.
    DeviceChoice(const Buses &buses, const Catalog &catalog, const ProjectDocument &project,
                 StructureView &tree, StructureEditor &editor, QObject *parent = nullptr);

    std::optional<Place> place() const { return m_place; }
    const ShownEncoder &encoder() const { return m_encoder; } // none: no encoder, or nothing known of it
    // If it is neither connected nor planned, the choice in the bus structure panel applies, or the first
    // device.
    void choose(std::optional<Place> number);
    // Another ring is connected: the device that the bus structure panel chose by itself gives way to the
    // previous one, if that is in the ring.
    void keep(std::optional<Place> before);

Q_SIGNALS:
    void changed(); // place or encoder, or the encoder is now connected

private:
    ShownEncoder find() const;
    std::optional<Place> otherwise() const;
    void followPlan();
    void show();

    const Buses &m_buses;
    const Catalog &m_catalog;
    const ProjectDocument &m_project;
    StructureView &m_tree;
    StructureEditor &m_editor;
    std::optional<Place> m_place;
    std::optional<ProjectDocument::DeviceId> m_planned; // the device at that place in the plan
    ShownEncoder m_encoder;
    std::optional<Place> m_told;
    bool m_isChoosing = false;
};

} // namespace codewheel
