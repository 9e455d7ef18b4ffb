// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/buses/dropped_device.h"

#include "app/user_devices.h"
#include "project/file_access.h"
#include "widgets/look/inline_message.h"

#include <QDir>
#include <QFileInfo>

namespace codewheel {
namespace {

constexpr qint64 largestDescription = 1 << 20; // bytes

} // namespace

DroppedDevice::DroppedDevice(InlineMessage &notice, QString folder, QObject *parent)
    : QObject(parent)
    , m_notice(notice)
    , m_folder(std::move(folder))
{
    connect(&notice, &InlineMessage::actionTriggered, this, &DroppedDevice::keep);
}

// Only files with this suffix are read.
QString DroppedDevice::keptAs(const QString &path) const
{
    return QDir(m_folder).filePath(QFileInfo(path).completeBaseName() + QStringLiteral(".json"));
}

// A new version replaces the one that is kept, which is therefore ignored.
void DroppedDevice::offer(const QString &path)
{
    const QFileInfo file(path);
    const QString kept = keptAs(path);
    Catalog catalog = Catalog::builtIn();
    (void)addUserDevices(catalog, m_folder, kept);
    if (const auto added = addDeviceFile(catalog, path); !added) {
        m_notice.showMessage(Role::attention,
                             tr("%1 is not a device description that can be used. %2: %3")
                                 .arg(file.fileName(), added.error().place(), added.error().reason));
        return;
    }
    m_path = path;
    m_notice.showMessage(
        Role::attention,
        QFileInfo::exists(kept)
            ? tr("%1 is a device description. Replace yours of the same name with it?").arg(file.fileName())
            : tr("%1 is a device description. Keep it with your own?").arg(file.fileName()),
        tr("&Keep it"));
}

void DroppedDevice::keep()
{
    const QString kept = keptAs(m_path);
    const auto text = readWholeFile(m_path, largestDescription);
    if (!text || !QDir().mkpath(m_folder)) {
        m_notice.showMessage(
            Role::fault, tr("%1 could not be kept: %2")
                             .arg(QFileInfo(m_path).fileName(),
                                  !text ? tr("it cannot be read") : tr("%1 cannot be made").arg(m_folder)));
        return;
    }
    if (const auto saved = replaceFile(kept, *text, OldFile::isKeptAsBackup); !saved) {
        m_notice.showMessage(
            Role::fault,
            tr("%1 could not be kept: %2").arg(QFileInfo(m_path).fileName(), whyNotWritten(saved.error())));
        return;
    }
    m_notice.showMessage(Role::running,
                         tr("%1 is kept. Its device is in the catalog from the next start on.").arg(kept));
}

} // namespace codewheel
