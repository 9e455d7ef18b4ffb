// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/canopen/bus/canopen_settings.h"
#include "project/project.h"

#include <memory>

namespace codewheel {

class BusKind;

// A CAN bus with CANopen as planned.
struct CanopenPlan
{
    CanopenSettings settings;

    friend bool operator==(const CanopenPlan &, const CanopenPlan &) = default;
};

// What is peculiar to an encoder of the plan (ProjectDevice::its()).
struct CanopenEncoderSettings
{
    QString file{}; // EDS or DCF that its objects are taken from; empty: none

    friend bool operator==(const CanopenEncoderSettings &, const CanopenEncoderSettings &) = default;
};

inline constexpr char canopenKind[] = "canopen";

// Null: the project has no such bus with this number.
const CanopenPlan *canopenPlan(const Project &project, BusId bus);
// Plans the bus if the project does not have it yet.
void setCanopenPlan(Project &project, BusId bus, CanopenPlan plan);

// For the list of kinds (bus_kind.cpp).
std::unique_ptr<const BusKind> makeCanopenKind();

} // namespace codewheel
