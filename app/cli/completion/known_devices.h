// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "cli/kinds/link_kind.h"
#include "project/project.h"

namespace codewheel {

// What can be told of a call that is being typed without opening any link: from its project, and from the
// plan of the training bus. What it does not know is left out.
class KnownDevices
{
public:
    // `link` and `projectFile` as typed; empty: none.
    KnownDevices(const QString &link, const QString &projectFile);

    const Catalog &catalog() const { return m_catalog; }
    const std::vector<KnownDevice> &devices() const { return m_devices; } // by place, then by station
    QStringList buses() const;
    // Of the device at this place; of all devices if it is not known which one is there.
    std::vector<const ParameterDescription *> parameters(const QString &place) const;

private:
    void addTraining(const QString &link);
    void addPlanned(bool leadsToPlan);

    Catalog m_catalog;
    std::optional<Project> m_project;
    std::vector<KnownDevice> m_devices;
};

} // namespace codewheel
