// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/plan_rules.h"
#include "vocabulary/eeprom_count.h"

#include <QDateTime>

#include <map>

namespace codewheel {

// What a connected encoder is known to have.
struct LiveEncoder
{
    std::vector<StoredValue> values;
    std::vector<StoredCams> cams;
    std::optional<NotLive> notLive{};
    bool isSimulated = false;
    std::map<Parameter, Kept> kept{}; // its values
};

// Everything a commissioning report is made of; no other source is used.
struct ReportInput
{
    Project project;
    QString file{};  // of the project, as it is to be named; empty: never saved
    QString version; // of the program
    QDateTime now;   // its time zone is used for all times in the report
    // What is known now, by place. A place that is missing here is reported as stored in the project.
    std::map<Place, LiveEncoder> live{};
    std::map<Place, EepromCount> writes{};
    // The connected buses, to be compared with the configured ones.
    std::map<BusId, ConnectedBus> connected{};
};

} // namespace codewheel
