// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of every link to a serial line (serial/byte_link.h), over a real pseudo terminal and
// simulated. Anything timed waits for its event, for up to an hour.
#include "kinds/esc/simulator/simulated_esc_line_link.h"
#include "links/serial_port_link.h"
#include "tests/support/pty_pair.h"
#include "vocabulary/port_text.h"

#include <gtest/gtest.h>
#include <optional>
#include <thread>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

const QByteArray request = "\x1B"
                           "05P\r\n";
const QByteArray answer = "\r\n00001235\r\n";

template <typename T>
RefusalCode idOf(const Result<T> &result)
{
    return result ? RefusalId::nothingToDo : result.error().id;
}

// The far end: an encoder at 05 that shows 1235h.
struct OverPty
{
    PtyPair pty{};
    SerialPortLink link{pty.path()};

    void answerRequest()
    {
        EXPECT_EQ(pty.receive(request.size()), request);
        pty.send(answer);
    }
    void leaveBytes() { pty.send("old"); }
    void unplug() { pty.unplug(); }
};

struct Simulated
{
    explicit Simulated(SimulatedEscLineLink::Clock clock = {})
        : link(line, std::move(clock))
    {}
    std::shared_ptr<SimulatedEscLine> line = std::make_shared<SimulatedEscLine>();
    SimulatedEscLineLink link;

    void answerRequest() {}
    void leaveBytes() { ASSERT_TRUE(link.write(request)); }
    void unplug() { line->setUnplugged(true); }
};

struct SimulatedInRealTime : Simulated
{
    SimulatedInRealTime()
        : Simulated([] {
            return std::chrono::duration_cast<Instant>(std::chrono::steady_clock::now().time_since_epoch());
        })
    {}
};

template <typename Bench>
class ByteLinkContract : public testing::Test
{
protected:
    ByteLink &link() { return m_bench.link; }
    QByteArray readAnswer()
    {
        QByteArray bytes;
        for (const Instant end = link().now() + 1h; bytes.size() < answer.size() && link().now() < end;) {
            const auto more = link().read(end);
            if (!more)
                break;
            bytes += *more;
        }
        return bytes;
    }

    Bench m_bench;
};

using Links = testing::Types<OverPty, Simulated, SimulatedInRealTime>;
TYPED_TEST_SUITE(ByteLinkContract, Links);

TYPED_TEST(ByteLinkContract, AClosedLineRefusesAll)
{
    ByteLink &link = this->link();
    EXPECT_EQ(idOf(link.read(link.now() + 1h)), RefusalId::lineClosed);
    EXPECT_EQ(idOf(link.write(request)), RefusalId::lineClosed);
    EXPECT_EQ(idOf(link.setBaudRate(9'600)), RefusalId::lineClosed);
    EXPECT_FALSE(link.name().isEmpty());
    link.close(); // does no harm
}

TYPED_TEST(ByteLinkContract, CarriesARequestAndItsAnswer)
{
    ByteLink &link = this->link();
    ASSERT_TRUE(link.open({}));
    ASSERT_TRUE(link.write(request));
    this->m_bench.answerRequest();
    EXPECT_EQ(this->readAnswer(), answer);
    EXPECT_EQ(link.read(link.now() + 1ms).value(), "");
}

TYPED_TEST(ByteLinkContract, ReadingEndsWithItsTime)
{
    ByteLink &link = this->link();
    ASSERT_TRUE(link.open({}));
    const Instant before = link.now();
    const auto nothing = link.read(before + 2ms);
    ASSERT_TRUE(nothing);
    EXPECT_EQ(*nothing, "");
    EXPECT_GE(link.now(), before + 2ms);
    EXPECT_EQ(link.read(before).value(), "") << "at once";
}

TYPED_TEST(ByteLinkContract, WhatLayThereIsDroppedWhenItIsOpened)
{
    ByteLink &link = this->link();
    ASSERT_TRUE(link.open({}));
    this->m_bench.leaveBytes();
    link.close();
    ASSERT_TRUE(link.open({}));
    EXPECT_EQ(link.read(link.now() + 20ms).value(), "");
}

TYPED_TEST(ByteLinkContract, ItsTimeNeverGoesBack)
{
    ByteLink &link = this->link();
    const Instant first = link.now();
    EXPECT_GE(first, 0us);
    link.wait(first + 5ms); // closed
    const Instant waited = link.now();
    EXPECT_GE(waited, first + 5ms);
    ASSERT_TRUE(link.open({}));
    EXPECT_GE(link.now(), waited);
    ASSERT_TRUE(link.read(link.now() + 5ms));
    const Instant read = link.now();
    EXPECT_GE(read, waited + 5ms);
    link.close();
    ASSERT_TRUE(link.open({}));
    EXPECT_GE(link.now(), read);
}

TYPED_TEST(ByteLinkContract, InterruptEndsTheNextReadOrWaitEarly)
{
    ByteLink &link = this->link();
    ASSERT_TRUE(link.open({}));
    link.interrupt();
    const auto interrupted = link.read(link.now() + 1h);
    ASSERT_TRUE(interrupted);
    EXPECT_EQ(*interrupted, "");
    ASSERT_TRUE(link.write(request));
    this->m_bench.answerRequest();
    EXPECT_EQ(this->readAnswer(), answer) << "nothing was lost";
    link.close();
    const std::jthread other([&] { link.interrupt(); });
    link.wait(link.now() + 1h);
}

TYPED_TEST(ByteLinkContract, AnUnpluggedAdapterIsToldOnceAndDoesNotOpen)
{
    ByteLink &link = this->link();
    ASSERT_TRUE(link.open({}));
    const QString name = link.name();
    this->m_bench.unplug();
    const auto lost = link.read(link.now() + 1h);
    ASSERT_EQ(idOf(lost), RefusalId::portLost);
    ASSERT_EQ(lost.error().arguments.size(), 1U);
    EXPECT_EQ(portText(lost.error().arguments.front()), name);
    EXPECT_EQ(idOf(link.read(link.now() + 1h)), RefusalId::lineClosed);
    EXPECT_EQ(idOf(link.write(request)), RefusalId::lineClosed);
    EXPECT_EQ(idOf(link.open({})), RefusalId::portNotFound);
    EXPECT_EQ(link.name(), name);
}

TYPED_TEST(ByteLinkContract, UnpluggingIsNoticedByAWriteToo)
{
    ByteLink &link = this->link();
    ASSERT_TRUE(link.open({}));
    this->m_bench.unplug();
    EXPECT_EQ(idOf(link.write(request)), RefusalId::portLost);
    EXPECT_EQ(idOf(link.write(request)), RefusalId::lineClosed);
}

} // namespace
} // namespace codewheel
