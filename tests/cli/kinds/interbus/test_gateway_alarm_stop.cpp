// SPDX-License-Identifier: GPL-3.0-or-later
// What `master alarm-stop` says of its zeros, on gateways with one fault each.
#include "tests/cli/kinds/interbus/gateway_peer.h"
#include "tests/links/crooked_peer.h"

#include <QDateTime>
#include <QFile>
#include <QJsonArray>

#include <algorithm>
#include <atomic>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <thread>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Not;

constexpr char readHoldingFunction = 3;
constexpr char writeFunction = 16;
constexpr int writesUntilReadBack = 2; // before anything is asked, and once more

// A gateway with the OUT registers of three devices, which works but for its fault.
class StoppedGateway
{
public:
    struct Fault
    {
        std::chrono::milliseconds delay{}; // of each answer
        int writeException = 0;            // of each write
        int readException = 0;             // of each read
        int outEnd = 0;                    // from this register on writes are refused; 0: none
        int silentWrites = 0;              // so many are carried out, and the connection ends
        bool isDeafAfterwards = false;     // to everything
        int foreignOut = 0;                // of 1.0, whatever is written
        bool showsZerosOnce = false;       // and then that again
    };

    explicit StoppedGateway(Fault fault)
        : m_fault(fault)
        , m_peer([this](const SeenRequest &request) { return react(request); })
    {}

    CliRun alarmStop(const char *options) const
    {
        return RingProject().run(QStringLiteral("master alarm-stop ") + QString::fromLatin1(options),
                                 QStringLiteral("modbus-tcp:127.0.0.1:%1").arg(m_peer.port()));
    }
    QDateTime firstWriteAt() const { return m_firstWriteAt; }

private:
    Reaction react(const SeenRequest &request)
    {
        const bool isWrite = request.message[0] == writeFunction;
        if (isWrite && !m_firstWriteAt.isValid())
            m_firstWriteAt = QDateTime::currentDateTime();
        m_writes += isWrite ? 1 : 0;
        if (m_isDeaf)
            return {};
        if (isWrite && m_fault.silentWrites-- > 0) {
            m_isDeaf = m_fault.isDeafAfterwards;
            return {.bytes = {}, .hangsUp = true};
        }
        std::this_thread::sleep_for(m_fault.delay);
        return {CrookedPeer::tcpFrame(request.transaction, request.unit, answerTo(request.message))};
    }

    int writeException(const QByteArray &message) const
    {
        constexpr int noSuchRegister = 2;
        const int end = static_cast<uchar>(message[2]) + static_cast<uchar>(message[4]); // few registers
        return m_fault.outEnd != 0 && end > m_fault.outEnd ? noSuchRegister : m_fault.writeException;
    }

    QByteArray answerTo(const QByteArray &message)
    {
        const int exception = message[0] == writeFunction ? writeException(message) : m_fault.readException;
        if (exception != 0)
            return QByteArray(1, static_cast<char>(message[0] | 0x80)) + static_cast<char>(exception);
        if (message[0] != readHoldingFunction)
            return rightAnswer(message);
        QByteArray zeros = rightAnswer(message);
        std::fill(zeros.begin() + 2, zeros.end(), '\0');
        const bool showsZeros = m_fault.showsZerosOnce && m_writes == writesUntilReadBack;
        if (!showsZeros)
            zeros[5] = static_cast<char>(m_fault.foreignOut);
        m_fault.showsZerosOnce = m_fault.showsZerosOnce && !showsZeros;
        return zeros;
    }

    Fault m_fault;
    bool m_isDeaf = false;
    int m_writes = 0;
    QDateTime m_firstWriteAt;
    CrookedPeer m_peer; // last: its thread uses the rest
};

int countIn(const std::string &text, const char *what)
{
    return static_cast<int>(QString::fromStdString(text).count(QString::fromLatin1(what)));
}

QJsonObject zerosOf(const CliRun &run)
{
    return run.json()[u"zeros"].toObject();
}

TEST(CliAlarmStop, WhatWasAcknowledgedInTimeIsNotSaidToBeMissing)
{
    const CliRun run = StoppedGateway({.delay = 300ms}).alarmStop("--patience 8");
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.err, Not(HasSubstr("have not arrived")));
    EXPECT_EQ(countIn(run.err, "are acknowledged, but not read back yet"), 1) << run.err;
    EXPECT_THAT(run.out, HasSubstr("were read back as 00000000"));
    EXPECT_THAT(run.out, Not(HasSubstr("have not arrived")));
}

TEST(CliAlarmStop, TheTimeOfTheZerosIsWhenTheyLeft)
{
    const StoppedGateway gateway({.delay = 200ms});
    const CliRun run = gateway.alarmStop("--patience 8 --json");
    const auto sent = zerosOf(run)[u"sent"].toObject();
    const auto time = QDateTime::fromString(sent[u"time"].toString(), Qt::ISODateWithMs);
    EXPECT_LT(std::abs(time.msecsTo(gateway.firstWriteAt())), 150) << run.out;
    EXPECT_EQ(run.json()[u"messages"].toArray().first()[u"milliseconds"], sent[u"milliseconds"]);
    EXPECT_GE(zerosOf(run)[u"acknowledged"][u"milliseconds"].toInt(), sent[u"milliseconds"].toInt() + 200);
}

TEST(CliAlarmStop, TheJsonSaysWhereTheZerosAre)
{
    const CliRun run = StoppedGateway({}).alarmStop("--json");
    EXPECT_EQ(run.exit, 0) << run.err;
    const QJsonObject zeros = zerosOf(run);
    EXPECT_EQ(zeros[u"state"].toString(), QStringLiteral("readBack"));
    for (const char *moment : {"sent", "acknowledged", "readBack"})
        EXPECT_TRUE(zeros[QLatin1String(moment)].isObject()) << moment;
    const QJsonArray registers = zeros[u"registers"].toArray();
    ASSERT_EQ(registers.size(), 3);
    EXPECT_EQ(registers[1].toObject(), (QJsonObject{{QStringLiteral("place"), QStringLiteral("2.0")},
                                                    {QStringLiteral("first"), 2},
                                                    {QStringLiteral("count"), 2},
                                                    {QStringLiteral("out"), QStringLiteral("00000000")},
                                                    {QStringLiteral("refused"), false}}));
}

// Its OUT area ends behind 1.0.
TEST(CliAlarmStop, SaysWhichDevicesHaveRefusedTheirZeros)
{
    const CliRun run = StoppedGateway({.outEnd = 2}).alarmStop("--patience 2");
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("acknowledged, but refused for 2.0, 3.0"));
    EXPECT_THAT(run.err, HasSubstr("have not arrived within 2 s."));
    EXPECT_THAT(run.err, Not(HasSubstr("not known")));
    const CliRun json = StoppedGateway({.outEnd = 2}).alarmStop("--patience 1 --json");
    EXPECT_EQ(zerosOf(json)[u"state"].toString(), QStringLiteral("refused"));
    EXPECT_FALSE(zerosOf(json)[u"registers"][0][u"refused"].toBool());
    EXPECT_TRUE(zerosOf(json)[u"registers"][1][u"refused"].toBool());
}

// The gateway has got them, and nobody can know.
TEST(CliAlarmStop, ZerosWhoseAnswerWasLostAreNotSaidToBeMissing)
{
    StoppedGateway::Fault fault{.silentWrites = 1, .isDeafAfterwards = true};
    const CliRun run = StoppedGateway(fault).alarmStop("--patience 2 --json");
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(zerosOf(run)[u"state"].toString(), QStringLiteral("unanswered"));
    EXPECT_EQ(zerosOf(run)[u"acknowledged"], QJsonValue());
    EXPECT_THAT(run.err, Not(HasSubstr("have not arrived")));
    EXPECT_EQ(countIn(run.err, "sent, but are not acknowledged yet: it is not known"), 1) << run.err;
    EXPECT_EQ(countIn(run.err, "not acknowledged within 2 s: it is not known whether"), 1) << run.err;
}

TEST(CliAlarmStop, RefusedZerosHaveNotArrivedAndEachSentenceIsSaidOnce)
{
    for (const int exception : {2, 4}) {
        const CliRun run =
            StoppedGateway({.delay = 50ms, .writeException = exception}).alarmStop("--patience 3");
        EXPECT_EQ(run.exit, 1);
        EXPECT_EQ(countIn(run.err, "exception"), 1) << run.err;
        EXPECT_EQ(countIn(run.err, "have not arrived yet."), 1) << run.err;
        EXPECT_EQ(countIn(run.err, "have not arrived within 3 s."), 1) << run.err;
        EXPECT_THAT(run.err, Not(HasSubstr("not known")));
        EXPECT_THAT(run.out, HasSubstr("refused"));
        EXPECT_THAT(run.out, Not(HasSubstr("have not arrived"))) << "standard error says so";
        for (const char *ofWindow : {"Operate", "Watch", "The bus runs", "link is lost"})
            EXPECT_THAT(run.out + run.err, Not(HasSubstr(ofWindow)));
    }
    const CliRun tripped = StoppedGateway({.writeException = 4}).alarmStop("--patience 1");
    EXPECT_THAT(tripped.err, HasSubstr("codewheel-cli gateway --acknowledge-watchdog"));
}

TEST(CliAlarmStop, AcknowledgedZerosThatCannotBeLookedAtAreSaidToBeThat)
{
    const CliRun run = StoppedGateway({.readException = 2}).alarmStop("--patience 2 --json");
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "registersRefused");
    EXPECT_EQ(zerosOf(run)[u"state"].toString(), QStringLiteral("acknowledged"));
    EXPECT_THAT(run.err, HasSubstr("were acknowledged, but not read back within 2 s"));
    EXPECT_THAT(run.err, Not(HasSubstr("have not arrived")));
}

TEST(CliAlarmStop, WordsOfSomebodyElseAreSaidOnce)
{
    const CliRun run = StoppedGateway({.foreignOut = 7}).alarmStop("");
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(countIn(run.out + run.err, "was read back as something else: 1.0 00000007"), 1) << run.err;
    EXPECT_THAT(run.out, Not(HasSubstr("were read back as 00000000")));
    const CliRun json = StoppedGateway({.foreignOut = 7}).alarmStop("--json");
    EXPECT_EQ(zerosOf(json)[u"state"].toString(), QStringLiteral("overwritten"));
    EXPECT_EQ(zerosOf(json)[u"registers"][0][u"out"].toString(), QStringLiteral("00000007"));
}

TEST(CliAlarmStop, WhereNobodyIsNothingWasSent)
{
    const CliRun run = RingProject().run(QStringLiteral("master alarm-stop --patience 1 --json"),
                                         QStringLiteral("modbus-tcp:127.0.0.1:1"));
    EXPECT_EQ(zerosOf(run)[u"state"].toString(), QStringLiteral("notSent"));
    EXPECT_EQ(zerosOf(run)[u"sent"], QJsonValue());
    EXPECT_EQ(zerosOf(run)[u"registers"][0][u"out"], QJsonValue());
    EXPECT_EQ(countIn(run.err, "have not arrived yet."), 1) << run.err;
}

// The word that was in OUT before does not come back by itself.
TEST(CliAlarmStop, TheWordOfBeforeThatComesBackIsSomebodyElses)
{
    const StoppedGateway gateway({.foreignOut = 7, .showsZerosOnce = true});
    const CliRun run = gateway.alarmStop("");
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("was read back as something else: 1.0 00000007"));
    EXPECT_THAT(run.out, HasSubstr("then as something else"));
}

// The second ring gets its zeros while the first one, which answers nothing, is waited for.
TEST(CliAlarmStop, AMuteRingDoesNotKeepTheOthersWaiting)
{
    std::atomic<int> writesToOther = 0;
    std::atomic<int> writesBeforeItWasRead = -1;
    std::atomic<bool> wasWaited = false;
    std::atomic<bool> cameMeanwhile = false;
    const CrookedPeer mute([&](const SeenRequest &) {
        for (int i = 0; i < 500 && !wasWaited && writesToOther == 0; ++i)
            std::this_thread::sleep_for(10ms);
        if (!wasWaited.exchange(true))
            cameMeanwhile = writesToOther > 0;
        return Reaction{.bytes = {}, .hangsUp = true};
    });
    const CrookedPeer other([&](const SeenRequest &request) {
        int none = -1;
        if (request.message[0] == writeFunction)
            ++writesToOther;
        else
            writesBeforeItWasRead.compare_exchange_strong(none, writesToOther.load());
        return Reaction{
            CrookedPeer::tcpFrame(request.transaction, request.unit, rightAnswer(request.message))};
    });
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("two.codewheel")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    QByteArray buses;
    for (const int port : {mute.port(), other.port()})
        buses +=
            (buses.isEmpty() ? "" : ", ") +
            QByteArray(
                R"({"kind": "interbus", "number": %1, "name": "Ring %1", "link": {"kind": )"
                R"("modbus-tcp", "settings": {"host": "127.0.0.1", "port": "%2", "time-out": "10000"}}, )"
                R"("devices": )"
                R"([{"place": "1.0", "deviceCode": "0237h", "inWords": 2, "outWords": 2, )"
                R"("device": "fraba-ocd-ib"}]})")
                .replace("%1", buses.isEmpty() ? "1" : "2")
                .replace("%2", QByteArray::number(port));
    file.write(R"({"format": "codewheel-project", "version": 2, "buses": [)" + buses + "]}");
    file.close();
    const CliRun run =
        runLine(QStringLiteral("master alarm-stop --patience 2 --link project --project ") + file.fileName());
    EXPECT_EQ(run.exit, 1);
    EXPECT_TRUE(cameMeanwhile) << run.err;
    EXPECT_EQ(writesBeforeItWasRead, 1);
    EXPECT_THAT(run.err,
                HasSubstr("Ring 1: The zeros of the ALARM STOP were sent, but are not acknowledged"));
    EXPECT_THAT(run.err, HasSubstr("codewheel-cli: Ring 1: "));
}

} // namespace
} // namespace codewheel
