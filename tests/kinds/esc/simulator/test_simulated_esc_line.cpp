// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/simulator/simulated_esc_line_link.h"

#include <bit>
#include <gtest/gtest.h>
#include <thread>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr SerialSettings usual{};

class SimulatedEscLineTest : public testing::Test
{
protected:
    void SetUp() override { ASSERT_TRUE(m_link.open(usual)); }

    void send(const QByteArray &bytes) { ASSERT_TRUE(m_link.write(bytes)); }
    void request(const char *text) { send("\x1B" + QByteArray(text) + "\r\n"); }
    // Everything that comes within this time.
    QByteArray heard(Instant time = 100ms)
    {
        const Instant until = m_link.now() + time;
        QByteArray all;
        m_arrivals.clear();
        while (m_link.now() < until) {
            const QByteArray bytes = m_link.read(until).value();
            if (!bytes.isEmpty())
                m_arrivals.push_back(m_link.now());
            all += bytes;
        }
        return all;
    }
    QByteArray answer(const char *text)
    {
        request(text);
        return heard();
    }
    void set(const EscLineFaults &faults) { m_line->setFaults(faults); }

    std::shared_ptr<SimulatedEscLine> m_line = std::make_shared<SimulatedEscLine>();
    SimulatedEscLineLink m_link{m_line};
    std::vector<Instant> m_arrivals;
};

TEST_F(SimulatedEscLineTest, HasTheThreeEncodersOfTheTrainingBus)
{
    EXPECT_EQ(m_line->addresses(), (std::vector<EscLineAddress>{{0x03}, {0x05}, {0x12}}));
    EXPECT_EQ(answer("05P"), "\r\n00001235\r\n");
    EXPECT_EQ(answer("03N"), "\r\n0012D591\r\n");
    EXPECT_EQ(answer("12U"), "\r\n1000\r\n");
    EXPECT_EQ(answer("04P"), "");
}

// 6 characters out, 200 us, 12 back; 11 bits each at 19200 Bd.
TEST_F(SimulatedEscLineTest, KeepsTheTimeOfTheLine)
{
    request("05P");
    EXPECT_EQ(m_link.now(), 0us);
    EXPECT_EQ(heard(), "\r\n00001235\r\n");
    EXPECT_EQ(m_arrivals.size(), 12U);
    EXPECT_EQ(m_arrivals.front(), 3438us + 200us + 573us);
    EXPECT_EQ(m_arrivals.back(), 3438us + 200us + 6875us);
    EXPECT_EQ(m_link.now(), 100ms);
    m_line->setAnswerDelay(5ms);
    request("05P");
    heard();
    EXPECT_EQ(m_arrivals.front(), 100ms + 3438us + 5ms + 573us);
}

// A reader waiting in real time is woken at these two times, not for each character.
TEST_F(SimulatedEscLineTest, TellsWhenTheRequestAndWhenTheWholeAnswerHasPassed)
{
    SimulatedEscLine line;
    line.begin(usual);
    EXPECT_FALSE(line.runEnd());
    line.send("\x1B"
              "05P\r\n",
              0us);
    EXPECT_EQ(line.runEnd(), 3438us);
    EXPECT_EQ(line.nextEnd(), 573us) << "of a character: for who passes it on";
    EXPECT_EQ(line.advance(3438us).bytes, "");
    EXPECT_EQ(line.runEnd(), 3438us + 200us + 6875us);
}

TEST_F(SimulatedEscLineTest, ShaftsTurnWithTheTimeOfTheLine)
{
    EXPECT_TRUE(m_line->withEncoder({5}, [](SimulatedEscEncoder &encoder) { encoder.shaft().setSpeed(60); }));
    heard(1s);
    EXPECT_FALSE(m_line->withEncoder({9}, [](SimulatedEscEncoder &) {}));
    EXPECT_EQ(answer("05P"), "\r\n0000324D\r\n"); // 1235h + 1003 ms x 8.192 steps
}

TEST_F(SimulatedEscLineTest, RequestsOneAfterTheOtherAreAllAnswered)
{
    send("\x1B"
         "05D\r\n\x1B"
         "05U\r\n");
    // The first answer meets the second request on the wire: both are spoiled.
    EXPECT_FALSE(heard().contains("2000"));
    EXPECT_EQ(answer("05D"), "\r\n2000\r\n");
    EXPECT_EQ(answer("05U"), "\r\n1000\r\n");
}

TEST_F(SimulatedEscLineTest, TwoThatAnswerTheMasterAddressSpoilEachOther)
{
    const QByteArray collided = answer("00P");
    EXPECT_EQ(collided.size(), 36);
    for (const char byte : collided)
        EXPECT_LT(byte, 0); // junk of 8 bits
    for (const EscLineAddress address : {EscLineAddress{0x03}, EscLineAddress{0x12}})
        m_line->withEncoder(address,
                            [](SimulatedEscEncoder &encoder) { encoder.condition().powered = false; });
    EXPECT_EQ(answer("00P"), "\r\n00001235\r\n");
}

TEST_F(SimulatedEscLineTest, AtAnotherBaudRateNothingIsUnderstood)
{
    ASSERT_TRUE(m_link.setBaudRate(9'600));
    EXPECT_EQ(answer("05P"), "");
    ASSERT_TRUE(m_link.setBaudRate(19'200));
    EXPECT_EQ(answer("05Y1"), "\r\n"); // at the old rate
    EXPECT_EQ(answer("05P"), "");
    ASSERT_TRUE(m_link.setBaudRate(9'600));
    EXPECT_EQ(answer("05P"), "\r\n00001235\r\n");
    request("05P");
    ASSERT_TRUE(m_link.setBaudRate(19'200)); // meanwhile
    const QByteArray junk = heard();
    EXPECT_EQ(junk.size(), 12);
    for (const char byte : junk)
        EXPECT_LT(byte, 0);
}

TEST_F(SimulatedEscLineTest, AtAnotherFormatNothingIsUnderstood)
{
    ASSERT_TRUE(m_link.open({.dataBits = 7}));
    EXPECT_EQ(answer("05P"), "");
    ASSERT_TRUE(m_link.open({.parity = SerialSettings::Parity::even}));
    EXPECT_EQ(answer("05P"), "");
    ASSERT_TRUE(m_link.open({.stopBits = 1}));
    EXPECT_EQ(answer("05P"), "\r\n00001235\r\n");
}

TEST_F(SimulatedEscLineTest, EchoesWhatIsSent)
{
    set({.echo = true});
    EXPECT_EQ(answer("05P"), "\x1B"
                             "05P\r\n\r\n00001235\r\n");
    EXPECT_EQ(m_arrivals.front(), 573us);
}

TEST_F(SimulatedEscLineTest, BytesAreLost)
{
    set({.lost = 1'000});
    EXPECT_EQ(answer("05P"), "");
    set({});
    EXPECT_EQ(answer("05P"), "\r\n00001235\r\n");
}

TEST_F(SimulatedEscLineTest, BytesAreCorruptedInOneBit)
{
    set({.corrupted = 1'000, .echo = true});
    const QByteArray sent = "0123456789";
    send(sent);
    const QByteArray echo = heard();
    ASSERT_EQ(echo.size(), sent.size());
    for (qsizetype i = 0; i < sent.size(); ++i)
        EXPECT_EQ(std::popcount(static_cast<unsigned char>(sent[i] ^ echo[i])), 1) << i;
}

TEST_F(SimulatedEscLineTest, BytesAreDoubled)
{
    set({.doubled = 1'000, .echo = true});
    send("0P\r");
    EXPECT_EQ(heard(), "00PP\r\r");
    EXPECT_EQ(m_arrivals.back(), 3438us);
}

TEST_F(SimulatedEscLineTest, BytesAreDelayedWithAllThatFollow)
{
    set({.delayed = 1'000, .delay = 7ms, .echo = true});
    send("05");
    EXPECT_EQ(heard(), "05");
    EXPECT_EQ(m_arrivals, (std::vector<Instant>{7573us, 15146us}));
}

// Of 100 000 bytes, 1 % of each, within four standard deviations of 31.
TEST_F(SimulatedEscLineTest, FaultsComeAsOftenAsTheyAreSet)
{
    const QByteArray sent(100'000, '0');
    const auto echoed = [&](const EscLineFaults &faults) {
        set(faults);
        send(sent);
        return heard(100s);
    };
    EXPECT_NEAR(static_cast<double>(echoed({.lost = 10, .echo = true}).size()), 99'000, 126);
    EXPECT_NEAR(static_cast<double>(echoed({.doubled = 10, .echo = true}).size()), 101'000, 126);
    EXPECT_NEAR(static_cast<double>(echoed({.corrupted = 10, .echo = true}).count('0')), 99'000, 126);
}

TEST_F(SimulatedEscLineTest, ARunCanBeRepeated)
{
    const auto run = [](std::uint32_t seed) {
        auto line = std::make_shared<SimulatedEscLine>(trainingLine(), seed);
        line->setFaults({.lost = 50, .corrupted = 50, .doubled = 50, .delayed = 50, .echo = true});
        SimulatedEscLineLink link(line);
        EXPECT_TRUE(link.open(usual));
        QByteArray all;
        for (int i = 0; i < 50; ++i) {
            EXPECT_TRUE(link.write("\x1B"
                                   "05P\r\n"));
            for (const Instant until = link.now() + 50ms; link.now() < until;)
                all += link.read(until).value();
        }
        return all;
    };
    EXPECT_EQ(run(7), run(7));
    EXPECT_NE(run(7), run(8));
}

TEST_F(SimulatedEscLineTest, OneOrAllFallSilent)
{
    m_line->withEncoder({5}, [](SimulatedEscEncoder &encoder) { encoder.condition().mute = true; });
    EXPECT_EQ(answer("05P"), "");
    EXPECT_EQ(answer("12U"), "\r\n1000\r\n");
    m_line->setSilent(true);
    EXPECT_EQ(answer("12U"), "");
    m_line->setSilent(false);
    EXPECT_EQ(answer("05P"), "\r\n00001235\r\n");
}

RefusalCode idOf(const Result<QByteArray> &result)
{
    return result ? RefusalId::nothingToDo : result.error().id;
}

TEST_F(SimulatedEscLineTest, AnUnpluggedAdapterIsToldOnceAndDoesNotOpen)
{
    m_line->setUnplugged(true);
    EXPECT_EQ(idOf(m_link.read(1s)), RefusalId::portLost);
    EXPECT_EQ(idOf(m_link.read(1s)), RefusalId::lineClosed);
    EXPECT_EQ(m_link.write("x").error().id, RefusalId::lineClosed);
    EXPECT_EQ(m_link.open(usual).error().id, RefusalId::portNotFound);
    m_line->setUnplugged(false);
    EXPECT_TRUE(m_link.open(usual));
    EXPECT_EQ(answer("05P"), "\r\n00001235\r\n");
}

TEST_F(SimulatedEscLineTest, OpeningDropsWhatWasOnTheWireAndItsTimeGoesOn)
{
    heard(5s);
    request("05P");
    const Instant before = m_link.now();
    EXPECT_GE(before, 5s);
    ASSERT_TRUE(m_link.open(usual));
    EXPECT_EQ(m_link.now(), before);
    EXPECT_EQ(heard(), "");
    m_link.close();
    EXPECT_EQ(idOf(m_link.read(1s)), RefusalId::lineClosed);
}

TEST_F(SimulatedEscLineTest, InterruptEndsTheNextRead)
{
    request("05P");
    m_link.interrupt();
    EXPECT_EQ(m_link.read(1s).value(), "");
    EXPECT_EQ(m_link.now(), 0us);
    EXPECT_EQ(heard(), "\r\n00001235\r\n");
}

// A line with a clock waits for it. This clock advances by 1 ms at each look.
TEST(SimulatedLineInRealTime, KeepsTheTimeOfItsClock)
{
    Instant time = 1h;
    SimulatedEscLineLink link(std::make_shared<SimulatedEscLine>(), [&] { return time += 1ms; });
    ASSERT_TRUE(link.open(usual));
    ASSERT_TRUE(link.write("\x1B"
                           "05P\r\n"));
    QByteArray all;
    while (link.now() < 20ms)
        all += link.read(20ms).value();
    EXPECT_EQ(all, "\r\n00001235\r\n");
}

TEST(SimulatedLineInRealTime, InterruptAndUnpluggingEndTheReadUnderWay)
{
    const auto line = std::make_shared<SimulatedEscLine>();
    SimulatedEscLineLink link(line, [] { return Instant{}; }); // its time never advances
    ASSERT_TRUE(link.open(usual));
    {
        const std::jthread other([&] { link.interrupt(); });
        EXPECT_EQ(link.read(24h).value(), "");
    }
    const std::jthread other([&] { line->setUnplugged(true); });
    EXPECT_EQ(link.read(24h).error().id, RefusalId::portLost);
}

} // namespace
} // namespace codewheel
