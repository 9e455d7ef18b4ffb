// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"
#include "vocabulary/find_by.h"

#include <QStringList>

#include <span>

namespace codewheel {

// All device descriptions the program knows, read once at start.
class Catalog
{
public:
    // What is wrong with a description file: file, line (from 1), key and reason in the user's language.
    struct Fault
    {
        QString file;
        int line = 0; // 0: the file as a whole
        QString key;
        QString reason;

        QString place() const; // "my.json, line 7, parameters[0].minimum"
    };

    // Files in the order in which they are to be added: by name without ".json", so that fraba-ocd-ib comes
    // before fraba-ocd-ib-k1, which may share its tables.
    static QStringList inReadingOrder(QStringList files);

    // The descriptions that come with the program. A broken one is a defect of the program.
    static Catalog builtIn();

    // Adds the description in `json`, or returns what is wrong with it and adds nothing.
    tl::expected<void, Fault> add(const QByteArray &json, const QString &file);

    std::span<const DeviceDescription> devices() const { return m_devices; }
    const DeviceDescription *find(QStringView key) const
    {
        return findBy(m_devices, key, &DeviceDescription::key);
    }
    // For a participant of unknown make: the generic description for its ID code and width, if there is one.
    const DeviceDescription *generic(unsigned deviceCode) const;
    // By its name; without one, or with one that no description has, the make is unknown.
    const DeviceDescription *find(QStringView key, unsigned deviceCode) const;
    // Likewise if the name belongs to a device with another code.
    const DeviceDescription *findFitting(QStringView key, unsigned deviceCode) const;

private:
    static Catalog readBuiltIn();

    std::vector<DeviceDescription> m_devices;
};

} // namespace codewheel
