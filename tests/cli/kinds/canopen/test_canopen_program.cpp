// SPDX-License-Identifier: GPL-3.0-or-later
// Over a serial CAN adapter and an encoder that know nothing of this program.
#include "tests/cli/cli_run.h"
#include "tests/support/peer_process.h"

#include <csignal>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class CanNodePeer : public test::PeerProcess
{
public:
    explicit CanNodePeer(const QString &options = {})
        : PeerProcess(QStringLiteral(CODEWHEEL_PYTHON), QStringList{QStringLiteral(CODEWHEEL_CANOPEN_PEER)} +
                                                            options.split(u' ', Qt::SkipEmptyParts))
    {}

    CliRun runLine(const QString &line, const QString &settings = {}, int rate = 250'000)
    {
        return codewheel::runLine(
            line + QStringLiteral(" --link slcan:%1,rate=%2%3").arg(port()).arg(rate).arg(settings));
    }
    // It has been stopped, and goes on.
    void wake() { EXPECT_EQ(::kill(static_cast<pid_t>(process().processId()), SIGCONT), 0); }
};

TEST(CliCanProgram, ListeningSendsNothing)
{
    CanNodePeer peer(QStringLiteral("--running"));
    const CliRun scan = peer.runLine(QStringLiteral("scan --listen 1"));
    EXPECT_EQ(scan.exit, 0);
    EXPECT_THAT(scan.out, HasSubstr("can:5  operational  sends  -"));
    const CliRun monitor = peer.runLine(QStringLiteral("monitor can:5 --for 1"));
    EXPECT_THAT(monitor.out, HasSubstr("position 5000"));
    EXPECT_EQ(scan.err + monitor.err, "");
    EXPECT_THAT(peer.order(QStringLiteral("heard")), IsEmpty());
    EXPECT_THAT(peer.order(QStringLiteral("state")), ElementsAre("closed S5")); // never open to send
}

TEST(CliCanProgram, WhatSendsSaysSo)
{
    CanNodePeer peer;
    const CliRun run = peer.runLine(QStringLiteral("read can:5 serial-number"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.out, "serial-number  = 4711 (1267h)\n");
    EXPECT_THAT(run.err, HasSubstr("in Operate, frames are sent"));
    EXPECT_EQ(peer.runLine(QStringLiteral("od can:5 read 1008")).out, "1008h:0 1008 = \"Peer encoder\"\n");
}

TEST(CliCanProgram, ObjectsAreWrittenOnceAndNodesStarted)
{
    CanNodePeer peer;
    EXPECT_EQ(peer.runLine(QStringLiteral("od can:5 write 6001=4096 --yes")).exit, 0);
    EXPECT_EQ(peer.runLine(QStringLiteral("od can:5 write 1010:1=save --yes")).exit, 0);
    EXPECT_THAT(peer.order(QStringLiteral("objects")), ElementsAre("6001:0=00100000", "1010:1=73617665"));
    EXPECT_THAT(peer.runLine(QStringLiteral("nmt start can:5 --yes")).out, HasSubstr("is operational."));
    EXPECT_THAT(peer.runLine(QStringLiteral("nmt reset can:5 --yes")).out, HasSubstr("is back."));
    EXPECT_EQ(errorKey(peer.runLine(QStringLiteral("lss node 5 --yes --json"))), "nodeNumberTaken");
}

TEST(CliCanProgram, ARateIsInForceAtOnceIfThatIsWanted)
{
    CanNodePeer peer;
    EXPECT_EQ(errorKey(peer.runLine(QStringLiteral("lss rate 500000 --activate --of can:5 --yes --json"))),
              "lssActivateNotAlone");
    EXPECT_EQ(errorKey(runLine(
                  QStringLiteral("lss rate 500000 --activate --alone --yes --json --link canopen:training"))),
              "lssActivateNotHere");
    const CliRun run = peer.runLine(QStringLiteral("lss rate 500000 --activate --alone --yes"));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("have 500000 Bd now"));
    EXPECT_THAT(peer.order(QStringLiteral("state")), ElementsAre("closed S6 !"));
    EXPECT_THAT(peer.order(QStringLiteral("heard")).back(), HasSubstr("7E5#0400")) << "and it is left";
    const CliRun gone = peer.runLine(QStringLiteral("lss show --alone --json"));
    EXPECT_EQ(errorKey(gone), "lssNoAnswer") << "at the rate of before";
}

TEST(CliCanProgram, WhatIsSentByLssAndNotAnsweredIsNotKnown)
{
    CanNodePeer peer(QStringLiteral("--unplugged-by 11"));
    const CliRun run = peer.runLine(QStringLiteral("lss node 9 --alone --yes"));
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("whether it has done it is not known"));
    EXPECT_THAT(run.err, HasSubstr("may still be in LSS configuration"));
}

// The peer stands still once the write has reached it, and carries it out when nobody waits for it any more.
void writeIntoAStall(const char *line)
{
    CanNodePeer peer(QStringLiteral("--stalls-at 6001"));
    const CliRun run = peer.runLine(QString::fromLatin1(line));
    peer.wake();
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "sdoWriteUnknown") << run.err;
    EXPECT_THAT(peer.order(QStringLiteral("objects")), ElementsAre("6001:0=00100000"));
    EXPECT_THAT(peer.runLine(QStringLiteral("od can:5 read 6001")).out, HasSubstr("4096"));
}

TEST(CliCanProgram, AnObjectWrittenIntoAStallIsNotKnownAndNotSentAgain)
{
    writeIntoAStall("od can:5 write 6001=4096 --yes --json");
}

TEST(CliCanProgram, AParameterWrittenIntoAStallIsNotKnownAndNotSentAgain)
{
    writeIntoAStall("write can:5 steps=4096 --yes --json");
}

TEST(CliCanProgram, BesideAnotherMasterNothingIsSentUnlessThatWasAgreedTo)
{
    CanNodePeer peer(QStringLiteral("--master"));
    const CliRun refused = peer.runLine(QStringLiteral("od can:5 read 1008 --json"));
    EXPECT_EQ(refused.exit, 1);
    EXPECT_EQ(errorKey(refused), "canopenOtherMaster");
    EXPECT_THAT(refused.err, HasSubstr("beside-master=yes"));
    EXPECT_THAT(peer.order(QStringLiteral("heard")), IsEmpty());
    EXPECT_EQ(peer.runLine(QStringLiteral("od can:5 read 1008"), QStringLiteral(",beside-master=yes")).exit,
              0);
}

TEST(CliCanProgram, ACommandIsNotCalledSentWhereTheAdapterDoesNotTell)
{
    CanNodePeer peer(QStringLiteral("--firmware canable"));
    EXPECT_EQ(errorKey(peer.runLine(QStringLiteral("nmt stop can:9 --yes --json"))), "nmtNotKnown");
    EXPECT_EQ(peer.runLine(QStringLiteral("nmt start --yes")).out, "");
}

TEST(CliCanProgram, ThatTheRateMayBeAnotherIsSaidOfWatchingToo)
{
    CanNodePeer peer(QStringLiteral("--firmware canable"));
    EXPECT_THAT(
        peer.runLine(QStringLiteral("scan --listen 1"), QStringLiteral(",unsure-watch=yes"), 800'000).err,
        HasSubstr("750"));
}

TEST(CliCanProgram, WhatTheAdapterDoesNotGetRidOfNobodyAcknowledges)
{
    CanNodePeer peer(QStringLiteral("--alone"));
    for (const char *line :
         {"od can:5 read 1000 --json", "lss scan --yes --json", "scan --ask --listen 1 --json"}) {
        const CliRun run = peer.runLine(QString::fromLatin1(line));
        EXPECT_EQ(run.exit, 1) << line;
        EXPECT_EQ(errorKey(run), "nobodyAcknowledges") << line;
        EXPECT_THAT(run.err, HasSubstr("unplug it")) << line;
    }
}

TEST(CliCanProgram, AnAdapterThatCannotListenOnlyIsOpenedOnlyIfThatWasAgreedTo)
{
    CanNodePeer peer(QStringLiteral("--no-listening"));
    const CliRun refused = peer.runLine(QStringLiteral("scan --listen 1 --json"));
    EXPECT_EQ(refused.exit, 1);
    EXPECT_EQ(errorKey(refused), "canWatchNotSure");
    EXPECT_THAT(refused.err, HasSubstr("unsure-watch=yes"));
    EXPECT_EQ(peer.runLine(QStringLiteral("scan --listen 1"), QStringLiteral(",unsure-watch=yes")).exit, 0);
    EXPECT_EQ(peer.runLine(QStringLiteral("od can:5 read 1008")).exit, 0); // it acknowledges anyway
}

} // namespace
} // namespace codewheel
