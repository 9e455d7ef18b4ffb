// SPDX-License-Identifier: GPL-3.0-or-later
// Who is behind a serial CAN adapter. Adapters are those of tests/can/slcan_peer.py and of serve canopen, at
// ports that are called like those of USB devices.
#include "tests/cli/cli_run.h"
#include "tests/support/peer_process.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <csignal>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class AdapterAtPort
{
public:
    AdapterAtPort(const QString &program, const QStringList &arguments)
        : m_process(program, arguments)
    {
        EXPECT_TRUE(QFile::link(m_process.port(), port()));
    }
    ~AdapterAtPort()
    {
        QProcess &process = m_process.process();
        process.closeWriteChannel();
        ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
        EXPECT_TRUE(process.waitForFinished(patience));
        process.readAllStandardError(); // of a program that is ended
    }
    AdapterAtPort(const AdapterAtPort &) = delete;
    AdapterAtPort &operator=(const AdapterAtPort &) = delete;

    static std::unique_ptr<AdapterAtPort> peer(const QString &options)
    {
        return std::make_unique<AdapterAtPort>(QStringLiteral(CODEWHEEL_PYTHON),
                                               QStringList{QStringLiteral(CODEWHEEL_CANOPEN_PEER)} +
                                                   options.split(u' ', Qt::SkipEmptyParts));
    }
    static std::unique_ptr<AdapterAtPort> served(const QString &options)
    {
        return std::make_unique<AdapterAtPort>(QStringLiteral(CODEWHEEL_CLI),
                                               (QStringLiteral("serve canopen ") + options).split(u' '));
    }

    QString port() const { return m_folder.filePath(QStringLiteral("ttyACM0")); }
    QJsonArray found()
    {
        m_run = runLine(QStringLiteral("find --yes --json ") + port());
        return m_run.json()[u"found"].toArray();
    }
    const CliRun &run() const { return m_run; }
    std::vector<std::string> order(const QString &text) { return m_process.order(text); }

private:
    QTemporaryDir m_folder;
    test::PeerProcess m_process;
    CliRun m_run;
};

TEST(CliFindCan, FindsTheRateByListeningOnly)
{
    const auto adapter = AdapterAtPort::served(QStringLiteral("--rate 500000 --quirk autostart"));
    const QJsonArray found = adapter->found();
    ASSERT_EQ(found.size(), 1) << adapter->run().out;
    EXPECT_EQ(found[0][u"kind"].toString(), QStringLiteral("canopen"));
    EXPECT_EQ(found[0][u"link"].toString(), QStringLiteral("slcan:%1,rate=500000").arg(adapter->port()));
    EXPECT_THAT(found[0][u"text"].toString().toStdString(), HasSubstr("CANopen nodes are heard: 5, 6, 7."));
}

TEST(CliFindCan, SendsNothingOnTheBus)
{
    const auto adapter = AdapterAtPort::peer(QStringLiteral("--running --master"));
    const QJsonArray found = adapter->found();
    ASSERT_EQ(found.size(), 1) << adapter->run().out;
    EXPECT_TRUE(found[0][u"masterAtWork"].toBool());
    EXPECT_THAT(adapter->order(QStringLiteral("heard")), IsEmpty());
    EXPECT_THAT(adapter->order(QStringLiteral("state")), ElementsAre("closed S4")); // never open to send
}

TEST(CliFindCan, AnAdapterThatCannotListenOnlyIsToldAndNotOpened)
{
    const auto adapter = AdapterAtPort::peer(QStringLiteral("--no-listening"));
    const QJsonArray found = adapter->found();
    ASSERT_EQ(found.size(), 1) << adapter->run().out;
    EXPECT_THAT(found[0][u"text"].toString().toStdString(), HasSubstr("not known to be able to listen only"));
    EXPECT_THAT(adapter->order(QStringLiteral("state")), ElementsAre("closed S4"));
}

TEST(CliFindCan, OtherPortsAreNotAskedForAdapters)
{
    const CliRun run = runLine(QStringLiteral("find /dev/null"));
    EXPECT_THAT(run.out, Not(HasSubstr("SLCAN")));
}

// What is no adapter is asked for other protocols as ever.
TEST(CliFindCan, AnEncoderOnALineAtSuchAPortIsFoundAllTheSame)
{
    AdapterAtPort line(
        QStringLiteral(CODEWHEEL_PYTHON),
        {QStringLiteral(CODEWHEEL_ESC_PEER), QStringLiteral("--addresses"), QStringLiteral("12")});
    const QJsonArray found = line.found();
    ASSERT_EQ(found.size(), 1) << line.run().out;
    EXPECT_EQ(found[0][u"kind"].toString(), QStringLiteral("esc"));
}

} // namespace
} // namespace codewheel
