// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/kept_counts.h"

#include "catalog/catalog.h"
#include "journal/ledger.h"

#include <algorithm>

namespace codewheel {
namespace {

// All identities the project knows for the encoder, best first (docs/journal.md).
std::vector<EncoderIdentity> identitiesOf(const ProjectDevice &device, const Catalog &catalog,
                                          const QString &projectFile)
{
    std::vector<EncoderIdentity> identities;
    const DeviceDescription *description = catalog.find(device.participant.deviceKey);
    const QString vendor = description ? description->vendor : QString();
    const Place place = device.place();
    const auto serial = std::ranges::find(device.stored, Parameter::serialNumber, &StoredValue::parameter);
    if (serial != device.stored.end() && serial->evidence == Evidence::read)
        identities.push_back({CountedBy::serialNumber, vendor, serial->value.toString(), projectFile, place});
    if (!device.label.serialNumber.isEmpty())
        identities.push_back(
            {CountedBy::labelSerialNumber, vendor, device.label.serialNumber, projectFile, place});
    identities.push_back({CountedBy::place, vendor, {}, projectFile, place});
    return identities;
}

} // namespace

void addKept(ReportInput &input, const Ledger &ledger, const Catalog &catalog, const QString &projectFile)
{
    for (const ProjectDevice &device : input.project.devices) {
        if (input.writes.contains(device.place()))
            continue;
        for (const EncoderIdentity &identity : identitiesOf(device, catalog, projectFile))
            if (const EepromCount count = ledger.writes(identity); count.since.isValid()) {
                input.writes[device.place()] = count;
                break;
            }
    }
}

} // namespace codewheel
