// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"

#include "catalog/description_reader.h"
#include "catalog/strict_json.h"

#include <QDirIterator>
#include <QFile>

#include <algorithm>

namespace codewheel {
Catalog Catalog::builtIn()
{
    Catalog catalog;
    QDirIterator files(QStringLiteral(":/devices"), {QStringLiteral("*.json")});
    while (files.hasNext()) {
        QFile file(files.next());
        if (!file.open(QIODevice::ReadOnly))
            qFatal("%s cannot be read", qPrintable(file.fileName()));
        if (const auto added = catalog.add(file.readAll(), file.fileName()); !added)
            qFatal("%s:%d: %s: %s", qPrintable(added.error().file), added.error().line,
                   qPrintable(added.error().key), qPrintable(added.error().reason));
    }
    std::ranges::sort(catalog.m_devices, {}, &DeviceDescription::key);
    return catalog;
}

tl::expected<void, Catalog::Fault> Catalog::add(const QByteArray &json, const QString &file)
{
    FaultKeeper faults(json, file);
    const Json::Value root = parseStrictly(json, faults);
    if (faults.first())
        return tl::unexpected(*faults.first());

    DeviceDescription device = readDescription(root, faults);
    if (find(device.key))
        faults.report(root["key"], QStringLiteral("key"),
                      QCoreApplication::translate("codewheel::Catalog",
                                                  "A device with the key \"%1\" is in the catalog already.")
                          .arg(device.key));
    if (faults.first())
        return tl::unexpected(*faults.first());
    m_devices.push_back(std::move(device));
    return {};
}

const DeviceDescription *Catalog::find(QStringView key) const
{
    const auto found = std::ranges::find(m_devices, key, &DeviceDescription::key);
    return found == m_devices.end() ? nullptr : &*found;
}

const DeviceDescription *Catalog::generic(unsigned deviceCode) const
{
    const auto found = std::ranges::find_if(m_devices, [deviceCode](const DeviceDescription &device) {
        return device.isGeneric() && device.deviceCode == deviceCode;
    });
    return found == m_devices.end() ? nullptr : &*found;
}

} // namespace codewheel
