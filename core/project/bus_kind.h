// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/bus_outline.h"
#include "project/project.h"

#include <memory>
#include <span>

namespace codewheel {

namespace report_sections {
struct BusSections;
}
class Catalog;
class JsonObject;
class PlanRules;
class Profile;
class ProjectWriter;
class RecordedRows;

// A kind of bus in a project: how its buses are displayed, checked, and stored in the file
// (docs/project-files.md).
class BusKind
{
public:
    virtual ~BusKind() = default;

    virtual QString key() const = 0;   // in files: "interbus"
    virtual QString title() const = 0; // in the user's language: "INTERBUS ring"
    // Of a bus without a project, the same in all languages: "Line".
    virtual QString usualName() const = 0;
    // Of a bus that is new in a project or a window, in the language of the user.
    virtual QString nameOfNew() const { return usualName(); }
    virtual std::optional<BusId> trainingBus() const { return {}; } // no other kind gets its number
    virtual KindData usual() const = 0;                             // the defaults where nothing has been set
    virtual QString linkText(const KindData &settings) const = 0;   // "/dev/ttyUSB0, 19200 Bd, 8N2"
    // Whether its link is a simulated one. What is seen on it may be kept and reported.
    virtual bool isTraining(const KindData &settings) const = 0;
    // As planned. The catalog must outlive it; the project need not.
    virtual std::unique_ptr<BusOutline> outline(const Project &project, BusId bus,
                                                const Catalog &catalog) const = 0;
    // Without "kind", "number" and "name". Errors are reported to the object's keeper; the caller assigns the
    // devices to their bus.
    virtual KindData read(const JsonObject &json, std::vector<ProjectDevice> &devices) const = 0;
    virtual void write(ProjectWriter &writer, const KindData &settings,
                       std::span<const ProjectDevice> devices) const = 0;
    // How its devices are planned; by default they cannot be.
    virtual const PlanRules &planRules() const;
    // The traffic of a recorded bus with an encoder of this profile; null: it is none of this kind.
    virtual std::unique_ptr<RecordedRows> recordedRows(Profile profile) const;
    // How the report describes its buses; null: by the places of their devices, and nothing more.
    virtual const report_sections::BusSections *reportSections() const { return nullptr; }
};

// Whether the bus is planned with a simulated link, or not planned at all.
bool plansTraining(const Project &project, BusId bus);

// The built-in ones, and any that were added.
const BusKind *busKind(QStringView key); // null: there is none
QStringList busKindKeys();
void addBusKind(std::unique_ptr<const BusKind> kind);

} // namespace codewheel
