// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/device_description.h"

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
        int line = 0;
        QString key;
        QString reason;
    };

    // The descriptions that come with the program. A broken one is a defect of the program.
    static Catalog builtIn();

    // Adds the description in `json`, or says what is wrong with it and adds nothing.
    tl::expected<void, Fault> add(const QByteArray &json, const QString &file);

    std::span<const DeviceDescription> devices() const { return m_devices; }
    const DeviceDescription *find(QStringView key) const;
    // For a participant whose make is not known: the generic description of its ID code and width, if there
    // is one.
    const DeviceDescription *generic(unsigned deviceCode) const;

private:
    std::vector<DeviceDescription> m_devices;
};

} // namespace codewheel
