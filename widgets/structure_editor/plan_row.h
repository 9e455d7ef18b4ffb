// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/check_project.h"

#include <vector>

namespace codewheel {

class Catalog;

// What the structure editor shows of a planned device. Two that are equal look the same.
struct PlanRow
{
    Place place;
    Participant participant;
    QString station;
    QString group;
    QString note;
    QString serialNumber; // of its label
    QString name;
    QString profile;
    DeviceAddresses addresses;
    AddressRules::Unit unit = AddressRules::Unit::byte;
    std::vector<Finding> findings;

    friend bool operator==(const PlanRow &, const PlanRow &) = default;
};

// In ring order.
std::vector<PlanRow> planRows(const Project &project, BusId ring, const Catalog &catalog);

// "FRABA OCD-IB K3", "analog input", "device not known"
QString planName(const Participant &participant, const Catalog &catalog);
// Whether it belongs on a local bus: it stands on one, or its ID code says so.
bool prefersLocalBus(const Participant &participant);

} // namespace codewheel
