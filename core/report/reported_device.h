// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "report/report_input.h"

namespace codewheel {

// One device of the project with what is known of it: from the connected encoder, otherwise as stored in the
// project. Points into input and catalog.
struct ReportedDevice
{
    const ProjectDevice *planned = nullptr;
    QString shownPlace{}; // with the name of its bus, if several buses of the project have such places
    const DeviceDescription *description = nullptr; // null: no encoder, or not known to this program
    bool isConnected = false;
    bool isSimulated = false;
    std::optional<NotLive> notLive{}; // of a connected one: what is known of it is of before
    std::vector<StoredValue> values;
    std::vector<StoredCams> cams;
    std::map<Parameter, Kept> kept{}; // as far as somebody knows

    Place place() const { return planned->place(); }
    const StoredValue *known(Parameter parameter) const;
    // How it is known, and how it is kept: "read, stored"; empty: it is not known.
    QString evidence(Parameter parameter) const;
    const StoredCams *knownCams(unsigned program) const;
    const CamProgram *wantedCams(unsigned program) const;
    ParameterValues knownValues() const;
    // Its settings, and whatever else is wanted or known; without the serial number.
    std::vector<Parameter> parameters() const;
    std::vector<unsigned> camPrograms() const; // wanted or known, 1..8
};

// In ring order.
std::vector<ReportedDevice> reportedDevices(const ReportInput &input, const Catalog &catalog);

} // namespace codewheel
