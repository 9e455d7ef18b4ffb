// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProcess>

#include <gtest/gtest.h>

namespace codewheel {

// Another program that has a port open, without a lock and not for itself alone, as many a terminal program
// does. It gives it back when it ends.
class PortHolder
{
public:
    PortHolder(const QString &python, const QString &port)
    {
        m_process.start(python, {QStringLiteral("-c"),
                                 QStringLiteral("import os, sys\n"
                                                "os.open(sys.argv[1], os.O_RDWR | os.O_NOCTTY)\n"
                                                "print('open', flush=True)\n"
                                                "input()\n"),
                                 port});
        EXPECT_TRUE(m_process.waitForReadyRead(20'000)) << m_process.readAllStandardError().toStdString();
    }
    ~PortHolder() { end(); }
    PortHolder(const PortHolder &) = delete;
    PortHolder &operator=(const PortHolder &) = delete;

    qint64 id() const { return m_process.processId(); }
    void end()
    {
        m_process.closeWriteChannel();
        m_process.waitForFinished(20'000);
    }

private:
    QProcess m_process;
};

} // namespace codewheel
