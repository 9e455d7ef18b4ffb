// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProcess>

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace codewheel::test {

// A program that serves a port: it prints the path of it as its first line, and ends with its standard input.
// Each line that comes there is an order, which it answers with lines that end with "ok".
class PeerProcess
{
public:
    PeerProcess(const QString &program, const QStringList &arguments)
    {
        m_process.start(program, arguments);
        m_port = readLine();
    }
    ~PeerProcess() { unplug(); }
    PeerProcess(const PeerProcess &) = delete;
    PeerProcess &operator=(const PeerProcess &) = delete;

    const QString &port() const { return m_port; }
    QProcess &process() { return m_process; }
    // What it says to this.
    std::vector<std::string> order(const QString &text)
    {
        m_process.write(text.toLatin1() + '\n');
        std::vector<std::string> lines;
        for (QString line = readLine(); line != QStringLiteral("ok") && !line.isNull(); line = readLine())
            lines.push_back(line.toStdString());
        return lines;
    }
    // The port is gone.
    void unplug()
    {
        m_process.closeWriteChannel();
        EXPECT_TRUE(m_process.state() == QProcess::NotRunning || m_process.waitForFinished(longestWait));
        EXPECT_EQ(m_process.readAllStandardError(), "");
    }

private:
    static constexpr int longestWait = 60'000; // ms

    QString readLine()
    {
        while (!m_process.canReadLine())
            if (!m_process.waitForReadyRead(longestWait)) {
                ADD_FAILURE() << m_process.readAllStandardError().toStdString();
                return {};
            }
        return QString::fromLocal8Bit(m_process.readLine()).trimmed();
    }

    QProcess m_process;
    QString m_port;
};

} // namespace codewheel::test
