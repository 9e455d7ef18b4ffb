// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/comparison.h"
#include "bus/not_live.h"
#include "project/finding.h"
#include "project/project.h"
#include "vocabulary/refusal.h"

#include <QCoreApplication>

#include <map>

namespace codewheel {

class Catalog;
class EncoderBus;
struct DeviceDescription;

// A column of the structure editor.
enum class PlanField : std::uint8_t { place, station, group, device, own, serialNumber, note, findings };
struct PlanColumn
{
    PlanField field = PlanField::own;
    QString title;
    std::size_t own = 0; // which one of the kind's own
    bool isNumber = false;

    friend bool operator==(const PlanColumn &, const PlanColumn &) = default;
};

// The content of a column of the kind's own.
struct PlanCell
{
    QString text;
    QString toolTip;              // empty: that of the device
    std::optional<QString> typed; // what an edit starts with; empty: it cannot be edited

    friend bool operator==(const PlanCell &, const PlanCell &) = default;
};

// What the structure editor shows of a planned device. Equal rows look the same.
struct PlanRow
{
    Place place;
    std::optional<std::size_t> parent; // among the devices of the bus; empty: directly on the bus
    bool isCoupler = false;            // others can be below it
    QString station;
    QString group;
    QString note;
    QString serialNumber; // on its label
    QString name;         // "FRABA OCD-IB K3"
    QString toolTip;
    std::vector<PlanCell> own;
    QStringList codes; // that it is also found by
    std::vector<Finding> findings;

    friend bool operator==(const PlanRow &, const PlanRow &) = default;
};

// The devices of a bus after an edit, and where each was before; empty: it is new.
struct EditedPlan
{
    std::vector<ProjectDevice> devices;
    std::vector<std::optional<std::size_t>> from;
};

// Where a device can be put, in terms of its kind of bus.
struct PlanTarget
{
    QString text;
    KindData where;
};

// What is on a connected bus, and which planned devices are different ones there, as the bus reports
// (EncoderBus::isOther).
struct ConnectedBus
{
    std::vector<Participant> devices;
    std::map<NodeId, Refusal> others;
    std::map<NodeId, NotLive> notLive{}; // devices that are not known to be there now, as they were then

    friend bool operator==(const ConnectedBus &, const ConnectedBus &) = default;
};
ConnectedBus connectedBus(const Project &project, const EncoderBus &bus);

// By keys: before or after its neighbour; below the one before it; out again; to the other bus of its
// coupler.
enum class PlanStep : std::uint8_t { up, down, in, out, changeBus };

// How the devices of one kind of bus are planned: what is shown of them, where they can be, what can be done
// to them, and how the plan compares to what is connected. Devices are given by their index among those of
// the bus. By default: each device has one of places(), which is typed, and nothing is below another.
class PlanRules
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::PlanRules)

public:
    using Devices = std::span<const ProjectDevice>;

    virtual ~PlanRules() = default;

    std::vector<PlanColumn> columns(const Project &project, BusId bus) const;
    std::vector<PlanRow> rows(const Project &project, BusId bus, const Catalog &catalog) const;
    // What breaks a rule of the bus, device by device; rows() includes it as well.
    virtual std::vector<Finding> check(const Project &, BusId) const { return {}; }
    // "FRABA OCD-IB K3"
    virtual QString nameOf(const Participant &device, const Catalog &catalog) const;
    // By which its bus tells what it is: "37h"; empty: it does not.
    virtual QString codeOf(const Participant & /*device*/) const { return {}; }
    // Order follows from where a device is attached: devices are moved by keys and by dragging.
    virtual bool isOrdered() const { return false; }
    virtual bool isEditable(const PlanRow &row, const PlanColumn &column) const;

    // What is wrong with a text for this cell; empty: nothing.
    virtual QString complaint(const Project &project, Place device, const PlanColumn &column,
                              const QString &text) const;
    virtual Result<EditedPlan> type(const Project &project, Place device, const PlanColumn &column,
                                    const QString &text) const;

    virtual std::vector<Participant> offered(const Catalog &catalog) const;
    // From an ID code and a length code; empty: this kind knows devices only by their descriptions.
    virtual std::optional<Participant> coded(unsigned, unsigned) const { return std::nullopt; }
    virtual QString reading(const Participant &device, const Catalog &catalog) const; // in full
    // Seen from the chosen device, the usual one first: it is planned (its index), or only connected (where).
    virtual std::vector<PlanTarget> targets(const Project &project, BusId bus,
                                            std::optional<std::size_t> chosen,
                                            std::optional<NodeId> connected) const;
    // Of these targets, where `device` belongs if it was to be put at `target`.
    virtual std::size_t preferred(const std::vector<PlanTarget> &, const Participant &,
                                  std::size_t target) const
    {
        return target;
    }

    virtual Result<EditedPlan> insert(const Project &project, BusId bus, const Participant &device,
                                      const KindData &where) const;
    // With everything below them.
    virtual Result<EditedPlan> remove(const Project &project, BusId bus,
                                      std::span<const std::size_t> devices) const;
    // Another kind of device at this place; station, group, note and addresses stay.
    virtual Result<EditedPlan> change(const Project &project, BusId bus, std::size_t device,
                                      const Participant &to) const;
    virtual Result<EditedPlan> move(const Project &project, BusId bus, std::span<const std::size_t> devices,
                                    const KindData &where) const;
    // Empty: there is no such place.
    virtual std::optional<KindData> stepped(const Project &, BusId, std::size_t, PlanStep) const
    {
        return std::nullopt;
    }
    // Dropped into this row below `parent`, or on it (row < 0).
    virtual std::optional<KindData> dropped(const Project &, BusId, std::size_t, std::optional<std::size_t>,
                                            int) const
    {
        return std::nullopt;
    }

    // The plan compared to what is connected; by default place by place.
    virtual Comparison compare(const Project &project, BusId bus, const ConnectedBus &connected) const;
    // "3.0: configured K3 37h, found K2 36h"
    virtual QString comparisonText(const ComparisonLine &line, const Project &project, BusId bus,
                                   const ConnectedBus &connected, const Catalog &catalog) const;
    // Planned devices of which nobody can say whether they are at their places, and why, although the line of
    // the comparison is the same.
    virtual std::map<NodeId, Refusal> uncertain(const Project &, BusId, const ConnectedBus &,
                                                const Catalog &) const
    {
        return {};
    }
    // The plan with these lines taken over from what is connected. If another device is in its place, what
    // belongs to the place stays.
    virtual EditedPlan takenOver(const Project &project, BusId bus, const ConnectedBus &connected,
                                 const Comparison &comparison, std::span<const std::size_t> lines) const;

protected:
    static EditedPlan unchanged(const Project &project, BusId bus);
    // Why a device cannot be there along with the others; empty: it can.
    virtual QString whyNotAt(NodeId place, Devices others) const;

private:
    virtual QString placeTitle() const { return tr("Address"); }
    virtual std::vector<PlanColumn> ownColumns(const Project &, BusId) const { return {}; }
    // Adds the kind's own to the rows. Returns the same as check().
    virtual std::vector<Finding> complete(std::vector<PlanRow> &, const Project &project, BusId bus,
                                          const Catalog &) const
    {
        return check(project, bus);
    }

    // All there are, in their order.
    virtual std::vector<NodeId> places() const { return {}; }
    virtual std::optional<NodeId> typedPlace(const QString &text) const; // "5" and "can:5"
    virtual QString noPlaceText(const QString &text) const;
    virtual bool isOffered(const DeviceDescription &) const { return false; }
};

// What was known and wanted of it does not apply to the device that replaces it.
void becomeAnother(ProjectDevice &device);

} // namespace codewheel
