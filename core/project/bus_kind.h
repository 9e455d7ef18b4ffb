// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_outline.h"
#include "project/project.h"

#include <memory>
#include <span>

namespace codewheel {

class Catalog;
class JsonObject;
class PlanRules;
class ProjectWriter;

// A kind of bus in a project: how its buses are looked at, checked, and kept in the file
// (docs/project-files.md).
class BusKind
{
public:
    virtual ~BusKind() = default;

    virtual QString key() const = 0;       // in files: "interbus"
    virtual QString title() const = 0;     // in the user's language: "INTERBUS ring"
    virtual QString usualName() const = 0; // of a bus that is new in a project: "Ring"
    virtual std::optional<BusId> trainingBus() const { return {}; } // no other kind gets its number
    virtual KindData usual() const = 0;                           // what is set where nobody has set anything
    virtual QString linkText(const KindData &settings) const = 0; // "/dev/ttyUSB0, 19200 Bd, 8N2"
    // Whether its link is a simulated one, of which what is seen may be kept and reported.
    virtual bool isTraining(const KindData &settings) const = 0;
    // As it is planned. The catalog outlives it; the project need not.
    virtual std::unique_ptr<BusOutline> outline(const Project &project, BusId bus,
                                                const Catalog &catalog) const = 0;
    // Without "kind", "number" and "name". What is wrong is reported to the object's keeper; the devices are
    // given their bus by the caller.
    virtual KindData read(const JsonObject &json, std::vector<ProjectDevice> &devices) const = 0;
    virtual void write(ProjectWriter &writer, const KindData &settings,
                       std::span<const ProjectDevice> devices) const = 0;
    // How its devices are planned; as it stands, they cannot be.
    virtual const PlanRules &planRules() const;
};

// Whether the bus is planned with a simulated link, or not at all.
bool plansTraining(const Project &project, BusId bus);

// Those of the program, and what was added.
const BusKind *busKind(QStringView key); // null: there is none
QStringList busKindKeys();
void addBusKind(std::unique_ptr<const BusKind> kind);

} // namespace codewheel
