// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"

#include "catalog/description_reader.h"
#include "catalog/strict_json.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>

namespace codewheel {

QString Catalog::Fault::place() const
{
    QString place = file;
    if (line > 0)
        place = QCoreApplication::translate("codewheel::Catalog", "%1, line %2").arg(file).arg(line);
    return key.isEmpty() ? place : place + QStringLiteral(", ") + key;
}

QStringList Catalog::inReadingOrder(QStringList files)
{
    std::ranges::sort(files, {}, [](const QString &file) { return QFileInfo(file).completeBaseName(); });
    return files;
}

// The files are part of the program, so they are read only once.
Catalog Catalog::builtIn()
{
    static const Catalog catalog = readBuiltIn();
    return catalog;
}

Catalog Catalog::readBuiltIn()
{
    Catalog catalog;
    const QDir folder(QStringLiteral(":/devices"));
    for (const QString &name : inReadingOrder(folder.entryList({QStringLiteral("*.json")}))) {
        QFile file(folder.filePath(name));
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

    DeviceDescription device = readDescription(root, *this, faults);
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

const DeviceDescription *Catalog::find(QStringView key, unsigned deviceCode) const
{
    const DeviceDescription *named = find(key);
    return named != nullptr ? named : generic(deviceCode);
}

const DeviceDescription *Catalog::findFitting(QStringView key, unsigned deviceCode) const
{
    const DeviceDescription *named = find(key);
    return named != nullptr && named->deviceCode == deviceCode ? named : generic(deviceCode);
}

const DeviceDescription *Catalog::generic(unsigned deviceCode) const
{
    const auto found = std::ranges::find_if(m_devices, [deviceCode](const DeviceDescription &device) {
        return device.isGeneric() && device.hasWords() && device.deviceCode == deviceCode;
    });
    return found == m_devices.end() ? nullptr : &*found;
}

} // namespace codewheel
