// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cams/cam_fields.h"
#include "report/reported_device.h"

namespace codewheel {

// Where an encoder is known to have something other than what is wanted.
struct ValueDeviation
{
    Parameter parameter = Parameter::steps;
    Value wanted = 0;
    StoredValue known;
};
struct CamDeviation
{
    unsigned program = 1;
    CamField field;
    std::int64_t wanted = 0;
    std::int64_t known = 0;
    Evidence evidence = Evidence::read;
};

struct Deviations
{
    std::vector<ValueDeviation> values;
    std::vector<CamDeviation> cams;
    int notKnown = 0; // wanted values and cam programs that could not be compared

    std::size_t count() const { return values.size() + cams.size(); }
};

Deviations deviationsOf(const ReportedDevice &device);

// Of a whole project.
struct DeviationCounts
{
    int deviations = 0;
    int notKnown = 0;
};
DeviationCounts countDeviations(const std::vector<ReportedDevice> &devices);

// How the connected buses differ from the configured ones.
struct BusComparisons
{
    std::vector<std::pair<QString, QStringList>> lines; // for each one compared: its name, and in words
    QStringList notCompared;                            // names of others that have devices
    QStringList old;                                    // what was compared as it was before, and why

    std::int64_t differences() const;
};
BusComparisons busComparisons(const ReportInput &input, const Catalog &catalog);

} // namespace codewheel
