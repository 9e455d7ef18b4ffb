// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/interbus/gateway/served_clients.h"
#include "kinds/interbus/words/device_number.h"
#include "tests/support/faulty_ring.h"
#include "tests/support/offered_ring.h"
#include "tests/support/scripted_link.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::OfferedRing;
using testing::ElementsAre;

const Catalog &catalog()
{
    static const Catalog all = Catalog::builtIn();
    return all;
}

// 1.0 has 32 bits in both directions, 2.0 16 bits of IN, 3.0 none, 4.0 48 bits, 5.0 32 bits again. IN is OUT
// and 1.
std::unique_ptr<ScriptedLink> mixedRing()
{
    const auto device = [](int segment, int in, int out) {
        return RingDevice{DeviceNumber{segment, 0}.node(), 0x0333, in, out, {}};
    };
    auto link = std::make_unique<ScriptedLink>(
        RingStructure{device(1, 2, 2), device(2, 1, 0), device(3, 0, 0), device(4, 3, 3), device(5, 2, 2)});
    link->answerWith([](std::size_t i, Word out) { return i == 1 ? 0xABCD : out + 1; });
    return link;
}

ModbusBytes pdu(std::initializer_list<int> numbers)
{
    ModbusBytes bytes;
    bool isFunction = true;
    for (const int number : numbers) {
        if (!std::exchange(isFunction, false))
            bytes.push_back(static_cast<std::uint8_t>(number >> 8));
        bytes.push_back(static_cast<std::uint8_t>(number & 0xFF));
    }
    return bytes;
}
ModbusBytes writing(int first, const std::vector<Register> &values)
{
    ModbusBytes bytes = pdu({16, first, static_cast<int>(values.size())});
    bytes.push_back(static_cast<std::uint8_t>(2 * values.size()));
    for (const Register value : values) {
        bytes.push_back(static_cast<std::uint8_t>(value >> 8));
        bytes.push_back(static_cast<std::uint8_t>(value & 0xFF));
    }
    return bytes;
}

class ServedUnitsTest : public testing::Test
{
protected:
    ServedUnits::Answer ask(const ModbusBytes &request, int unit = 1)
    {
        return m_units.answer(unit, request);
    }
    int exceptionOf(const ModbusBytes &request, int unit = 1)
    {
        const auto answer = ask(request, unit);
        EXPECT_TRUE(answer.isException);
        EXPECT_EQ(answer.pdu.size(), 2U);
        EXPECT_EQ(answer.pdu[0], request[0] | 0x80);
        return answer.pdu.back();
    }
    std::vector<Register> read(int function, int first, int count)
    {
        const auto answer = ask(pdu({function, first, count}));
        EXPECT_FALSE(answer.isException) << first;
        std::vector<Register> registers;
        for (std::size_t i = 2; i + 1 < answer.pdu.size(); i += 2)
            registers.push_back(static_cast<Register>((answer.pdu[i] << 8) | answer.pdu[i + 1]));
        return registers;
    }
    void becomes(bool running, bool operating)
    {
        m_ring.bus().setRunning(running);
        m_ring.bus().setOperate(operating);
        EXPECT_TRUE(m_ring.waitFor(
            [&] { return m_ring.bus().isRunning() == running && m_ring.bus().isOperating() == operating; }));
    }

    OfferedRing m_ring{mixedRing(), catalog()};
    ServedUnits m_units{m_ring.guests()};
};

TEST_F(ServedUnitsTest, WordsAreInRingOrderHighWordFirst)
{
    EXPECT_FALSE(ask(writing(0, {0x1234, 0x5678})).isException);
    EXPECT_FALSE(ask(writing(5, {0x9ABC, 0xDEF0})).isException);
    EXPECT_THAT(read(3, 0, 7), ElementsAre(0x1234, 0x5678, 0, 0, 0, 0x9ABC, 0xDEF0));
    EXPECT_THAT(read(4, 0, 8), ElementsAre(0x1234, 0x5679, 0xABCD, 0, 1, 0, 0x9ABC, 0xDEF1));
    EXPECT_THAT(read(3, 4'096, 8), ElementsAre(0x1234, 0x5679, 0xABCD, 0, 1, 0, 0x9ABC, 0xDEF1));
    EXPECT_THAT(read(4, 1, 2), ElementsAre(0x5679, 0xABCD));
}

TEST_F(ServedUnitsTest, HalfAWordKeepsTheOther)
{
    ask(writing(0, {0x1234, 0x5678}));
    EXPECT_FALSE(ask(pdu({6, 1, 0xFFFF})).isException);
    EXPECT_THAT(read(3, 0, 2), ElementsAre(0x1234, 0xFFFF));
    EXPECT_FALSE(ask(pdu({6, 0, 0xAAAA})).isException);
    EXPECT_THAT(read(3, 0, 2), ElementsAre(0xAAAA, 0xFFFF));
    EXPECT_FALSE(ask(writing(1, {0x1111, 0x2222})).isException) << "half of 1.0, half of 4.0";
    EXPECT_THAT(read(3, 0, 4), ElementsAre(0xAAAA, 0x1111, 0x2222, 0));
}

TEST_F(ServedUnitsTest, BitsAreWrittenByAMask)
{
    ask(writing(0, {0x0012, 0}));
    EXPECT_FALSE(ask(pdu({22, 0, 0x00F2, 0x0025})).isException);
    EXPECT_THAT(read(3, 0, 2), ElementsAre(0x0017, 0));
}

// IN is that of the cycle with which the words went out.
TEST_F(ServedUnitsTest, Function23WritesBeforeItReads)
{
    const auto answer = ask({0x17, 0x10, 0, 0, 2, 0, 0, 0, 2, 4, 0, 7, 0, 8});
    EXPECT_FALSE(answer.isException);
    EXPECT_THAT(answer.pdu, ElementsAre(0x17, 4, 0, 7, 0, 9));
    EXPECT_EQ(exceptionOf({0x17, 0x30, 0, 0, 2, 0, 0, 0, 2, 4, 0, 1, 0, 1}), 2);
    EXPECT_THAT(read(3, 0, 2), ElementsAre(7, 8)) << "nor written";
}

TEST_F(ServedUnitsTest, TheStateOfTheRingCanBeRead)
{
    EXPECT_THAT(read(4, 8'192, 2), ElementsAre(0x00E0, 0));
    becomes(false, true);
    EXPECT_THAT(read(3, 8'192, 1), ElementsAre(0x00C0));
}

TEST_F(ServedUnitsTest, OutsideTheMapIsExceptionTwo)
{
    for (const ModbusBytes &request :
         {pdu({4, 8, 1}), pdu({4, 7, 2}), pdu({4, 4'096, 1}), pdu({3, 7, 1}), pdu({3, 6, 2}),
          pdu({3, 4'104, 1}), pdu({4, 8'194, 1}), pdu({4, 8'193, 2}), pdu({4, 65'535, 125}), pdu({6, 7, 0}),
          pdu({6, 4'096, 0}), pdu({6, 8'192, 0}), writing(6, {0, 0}), writing(65'535, {0, 0})})
        EXPECT_EQ(exceptionOf(request), 2) << int{request[0]} << ' ' << request[1] * 256 + request[2];
}

// Behind the 32nd bit of 4.0.
TEST_F(ServedUnitsTest, WhatIsBehindTheWordOfADeviceIsZeroAndNotWritten)
{
    EXPECT_EQ(exceptionOf(pdu({6, 4, 1})), 2);
    EXPECT_EQ(exceptionOf(writing(2, {1, 2, 3})), 2);
    EXPECT_THAT(read(3, 2, 3), ElementsAre(0, 0, 0));
}

TEST_F(ServedUnitsTest, InWatchAndWhileTheBusIsStoppedNothingIsWritten)
{
    becomes(true, false);
    EXPECT_EQ(exceptionOf(writing(0, {1, 2})), 4);
    becomes(false, true);
    EXPECT_EQ(exceptionOf(writing(0, {1, 2})), 4);
    EXPECT_THAT(read(3, 0, 2), ElementsAre(0, 0));
    becomes(true, true);
    EXPECT_FALSE(ask(writing(0, {1, 2})).isException);
}

TEST_F(ServedUnitsTest, WhoMayOnlyReadHasNoFunctionsThatWrite)
{
    m_units = ServedUnits(m_ring.guests(), ServedUnits::Writing::refused);
    for (const ModbusBytes &request : {pdu({6, 0, 1}), writing(0, {1, 2}), pdu({22, 0, 0, 1}),
                                       ModbusBytes{0x17, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0, 1}})
        EXPECT_EQ(exceptionOf(request), 1);
    EXPECT_THAT(read(3, 0, 2), ElementsAre(0, 0));
}

TEST_F(ServedUnitsTest, WithoutARingNothingIsAnswered)
{
    m_ring.bus().close();
    EXPECT_EQ(exceptionOf(pdu({4, 0, 1})), 4);
    EXPECT_EQ(exceptionOf(writing(0, {1, 2})), 4);
}

TEST_F(ServedUnitsTest, EachSeatHasItsRing)
{
    OfferedRing other(mixedRing(), catalog());
    m_units = ServedUnits({{1, m_ring.guests()}, {2, other.guests()}});
    EXPECT_FALSE(ask(writing(0, {0, 0x11}), 1).isException);
    EXPECT_FALSE(ask(writing(0, {0, 0x22}), 2).isException);
    EXPECT_EQ(ask(pdu({3, 1, 1}), 1).pdu.back(), 0x11);
    EXPECT_EQ(ask(pdu({3, 1, 1}), 2).pdu.back(), 0x22);
    for (const int unit : {0, 3, 255})
        EXPECT_EQ(exceptionOf(pdu({3, 1, 1}), unit), 11);
    EXPECT_THAT(m_units.units(), ElementsAre(1, 2));
}

TEST_F(ServedUnitsTest, WhatWasWrittenIsTold)
{
    const auto answer = ask(pdu({6, 6, 0x1234}));
    ASSERT_TRUE(answer.written);
    EXPECT_EQ(answer.written->place, NodeId("5.0"));
    EXPECT_EQ(answer.written->word, 0x1234U);
    EXPECT_GT(answer.written->at, Instant(0));
    EXPECT_TRUE(answer.isWrite);
    EXPECT_FALSE(ask(pdu({4, 0, 1})).isWrite);
    EXPECT_TRUE(ask(pdu({6, 99, 1})).isWrite);
}

// As masters do that send their whole image in each of their cycles.
TEST_F(ServedUnitsTest, WhatStoodThereAlreadyIsNotWritten)
{
    EXPECT_FALSE(ask(writing(0, {0, 0})).written) << "nor the zeros from the start";
    ask(writing(5, {0, 0x11}));
    const auto again = ask(writing(5, {0, 0x11}));
    EXPECT_FALSE(again.isException);
    EXPECT_TRUE(again.isWrite);
    EXPECT_FALSE(again.written);
    const auto half = ask(pdu({6, 6, 0x12}));
    ASSERT_TRUE(half.written);
    EXPECT_EQ(half.written->word, 0x12U);
    const auto first = ask(writing(0, {0, 7, 0, 0, 0, 0, 0x12}));
    EXPECT_TRUE(first.isException || (first.written && first.written->place == NodeId("1.0")));
}

// On a ring with a master, which sets the outputs to 0 when the bus fails.
TEST(ServedUnitsOnARing, AFaultIsInTheStatusAndStopsWriting)
{
    FaultyRing faulty;
    OfferedRing ring(std::move(faulty.link), catalog());
    const ServedUnits units(ring.guests());
    EXPECT_THAT(units.answer(1, pdu({4, 8'192, 1})).pdu, ElementsAre(4, 2, 0x00, 0xE0));
    EXPECT_FALSE(units.answer(1, pdu({6, 0, 1})).isException);
    faulty.ring->setFault(TrainingFault::wireBreak, NodeId("2.0"), 1);
    EXPECT_TRUE(ring.waitFor([&] { return ring.bus().latest().state == MasterState::busFail; }));
    EXPECT_EQ(units.answer(1, pdu({6, 0, 1})).pdu.back(), 4);
    EXPECT_THAT(units.answer(1, pdu({3, 0, 1})).pdu, ElementsAre(3, 2, 0, 0));
    // The master has found the place: behind 1.0.
    EXPECT_TRUE(ring.waitFor([&] { return ring.bus().latest().master->faultPlace().has_value(); }));
    const auto parameter = units.answer(1, pdu({4, 8'193, 1})).pdu;
    EXPECT_EQ(parameter[2] * 256 + parameter[3], ring.bus().latest().master->parameter);
    EXPECT_EQ(parameter[2], 1) << "the segment";
    EXPECT_EQ(units.answer(1, pdu({4, 8'192, 1})).pdu.back() & 0x20, 0) << "not in RUN";
}

TEST(ServedUnitsOnARing, AWordThatAJobHoldsIsBusy)
{
    FaultyRing faulty;
    OfferedRing ring(std::move(faulty.link), catalog());
    faulty.ring->setFault(TrainingFault::slowConfirmation, NodeId("1.0"), 1);
    const ServedUnits units(ring.guests());
    EncoderSession *encoder = ring.bus().encoder(ring.bus().placeOf(NodeId("1.0")));
    ASSERT_NE(encoder, nullptr);
    ASSERT_TRUE(ring.waitFor([&] { return encoder->latest().state == EncoderState::operation; }));
    bool hasEnded = false;
    QObject::connect(encoder, &EncoderSession::finished, encoder, [&] { hasEnded = true; });
    WriteParameters job;
    job.values = {{Parameter::steps, 255}};
    ASSERT_TRUE(encoder->start(job));
    ASSERT_TRUE(ring.waitFor([&] { return ring.bus().latest().devices[0].heldByJob; }));
    EXPECT_EQ(units.answer(1, pdu({6, 0, 1})).pdu.back(), 6);
    EXPECT_FALSE(units.answer(1, pdu({6, 2, 1})).isException) << "that of another device is free";
    EXPECT_TRUE(ring.waitFor([&] { return hasEnded; }));
    EXPECT_FALSE(units.answer(1, pdu({6, 0, 0})).isException);
}

TEST(ServedClients, TellWhoIsThereAndWhatTheyDid)
{
    using What = ClientNews::What;
    const ServedClient::Time now{};
    ServedClients clients(2);
    const auto first = clients.come(QStringLiteral("one"), now);
    ASSERT_TRUE(first);
    ASSERT_TRUE(clients.come(QStringLiteral("two"), now));
    EXPECT_FALSE(clients.come(QStringLiteral("three"), now)) << "more than two";
    const ServedWord word{NodeId("1.0"), 7, Instant(5)};
    clients.took(*first, 3, {.pdu = {}, .isException = false, .isWrite = true, .written = word}, now);
    clients.took(*first, 3, {.pdu = {}, .isException = true, .isWrite = true, .written = {}}, now);
    clients.took(*first, 3, {.pdu = {}, .isException = false, .isWrite = true, .written = {}}, now);
    const auto there = clients.clients();
    ASSERT_EQ(there.size(), 2U);
    EXPECT_EQ(there[0].address, QStringLiteral("one"));
    EXPECT_EQ(there[0].unit, 3);
    EXPECT_EQ(there[0].requests, 3U);
    EXPECT_EQ(there[0].writes, 1U) << "what stood there already is not written";
    EXPECT_EQ(there[0].refused, 1U);
    ASSERT_TRUE(there[0].written);
    EXPECT_EQ(there[0].written->word, word);
    clients.leave(*first);
    EXPECT_TRUE(clients.come(QStringLiteral("four"), now));
    EXPECT_EQ(clients.refusedConnections(), 1U);
    EXPECT_EQ(clients.everCame(), 3U);
    EXPECT_EQ(clients.total().requests, 3U) << "those of who left included";
    std::vector<What> news;
    for (const ClientNews &one : clients.takeNews())
        news.push_back(one.what);
    EXPECT_THAT(news, ElementsAre(What::came, What::came, What::refused, What::left, What::came));
    EXPECT_THAT(clients.takeNews(), testing::IsEmpty());
}

} // namespace
} // namespace codewheel
