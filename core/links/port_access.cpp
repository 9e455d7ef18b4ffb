// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/port_access.h"

#include "vocabulary/shell_command.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <grp.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

namespace codewheel {
namespace {

// Nothing with a line behind it: a file, a folder, a disk, or a device of another kind such as /dev/null.
bool isNoPort(const QString &path)
{
    struct stat status = {};
    if (::stat(QFile::encodeName(path).constData(), &status) != 0)
        return false;
    if (!S_ISCHR(status.st_mode))
        return true;
    const QString kind = QFileInfo(QStringLiteral("/sys/dev/char/%1:%2/subsystem")
                                       .arg(major(status.st_rdev))
                                       .arg(minor(status.st_rdev)))
                             .canonicalFilePath(); // empty: the system names none, as for a pseudo terminal
    return !kind.isEmpty() && QFileInfo(kind).fileName() != QStringLiteral("tty");
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

bool mayGroupUse(const QString &path)
{
    constexpr mode_t readAndWrite = S_IRGRP | S_IWGRP;
    struct stat status = {};
    return ::stat(QFile::encodeName(path).constData(), &status) == 0 &&
           (status.st_mode & readAndWrite) == readAndWrite;
}

bool isForGroup(const QString &path)
{
    static const QStringList groupsOfPorts{QStringLiteral("dialout"), QStringLiteral("uucp"),
                                           QStringLiteral("plugdev")};
    return mayGroupUse(path) && groupsOfPorts.contains(groupOf(path));
}

QString rightsCommand(const QString &path)
{
    return isForGroup(path) ? shellCommand(QStringLiteral("sudo usermod -aG %1 $USER"), {groupOf(path)})
                            : shellCommand(QStringLiteral("sudo setfacl -m u:$USER:rw %1"), {path});
}

bool isSamePort(const QString &one, const QString &other)
{
    if (one.isEmpty() || other.isEmpty())
        return false;
    const QString path = QFileInfo(portPath(one)).canonicalFilePath();
    return portPath(one) == portPath(other) ||
           (!path.isEmpty() && path == QFileInfo(portPath(other)).canonicalFilePath());
}

RefusalCode portRefusalOf(int errorNumber)
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

Refusal portRefusal(RefusalCode id, const QString &path, const QString &errorText)
{
    if ((id == RefusalId::linkFailed || id == RefusalId::portNoRights) && isNoPort(path))
        return {RefusalKind::link,
                RefusalId::linkFailed,
                {QCoreApplication::translate("codewheel::PortAccess", "%1 is not a serial port.").arg(path)}};
    if (id == RefusalId::portNoRights)
        return {RefusalKind::link, id, {path, groupOf(path), rightsCommand(path)}};
    if (id == RefusalId::linkFailed)
        return {RefusalKind::link, id, {QStringLiteral("%1: %2").arg(path, errorText)}};
    return {RefusalKind::link, id, {path}};
}

std::optional<Refusal> portHindrance(const QString &path)
{
    if (isNoPort(path))
        return portRefusal(RefusalId::linkFailed, path, {});
    if (::access(QFile::encodeName(path).constData(), R_OK | W_OK) == 0)
        return std::nullopt;
    const int reason = errno;
    return portRefusal(portRefusalOf(reason), path, QString::fromLocal8Bit(std::strerror(reason)));
}

std::optional<Refusal> openingHindrance(const QString &path, const Computer &computer)
{
    if (auto hindrance = portHindrance(path))
        return hindrance;
    const auto holders = computer.holdersOf(path);
    const bool isHeld = !std::ranges::all_of(holders, &Process::isOurs); // locks keep us from ourselves
    return isHeld ? std::optional(portRefusal(RefusalId::portInUse, path, {})) : std::nullopt;
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
