// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "can/can_link.h"

#include <functional>
#include <gtest/gtest.h>
#include <memory>
#include <thread>

namespace codewheel::test {

// A link to a CAN bus, and a peer on that bus.
class CanBench
{
public:
    virtual ~CanBench() = default;
    virtual CanLink &link() = 0;
    virtual void peerSends(const CanFrame &frame) = 0;
    // What the link has sent since the last call, as far as it has arrived.
    virtual std::vector<CanFrame> peerHeard() = 0;
    // Whether what the link sends is taken: else it waits in its queue.
    virtual void setPeerThere(bool there) = 0;
    virtual void makeBusOff() = 0;
    virtual void unplug() = 0;
};

// A kind of link that must fulfil the contract of CanLink.
struct CanLinkUnderTest
{
    const char *name;
    std::function<std::unique_ptr<CanBench>()> make; // its link closed
    CanFate fate = CanFate::done;                    // of what it has sent
    bool mayFillUp = true;                           // its queue can be full
    bool tellsBusOff = true;
};

// The contract. Include in one file of a test program, and there:
// INSTANTIATE_TEST_SUITE_P(Simulated, CanLinkContract, testing::Values(CanLinkUnderTest{...}));
// Anything timed waits for its event, for up to an hour.
class CanLinkContract : public testing::TestWithParam<CanLinkUnderTest>
{
protected:
    static constexpr std::chrono::hours patience{1};

    CanLink &link() { return m_bench->link(); }
    void open(CanUse use)
    {
        if (use == CanUse::watch)
            link().takeUnsureWatch();
        const auto opened = link().open(use);
        ASSERT_TRUE(opened) << static_cast<int>(opened.error().kind);
    }
    // Receives until `isEnough`. Errors are left out.
    template <typename Enough>
    CanNews receiveUntil(Enough isEnough)
    {
        CanNews all;
        for (const Instant end = link().now() + patience; !isEnough(all) && link().now() < end;) {
            const auto news = link().receive(end);
            if (!news) {
                ADD_FAILURE() << "refused";
                break;
            }
            for (const CanFrame &frame : news->frames)
                if (!frame.isError)
                    all.frames.push_back(frame);
            all.fates.insert(all.fates.end(), news->fates.begin(), news->fates.end());
        }
        return all;
    }
    std::vector<CanFrame> receiveFrames(std::size_t count)
    {
        return receiveUntil([=](const CanNews &all) { return all.frames.size() >= count; }).frames;
    }
    std::vector<CanFate> receiveFates(std::size_t count)
    {
        return receiveUntil([=](const CanNews &all) { return all.fates.size() >= count; }).fates;
    }
    std::vector<CanFrame> peerHeard(std::size_t count)
    {
        std::vector<CanFrame> all;
        for (const Instant end = link().now() + patience; all.size() < count && link().now() < end;) {
            link().wait(link().now() + std::chrono::milliseconds(1));
            for (const CanFrame &frame : m_bench->peerHeard())
                all.push_back(frame);
        }
        return all;
    }

    std::unique_ptr<CanBench> m_bench = GetParam().make();
};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(CanLinkContract);

inline void PrintTo(const CanLinkUnderTest &link, std::ostream *stream)
{
    *stream << link.name;
}

// Of every form a frame can have.
inline std::vector<CanFrame> framesOfAllForms()
{
    return {
        {.id = 0x000, .length = 2, .bytes = {0x01, 0x05}},
        {.id = 0x080},
        {.id = 0x605, .length = 8, .bytes = {0x40, 0x18, 0x10, 0x01, 0x00, 0xFF, 0x0D, 0x07}},
        {.id = 0x705, .isRemote = true, .length = 1},
        {.id = 0x7FF, .length = 1, .bytes = {0x7F}},
        {.id = 0x0000'0012, .isExtended = true, .length = 1, .bytes = {0x12}},
        {.id = 0x0CFF'E0E0, .isExtended = true, .length = 3, .bytes = {1, 2, 3}},
        {.id = 0x1FFF'FFFF, .isExtended = true, .isRemote = true},
    };
}

// Without what is told of its way.
inline std::vector<CanFrame> bare(std::vector<CanFrame> frames)
{
    for (CanFrame &frame : frames) {
        frame.time.reset();
        frame.interface.clear();
    }
    return frames;
}

template <typename T>
RefusalKind refusalKindOf(const Result<T> &result)
{
    return result ? RefusalKind::badInput : result.error().kind; // no link is refused with that here
}

TEST_P(CanLinkContract, AClosedBusRefusesAll)
{
    EXPECT_EQ(refusalKindOf(link().receive(link().now() + patience)), RefusalKind::link);
    EXPECT_EQ(refusalKindOf(link().send({.id = 0x080})), RefusalKind::link);
    EXPECT_EQ(link().status().state, CanState::notKnown);
    EXPECT_FALSE(link().name().isEmpty());
    link().close(); // does no harm
}

TEST_P(CanLinkContract, BringsFramesOfEveryFormWithTheirTime)
{
    for (const CanUse use : {CanUse::watch, CanUse::operate}) {
        open(use);
        const Instant before = link().now();
        for (const CanFrame &frame : framesOfAllForms())
            m_bench->peerSends(frame);
        const std::vector<CanFrame> received = receiveFrames(framesOfAllForms().size());
        EXPECT_EQ(bare(received), framesOfAllForms());
        Instant last = before - std::chrono::milliseconds(1); // as an adapter counts
        for (const CanFrame &frame : received) {
            ASSERT_TRUE(frame.time);
            EXPECT_GE(*frame.time, last);
            EXPECT_LE(*frame.time, link().now());
            last = *frame.time;
        }
    }
}

TEST_P(CanLinkContract, SendsFramesOfEveryFormInTheirOrder)
{
    open(CanUse::operate);
    std::size_t sent = 0;
    for (const CanFrame &frame : framesOfAllForms())
        sent += link().send(frame).value_or(false) ? 1 : 0;
    EXPECT_EQ(sent, framesOfAllForms().size());
    EXPECT_EQ(receiveFates(sent), std::vector<CanFate>(sent, GetParam().fate));
    EXPECT_EQ(bare(peerHeard(sent)), framesOfAllForms());
}

TEST_P(CanLinkContract, OpeningSendsNothing)
{
    for (const CanUse use : {CanUse::operate, CanUse::watch, CanUse::operate}) {
        open(use);
        link().wait(link().now() + std::chrono::milliseconds(5));
    }
    link().close();
    EXPECT_TRUE(m_bench->peerHeard().empty());
}

TEST_P(CanLinkContract, InWatchNothingIsSent)
{
    open(CanUse::watch);
    const auto sent = link().send({.id = 0x000, .length = 2, .bytes = {0x80, 0x00}});
    EXPECT_EQ(refusalKindOf(sent), RefusalKind::link);
    link().wait(link().now() + std::chrono::milliseconds(5));
    open(CanUse::operate);
    link().wait(link().now() + std::chrono::milliseconds(5));
    EXPECT_TRUE(m_bench->peerHeard().empty()) << "nor later";
}

TEST_P(CanLinkContract, ReceivingEndsWithItsTime)
{
    open(CanUse::watch);
    const Instant before = link().now();
    const auto nothing = link().receive(before + std::chrono::milliseconds(2));
    ASSERT_TRUE(nothing);
    EXPECT_TRUE(nothing->frames.empty());
    EXPECT_GE(link().now(), before + std::chrono::milliseconds(2));
    EXPECT_TRUE(link().receive(before)) << "at once";
}

TEST_P(CanLinkContract, WhatLayThereIsDroppedWhenItIsOpened)
{
    open(CanUse::watch);
    m_bench->peerSends({.id = 0x705, .length = 1, .bytes = {0x05}});
    link().wait(link().now() + std::chrono::milliseconds(20));
    open(CanUse::watch);
    m_bench->peerSends({.id = 0x706, .length = 1, .bytes = {0x05}});
    const std::vector<CanFrame> received = receiveFrames(1);
    ASSERT_EQ(received.size(), 1U);
    EXPECT_EQ(received[0].id, 0x706U);
}

TEST_P(CanLinkContract, ItsTimeNeverGoesBack)
{
    using namespace std::chrono_literals;
    const Instant first = link().now();
    EXPECT_GE(first, 0us);
    link().wait(first + 5ms); // closed
    const Instant waited = link().now();
    EXPECT_GE(waited, first + 5ms);
    open(CanUse::watch);
    EXPECT_GE(link().now(), waited);
    link().wait(link().now() + 5ms);
    const Instant opened = link().now();
    EXPECT_GE(opened, waited + 5ms);
    link().close();
    open(CanUse::operate);
    EXPECT_GE(link().now(), opened);
}

TEST_P(CanLinkContract, InterruptEndsTheNextReceiveOrWaitEarly)
{
    open(CanUse::watch);
    link().interrupt();
    const auto interrupted = link().receive(link().now() + patience);
    ASSERT_TRUE(interrupted);
    EXPECT_TRUE(interrupted->frames.empty());
    m_bench->peerSends({.id = 0x705, .length = 1, .bytes = {0x05}});
    EXPECT_EQ(receiveFrames(1).size(), 1U) << "nothing was lost";
    link().close();
    const std::jthread other([&] { link().interrupt(); });
    link().wait(link().now() + patience);
}

TEST_P(CanLinkContract, AFullQueueSaysSoAndLosesNothing)
{
    if (!GetParam().mayFillUp)
        GTEST_SKIP() << "it takes what it is given";
    open(CanUse::operate);
    m_bench->setPeerThere(false);
    std::vector<CanFrame> taken;
    for (std::uint32_t i = 0; i < 100'000; ++i) {
        const CanFrame frame{.id = 0x100 + i % 0x100, .length = 1, .bytes = {static_cast<std::uint8_t>(i)}};
        const auto sent = link().send(frame);
        ASSERT_TRUE(sent);
        if (!*sent)
            break;
        taken.push_back(frame);
    }
    ASSERT_LT(taken.size(), 100'000U);
    EXPECT_GT(taken.size(), 0U);
    m_bench->setPeerThere(true);
    EXPECT_EQ(receiveFates(taken.size()), std::vector<CanFate>(taken.size(), GetParam().fate));
    EXPECT_EQ(bare(peerHeard(taken.size())), taken);
    EXPECT_TRUE(link().send({.id = 0x080}).value_or(false));
    EXPECT_EQ(receiveFates(1).size(), 1U);
}

TEST_P(CanLinkContract, BusOffIsToldAndEndsWithOpening)
{
    if (!GetParam().tellsBusOff)
        GTEST_SKIP() << "it is never told";
    open(CanUse::operate);
    m_bench->makeBusOff();
    for (const Instant end = link().now() + patience;
         link().status().state != CanState::busOff && link().now() < end;)
        ASSERT_TRUE(link().receive(link().now() + std::chrono::milliseconds(10)));
    const auto sent = link().send({.id = 0x080});
    if (sent) {
        EXPECT_EQ(receiveFates(1), std::vector{CanFate::refused});
    }
    EXPECT_TRUE(m_bench->peerHeard().empty());
    open(CanUse::operate);
    EXPECT_NE(link().status().state, CanState::busOff);
    EXPECT_TRUE(link().send({.id = 0x080}).value_or(false));
    EXPECT_EQ(receiveFates(1), std::vector{GetParam().fate});
}

TEST_P(CanLinkContract, AnAdapterThatIsGoneIsToldAndDoesNotOpen)
{
    open(CanUse::watch);
    const QString name = link().name();
    m_bench->unplug();
    EXPECT_EQ(refusalKindOf(link().receive(link().now() + patience)), RefusalKind::link);
    EXPECT_EQ(refusalKindOf(link().receive(link().now() + patience)), RefusalKind::link);
    EXPECT_EQ(refusalKindOf(link().send({.id = 0x080})), RefusalKind::link);
    EXPECT_EQ(refusalKindOf(link().open(CanUse::watch)), RefusalKind::link);
    EXPECT_EQ(link().name(), name);
}

} // namespace codewheel::test
