// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/place.h"
#include "widgets/palette/palette_source.h"

#include <functional>

namespace codewheel {

class Buses;
class Catalog;
class ProjectDocument;
class StructureView;
struct ListedDevice;

// The devices of all buses, connected or planned, for the command palette.
class PaletteDevices : public PaletteSource
{
public:
    // All must outlive it.
    PaletteDevices(const StructureView &structure, const Buses &buses, const ProjectDocument &project,
                   const Catalog &catalog, std::function<void(Place)> choose);

    void begin() override;
    std::vector<PaletteEntry> next() override;

private:
    PaletteEntry entryOf(const ListedDevice &device) const;
    QString wordsOf(const ListedDevice &device) const;

    const StructureView &m_structure;
    const Buses &m_buses;
    const ProjectDocument &m_project;
    const Catalog &m_catalog;
    const std::function<void(Place)> m_choose;
    bool m_isGiven = false;
};

} // namespace codewheel
