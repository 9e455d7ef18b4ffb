// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/port_access.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <array>
#include <cerrno>
#include <cstring>
#include <grp.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

namespace codewheel {
namespace {

// Nothing with a line behind it: a file, a folder, or one of the system's own devices such as /dev/null.
bool isNoPort(const QString &path)
{
    constexpr unsigned memoryDevices = 1; // their major number on Linux
    struct stat status = {};
    return ::stat(QFile::encodeName(path).constData(), &status) == 0 &&
           (!S_ISCHR(status.st_mode) || major(status.st_rdev) == memoryDevices);
}

} // namespace

QString portPath(const QString &port)
{
    return port.contains(u'/') ? port : QStringLiteral("/dev/") + port;
}

QString groupOf(const QString &path)
{
    struct stat status = {};
    if (::stat(QFile::encodeName(path).constData(), &status) != 0)
        return {};
    group entry = {};
    group *found = nullptr;
    std::array<char, 4096> names{};
    ::getgrgid_r(status.st_gid, &entry, names.data(), names.size(), &found);
    return found ? QString::fromLocal8Bit(found->gr_name) : QString::number(status.st_gid);
}

bool isSamePort(const QString &one, const QString &other)
{
    if (one.isEmpty() || other.isEmpty())
        return false;
    const QString path = QFileInfo(portPath(one)).canonicalFilePath();
    return portPath(one) == portPath(other) ||
           (!path.isEmpty() && path == QFileInfo(portPath(other)).canonicalFilePath());
}

RefusalId portRefusalOf(int errorNumber)
{
    switch (errorNumber) {
    case ENOENT:
    case ENODEV:
    case ENXIO:
    case ENOTDIR:
        return RefusalId::portNotFound;
    case EACCES:
    case EPERM:
        return RefusalId::portNoRights;
    case EBUSY:
    case EWOULDBLOCK:
        return RefusalId::portInUse;
    default:
        return RefusalId::linkFailed;
    }
}

Refusal portRefusal(RefusalId id, const QString &path, const QString &errorText)
{
    if (id == RefusalId::portNoRights) {
        const QString group = groupOf(path);
        return {RefusalKind::link, id, {path, group, QStringLiteral("sudo usermod -aG %1 $USER").arg(group)}};
    }
    if (id == RefusalId::linkFailed && isNoPort(path))
        return {RefusalKind::link,
                id,
                {QCoreApplication::translate("codewheel::PortAccess", "%1 is not a serial port.").arg(path)}};
    if (id == RefusalId::linkFailed)
        return {RefusalKind::link, id, {QStringLiteral("%1: %2").arg(path, errorText)}};
    return {RefusalKind::link, id, {path}};
}

std::optional<Refusal> portHindrance(const QString &path)
{
    if (::access(QFile::encodeName(path).constData(), R_OK | W_OK) == 0)
        return std::nullopt;
    const int reason = errno;
    return portRefusal(portRefusalOf(reason), path, QString::fromLocal8Bit(std::strerror(reason)));
}

Refusal lineSettingRefusal(const QString &setting)
{
    return {RefusalKind::badInput,
            RefusalId::lineSettingWrong,
            {setting, QCoreApplication::translate("SerialPortLink",
                                                  "baud rates that the adapter has, 7 or 8 data bits, parity "
                                                  "none, even or odd, 1 or 2 stop bits")}};
}

} // namespace codewheel
