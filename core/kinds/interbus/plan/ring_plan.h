// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"

#include <map>

namespace codewheel {

class BusKind;

// How addresses in the process image are counted and checked.
struct AddressRules
{
    enum class Unit : std::uint8_t { byte, word };

    Unit unit = Unit::byte; // as shown and typed
    int first = 0;          // of automatic addresses, bytes
    bool step5 = false;     // encoders must be above P127 (Step 5)

    friend bool operator==(const AddressRules &, const AddressRules &) = default;
};

// The link the project is used with: its kind ("training") and settings, as stored in its file.
struct ProjectLink
{
    QString kind = QStringLiteral("training");
    std::map<QString, QString> settings;

    friend bool operator==(const ProjectLink &, const ProjectLink &) = default;
};

// Where a device is in the process image if that was given by hand, in bytes; empty: automatic.
struct GivenAddresses
{
    std::optional<int> in{};
    std::optional<int> out{};

    friend bool operator==(const GivenAddresses &, const GivenAddresses &) = default;
};

// A ring as planned; its devices have GivenAddresses.
struct RingPlan
{
    ProjectLink link;
    AddressRules addresses;
    double cableKilometres = 0;

    friend bool operator==(const RingPlan &, const RingPlan &) = default;
};
inline constexpr char interbusKind[] = "interbus";

// The defaults if the project has no ring with this number.
const RingPlan &ringPlan(const Project &project, BusId ring);
// Plans the ring if the project does not have it yet.
void setRingPlan(Project &project, BusId ring, RingPlan plan);

// Rings, for the list of kinds (bus_kind.cpp).
std::unique_ptr<const BusKind> makeRingKind();

} // namespace codewheel
