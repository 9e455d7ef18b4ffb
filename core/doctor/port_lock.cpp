// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/port_lock.h"

namespace codewheel {
namespace {

// "/run/lock/LCK..ttyUSB0"
QString lockFile(QString path)
{
    const QString devices = QStringLiteral("/dev/");
    if (path.startsWith(devices))
        path.remove(0, devices.size());
    return QStringLiteral("/run/lock/LCK..") + path.replace(u'/', u'_');
}

// "      4711 minicom root"; 0: it does not say.
int writerOf(const QString &file, const Computer &computer)
{
    return computer.contents(file).simplified().split(' ').value(0).toInt();
}

} // namespace

std::optional<Process> lockerOf(const QString &path, const Computer &computer)
{
    const auto writer = computer.process(writerOf(lockFile(computer.canonical(path)), computer));
    return writer && writer->isOfOther ? writer : std::nullopt;
}

QString staleLock(const QString &path, const Computer &computer)
{
    const QString file = lockFile(path);
    const int writer = writerOf(file, computer);
    return writer > 0 && !computer.exists(writer) && !computer.mayRemove(file) ? file : QString();
}

} // namespace codewheel
