// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_refusals.h"
#include "replay/can_log_link.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class CanLogOnDisk : public testing::Test
{
protected:
    QString put(const QByteArray &text)
    {
        const QString path = m_folder.filePath(QStringLiteral("bus.log"));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        return path;
    }
    QString putBus()
    {
        return put("(1544106679.000000) can0 705#7F\n"
                   "(1544106679.000500) can1 100#\n"
                   "(1544106679.500000) can0 185#88130000\n"
                   "(1544106679.400000) can0 185#89130000\n" // out of order
                   "nonsense\n"
                   "(1544106681.000000) can0 12345678#\n");
    }
    RefusalCode refusalOf(const QByteArray &text, const std::string &interface = {})
    {
        const auto looked = CanLog(put(text), interface).look();
        EXPECT_FALSE(looked);
        return looked ? RefusalCode(RefusalId::cancelled) : looked.error().id;
    }

    QTemporaryDir m_folder;
};

TEST_F(CanLogOnDisk, TellsWhatIsInIt)
{
    const auto looked = CanLog(putBus()).look();
    ASSERT_TRUE(looked);
    EXPECT_EQ(looked->interface, "can0");
    EXPECT_EQ(looked->frames, 4);
    EXPECT_EQ(looked->otherFrames, 1);
    EXPECT_EQ(looked->faults, 1);
    EXPECT_TRUE(looked->isSince1970);
    EXPECT_EQ(looked->length(), 2s);
    EXPECT_EQ(looked->identifiers, (std::set<std::uint32_t>{0x185, 0x705}));
}

TEST_F(CanLogOnDisk, SaysWhyItCannotBeTaken)
{
    EXPECT_EQ(refusalOf("nonsense\n"), CanRefusalId::logEmpty);
    EXPECT_EQ(refusalOf("  can0  185   [1]  88\n"), CanRefusalId::logHasNoTimes);
    EXPECT_EQ(refusalOf("(1544106679.000000) can0 185#88\n", "can1"), CanRefusalId::logHasNotThat);
    EXPECT_EQ(CanLog(m_folder.filePath(QStringLiteral("none"))).look().error().id,
              RefusalId::fileNotReadable);
}

TEST_F(CanLogOnDisk, WhatWasReceivedComesAgainAtItsTime)
{
    CanLogLink link(putBus(), {});
    ASSERT_TRUE(link.open(CanUse::watch));
    EXPECT_TRUE(link.receive(0s)->frames.empty()) << "nobody is there yet";
    EXPECT_EQ(link.receive(1s)->frames.front().id, 0x705U);
    EXPECT_TRUE(link.receive(100ms)->frames.empty());
    EXPECT_EQ(link.now(), 100ms);
    const auto both = link.receive(1s);
    ASSERT_EQ(both->frames.size(), 2U);
    EXPECT_EQ(both->frames[0].time, 500ms);
    EXPECT_EQ(both->frames[1].time, 500ms) << "time never goes back";
    EXPECT_TRUE(link.receive(10s)->frames.front().isExtended);
    EXPECT_EQ(link.now(), 2s);
    EXPECT_TRUE(link.receive(10s)->frames.empty());
    EXPECT_EQ(link.now(), 10s);
}

TEST_F(CanLogOnDisk, NothingIsSentIntoThePast)
{
    CanLogLink link(putBus(), {});
    EXPECT_EQ(link.open(CanUse::operate).error().id, CanRefusalId::onlyLogged);
    ASSERT_TRUE(link.open(CanUse::watch));
    EXPECT_EQ(link.send({.id = 1}).error().id, CanRefusalId::onlyLogged);
    EXPECT_EQ(link.status().listensOnly, true);
}

TEST_F(CanLogOnDisk, OpenedAgainItBeginsAnewAndItsClockGoesOn)
{
    CanLogLink link(putBus(), {});
    ASSERT_TRUE(link.open(CanUse::watch));
    link.wait(5s);
    link.close();
    EXPECT_FALSE(link.receive(6s));
    ASSERT_TRUE(link.open(CanUse::watch));
    EXPECT_EQ(link.receive(6s)->frames.front().time, 5s);
}

} // namespace
} // namespace codewheel
