// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_refusals.h"
#include "links/socket_can_link.h"
#include "tests/links/bench_can_device.h"
#include "vocabulary/refusal_text.h"

#include <QTimer>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::BenchCanBus;
using test::BenchCanDevice;

class SocketCan : public testing::Test
{
protected:
    Refusal refusalOf(CanUse use)
    {
        const auto opened = m_link.open(use);
        EXPECT_FALSE(opened);
        return opened ? Refusal{} : opened.error();
    }
    void operate() { ASSERT_TRUE(m_link.open(CanUse::operate)); }
    CanNews news(Instant patience = 1h)
    {
        const auto got = m_link.receive(m_link.now() + patience);
        EXPECT_TRUE(got);
        return got.value_or(CanNews());
    }
    bool send(std::uint32_t id) { return m_link.send({.id = id}).value_or(false); }
    CanStatus &told() { return m_bus->interface->status; }
    BenchCanDevice &device() { return *m_bus->device; }

    std::shared_ptr<BenchCanBus> m_bus = std::make_shared<BenchCanBus>();
    bool m_hasPlugin = true;
    SocketCanLink m_link{
        QStringLiteral("can7"),
        [this](const QString &) { return m_hasPlugin ? std::make_unique<BenchCanDevice>(m_bus) : nullptr; },
        [this](const QString &) { return m_bus->interface; }};
};

using SocketCanFates = std::vector<CanFate>;

TEST_F(SocketCan, WatchesWhatListensOnlyAndNothingElseUnasked)
{
    EXPECT_EQ(refusalText(refusalOf(CanUse::watch)).toStdString(),
              "can7 is not set to listen only, so it acknowledges what others send. Set it so with \"sudo ip "
              "link set can7 down && sudo ip link set can7 up type can bitrate 125000 listen-only on\", or "
              "agree that it acknowledges. Nothing was opened.");
    told().listensOnly = false;
    EXPECT_EQ(refusalOf(CanUse::watch).id, CanRefusalId::watchNotSure);
    EXPECT_EQ(m_bus->device, nullptr);
    told().listensOnly = true;
    EXPECT_TRUE(m_link.open(CanUse::watch));
    EXPECT_EQ(m_link.status(), (CanStatus{.rate = 125'000, .listensOnly = true}));
    told().listensOnly = false;
    m_link.takeUnsureWatch();
    EXPECT_TRUE(m_link.open(CanUse::watch));
    EXPECT_EQ(m_link.status().listensOnly, false);
}

TEST_F(SocketCan, SaysWhyItDoesNotOpen)
{
    m_hasPlugin = false;
    EXPECT_EQ(refusalOf(CanUse::operate).id, CanRefusalId::pluginMissing);
    m_hasPlugin = true;
    m_bus->openError = EAFNOSUPPORT;
    EXPECT_EQ(refusalOf(CanUse::operate).id, CanRefusalId::notInKernel);
    m_bus->openError = ENODEV;
    EXPECT_EQ(refusalOf(CanUse::operate).id, CanRefusalId::interfaceMissing);
    m_bus->openError = EPERM;
    EXPECT_EQ(refusalOf(CanUse::operate).id, RefusalId::linkFailed);
    m_bus->interface->isUp = false;
    EXPECT_EQ(
        refusalText(refusalOf(CanUse::operate)).toStdString(),
        "The CAN interface can7 is switched off. Switch it on with the rate of the bus: sudo ip link set "
        "can7 up type can bitrate 250000");
    m_bus->interface.reset();
    EXPECT_EQ(refusalOf(CanUse::operate).id, CanRefusalId::interfaceMissing);
}

TEST_F(SocketCan, AFrameIsDoneWhenItComesBack)
{
    operate();
    m_bus->isAcknowledged = false;
    EXPECT_TRUE(send(0x101));
    EXPECT_TRUE(send(0x102));
    EXPECT_TRUE(news(5ms).fates.empty());
    device().echo(m_bus->written[1]);
    EXPECT_TRUE(news(5ms).fates.empty()) << "the first is still waiting";
    device().echo(m_bus->written[0]);
    const CanNews both = news();
    EXPECT_EQ(both.fates, (SocketCanFates{CanFate::done, CanFate::done}));
    EXPECT_TRUE(both.frames.empty()) << "own frames are not received";
}

TEST_F(SocketCan, WhatNeverComesBackIsNotKnown)
{
    operate();
    m_bus->isAcknowledged = false;
    EXPECT_TRUE(send(0x101));
    SocketCanFates fates;
    while (fates.empty())
        fates = news(50ms).fates;
    EXPECT_EQ(fates, SocketCanFates{CanFate::notKnown});
}

TEST_F(SocketCan, ADriverThatDoesNotConfirmLeavesItUnknown)
{
    m_bus->interface->isConfirming = false;
    operate();
    EXPECT_TRUE(send(0x101));
    EXPECT_EQ(news().fates, SocketCanFates{CanFate::notKnown});
}

TEST_F(SocketCan, AFullQueueIsNoError)
{
    operate();
    m_bus->writeError = ENOBUFS;
    const auto full = m_link.send({.id = 0x101});
    ASSERT_TRUE(full);
    EXPECT_FALSE(*full);
    m_bus->writeError = 0;
    EXPECT_TRUE(send(0x101));
    m_bus->writeError = EINVAL;
    EXPECT_EQ(m_link.send({.id = 0x101}).error().id, RefusalId::linkFailed);
}

TEST_F(SocketCan, ErrorFramesTellTheState)
{
    const struct
    {
        QCanBusFrame::FrameError error;
        QByteArray details;
        CanState state;
    } table[] = {
        {QCanBusFrame::ControllerError, QByteArray("\0\x04", 2), CanState::warning},
        {QCanBusFrame::ControllerError, QByteArray("\0\x20", 2), CanState::passive},
        {QCanBusFrame::ControllerError, QByteArray("\0\x40", 2), CanState::active},
        {QCanBusFrame::BusError, {}, CanState::active},
        {QCanBusFrame::BusOffError, {}, CanState::busOff},
        {QCanBusFrame::ControllerRestartError, {}, CanState::active},
    };
    operate();
    for (const auto &row : table) {
        device().bringError(row.error, row.details);
        const auto frames = news().frames;
        ASSERT_EQ(frames.size(), 1U);
        EXPECT_TRUE(frames[0].isError);
        EXPECT_EQ(frames[0].id, static_cast<std::uint32_t>(row.error));
        EXPECT_EQ(m_link.status().state, row.state);
    }
    device().bringError(QCanBusFrame::UnknownError, QByteArray("\0\0\0\0\0\0\x80\x07", 8));
    news();
    EXPECT_EQ(m_link.status().transmitErrors, 128);
    EXPECT_EQ(m_link.status().receiveErrors, 7);
}

TEST_F(SocketCan, AfterBusOffNothingIsSent)
{
    operate();
    m_bus->isAcknowledged = false;
    EXPECT_TRUE(send(0x101));
    device().bringError(QCanBusFrame::BusOffError, {});
    EXPECT_EQ(news().fates, SocketCanFates{CanFate::notKnown});
    const auto refused = m_link.send({.id = 0x101});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error(),
              (Refusal{RefusalKind::link,
                       CanRefusalId::busOff,
                       {QStringLiteral("can7"), QStringLiteral("sudo ip link set can7 type can restart")}}));
}

TEST_F(SocketCan, WhatIsOffTheBusIsNotOpened)
{
    told() = {.state = CanState::busOff};
    const auto opened = m_link.open(CanUse::operate);
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().id, CanRefusalId::busOff);
    told() = {.state = CanState::active};
    EXPECT_TRUE(m_link.open(CanUse::operate));
}

TEST_F(SocketCan, WhatTheSystemSaysOfTheStateIsTaken)
{
    operate();
    told() = {.state = CanState::passive, .transmitErrors = 130, .rate = 125'000};
    while (m_link.status().state != CanState::passive)
        news(50ms);
    EXPECT_EQ(m_link.status().transmitErrors, 130);
}

TEST_F(SocketCan, AnInterfaceThatGoesOrIsSwitchedOffIsLost)
{
    for (const bool goes : {true, false}) {
        m_bus->interface = CanInterface{.name = QStringLiteral("can7"), .isUp = true};
        operate();
        if (goes)
            m_bus->interface.reset();
        else
            m_bus->interface->isUp = false;
        const auto lost = m_link.receive(m_link.now() + 1h);
        ASSERT_FALSE(lost);
        EXPECT_EQ(lost.error().id, CanRefusalId::interfaceLost);
        EXPECT_EQ(m_link.receive(m_link.now() + 1h).error().id, RefusalId::lineClosed);
    }
    for (const int error : {ENETDOWN, ENXIO, ENODEV}) {
        m_bus->interface = CanInterface{.name = QStringLiteral("can7"), .isUp = true};
        m_bus->writeError = error;
        operate();
        EXPECT_EQ(m_link.send({.id = 0x101}).error().id, CanRefusalId::interfaceLost);
    }
}

TEST_F(SocketCan, FramesWakeItAndHaveTheirTime)
{
    operate();
    const Instant before = m_link.now();
    QTimer::singleShot(20ms, m_bus->device, [this] {
        QCanBusFrame frame(0x705, QByteArray("\x05", 1));
        device().bring(frame);
    });
    const auto frames = news().frames;
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].interface, "can7");
    EXPECT_GE(*frames[0].time, before);
    EXPECT_LE(*frames[0].time, m_link.now());
}

TEST_F(SocketCan, FramesOfCanFdAreNone)
{
    operate();
    QCanBusFrame longer(0x705, QByteArray(12, 'x'));
    longer.setFlexibleDataRateFormat(true);
    device().bring(longer);
    EXPECT_TRUE(news(5ms).frames.empty());
}

// The real plugin, at a name that no interface has.
TEST(SocketCanPlugin, IsThere)
{
    EXPECT_TRUE(socketCanDevice(QStringLiteral("can-none")));
    SocketCanLink link(QStringLiteral("can-none"));
    EXPECT_EQ(link.open(CanUse::operate).error().id, CanRefusalId::interfaceMissing);
}

} // namespace
} // namespace codewheel
