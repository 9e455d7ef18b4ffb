// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "tests/kinds/interbus/gateway/gateway_ring.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace test;
using namespace std::chrono_literals;

class GatewayLinkTest : public testing::Test
{
protected:
    void make(int devices, const GatewaySettings &settings = {})
    {
        link = std::make_unique<GatewayLink>(std::make_unique<RegisterBankPort>(bank), settings,
                                             k3Ring(devices));
        in.assign(static_cast<std::size_t>(devices), 0);
        out = in;
    }
    void makeOpen(int devices, const GatewaySettings &settings = {})
    {
        make(devices, settings);
        ASSERT_TRUE(link->open());
    }
    void setOut(int device, Word word)
    {
        bank->holding[2 * device] = static_cast<Register>(word >> 16);
        bank->holding[2 * device + 1] = static_cast<Register>(word);
    }

    std::shared_ptr<RegisterBank> bank = std::make_shared<RegisterBank>();
    std::unique_ptr<GatewayLink> link;
    std::vector<Word> in;
    std::vector<Word> out;
};

TEST_F(GatewayLinkTest, ConnectingAndWatchingWriteNothing)
{
    makeOpen(3);
    ASSERT_TRUE(link->readBackOut());
    for (int i = 0; i < 100; ++i)
        ASSERT_TRUE(link->watch(out, in));
    EXPECT_EQ(bank->writes, 0);
}

TEST_F(GatewayLinkTest, WatchShowsWhatSomebodyElseWrites)
{
    makeOpen(2);
    setOut(1, 0x0200'00FF);
    ASSERT_TRUE(link->watch(out, in));
    ASSERT_TRUE(link->watch(out, in));
    EXPECT_EQ(out, (std::vector<Word>{0, 0x0200'00FF}));
}

// Its OUT words take two writes.
TEST_F(GatewayLinkTest, WhatAnInterruptedExchangeDidNotWriteIsNotSomebodyElses)
{
    makeOpen(70);
    out.assign(70, 0x0200'00FF);
    bank->onWrite = [this] {
        if (bank->writes == 1)
            link->interrupt();
    };
    const auto interrupted = link->exchange(out, in);
    ASSERT_FALSE(interrupted);
    EXPECT_EQ(interrupted.error().kind, RefusalKind::stopped);
    EXPECT_TRUE(link->exchange(out, in));
    EXPECT_EQ(link->readBackOut(), out);
}

// 140 registers of OUT; no test of the connection can find that out, since it writes nothing.
TEST_F(GatewayLinkTest, AGatewayThatTakesFewRegistersInOneWriteGetsFewer)
{
    makeOpen(70);
    ASSERT_TRUE(link->readBackOut());
    bank->mostWritten = 30;
    out.assign(70, 0x0200'00FF);
    ASSERT_TRUE(link->exchange(out, in));
    EXPECT_EQ(link->readBackOut(), out);
    const int writes = bank->writes;
    EXPECT_EQ(link->sendZeros(in).value().areThere, std::optional(true));
    EXPECT_LE(bank->writes - writes, 140 / 15 + 1) << "it has learned it";
}

TEST_F(GatewayLinkTest, ZerosAreToo)
{
    makeOpen(70);
    out.assign(70, 0x0200'00FF);
    ASSERT_TRUE(link->readBackOut() && link->exchange(out, in));
    bank->mostWritten = 100;
    EXPECT_EQ(link->sendZeros(in).value().areThere, std::optional(true));
}

TEST_F(GatewayLinkTest, AForeignWordIsNamedAndNotOverwritten)
{
    makeOpen(2);
    out = {0x0200'00FF, 0};
    ASSERT_TRUE(link->exchange(out, in));
    setOut(1, 0x8000'0000);
    const int writes = bank->writes;
    const auto exchanged = link->exchange(out, in);
    ASSERT_FALSE(exchanged);
    EXPECT_EQ(exchanged.error(), (Refusal{RefusalKind::busy,
                                          GatewayRefusalId::outNotOurs,
                                          {QStringLiteral("2.0"), Word{0}, Word{0x8000'0000}}}));
    EXPECT_EQ(bank->writes, writes);
    EXPECT_EQ(link->readBackOut(), (std::vector<Word>{0x0200'00FF, 0x8000'0000}));
}

// The connection ends with a write: before it is sent, or with its answer.
class PortThatClosesAtAWrite final : public RegisterBankPort
{
public:
    struct Next
    {
        std::optional<RegisterError> failure{};
        Word puts = 0; // in OUT of the first device meanwhile
    };
    PortThatClosesAtAWrite(const std::shared_ptr<RegisterBank> &bank, Next &next)
        : RegisterBankPort(bank)
        , m_next(next)
    {}
    Done write(int first, std::span<const Register> from) override
    {
        if (!m_next.failure)
            return RegisterBankPort::write(first, from);
        bank().holding[0] = static_cast<Register>(m_next.puts >> 16);
        bank().holding[1] = static_cast<Register>(m_next.puts);
        return tl::unexpected(*std::exchange(m_next.failure, std::nullopt));
    }

private:
    Next &m_next;
};

class GatewayThatCloses : public GatewayLinkTest
{
protected:
    // What an exchange ends with whose write fails like this, with `there` in OUT of the first device then.
    Result<void> exchangeFailing(const RegisterError &error, Word there)
    {
        in.assign(1, 0);
        out.assign(1, before);
        link = std::make_unique<GatewayLink>(std::make_unique<PortThatClosesAtAWrite>(bank, next),
                                             GatewaySettings{}, k3Ring(1));
        EXPECT_TRUE(link->open());
        EXPECT_TRUE(link->exchange(out, in));
        out = {run};
        next = {error, there};
        return link->exchange(out, in);
    }

    static constexpr Word before = 0x0200'00FF;
    static constexpr Word run = 0x8000'0000;
    PortThatClosesAtAWrite::Next next;
};

TEST_F(GatewayThatCloses, AWriteThatWasNotSentIsSentAgainThoughTheWordBeforeItIsThere)
{
    EXPECT_TRUE(exchangeFailing({.kind = RegisterError::Kind::closed, .isSent = false}, before));
    EXPECT_EQ(link->readBackOut(), (std::vector<Word>{run}));
}

TEST_F(GatewayThatCloses, AWriteThatWasNotSentGivesWayToSomebodyElse)
{
    const auto done = exchangeFailing({.kind = RegisterError::Kind::closed, .isSent = false}, 0x0100'0001);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().id, GatewayRefusalId::outNotOurs);
}

// It may have acted: that is not told as if nothing had been sent.
TEST_F(GatewayThatCloses, AWriteWithoutAnAnswerStaysInDoubtWhateverIsThere)
{
    const auto done = exchangeFailing({.kind = RegisterError::Kind::noAnswer}, 0x0100'0001);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().id, GatewayRefusalId::registersUnanswered);
    EXPECT_EQ(done.error().kind, RefusalKind::link);
}

TEST_F(GatewayLinkTest, WhatIsOnTheGatewayWhenConnectingCountsAsOurs)
{
    setOut(0, 0x8000'0000);
    makeOpen(1);
    out = link->readBackOut().value();
    EXPECT_EQ(out, std::vector<Word>{0x8000'0000});
    EXPECT_TRUE(link->exchange(out, in));
    setOut(0, 0);
    EXPECT_FALSE(link->exchange(out, in));
}

TEST_F(GatewayLinkTest, ZerosGoOutWhateverIsThereAndAreReadBack)
{
    makeOpen(2);
    ASSERT_TRUE(link->readBackOut());
    setOut(1, 0x8000'0000);
    EXPECT_EQ(link->sendZeros(in).value().areThere, std::optional(true));
    EXPECT_EQ(link->readBackOut(), std::vector<Word>(2));
    bank->onWrite = [this] { setOut(1, 0x8000'0000); };
    const auto overwritten = link->sendZeros(in).value();
    EXPECT_EQ(overwritten.areThere, std::optional(false));
    EXPECT_EQ(overwritten.notZero, QStringLiteral("2.0 80000000 (register 2)"));
}

TEST_F(GatewayLinkTest, ZerosThatCannotBeReadBackAreNotSaidToHaveArrived)
{
    makeOpen(1, {.readsBack = false});
    EXPECT_EQ(link->sendZeros(in).value().areThere, std::optional<bool>());
    EXPECT_EQ(bank->writes, 1);
}

TEST_F(GatewayLinkTest, AGatewayThatDoesNotTellOutWorksWithoutIt)
{
    bank->holdingEnd = 0;
    makeOpen(1);
    const auto back = link->readBackOut();
    ASSERT_FALSE(back);
    EXPECT_EQ(back.error().id, GatewayRefusalId::outNotReadBack);
    EXPECT_TRUE(link->watch(out, in));
}

// What could not be read back is not overwritten with zeros: somebody else may have set it.
TEST_F(GatewayLinkTest, AnOutAreaThatIsShorterThanTheRingIsRefused)
{
    for (const int devices : {70, 50, 2}) { // two reads, one read, one register
        bank->holdingEnd = 2 * devices - 1;
        bank->writes = 0;
        makeOpen(devices);
        const auto back = link->readBackOut();
        ASSERT_FALSE(back);
        EXPECT_EQ(back.error().id, GatewayRefusalId::outAreaTooShort);
        EXPECT_EQ(bank->writes, 0);
    }
}

// The zeros of an ALARM STOP go to whatever there is.
TEST_F(GatewayLinkTest, ZerosReachTheDevicesOfAnOutAreaThatEndsTooEarly)
{
    bank->holdingEnd = 4;
    makeOpen(3);
    setOut(0, 0x0200'00FF);
    setOut(1, 0x8000'0000);
    EXPECT_FALSE(link->sendZeros(in)) << "not to all";
    for (int i = 0; i < bank->holdingEnd; ++i)
        EXPECT_EQ(bank->holding[i], 0) << "register " << i;
}

TEST_F(GatewayLinkTest, ZerosOverALostLinkReachTheDevicesOfAnOutAreaThatEndsTooEarly)
{
    bank->holdingEnd = 4;
    makeOpen(3);
    setOut(0, 0x0200'00FF);
    setOut(1, 0x8000'0000);
    EXPECT_TRUE(link->sendZerosUnheard());
    for (int i = 0; i < bank->holdingEnd; ++i)
        EXPECT_EQ(bank->holding[i], 0) << "register " << i;
}

// Some outputs may be blocked, and not the others.
TEST_F(GatewayLinkTest, ZerosRefusedAsABlockAreTriedDeviceByDevice)
{
    for (const int code : {4, 6})
        for (const bool isUnheard : {false, true}) {
            bank->blockException = code;
            makeOpen(3);
            for (int i = 0; i < 3; ++i)
                setOut(i, 0x8000'0000);
            if (isUnheard)
                EXPECT_TRUE(link->sendZerosUnheard());
            else
                EXPECT_EQ(link->sendZeros(in).value().areThere, true);
            EXPECT_TRUE(link->sentZeros().acknowledgedAt);
            for (int i = 0; i < 6; ++i)
                EXPECT_EQ(bank->holding[i], 0) << "register " << i << ", exception " << code;
        }
}

TEST_F(GatewayLinkTest, ABusyGatewayIsWaitedForUntilThePatienceEnds)
{
    for (const int code : {5, 6, 10, 11}) {
        bank->busyCode = code;
        bank->busyUntil = {};
        makeOpen(1);
        ASSERT_TRUE(link->readBackOut());
        bank->busyUntil = link->now() + 1900ms;
        EXPECT_TRUE(link->exchange(out, in)) << code;
        EXPECT_GE(link->now(), bank->busyUntil);
        const auto retries = link->figures()->retries;
        EXPECT_LE(retries, 10U) << "not one after the other";
        bank->busyUntil = link->now() + 1h;
        const Instant begun = link->now();
        const auto exchanged = link->exchange(out, in);
        ASSERT_FALSE(exchanged);
        EXPECT_EQ(exchanged.error().id, GatewayRefusalId::registersRefused);
        EXPECT_GE(link->now() - begun, 2s);
        EXPECT_LT(link->now() - begun, 2200ms);
    }
}

TEST_F(GatewayLinkTest, AnImageThatIsTooShortIsNoticedWhenConnecting)
{
    bank->inputEnd = 5;
    make(3);
    const auto opened = link->open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().id, GatewayRefusalId::registersRefused);
}

TEST_F(GatewayLinkTest, WithoutDevicesThereIsNothingToExchange)
{
    make(0);
    const auto opened = link->open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().id, GatewayRefusalId::gatewayHasNoDevices);
}

TEST_F(GatewayLinkTest, AWordThatNeverAgreesIsNotUpToDate)
{
    makeOpen(1);
    for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(link->watch(out, in));
    EXPECT_TRUE(link->isUpToDate(0));
    struct Restless final : RegisterBankPort
    {
        using RegisterBankPort::RegisterBankPort;
        Done read(RegisterArea area, int first, std::span<Register> to) override
        {
            bank().input[0] = static_cast<Register>(0xC000 + ++count % 100);
            return RegisterBankPort::read(area, first, to);
        }
        int count = 0;
    };
    GatewayLink restless(std::make_unique<Restless>(bank), {}, k3Ring(1));
    ASSERT_TRUE(restless.open());
    for (int i = 0; i < 200; ++i)
        ASSERT_TRUE(restless.watch(out, in));
    EXPECT_FALSE(restless.isUpToDate(0));
    EXPECT_GE(restless.figures()->tornWords, 9u);
}

TEST_F(GatewayLinkTest, ExchangesAreAnIntervalApart)
{
    makeOpen(1, {.pollInterval = std::chrono::milliseconds(50)});
    const Instant begun = link->now();
    ASSERT_TRUE(link->watch(out, in));
    int turns = 0;
    for (; !link->isDue(); ++turns)
        link->wait(link->now() + std::chrono::milliseconds(10));
    EXPECT_GE(turns, 4) << "turns are shorter";
    EXPECT_GE(link->now() - begun, std::chrono::milliseconds(50));
    EXPECT_LE(link->now() - begun, std::chrono::milliseconds(51));
}

} // namespace
} // namespace codewheel
