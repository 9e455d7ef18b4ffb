// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProcess>
#include <QRandomGenerator>
#include <QThread>

#include <gtest/gtest.h>

namespace codewheel::test {

// A program that records until it is killed (recording_child.cpp).
class RecordingProcess
{
public:
    explicit RecordingProcess(const QStringList &arguments)
    {
        m_child.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        m_child.start(QStringLiteral(RECORDING_CHILD), arguments);
        EXPECT_TRUE(m_child.waitForStarted(generous));
    }
    // Until it has promised so often.
    void waitFor(int lines)
    {
        for (int line = 0; line < lines; ++line) {
            while (!m_child.canReadLine())
                if (!m_child.waitForReadyRead(generous)) {
                    ADD_FAILURE() << "the child says nothing";
                    return;
                }
            m_promised = m_child.readLine().trimmed().toLongLong();
        }
    }
    // In the middle of it; returns what it last promised.
    std::int64_t kill()
    {
        QThread::usleep(static_cast<unsigned long>(QRandomGenerator::global()->bounded(20'000)));
        m_child.kill(); // SIGKILL
        EXPECT_TRUE(m_child.waitForFinished(generous));
        while (m_child.canReadLine()) // said before it was killed
            m_promised = m_child.readLine().trimmed().toLongLong();
        return m_promised;
    }

private:
    static constexpr int generous = 120'000; // ms

    QProcess m_child;
    std::int64_t m_promised = 0;
};

} // namespace codewheel::test
