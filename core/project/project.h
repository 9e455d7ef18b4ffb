// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bus/participant.h"
#include "project/word_list.h"
#include "vocabulary/cam_program.h"
#include "vocabulary/kind_data.h"
#include "vocabulary/known.h"

#include <QDateTime>
#include <QString>

#include <optional>
#include <span>
#include <vector>

namespace codewheel {

class Catalog;
struct DeviceDescription;

// What the user reads from the label of a device; 0 or empty: not given.
struct DeviceLabel
{
    int turns = 0;
    int stepsPerTurn = 0;
    QString serialNumber;

    friend bool operator==(const DeviceLabel &, const DeviceLabel &) = default;
};

// A value an encoder was known to have, kept in the project.
struct StoredValue
{
    Parameter parameter = Parameter::steps;
    Value value = 0;
    Evidence evidence = Evidence::told;
    QDateTime at; // UTC

    friend bool operator==(const StoredValue &, const StoredValue &) = default;
};
struct StoredCams
{
    CamProgram program;
    Evidence evidence = Evidence::read;
    QDateTime at; // UTC

    friend bool operator==(const StoredCams &, const StoredCams &) = default;
};

// The position an encoder showed last, for its replacement.
struct LastPosition
{
    std::int64_t position = 0; // steps
    QDateTime at;              // UTC
    ParameterValues scale{};   // known of the encoder with it, by parameter; empty: nothing

    friend bool operator==(const LastPosition &, const LastPosition &) = default;
};

// One device of the planned bus, and what is wanted and known of it.
struct ProjectDevice
{
    BusId bus = firstBus;
    Participant
        participant; // its number follows from its place and level, or is its address on a serial line
    QString station; // "Crane 1, hoist"; empty: none
    QString group;
    QString note;
    DeviceLabel label;
    ParameterValues wanted;             // by parameter
    std::vector<CamProgram> wantedCams; // by number
    std::vector<StoredValue> stored;    // by parameter
    std::vector<StoredCams> storedCams; // by number
    std::optional<LastPosition> lastPosition;
    KindData settings; // of its kind of bus, which reads and writes them; empty: the usual ones

    Place place() const { return {bus, participant.number}; }
    void standAt(Place place)
    {
        bus = place.bus;
        participant.number = place.node;
    }
    template <typename T>
    T its() const
    {
        const T *given = settings.as<T>();
        return given != nullptr ? *given : T();
    }
    template <typename T>
    void set(const T &its)
    {
        settings = its == T() ? KindData() : KindData(its);
    }

    friend bool operator==(const ProjectDevice &, const ProjectDevice &) = default;
};

struct ProjectSequence
{
    QString name;
    WordList list;

    friend bool operator==(const ProjectSequence &, const ProjectSequence &) = default;
};

// One bus of the plan. Its devices are in the project's list.
struct PlannedBus
{
    BusId id;
    QString kind;      // "interbus", "esc"
    QString name;      // unique within a project
    KindData settings; // a RingPlan or a EscLinePlan, depending on the kind

    friend bool operator==(const PlannedBus &, const PlannedBus &) = default;
};

// A ring without devices: what a project starts with.
std::vector<PlannedBus> usualBuses();

// The document: planned buses with what is wanted of their encoders. A value; edits make a new one. Its file
// is documented in docs/project-files.md.
struct Project
{
    QString title;
    QString note;
    std::vector<PlannedBus> buses = usualBuses(); // by number
    std::vector<ProjectDevice> devices;           // in the order of the buses; those of a bus in its order
    std::vector<ProjectSequence> sequences;

    friend bool operator==(const Project &, const Project &) = default;
};

const PlannedBus *findBus(const Project &project, BusId bus); // null: it has none with this number
PlannedBus *findBus(Project &project, BusId bus);

// Null: the project has none there.
const ProjectDevice *findDevice(const Project &project, Place place);
ProjectDevice *findDevice(Project &project, Place place);

// Those of one bus, in its order.
std::span<const ProjectDevice> devicesOn(const Project &project, BusId bus);
std::span<ProjectDevice> devicesOn(Project &project, BusId bus);
std::vector<Participant> participantsOn(const Project &project, BusId bus);
// Replaces those of this bus, which the project has, with these.
void setDevicesOn(Project &project, BusId bus, std::vector<ProjectDevice> devices);

// What a device of the plan is: the description it is named by, or that of its device code if its make is not
// known. The resolution on its label takes precedence. Empty: there is no description.
std::optional<DeviceDescription> plannedDescription(const ProjectDevice &device, const Catalog &catalog);

} // namespace codewheel
