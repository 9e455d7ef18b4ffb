// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "links/serial_port_link.h"
#include "links/slcan_link.h"

#include <QProcess>

#include <gtest/gtest.h>

namespace codewheel::test {

// tests/can/slcan_peer.py, an adapter that knows nothing of this program, and the link to it.
class SlcanPeer
{
public:
    explicit SlcanPeer(const QString &options = {}, int rate = 250'000)
    {
        m_process.start(QStringLiteral(CODEWHEEL_PYTHON), QStringList{QStringLiteral(CODEWHEEL_SLCAN_PEER)} +
                                                              options.split(u' ', Qt::SkipEmptyParts));
        m_link = std::make_unique<SlcanLink>(std::make_unique<SerialPortLink>(readLine()), rate, 115'200);
    }
    ~SlcanPeer()
    {
        m_link.reset();
        unplug();
    }

    SlcanLink &link() { return *m_link; }
    // What it says to an order.
    QStringList order(const QString &text)
    {
        m_process.write(text.toLatin1() + '\n');
        QStringList lines;
        for (QString line = readLine(); line != QStringLiteral("ok") && !line.isNull(); line = readLine())
            lines << line;
        return lines;
    }
    std::string state() { return order(QStringLiteral("state")).value(0).trimmed().toStdString(); }
    void unplug()
    {
        if (m_process.state() == QProcess::NotRunning)
            return;
        m_process.closeWriteChannel();
        EXPECT_TRUE(m_process.waitForFinished(20'000));
        EXPECT_EQ(m_process.readAllStandardError(), "");
    }

private:
    QString readLine()
    {
        while (!m_process.canReadLine())
            if (!m_process.waitForReadyRead(60'000)) {
                ADD_FAILURE() << m_process.readAllStandardError().toStdString();
                return {};
            }
        return QString::fromLatin1(m_process.readLine()).trimmed();
    }

    QProcess m_process;
    std::unique_ptr<SlcanLink> m_link;
};

} // namespace codewheel::test
