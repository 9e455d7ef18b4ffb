// SPDX-License-Identifier: GPL-3.0-or-later
#include "user_devices.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QStandardPaths>

namespace codewheel {
namespace {

constexpr qint64 largestFile = 1 << 20; // far larger than any description

} // namespace

QString userDeviceFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           QStringLiteral("/codewheel/devices");
}

tl::expected<void, Catalog::Fault> addDeviceFile(Catalog &catalog, const QString &path)
{
    const auto translated = [](const char *text) {
        return QCoreApplication::translate("codewheel::UserDevices", text);
    };
    QFile file(path);
    if (!QFileInfo(path).isFile())
        return tl::unexpected(Catalog::Fault{
            path, 0, {}, translated(QT_TRANSLATE_NOOP("codewheel::UserDevices", "There is no such file."))});
    if (!file.open(QIODevice::ReadOnly))
        return tl::unexpected(Catalog::Fault{
            path,
            0,
            {},
            translated(QT_TRANSLATE_NOOP("codewheel::UserDevices", "The file cannot be read: %1."))
                .arg(file.errorString())});
    const QByteArray json = file.read(largestFile + 1);
    if (json.size() > largestFile)
        return tl::unexpected(Catalog::Fault{
            path,
            0,
            {},
            translated(QT_TRANSLATE_NOOP("codewheel::UserDevices",
                                         "The file is larger than 1 MiB: it is not a device description."))});
    return catalog.add(json, path);
}

std::vector<Catalog::Fault> addUserDevices(Catalog &catalog, const QString &folder, const QString &except)
{
    std::vector<Catalog::Fault> faults;
    const QString left = QFileInfo(except).canonicalFilePath();
    const QDir files(folder);
    for (const QString &name :
         Catalog::inReadingOrder(files.entryList({QStringLiteral("*.json")}, QDir::Files))) {
        const QString path = files.filePath(name);
        if (!left.isEmpty() && QFileInfo(path).canonicalFilePath() == left)
            continue;
        if (auto added = addDeviceFile(catalog, path); !added)
            faults.push_back(added.error());
    }
    return faults;
}

} // namespace codewheel
