// SPDX-License-Identifier: GPL-3.0-or-later
// The commands on a ring behind a real Modbus server.
#include "journal/ledger.h"
#include "project/project_file.h"
#include "tests/cli/kinds/interbus/gateway_peer.h"
#include "tests/links/crooked_peer.h"

#include <QJsonArray>

#include <atomic>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::Not;

QString line(const char *text)
{
    return QString::fromLatin1(text);
}

TEST(CliGatewayRing, AMonitorShowsWordsAndFiguresAndWritesNothing)
{
    GatewayPeer peer;
    const CliRun run = RingProject().run(line("monitor 2.0 --for 1"), peer.link());
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("000007D0"));
    EXPECT_THAT(run.out, HasSubstr("Transactions: "));
    EXPECT_THAT(run.out, HasSubstr("Answer time: "));
    EXPECT_THAT(run.out, Not(HasSubstr("(0.0 a second)")));
    EXPECT_EQ(peer.writes(), 0);
}

TEST(CliGatewayRing, AMonitorOfOtherRegistersPointsToTheTestOfTheGateway)
{
    GatewayPeer peer;
    const CliRun run = RingProject(2).run(line("monitor 1.0 --for 1"), peer.link(line("in=1")));
    EXPECT_THAT(run.out, HasSubstr("Test the registers of the gateway with codewheel-cli gateway."));
    const CliRun right = RingProject(2).run(line("monitor 1.0 --for 1"), peer.link());
    EXPECT_THAT(right.out, Not(HasSubstr("codewheel-cli gateway")));
}

TEST(CliGatewayRing, FiguresAreForProgramsToo)
{
    GatewayPeer peer(line("--devices 1"));
    const auto figures = RingProject(1)
                             .run(line("monitor 1.0 --for 2 --json"), peer.link(line("status=0,interval=10")))
                             .json()[u"figures"]
                             .toObject();
    EXPECT_GT(figures[u"transactions"].toInt(), 10);
    EXPECT_GT(figures[u"exchanges"].toInt(), 5);
    EXPECT_GT(figures[u"exchangesPerSecond"].toDouble(), 1.0);
    EXPECT_EQ(figures[u"connections"].toInt(), 1);
    EXPECT_EQ(figures[u"connectionsLost"].toInt(), 0);
    EXPECT_GT(figures[u"answerTime"].toObject()[u"longest"].toInt(), 0);
    EXPECT_EQ(figures[u"status"].toInt(), 0); // the high word of 1.0
    EXPECT_EQ(figures[u"exceptions"].toObject(), QJsonObject());
}

TEST(CliGatewayRing, TheFiguresOfAMonitorCountUntilItsEnd)
{
    std::atomic<int> requests = 0;
    const CrookedPeer peer([&](const SeenRequest &request) {
        ++requests;
        return Reaction{
            CrookedPeer::tcpFrame(request.transaction, request.unit, rightAnswer(request.message))};
    });
    const auto figures = RingProject()
                             .run(line("monitor 1.0 --for 1 --json"),
                                  QStringLiteral("modbus-tcp:127.0.0.1:%1").arg(peer.port()))
                             .json()[u"figures"]
                             .toObject();
    EXPECT_EQ(figures[u"transactions"].toInt(), requests.load());
    EXPECT_GT(requests.load(), 10);
}

TEST(CliGatewayRing, ConnectionsClosedAfterEachAnswerAreCounted)
{
    GatewayPeer peer(line("--devices 1 --closes 3"));
    const CliRun run = RingProject(1).run(line("monitor 1.0 --for 1"), peer.link(line("interval=10")));
    EXPECT_THAT(run.out, HasSubstr("The gateway closes the connection after each answer."));
    const auto figures = RingProject(1)
                             .run(line("monitor 1.0 --for 1 --json"), peer.link(line("interval=10")))
                             .json()[u"figures"]
                             .toObject();
    EXPECT_TRUE(figures[u"closesAfterEachAnswer"].toBool());
    EXPECT_GT(figures[u"closedAfterEachAnswer"].toInt(), 5);
    EXPECT_GT(figures[u"connections"].toInt(), figures[u"closedAfterEachAnswer"].toInt());
}

TEST(CliGatewayRing, ReadingGoesToOperateAndBack)
{
    GatewayPeer peer;
    const CliRun run = RingProject().run(line("read 3.0 --json"), peer.link());
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("4713")); // its serial number
    EXPECT_GT(peer.writes(), 0);
    EXPECT_EQ(peer.out(), line("00000000 00000000 00000000"));
}

// On a terminal only.
TEST(CliGatewayRing, AJobThatTakesLongSaysWhereItIs)
{
    GatewayPeer peer;
    const RingProject project;
    const QString slow = peer.link(line("interval=250"));
    const CliRun seen = project.run(line("read 3.0 steps"), slow, {.isThere = true});
    EXPECT_EQ(seen.exit, 0) << seen.err;
    EXPECT_THAT(seen.err, HasSubstr("Step "));
    EXPECT_THAT(seen.err, HasSubstr("Ctrl+C cancels"));
    EXPECT_EQ(project.run(line("read 3.0 steps"), slow).err, "");
}

TEST(CliGatewayRing, WritingIsAskedForAndCountedWhereThoseOfRealEncodersAre)
{
    GatewayPeer peer;
    const RingProject project;
    EXPECT_EQ(project.run(line("write 1.0 steps=1000"), peer.link()).exit, 2); // nobody to ask
    EXPECT_EQ(peer.writes(), 0);
    const CliRun written = project.run(line("write 1.0 steps=1000 --yes"), peer.link());
    EXPECT_EQ(written.exit, 0) << written.err;
    EXPECT_THAT(written.out, HasSubstr("read back"));
    EXPECT_EQ(peer.out(), line("00000000 00000000 00000000"));
    const auto ledger = Ledger::open(DatabasePlace::file(project.path(line("ledger.sqlite"))));
    ASSERT_TRUE(ledger);
    ASSERT_EQ(ledger->accounts().size(), 1U);
    EXPECT_EQ(ledger->accounts().front().count.writes, 1);
}

TEST(CliGatewayRing, LowWordFirstHoldsBothWays)
{
    GatewayPeer peer(line("--low-word-first"));
    const CliRun run =
        RingProject().run(line("preset 2.0 77 --in-position-mode --json"), peer.link(line("order=low")));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(run.json()[u"positionBefore"].toInt(), 2000);
    EXPECT_EQ(run.json()[u"positionAfter"].toInt(), 77);
}

TEST(CliGatewayRing, TheFrabaPresetIsRefusedWithoutWriting)
{
    GatewayPeer peer;
    const CliRun preset =
        RingProject().run(line("preset 1.0 --fraba --in-position-mode --json"), peer.link());
    EXPECT_EQ(preset.exit, 1);
    EXPECT_EQ(errorKey(preset), "linkDoesNotBoundCycles");
    const CliRun words = RingProject().run(line("words 1.0 60000000 --json"), peer.link());
    EXPECT_EQ(words.exit, 1);
    EXPECT_EQ(errorKey(words), "linkDoesNotBoundCycles");
    EXPECT_EQ(peer.writes(), 0);
}

TEST(CliGatewayRing, WordsAreSentAndTraced)
{
    GatewayPeer peer;
    const CliRun run = RingProject().run(line("words 2.0 20210000 00000000 --json"), peer.link());
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(rowsOf(run.json()), testing::Contains("20210000 A0001268"));
    EXPECT_EQ(peer.out(), line("00000000 00000000 00000000"));
}

TEST(CliGatewayRing, AnAlarmStopSaysThatItsZerosArrived)
{
    GatewayPeer peer;
    const CliRun run = RingProject().run(line("master alarm-stop"), peer.link());
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("were read back as 00000000"));
    EXPECT_GT(peer.writes(), 0);
}

// The gateway is gone with the zeros that are asked for once it is open: what the ring told until then is not
// lost with it.
TEST(CliGatewayRing, AnAlarmStopWhoseZerosAreMissingStillPrintsWhatTheRingTold)
{
    GatewayPeer peer(line("--pending 0200012C --vanish-at-write 2"));
    const CliRun run = RingProject().run(line("master alarm-stop --patience 2"), peer.link());
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("ALARM STOP: 00000000 is sent to all devices of the ring."));
    EXPECT_THAT(run.out, HasSubstr("Master:"));
    EXPECT_THAT(run.out, Not(HasSubstr("within 2 s")));
    EXPECT_THAT(run.err, HasSubstr("were acknowledged, but not read back within 2 s"));
    GatewayPeer other(line("--pending 0200012C --vanish-at-write 2"));
    const CliRun json = RingProject().run(line("master alarm-stop --patience 2 --json"), other.link());
    EXPECT_EQ(errorKey(json), "zerosNotReadBack");
    EXPECT_FALSE(json.json()[u"messages"].toArray().isEmpty());
}

// It hears the connection and nothing else: the first sentence comes while it is still waited for.
TEST(CliGatewayRing, AnAlarmStopOfAMuteGatewaySaysSoAndSendsItsZeros)
{
    std::mutex mutex;
    std::vector<QByteArray> heard;
    CrookedPeer mute([&](const SeenRequest &request) {
        const std::scoped_lock lock(mutex);
        heard.push_back(request.message);
        return Reaction();
    });
    const CliRun run = RingProject().run(line("master alarm-stop --patience 3"),
                                         QStringLiteral("modbus-tcp:127.0.0.1:%1").arg(mute.port()));
    EXPECT_EQ(run.exit, 1);
    EXPECT_TRUE(run.err.starts_with("codewheel-cli: The zeros of the ALARM STOP were sent, but are not "
                                    "acknowledged yet: it is not known"))
        << run.err;
    EXPECT_THAT(run.err, HasSubstr("not acknowledged within 3 s: it is not known"));
    const QByteArray zeros = QByteArray::fromHex("1000000006") + '\x0c' + QByteArray(12, '\0');
    const std::scoped_lock lock(mutex);
    EXPECT_TRUE(std::ranges::any_of(heard, [&](const QByteArray &one) { return one == zeros; }));
}

TEST(CliGatewayRing, WhatAcknowledgesAWatchdogNeverGoesIntoTheImage)
{
    GatewayPeer peer;
    const RingProject project;
    const auto acknowledge = [&](const char *at) {
        return project.run(line("gateway --acknowledge-watchdog --json"),
                           peer.link(line("watchdog-value=32768,watchdog=") + line(at)));
    };
    EXPECT_EQ(errorKey(acknowledge("0")), "registerMapWrong");
    EXPECT_EQ(peer.out(), line("00000000 00000000 00000000"));
    EXPECT_EQ(errorKey(runLine(line("gateway --acknowledge-watchdog --json --link ") +
                               peer.link(line("watchdog=9")))),
              "gatewayHasNoDevices")
        << "without a project nobody knows where the image is";
}

TEST(CliGatewayRing, SomebodyElseWhoWritesIsNamed)
{
    GatewayPeer peer(line("--other-writer 3"));
    const CliRun run = RingProject().run(line("write 1.0 steps=1000 --yes --json"), peer.link());
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "outNotOurs");
    EXPECT_THAT(run.err, HasSubstr("Somebody else writes to 2.0: OUT is 80000000 there"));
    EXPECT_TRUE(peer.out().endsWith(line(" 80000000 00000000"))); // nobody has overwritten it
}

TEST(CliGatewayRing, OutThatCannotBeReadBackIsSaidOnce)
{
    GatewayPeer peer(line("--no-read-back"));
    const CliRun run = RingProject().run(line("monitor 1.0 --for 1"), peer.link());
    EXPECT_EQ(run.exit, 0) << run.err;
    const auto first = run.err.find("cannot be read back");
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(run.err.find("cannot be read back", first + 1), std::string::npos);
    EXPECT_THAT(run.out, HasSubstr("  -    000003E8  not known  Running, position 1000"));
    const CliRun told = RingProject().run(line("monitor 1.0 --for 1 --json"), peer.link());
    EXPECT_EQ(told.json()[u"samples"].toArray().first()[u"out"], QJsonValue());
    EXPECT_EQ(peer.writes(), 0);
}

TEST(CliGatewayRing, ALinkThatIsLostIsExit1)
{
    GatewayPeer peer;
    const QString link = peer.link();
    EXPECT_EQ(RingProject().run(line("monitor 1.0 --for 1"), link).exit, 0);
    peer.vanish();
    EXPECT_EQ(errorKey(RingProject().run(line("monitor 1.0 --for 1 --json"), link)), "connectionRefused");
}

// The peer is gone once it has taken run: the values are in force, and nobody has seen it.
TEST(CliGatewayRing, WhatWasSentAndNotAnsweredIsNotKnown)
{
    const RingProject project;
    for (const char *word : {"80000000", "020000FF"}) {
        GatewayPeer peer(line("--vanish-behind ") + line(word));
        const CliRun run = project.run(line("write 1.0 steps=255 --yes --all"), peer.link());
        EXPECT_EQ(run.exit, 1);
        EXPECT_THAT(run.out, HasSubstr("sent: it is not known whether the encoder has it"));
        EXPECT_THAT(run.out, Not(HasSubstr("did not become active")));
        EXPECT_THAT(run.out, HasSubstr(std::string("OUT may still hold ") + word));
        EXPECT_THAT(run.out, testing::AnyOf(HasSubstr("EEPROM writes:   1"),
                                            HasSubstr("EEPROM writes:   0, perhaps 1 more")));
        EXPECT_THAT(run.err,
                    HasSubstr("In which state the encoder is, is not known until it is seen again."));
        EXPECT_THAT(run.err, Not(HasSubstr("The encoder was left in parameterization")));
    }
    GatewayPeer peer(line("--vanish-behind 80000000"));
    const CliRun run = project.run(line("write 1.0 steps=255 --yes --all --json"), peer.link());
    const QJsonObject doubt = run.json()[u"inDoubt"].toObject();
    EXPECT_EQ(doubt[u"values"].toArray().size(), 1);
    EXPECT_EQ(doubt[u"out"].toArray(), (QJsonArray{line("80000000"), line("020000FF")})) << "either of them";
    EXPECT_FALSE(doubt[u"position"].toBool());
    EXPECT_EQ(run.json()[u"leftIn"].toString(), line("unknown"));
}

// The first is confirmed and waits for run, which has not been sent.
TEST(CliGatewayRing, WhatIsConfirmedWhenTheLinkIsCutStillWaitsForRun)
{
    GatewayPeer peer(line("--vanish-behind 08000064"));
    const CliRun run = RingProject().run(line("write 1.0 steps=255 preset=100 --yes --all"), peer.link());
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("= 255  confirmed; takes effect only with run\n"));
    EXPECT_THAT(run.out, HasSubstr("= 100  sent: it is not known whether the encoder has it\n"));
    EXPECT_THAT(run.out, Not(HasSubstr("did not become active")));
    GatewayPeer again(line("--vanish-behind 08000064"));
    const QJsonArray confirmed =
        RingProject()
            .run(line("write 1.0 steps=255 preset=100 --yes --all --json"), again.link())
            .json()[u"confirmed"]
            .toArray();
    ASSERT_EQ(confirmed.size(), 1);
    EXPECT_EQ(confirmed[0][u"value"].toInt(), 255);
}

TEST(CliGatewayRing, APresetThatIsCutSaysOneThingOfThePosition)
{
    const RingProject project;
    const auto cutBehind = [&](const char *word) {
        GatewayPeer peer(line("--vanish-behind ") + line(word));
        return project.run(line("preset 1.0 100 --in-position-mode"), peer.link());
    };
    const CliRun sent = cutBehind("40000000");
    EXPECT_THAT(sent.out, HasSubstr("It is not known whether the encoder has this: position. It cannot be"));
    EXPECT_THAT(sent.out, Not(HasSubstr("Whether the position was set is not known: read it.")));
    const CliRun notSent = cutBehind("80000000");
    EXPECT_THAT(notSent.out, HasSubstr("It is not known whether the encoder has this: Preset = 100."));
    EXPECT_THAT(notSent.out, Not(HasSubstr("position was set"))) << "40000000 was not sent";
}

TEST(CliGatewayRing, WhereAJobIsCutTheStateOfTheEncoderIsNotKnown)
{
    const RingProject project;
    struct
    {
        const char *line;
        const char *word;
    } const rows[] = {
        {"velocity 1.0 off", "20800000"}, {"preset 1.0 100 --in-position-mode", "08000064"},
        {"reset 1.0 --yes", "0E000000"},  {"words 1.0 0200012C", "0200012C"},
        {"read 1.0 steps", "20210001"},
    };
    for (const auto &row : rows) {
        GatewayPeer peer(line("--vanish-behind ") + line(row.word));
        EXPECT_THAT(project.run(line(row.line), peer.link()).err,
                    HasSubstr(" In which state the encoder is, is not known until it is seen again."))
            << row.line;
    }
}

TEST(CliGatewayRing, AVelocityCommandThatIsCutSaysThatTheModeIsNotKnown)
{
    struct
    {
        const char *line;
        const char *word;
    } const rows[] = {{"velocity 1.0 on --in-position-mode", "20400001"}, {"velocity 1.0 off", "20800000"}};
    for (const auto &row : rows) {
        GatewayPeer peer(line("--vanish-behind ") + line(row.word));
        const CliRun run = RingProject().run(line(row.line), peer.link());
        EXPECT_EQ(run.exit, 1);
        EXPECT_THAT(run.err, HasSubstr("It is not known in which mode the encoder was left")) << row.word;
    }
}

QString camsOfTest(const RingProject &project)
{
    const QString name = project.path(line("cams.json"));
    QFile file(name);
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(
        R"({"format": "codewheel-cams", "version": 1, "device": "fraba-ocd-ib", "programs": [)"
        R"({"program": 1, "shift": 0, "cams": [{"cam": 0, "start": 100, "stop": 200, "active": true}]}]})");
    return name;
}

QJsonObject firstAccountOf(const RingProject &project)
{
    const CliRun ledger = runLine(line("ledger --json --ledger ") + project.path(line("ledger.sqlite")));
    return ledger.json()[u"accounts"].toArray().first().toObject();
}

CliRun storeOf(const RingProject &project, const GatewayPeer &peer, const QString &options = {})
{
    return runLine(QStringLiteral("store %1 1.0 --link %2 --ledger %3 %4")
                       .arg(project.file(), peer.link(), project.path(line("ledger.sqlite")), options)
                       .trimmed());
}

// It was perhaps in a cam program that was changed, and is stored when it is left.
TEST(CliGatewayRing, LeavingAModeThatIsNotKnownPerhapsCostAWrite)
{
    struct
    {
        const char *line;
        const char *told;
        int writes;
    } const rows[] = {
        {"velocity 1.0 off", "Position mode: 1000\nEEPROM writes:   0, perhaps 1 more\n", 0},
        {"reset 1.0 --yes", "EEPROM writes:   1, perhaps 1 more\n", 1},
        {"cams 1.0 read --program 2 --to-position --yes", "EEPROM writes:   0, perhaps 1 more\n", 0},
    };
    for (const auto &row : rows) {
        GatewayPeer peer;
        const RingProject project;
        const CliRun run = project.run(line(row.line), peer.link());
        EXPECT_EQ(run.exit, 0) << run.err;
        EXPECT_THAT(run.out, HasSubstr(row.told)) << row.line;
        const QJsonObject account = firstAccountOf(project);
        EXPECT_EQ(account[u"writes"].toInt(), row.writes) << row.line;
        EXPECT_EQ(account[u"perhaps"].toInt(), 1) << row.line;
    }
}

TEST(CliGatewayRing, ProgramsAreToldWhatAllJobsOfACallPerhapsCost)
{
    GatewayPeer peer;
    const RingProject project;
    const QString write = QStringLiteral("cams 1.0 write %1 --yes --json").arg(camsOfTest(project));
    const QJsonObject json = project.run(write, peer.link()).json();
    EXPECT_EQ(json[u"eepromWrites"].toInt(), 1);
    EXPECT_EQ(json[u"inDoubt"].toObject()[u"eepromWrites"].toInt(), 1);
}

TEST(CliGatewayRing, WhatAllJobsOfACallCostIsOneLineAsTheLedgerCountsIt)
{
    GatewayPeer peer;
    const RingProject project;
    const CliRun run =
        project.run(QStringLiteral("cams 1.0 write %1 --yes").arg(camsOfTest(project)), peer.link());
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out,
                HasSubstr("Written and read back: cam program 1.\nEEPROM writes:   1, perhaps 1 more\n"));
    const std::string done = run.out.substr(run.out.find("Written and read back"));
    EXPECT_EQ(done.find("EEPROM writes"), done.rfind("EEPROM writes")) << done;
    const QJsonObject account = firstAccountOf(project);
    EXPECT_EQ(account[u"writes"].toInt(), 1);
    EXPECT_EQ(account[u"perhaps"].toInt(), 1);
}

// Reading the programs leaves the one that the encoder is in, if it is in one.
TEST(CliGatewayRing, CamsInAModeThatIsNotKnownAreReadOnlyByConsent)
{
    GatewayPeer peer;
    const RingProject project;
    const QString write = QStringLiteral("cams 1.0 write %1").arg(camsOfTest(project));
    const char *announced = "The cam programs are read in cam mode.\n"
                            "EEPROM writes:   0, and 1 more where it is in a cam program that was changed\n";
    for (const QString &call :
         {write, QString(write).replace(line(" write "), line(" compare ")), line("cams 1.0 read")}) {
        const CliRun nobody = project.run(call, peer.link());
        EXPECT_EQ(nobody.exit, 2) << call.toStdString();
        EXPECT_THAT(nobody.out, HasSubstr(announced));
        EXPECT_THAT(nobody.err,
                    HasSubstr("Nothing was sent: there is nobody to ask. Add --yes to read them."));
    }
    const CliRun declined = project.run(write, peer.link(), {.isThere = true, .types = "n\n"});
    EXPECT_EQ(declined.exit, 2);
    EXPECT_THAT(declined.err, HasSubstr("Nothing was sent."));
    EXPECT_EQ(peer.out(), line("00000000 00000000 00000000"));
    EXPECT_TRUE(firstAccountOf(project).isEmpty());

    const CliRun agreed = project.run(write + line(" --yes"), peer.link());
    EXPECT_EQ(agreed.exit, 0) << agreed.err;
    EXPECT_THAT(agreed.out, HasSubstr(announced));
    EXPECT_THAT(agreed.out,
                HasSubstr("EEPROM writes: 1, one for each program that is changed and left. Reading "
                          "has perhaps cost so many: 1.\n"));
    EXPECT_THAT(agreed.out, HasSubstr("\nEEPROM writes:   1, perhaps 1 more\n"));
}

TEST(CliGatewayRing, CamsOfAnEncoderInParameterizationAreNotWritten)
{
    GatewayPeer peer(line("--pending 0200012C"));
    const RingProject project;
    const CliRun run =
        project.run(QStringLiteral("cams 1.0 write %1 --yes").arg(camsOfTest(project)), peer.link());
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, Not(HasSubstr("Nothing was sent"))) << "steps were read";
    EXPECT_THAT(run.err, HasSubstr("Nothing was written"));
    EXPECT_THAT(run.err, HasSubstr("The encoder is still in parameterization, as before"));
    EXPECT_THAT(run.out, HasSubstr("In which mode the encoder is now is not known."))
        << "nothing was switched";
}

TEST(CliGatewayRing, WhatEndsWithRunNamesTheCommandThatSendsIt)
{
    GatewayPeer peer(line("--pending 0200012C"));
    const RingProject project;
    const std::string way =
        " --link " + peer.link().toStdString() + " --project " + project.file().toStdString();
    const std::string command = "\n    codewheel-cli words 1.0 80000000 00000000" + way;
    EXPECT_THAT(project.run(line("reset 1.0 --yes"), peer.link()).err, HasSubstr("with run." + command));
    EXPECT_THAT(project.run(line("cams 1.0 read --yes"), peer.link()).err, HasSubstr(command));
    EXPECT_THAT(project.run(line("read 1.0 steps"), peer.link()).err, HasSubstr(command));
    EXPECT_THAT(storeOf(project, peer, line("--cams")).err, HasSubstr(command));
    EXPECT_EQ(project.run(line("words 1.0 80000000 00000000"), peer.link()).exit, 0);
    EXPECT_EQ(project.run(line("read 1.0 steps"), peer.link()).exit, 0) << "it is in operation";
}

TEST(CliGatewayRing, AResetThatIsCutSaysWhetherItWasSent)
{
    const RingProject project;
    const char *told = "The reset itself, 0E000000, was not sent.";
    for (const char *word : {"20800000", "20400000"}) {
        GatewayPeer peer(line("--vanish-behind ") + line(word));
        const CliRun run = project.run(line("reset 1.0 --yes"), peer.link());
        EXPECT_EQ(run.exit, 1);
        EXPECT_THAT(run.out, HasSubstr(told)) << word;
        EXPECT_THAT(run.out, Not(HasSubstr("factory settings. Read"))) << "there is no doubt";
    }
    for (const char *word : {"0E000000", "80000000", "20210001"}) {
        GatewayPeer peer(line("--vanish-behind ") + line(word));
        const CliRun run = project.run(line("reset 1.0 --yes"), peer.link());
        EXPECT_EQ(run.exit, 1);
        EXPECT_THAT(run.out, Not(HasSubstr(told))) << word;
        const bool isRead = line(word) == line("20210001");
        EXPECT_EQ(run.out.find("0E000000 and run were sent and answered") != std::string::npos, isRead)
            << word;
        EXPECT_EQ(run.out.find("has this: factory settings") == std::string::npos, isRead) << word;
    }
}

TEST(CliGatewayRing, AReadThatIsCutSaysWhatItLeavesInOut)
{
    GatewayPeer peer(line("--vanish-behind 20210001"));
    EXPECT_THAT(RingProject().run(line("read 1.0 steps"), peer.link()).out,
                HasSubstr("OUT may still hold 20210001"));
    GatewayPeer other(line("--vanish-behind 20210001"));
    const CliRun run = RingProject().run(line("read 1.0 steps --json"), other.link());
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(run.json()[u"inDoubt"].toObject()[u"out"].toArray(), QJsonArray{line("20210001")});
}

TEST(CliGatewayRing, CamsThatAreCutSayWhatTheyLeaveInOut)
{
    const RingProject project;
    const QString write = QStringLiteral("cams 1.0 write %1 --yes --to-position").arg(camsOfTest(project));
    struct
    {
        QString line;
        const char *word;
    } const rows[] = {
        {line("cams 1.0 read --program 1 --yes"), "20200011"},
        {write, "20800001"},
        {write, "20400001"},
        {write, "80000000"},
    };
    for (const auto &row : rows) {
        GatewayPeer peer(line("--vanish-behind ") + line(row.word));
        const CliRun run = project.run(row.line, peer.link());
        EXPECT_EQ(run.exit, 1) << row.word;
        EXPECT_THAT(run.out, HasSubstr(std::string("OUT may still hold ") + row.word));
        EXPECT_THAT(run.err,
                    HasSubstr("In which state the encoder is, is not known until it is seen again."));
    }
    GatewayPeer peer(line("--vanish-behind 20400001"));
    const QJsonObject doubt = project.run(write + line(" --json"), peer.link()).json()[u"inDoubt"].toObject();
    EXPECT_EQ(doubt[u"out"].toArray().first(), line("20400001"));
    EXPECT_EQ(doubt[u"camPrograms"].toArray(), QJsonArray{1});
}

// The program was left: that is an EEPROM write, seen by nobody.
TEST(CliGatewayRing, CamsThatAreCutBehindTheWordThatStoresThemPerhapsCostAWrite)
{
    const RingProject project;
    const QString write = QStringLiteral("cams 1.0 write %1 --yes --to-position").arg(camsOfTest(project));
    GatewayPeer peer(line("--vanish-behind 20800000 --vanish-at 2"));
    const CliRun run = project.run(write, peer.link());
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("EEPROM writes:   0, perhaps 2 more\n")) << "as the ledger says";
    EXPECT_THAT(run.out, Not(HasSubstr("Written and read back"))) << "it is not known whether it is saved";
    EXPECT_THAT(run.out, HasSubstr("It is not known whether the encoder has this: cam program 1."));
    EXPECT_THAT(run.out, HasSubstr("OUT may still hold 20800000"));
    EXPECT_THAT(run.out,
                HasSubstr("It is not known in which mode the encoder was left: the controller may get "
                          "no position."));
    const QJsonObject account = firstAccountOf(project);
    EXPECT_EQ(account[u"writes"].toInt(), 0);
    EXPECT_EQ(account[u"perhaps"].toInt(), 2) << "and the mode it was in was not known";
}

// Nobody can ask an encoder behind a gateway for its mode.
TEST(CliGatewayRing, AfterCamsItIsToldInWhichModeTheEncoderIs)
{
    GatewayPeer peer;
    const RingProject project;
    const CliRun stays = project.run(line("cams 1.0 read --program 2 --yes"), peer.link());
    EXPECT_EQ(stays.exit, 0) << stays.err;
    EXPECT_THAT(stays.out, HasSubstr("The encoder is now in cam mode, program 2; in which mode it was before "
                                     "is not known. With --to-position it is in position mode afterwards."));
    EXPECT_THAT(project.run(line("cams 1.0 read --program 2 --yes --stay"), peer.link()).out,
                HasSubstr("program 2; in which mode it was before is not known.\n"))
        << "who says where to is given no hint";
    const CliRun goes = project.run(line("cams 1.0 read --program 2 --yes --to-position"), peer.link());
    EXPECT_EQ(goes.exit, 0) << goes.err;
    EXPECT_THAT(goes.out, HasSubstr("The encoder is now in position mode; in which mode it was before is not "
                                    "known.\n"));
    EXPECT_THAT(project.run(line("monitor 1.0 --for 1"), peer.link()).out, HasSubstr("000003E8"));
    const CliRun json = project.run(line("cams 1.0 read --program 2 --yes --json"), peer.link());
    EXPECT_EQ(json.json()[u"mode"], line("cam"));
    EXPECT_EQ(json.json()[u"camProgram"], 2);
}

TEST(CliGatewayRing, AStoreThatIsCutSaysWhatItLeavesInOutAndWhatItKept)
{
    const RingProject project;
    const auto store = [&](const GatewayPeer &peer) {
        return runLine(QStringLiteral("store %1 1.0 --link %2").arg(project.file(), peer.link()));
    };
    GatewayPeer whole;
    EXPECT_EQ(store(whole).exit, 0);
    EXPECT_THAT(store(whole).out, Not(HasSubstr("kept from before")));
    GatewayPeer peer(line("--vanish-behind 20210004"));
    const CliRun run = store(peer);
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("1.0: OUT may still hold 20210004"));
    EXPECT_THAT(run.out, testing::ContainsRegex("steps +.*read\n"));
    EXPECT_THAT(run.out, testing::ContainsRegex("preset +.*read, kept from before\n"));
}

// A cam that others have set is stored when they leave its program; reading does not leave it.
TEST(CliGatewayRing, AStoreThatIsCutCostsNothingForWhatOthersChanged)
{
    const RingProject project;
    GatewayPeer peer(line("--left 20800001 46000015 --vanish-behind 20210002"));
    const CliRun run = storeOf(project, peer);
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("1.0: OUT may still hold 20210002"));
    EXPECT_THAT(run.out, Not(HasSubstr("EEPROM writes")));
    EXPECT_TRUE(firstAccountOf(project).isEmpty());
}

TEST(CliGatewayRing, AStoreOfCamsThatIsCutSaysStateAndModeAndWhatItCost)
{
    struct
    {
        const char *word;
        const char *mode;
    } const rows[] = {
        {"20800001",
         " It is not known in which mode the encoder was left: the controller may get no position."},
        {"20800002", " The encoder was left in cam mode: the controller gets no position."},
        {"20200011", " The encoder was left in cam mode, program 1: the controller gets no position."},
    };
    for (const auto &row : rows) {
        const RingProject project;
        GatewayPeer peer(line("--vanish-behind ") + line(row.word));
        const CliRun run = storeOf(project, peer, line("--cams"));
        EXPECT_EQ(run.exit, 1);
        EXPECT_THAT(
            run.err,
            HasSubstr(std::string(" In which state the encoder is, is not known until it is seen again.") +
                      row.mode))
            << row.word;
        EXPECT_THAT(run.out, HasSubstr("1.0: EEPROM writes:   0, perhaps 1 more\n")) << row.word;
        EXPECT_EQ(run.out.find("EEPROM writes"), run.out.rfind("EEPROM writes")) << run.out;
        EXPECT_EQ(firstAccountOf(project)[u"perhaps"].toInt(), 1) << row.word;
    }
    GatewayPeer peer(line("--vanish-behind 20800001"));
    const CliRun run = storeOf(RingProject(), peer, line("--cams --json"));
    const QJsonObject encoder = run.json()[u"encoders"].toArray().first().toObject();
    EXPECT_EQ(encoder[u"eepromWrites"].toInt(-1), 0);
    EXPECT_EQ(encoder[u"inDoubt"].toObject()[u"eepromWrites"].toInt(), 1);
}

// Where the mode is not known it goes to position mode.
TEST(CliGatewayRing, AStoreOfCamsSaysInWhichModeTheEncoderIsAfterwards)
{
    const RingProject project;
    GatewayPeer peer(line("--left 20800001"));
    const CliRun run = storeOf(project, peer, line("--cams"));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("1.0: EEPROM writes:   0, perhaps 1 more\n"
                                   "1.0: The encoder is now in position mode; in which mode it was before is "
                                   "not known.\n"));
    EXPECT_THAT(storeOf(project, peer).out, Not(HasSubstr(" mode"))) << "reading values does not change it";
}

// The word was never sent, since the value is read first.
TEST(CliGatewayRing, AWriteThatIsCutWhileItReadsHasSentNothing)
{
    GatewayPeer peer(line("--vanish-behind 20210001"));
    const CliRun run = RingProject().run(line("write 1.0 steps=1000 --yes"), peer.link());
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("= 1000  not sent\n"));
    EXPECT_THAT(run.out, Not(HasSubstr("did not become active")));
}

// Somebody, or a link, has left it so: what is read is not all that there is.
TEST(CliGatewayRing, AnEncoderFoundInParameterizationIsNamed)
{
    GatewayPeer peer(line("--pending 0200012C"));
    const RingProject project;
    const CliRun read = project.run(line("read 1.0 steps"), peer.link());
    EXPECT_EQ(read.exit, 1);
    EXPECT_THAT(read.out, HasSubstr("= 8192"));
    EXPECT_THAT(read.err, HasSubstr("1.0 is in parameterization and gives no position"));
    EXPECT_THAT(read.err,
                HasSubstr("IN (C200012C) says: Parameter 1 steps = 300 confirmed, or: Acknowledged: "
                          "Start of cam 1 = 300."))
        << "its mode is not known";
    EXPECT_EQ(errorKey(project.run(line("read 1.0 steps --json"), peer.link())), "foundInParameterization");
    EXPECT_EQ(project.run(line("read 2.0 steps"), peer.link()).exit, 0);
    const QString store = QStringLiteral("store %1 1.0 --json --link %2").arg(project.file(), peer.link());
    EXPECT_EQ(errorKey(runLine(store)), "foundInParameterization");
}

TEST(CliGatewayRing, WrongUnitsAndShortImagesAreSaid)
{
    GatewayPeer peer(line("--unit 5 --registers 4"));
    const RingProject project;
    const QString quick = line(",time-out=300,retries=1");
    const CliRun unit = project.run(line("monitor 1.0 --json"), peer.link() + quick);
    EXPECT_EQ(unit.exit, 1);
    EXPECT_THAT(errorKey(unit), testing::AnyOf("registersUnanswered", "registersRefused"));
    const CliRun image = project.run(line("monitor 1.0 --json"), peer.link(line("unit=5")) + quick);
    EXPECT_EQ(image.exit, 1);
    EXPECT_EQ(errorKey(image), "registersRefused");
    EXPECT_THAT(image.err, HasSubstr("Its image is shorter"));
    EXPECT_EQ(RingProject(2).run(line("monitor 1.0 --for 1"), peer.link(line("unit=5"))).exit, 0);
}

TEST(CliGatewayRing, ASettingThatFitsNoImageIsBadInput)
{
    const CliRun run = RingProject().run(line("monitor 1.0 --json"),
                                         line("modbus-tcp:127.0.0.1:1,in-area=holding")); // where OUT is
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(errorKey(run), "registerMapWrong");
}

TEST(CliGatewayRing, TheProjectLeadsToItsGateway)
{
    GatewayPeer peer;
    const RingProject project(3, plannedLink(peer));
    for (const char *link : {"project", "interbus:project", "interbus:project,interval=5"}) {
        const CliRun run = project.run(line("monitor 3.0 --for 1"), line(link));
        EXPECT_EQ(run.exit, 0) << link << run.err;
        EXPECT_THAT(run.out, HasSubstr("00000BB8")) << link;
    }
    EXPECT_EQ(errorKey(project.run(line("monitor 3.0 --json"), line("interbus:project,unit=x"))),
              "linkSettingWrong");
    EXPECT_EQ(peer.writes(), 0);
}

TEST(CliGatewayRing, APlanWithoutAHostSaysSo)
{
    const RingProject project(1, {line("modbus-tcp"), {}});
    const CliRun run = project.run(line("monitor 1.0 --json"), line("project"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "noGatewayInProject");
}

TEST(CliGatewayRing, ATransferWritesOnlyWhenItIsToldTo)
{
    GatewayPeer peer;
    const RingProject project;
    auto wanted = loadProject(project.file());
    ASSERT_TRUE(wanted);
    wanted->devices[0].wanted = {{Parameter::steps, 500}};
    wanted->devices[2].wanted = {{Parameter::steps, 700}};
    ASSERT_TRUE(saveProject(*wanted, project.file()));
    const QString transfer = QStringLiteral("transfer %1 --ledger %2 --link %3 %4")
                                 .arg(project.file(), project.path(line("ledger.sqlite")), peer.link());
    const CliRun dry = runLine(transfer.arg(line("--dry-run")));
    EXPECT_EQ(dry.exit, 0) << dry.err;
    EXPECT_THAT(dry.out, HasSubstr("500"));
    EXPECT_EQ(peer.writes(), 0);
    const CliRun done = runLine(transfer.arg(line("--yes")));
    EXPECT_EQ(done.exit, 0) << done.err;
    EXPECT_EQ(peer.out(), line("00000000 00000000 00000000"));
    EXPECT_THAT(project.run(line("read 3.0 steps"), peer.link()).out, HasSubstr("700"));
}

TEST(CliGatewayRing, ATransferThatIsCutSaysWhatItLeavesInOut)
{
    const RingProject project;
    auto wanted = loadProject(project.file());
    ASSERT_TRUE(wanted);
    wanted->devices[0].wanted = {{Parameter::steps, 500}};
    ASSERT_TRUE(saveProject(*wanted, project.file()));
    const auto transfer = [&](const QString &more) {
        GatewayPeer peer(line("--vanish-behind 80000000"));
        return runLine(QStringLiteral("transfer %1 --ledger %2 --link %3 --yes %4")
                           .arg(project.file(), project.path(line("ledger.sqlite")), peer.link(), more));
    };
    const CliRun run = transfer({});
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("OUT may still hold 80000000"));
    const QJsonObject encoder = transfer(line("--json")).json()[u"encoders"].toArray().first().toObject();
    EXPECT_TRUE(encoder[u"outLeft"].toArray().contains(line("80000000")));
}

TEST(CliGatewayRing, WhatTheEncodersHaveIsStoredInTheProject)
{
    GatewayPeer peer(line("--devices 2"));
    const RingProject project(2);
    const CliRun run = runLine(QStringLiteral("store %1 --link %2").arg(project.file(), peer.link()));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("8192"));
    const auto stored = loadProject(project.file());
    ASSERT_TRUE(stored);
    EXPECT_FALSE(stored->devices[1].stored.empty());
}

TEST(CliGatewayRing, IsRecordedInAThread)
{
    GatewayPeer peer;
    const RingProject project;
    const CliRun run = project.run(
        QStringLiteral("record 1.0 -o %1 --for 1 --json").arg(project.path(line("ring.cwrec"))), peer.link());
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(peer.writes(), 0);
}

TEST(CliGatewayRing, WorksOverASerialLine)
{
    GatewayPeer peer(line("--rtu --devices 1"));
    const CliRun run = RingProject(1).run(line("read 1.0 serial-number --json"), peer.link());
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("4711"));
    const CliRun taken = RingProject(1).run(line("monitor 1.0 --for 1 --json"), peer.link(line("unit=9")));
    EXPECT_EQ(errorKey(taken), "registersUnanswered");
}

} // namespace
} // namespace codewheel
