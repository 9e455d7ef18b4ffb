// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QJsonArray>
#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>

#include <vector>

namespace codewheel::test {

// A session bus of its own, which the program takes for that of the desktop while this exists; on it, if
// wanted, tests/app/notification_service.py, which knows nothing of this program.
class DesktopBus
{
public:
    DesktopBus();
    ~DesktopBus();

    void serve(const QStringList &options); // of the service
    void click(uint notice);
    // What the service has been asked so far by this name, oldest first: the arguments.
    std::vector<QJsonArray> calls(const QString &name);
    bool waitForCalls(const QString &name, std::size_t count);

private:
    void takeLines();

    const QByteArray m_before; // address of the desktop's own bus
    QTemporaryDir m_folder;
    QProcess m_bus;
    QProcess m_service;
    QStringList m_lines; // of the service
};

} // namespace codewheel::test
