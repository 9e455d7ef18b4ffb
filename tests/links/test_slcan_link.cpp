// SPDX-License-Identifier: GPL-3.0-or-later
// Links to tests/can/slcan_peer.py, which knows nothing of this program, over a real pseudo terminal.
// Anything timed waits for its event, for up to an hour.
#include "can/can_refusals.h"
#include "tests/links/slcan_peer.h"

#include <thread>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::SlcanPeer;

RefusalCode reasonOf(const Result<void> &result)
{
    return result ? RefusalId::nothingToDo : result.error().id;
}

// The next frames.
std::vector<CanFrame> framesFrom(CanLink &link, std::size_t count)
{
    std::vector<CanFrame> frames;
    for (const Instant end = link.now() + 1h; frames.size() < count && link.now() < end;) {
        auto news = link.receive(end);
        if (!news)
            break;
        frames.insert(frames.end(), news->frames.begin(), news->frames.end());
    }
    return frames;
}

std::vector<CanFate> fatesFrom(CanLink &link, std::size_t count)
{
    std::vector<CanFate> fates;
    for (const Instant end = link.now() + 1h; fates.size() < count && link.now() < end;) {
        auto news = link.receive(end);
        if (!news)
            break;
        fates.insert(fates.end(), news->fates.begin(), news->fates.end());
    }
    return fates;
}

void expectAFrame(SlcanPeer &peer)
{
    peer.order(QStringLiteral("bus 185#8813"));
    const auto frames = framesFrom(peer.link(), 1);
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].id, 0x185U);
    EXPECT_EQ(frames[0].length, 2);
    EXPECT_EQ(frames[0].bytes[1], 0x13);
    EXPECT_EQ(frames[0].interface, peer.link().name().section(u'/', -1).toStdString());
}

TEST(SlcanLink, ListensOnlyToWatchAndOpensToSend)
{
    SlcanPeer peer;
    ASSERT_TRUE(peer.link().open(CanUse::watch));
    EXPECT_EQ(peer.state(), "listening S5");
    expectAFrame(peer);
    EXPECT_EQ(peer.link().status().listensOnly, true);
    ASSERT_TRUE(peer.link().open(CanUse::operate));
    EXPECT_EQ(peer.state(), "open S5 !");
    EXPECT_TRUE(peer.link().send({.id = 0x60C, .length = 1, .bytes = {0x40}}).value_or(false));
    EXPECT_EQ(fatesFrom(peer.link(), 1), std::vector{CanFate::done});
    EXPECT_EQ(peer.order(QStringLiteral("heard")), QStringList{QStringLiteral("60C#40")});
    peer.link().close();
    EXPECT_EQ(peer.state(), "closed S5 !");
}

TEST(SlcanLink, UnderstandsAdaptersOfAllKinds)
{
    for (const char *options :
         {"--tear", "--end lf --firmware uccb", "--end crlf", "--end crlf --tear --late 5", "--late 450",
          "--open", "--stamps", "--firmware arduino --boot 600 --end crlf", "--boot 1900"}) {
        SlcanPeer peer(QString::fromLatin1(options));
        ASSERT_TRUE(peer.link().open(CanUse::watch)) << options;
        EXPECT_EQ(peer.state(), "listening S5") << options;
        expectAFrame(peer);
    }
}

TEST(SlcanLink, NeverOpensInsteadOfListening)
{
    SlcanPeer refusing(QStringLiteral("--no-listening"));
    EXPECT_EQ(reasonOf(refusing.link().open(CanUse::watch)), CanRefusalId::watchNotSure);
    EXPECT_EQ(refusing.state(), "closed S5");
    refusing.link().takeUnsureWatch();
    ASSERT_TRUE(refusing.link().open(CanUse::watch));
    EXPECT_EQ(refusing.link().status().listensOnly, false);
    EXPECT_EQ(refusing.state(), "open S5 !");
}

TEST(SlcanLink, SilentFirmwareIsOpenedByAgreementOnly)
{
    SlcanPeer peer(QStringLiteral("--firmware canable"));
    EXPECT_EQ(reasonOf(peer.link().open(CanUse::watch)), CanRefusalId::watchNotSure);
    EXPECT_EQ(peer.state(), "closed");
    peer.link().takeUnsureWatch();
    ASSERT_TRUE(peer.link().open(CanUse::watch));
    EXPECT_EQ(peer.state(), "open S5 !");
    EXPECT_EQ(peer.link().status().listensOnly, false);
    EXPECT_EQ(peer.link().firmware().version, "CANable-b158aa7 github.com");
    expectAFrame(peer);
    ASSERT_TRUE(peer.link().open(CanUse::operate));
    EXPECT_TRUE(peer.link().send({.id = 0x60C}).value_or(false));
    EXPECT_EQ(fatesFrom(peer.link(), 1), std::vector{CanFate::notKnown});
    EXPECT_EQ(peer.order(QStringLiteral("heard")), QStringList{QStringLiteral("60C#")});
}

TEST(SlcanLink, SaysThat800MayBe750)
{
    SlcanPeer lawicel({}, 800'000);
    ASSERT_TRUE(lawicel.link().open(CanUse::operate));
    EXPECT_FALSE(lawicel.link().remark());
    SlcanPeer canable(QStringLiteral("--firmware canable"), 800'000);
    ASSERT_TRUE(canable.link().open(CanUse::operate));
    ASSERT_TRUE(canable.link().remark());
    EXPECT_EQ(canable.link().remark()->id, CanRefusalId::rateMayBe750);
}

TEST(SlcanLink, SaysWhichRateIsRefused)
{
    SlcanPeer peer(QStringLiteral("--no-rates 5"));
    const auto refused = peer.link().open(CanUse::operate);
    ASSERT_FALSE(refused);
    EXPECT_EQ(
        refused.error(),
        (Refusal{RefusalKind::link, CanRefusalId::rateRefused, {peer.link().name(), std::int64_t{250'000}}}));
    EXPECT_EQ(peer.state(), "closed");
}

TEST(SlcanLink, ALateRefusalIsThatOfItsFrame)
{
    SlcanPeer peer;
    ASSERT_TRUE(peer.link().open(CanUse::operate));
    peer.order(QStringLiteral("hold"));
    EXPECT_TRUE(peer.link().send({.id = 0x101}).value_or(false));
    EXPECT_EQ(fatesFrom(peer.link(), 1), std::vector{CanFate::notKnown});
    EXPECT_TRUE(peer.link().send({.id = 0x102}).value_or(false));
    peer.order(QStringLiteral("go"));
    EXPECT_EQ(fatesFrom(peer.link(), 1), std::vector{CanFate::done});
    EXPECT_EQ(peer.order(QStringLiteral("heard")).size(), 2);
}

TEST(SlcanLink, TellsTheStateOfTheBus)
{
    SlcanPeer peer;
    ASSERT_TRUE(peer.link().open(CanUse::watch));
    peer.order(QStringLiteral("status 24"));
    const auto errors = framesFrom(peer.link(), 1);
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_TRUE(errors[0].isError);
    EXPECT_EQ(peer.link().status().state, CanState::passive);
}

TEST(SlcanLink, OpensABoardAgainThatStartedAnew)
{
    SlcanPeer peer;
    ASSERT_TRUE(peer.link().open(CanUse::watch));
    peer.link().wait(peer.link().now() + 1100ms);
    peer.order(QStringLiteral("reset"));
    EXPECT_EQ(peer.state(), "closed");
    for (const Instant end = peer.link().now() + 1h;
         peer.state() != "listening S5" && peer.link().now() < end;)
        ASSERT_TRUE(peer.link().receive(peer.link().now() + 10ms));
    expectAFrame(peer);
}

TEST(SlcanLink, RubbishIsCountedAndSkipped)
{
    SlcanPeer peer;
    ASSERT_TRUE(peer.link().open(CanUse::watch));
    peer.order(QStringLiteral("raw FFFE0D7431383538380D"));
    expectAFrame(peer);
    EXPECT_EQ(peer.link().skipped(), 2U + 6U);
}

TEST(SlcanLink, OpeningIsInterrupted)
{
    SlcanPeer peer(QStringLiteral("--late 100000"));
    const std::jthread other([&] { peer.link().interrupt(); });
    const auto stopped = peer.link().open(CanUse::watch);
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().kind, RefusalKind::stopped);
}

TEST(SlcanLink, AnOpeningThatWasInterruptedGoesOn)
{
    SlcanPeer peer(QStringLiteral("--late 100")); // ms
    int interruptions = 0;
    const std::jthread other([&](const std::stop_token &token) {
        for (; !token.stop_requested(); std::this_thread::sleep_for(50ms))
            peer.link().interrupt();
    });
    Result<void> opened = peer.link().open(CanUse::operate);
    for (; !opened && interruptions < 100; ++interruptions)
        opened = peer.link().open(CanUse::operate);
    EXPECT_TRUE(opened) << "each answer takes longer than it is from one interruption to the next";
    EXPECT_GT(interruptions, 3);
}

TEST(SlcanLink, AnAdapterThatIsUnpluggedIsTold)
{
    SlcanPeer peer;
    ASSERT_TRUE(peer.link().open(CanUse::watch));
    peer.unplug();
    const auto gone = peer.link().receive(peer.link().now() + 1h);
    ASSERT_FALSE(gone);
    EXPECT_EQ(gone.error().id, RefusalId::portLost);
    EXPECT_EQ(peer.link().status().state, CanState::notKnown);
}

} // namespace
} // namespace codewheel
