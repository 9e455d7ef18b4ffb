// SPDX-License-Identifier: GPL-3.0-or-later
// The port with a peer that answers wrongly on purpose. Whatever it sent, the next request gets its own
// answer: each register has its own number as its value, and no other is ever read.
//
// On a line an answer that is later than twice the time-out cannot be told from a right one; no peer is so
// slow. Where an answer is awaited the peer is asked again if it was too slow for the time-out; it shows the
// same reaction each time.
#include "kinds/interbus/gateway/register_texts.h"
#include "kinds/interbus/links/modbus_port.h"
#include "tests/links/crooked_peer.h"
#include "tests/support/pty_pair.h"

#include <array>
#include <atomic>
#include <gtest/gtest.h>
#include <thread>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using ErrorKind = RegisterError::Kind;
using Registers = std::vector<Register>;

constexpr quint8 unit = 9;
constexpr int patientTries = 200;
constexpr auto longestHangingUp = 300ms; // of the peer, until its end has come

struct CrookedTcp
{
    static QByteArray frame(const SeenRequest &request, const QByteArray &message, quint8 from = unit)
    {
        return CrookedPeer::tcpFrame(request.transaction, from, message);
    }

    CrookedPeer peer{CrookedPeer::React()};
    GatewaySettings settings{
        .host = QStringLiteral("127.0.0.1"), .tcpPort = peer.port(), .unit = unit, .timeOut = 400ms};
};

struct CrookedLine
{
    static QByteArray frame(const SeenRequest &, const QByteArray &message, quint8 from = unit)
    {
        return CrookedPeer::lineFrame(from, message);
    }

    PtyPair pty{};
    CrookedPeer peer{CrookedPeer::React(), pty.descriptor()};
    GatewaySettings settings{.transport = GatewaySettings::Transport::rtu,
                             .serialPort = pty.path(),
                             .unit = unit,
                             .timeOut = 400ms};
};

template <typename Way>
class WrongAnswers : public testing::Test
{
protected:
    WrongAnswers()
    {
        reactRightly();
        EXPECT_TRUE(m_port.open());
    }

    static Reaction rightReaction(const SeenRequest &request)
    {
        return {Way::frame(request, rightAnswer(request.message))};
    }
    void reactRightly() { m_way.peer.reactBy(rightReaction); }
    // With this message instead of the right one.
    void reactWith(const std::function<QByteArray(QByteArray)> &change)
    {
        m_way.peer.reactBy([change](const SeenRequest &request) {
            return Reaction{Way::frame(request, change(rightAnswer(request.message)))};
        });
    }

    static RegisterError patient(const std::function<RegisterPort::Done()> &call)
    {
        for (int tries = 0; tries < patientTries; ++tries) {
            const auto done = call();
            if (done)
                break;
            if (done.error().kind != ErrorKind::noAnswer)
                return done.error();
        }
        return {ErrorKind::noAnswer, 0, QStringLiteral("none of those expected")};
    }
    RegisterError readingFails()
    {
        return patient([&] {
            Registers read(2, 0xBEEF);
            auto done = m_port.read(RegisterArea::input, 20, read);
            EXPECT_EQ(read, Registers(2, 0xBEEF)) << "nothing is taken from a wrong answer";
            return done;
        });
    }
    RegisterError writingFails()
    {
        return patient([&] { return m_port.write(40, Registers{1, 2, 3}); });
    }
    // Registers of any two requests in a row have as many values, but others.
    void nextAnswersAreRight()
    {
        for (int first = 100, right = 0, tries = 0; right < 2; first += 10) {
            ASSERT_LT(++tries, patientTries);
            Registers read(2);
            if (!m_port.read(RegisterArea::input, first, read))
                continue;
            EXPECT_EQ(read, (Registers{static_cast<Register>(first), static_cast<Register>(first + 1)}));
            ++right;
        }
    }
    void noneIsTakenForAnother()
    {
        for (int first = 100, tries = 0; tries < 4; first += 10, ++tries) {
            Registers read(2);
            if (m_port.read(RegisterArea::input, first, read)) {
                EXPECT_EQ(read, (Registers{static_cast<Register>(first), static_cast<Register>(first + 1)}));
            }
        }
        reactRightly();
        nextAnswersAreRight();
    }
    void isWrong(const RegisterError &error)
    {
        EXPECT_EQ(error.kind, ErrorKind::wrongAnswer) << static_cast<int>(error.kind);
        EXPECT_FALSE(error.text.isEmpty());
        reactRightly();
        nextAnswersAreRight();
    }

    Way m_way;
    ModbusPort m_port{m_way.settings};
};

using CrookedWays = testing::Types<CrookedTcp, CrookedLine>;
TYPED_TEST_SUITE(WrongAnswers, CrookedWays);

TYPED_TEST(WrongAnswers, RightOnesAreTaken)
{
    this->nextAnswersAreRight();
    EXPECT_TRUE(this->m_port.write(40, Registers{1, 2, 3}));
}

TYPED_TEST(WrongAnswers, AnAnswerMayComeInPieces)
{
    this->m_way.peer.reactBy([](const SeenRequest &request) {
        Reaction reaction = WrongAnswers<TypeParam>::rightReaction(request);
        reaction.inPieces = true;
        return reaction;
    });
    this->nextAnswersAreRight();
    EXPECT_TRUE(this->m_port.write(40, Registers{1, 2, 3}));
    Registers one(1);
    EXPECT_TRUE(this->m_port.read(RegisterArea::holding, 7, one));
    EXPECT_EQ(one.front(), 7);
}

TYPED_TEST(WrongAnswers, ExceptionsAreToldByTheirCode)
{
    for (const int code : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 255}) {
        this->m_way.peer.reactBy([code](const SeenRequest &request) {
            const QByteArray exception{QByteArray(1, static_cast<char>(request.message[0] | 0x80)) +
                                       static_cast<char>(code)};
            return Reaction{TypeParam::frame(request, exception)};
        });
        EXPECT_EQ(this->readingFails(), (RegisterError{ErrorKind::exception, code, {}}));
        EXPECT_EQ(this->writingFails(), (RegisterError{ErrorKind::exception, code, {}}));
    }
    this->reactRightly();
    this->nextAnswersAreRight();
}

TYPED_TEST(WrongAnswers, AnotherUnit)
{
    this->m_way.peer.reactBy([](const SeenRequest &request) {
        return Reaction{TypeParam::frame(request, rightAnswer(request.message), unit + 1)};
    });
    const RegisterError error = this->readingFails();
    EXPECT_TRUE(error.text.contains(QString::number(unit + 1))) << error.text.toStdString();
    this->isWrong(error);
}

TYPED_TEST(WrongAnswers, AnotherFunction)
{
    this->reactWith([](QByteArray answer) { return answer.replace(0, 1, QByteArray(1, 3)); });
    const RegisterError error = this->readingFails();
    EXPECT_TRUE(error.text.contains(u'3')) << error.text.toStdString();
    this->isWrong(error);
}

TYPED_TEST(WrongAnswers, AnExceptionOfAnotherFunction)
{
    this->reactWith([](const QByteArray &) { return QByteArray("\x83\x02"); });
    this->isWrong(this->readingFails());
}

TYPED_TEST(WrongAnswers, FewerRegisters)
{
    this->reactWith([](const QByteArray &) { return QByteArray("\x04\x02\x12\x34"); });
    this->isWrong(this->readingFails());
}

TYPED_TEST(WrongAnswers, MoreRegisters)
{
    this->reactWith([](const QByteArray &) { return QByteArray("\x04\x06\x12\x34\x56\x78\x11\x22"); });
    this->isWrong(this->readingFails());
}

TYPED_TEST(WrongAnswers, BytesThatAreCountedWrong)
{
    for (const char count : {'\3', '\5', '\xFF'}) {
        this->reactWith([count](QByteArray answer) { return answer.replace(1, 1, QByteArray(1, count)); });
        this->isWrong(this->readingFails());
    }
}

TYPED_TEST(WrongAnswers, AWriteOfOtherRegisters)
{
    for (const qsizetype byte : {1, 2, 3, 4}) { // of the first register and of the count
        this->reactWith([byte](QByteArray answer) {
            return answer.replace(byte, 1, QByteArray(1, static_cast<char>(answer[byte] ^ 1)));
        });
        this->isWrong(this->writingFails());
    }
}

TYPED_TEST(WrongAnswers, Garbage)
{
    this->m_way.peer.reactBy([](const SeenRequest &) {
        return Reaction{"HTTP/1.1 400 Bad Request\r\nConnection: close\r\n\r\n"};
    });
    this->isWrong(this->readingFails());
}

TYPED_TEST(WrongAnswers, SilenceIsNoAnswerAndTakesTheTimeOut)
{
    this->m_way.peer.reactBy([](const SeenRequest &) { return Reaction{}; });
    Registers read(2);
    const Instant begun = this->m_port.now();
    EXPECT_EQ(this->m_port.read(RegisterArea::input, 20, read).error().kind, ErrorKind::noAnswer);
    EXPECT_GE(this->m_port.now() - begun, this->m_way.settings.timeOut);
    this->reactRightly();
    this->nextAnswersAreRight();
}

TYPED_TEST(WrongAnswers, HalfAnAnswer)
{
    for (const qsizetype cut : {1, 5}) {
        this->m_way.peer.reactBy([cut](const SeenRequest &request) {
            Reaction half = WrongAnswers<TypeParam>::rightReaction(request);
            half.bytes.chop(cut);
            return half;
        });
        this->isWrong(this->readingFails());
    }
}

// The second one must not be taken for the answer to the next request, which has the same form.
TYPED_TEST(WrongAnswers, TwoAnswers)
{
    this->m_way.peer.reactBy([](const SeenRequest &request) {
        const QByteArray frame = WrongAnswers<TypeParam>::rightReaction(request).bytes;
        return Reaction{frame + frame};
    });
    this->nextAnswersAreRight();
}

TYPED_TEST(WrongAnswers, TwoAnswersAfterSilence)
{
    this->m_way.peer.reactBy([](const SeenRequest &) { return Reaction{}; });
    Registers read(2);
    EXPECT_EQ(this->m_port.read(RegisterArea::input, 20, read).error().kind, ErrorKind::noAnswer);
    this->m_way.peer.reactBy([](const SeenRequest &request) {
        const QByteArray frame = WrongAnswers<TypeParam>::rightReaction(request).bytes;
        return Reaction{frame + frame};
    });
    this->nextAnswersAreRight();
}

// The first, third, ... request gets `instead`, and its answer when the next one has come, before that one's.
template <typename Way>
CrookedPeer::React answeringLate(const std::function<QByteArray(const SeenRequest &)> &instead)
{
    struct State
    {
        int requests = 0;
        QByteArray late;
    };
    return [instead, state = std::make_shared<State>()](const SeenRequest &request) {
        const QByteArray right = Way::frame(request, rightAnswer(request.message));
        if (++state->requests % 2 == 0)
            return Reaction{state->late + right};
        state->late = right;
        return Reaction{instead(request)};
    };
}

TYPED_TEST(WrongAnswers, LateAnswers)
{
    this->m_way.peer.reactBy(answeringLate<TypeParam>([](const SeenRequest &) { return QByteArray(); }));
    this->noneIsTakenForAnother();
}

TYPED_TEST(WrongAnswers, LateAnswersBehindWrongOnes)
{
    this->m_way.peer.reactBy(answeringLate<TypeParam>(
        [](const SeenRequest &request) { return TypeParam::frame(request, "\x84\x02\x01"); }));
    this->noneIsTakenForAnother();
    this->m_way.peer.reactBy(answeringLate<TypeParam>(
        [](const SeenRequest &request) { return TypeParam::frame(request, "\x04\x02\x12\x34"); }));
    this->noneIsTakenForAnother();
}

using WrongTcp = WrongAnswers<CrookedTcp>;

TEST_F(WrongTcp, AnAnswerToALaterTransaction)
{
    m_way.peer.reactBy([](const SeenRequest &request) {
        return Reaction{CrookedPeer::tcpFrame(static_cast<quint16>(request.transaction + 1), unit,
                                              rightAnswer(request.message))};
    });
    isWrong(readingFails());
}

// As some gateways do; then nothing would tell a late answer from the right one.
TEST_F(WrongTcp, AGatewayThatDoesNotRepeatTheNumberIsNamedSo)
{
    m_way.peer.reactBy([](const SeenRequest &request) {
        return Reaction{CrookedPeer::tcpFrame(0x7FFF, unit, rightAnswer(request.message))};
    });
    EXPECT_EQ(readingFails().kind, ErrorKind::wrongAnswer);
    const RegisterError again = readingFails();
    isWrong(again);
    EXPECT_EQ(again.text, wrongAnswerKey(WrongAnswer::oneTransaction, {0x7FFF}));
}

// The number is that of an earlier request then, as if the answer to it came late.
TEST_F(WrongTcp, AGatewayThatAlwaysSendsANumberOfOursIsNamedSo)
{
    m_port.close(); // the peer has one client at a time
    for (const quint16 number : std::array<quint16, 3>{1, 2, 3}) {
        m_way.peer.reactBy([number](const SeenRequest &request) {
            return Reaction{CrookedPeer::tcpFrame(number, unit, rightAnswer(request.message))};
        });
        ModbusPort port(m_way.settings);
        ASSERT_TRUE(port.open());
        RegisterError last;
        Registers read(2);
        for (int requests = 0; requests < 5; ++requests)
            if (const auto done = port.read(RegisterArea::input, 20, read); !done)
                last = done.error();
        EXPECT_EQ(last.kind, ErrorKind::wrongAnswer);
        EXPECT_EQ(last.text, wrongAnswerKey(WrongAnswer::oneTransaction, {number}));
    }
}

TEST_F(WrongTcp, AnswersThatAreAlwaysTooLateAreNamedSo)
{
    const auto late = std::make_shared<QByteArray>();
    m_way.peer.reactBy([late](const SeenRequest &request) {
        return Reaction{std::exchange(*late, rightReaction(request).bytes)};
    });
    Registers read(2);
    EXPECT_FALSE(m_port.read(RegisterArea::input, 20, read).error().isLate) << "none has come yet";
    EXPECT_TRUE(m_port.read(RegisterArea::input, 20, read).error().isLate);
    reactRightly();
    nextAnswersAreRight();
}

TEST_F(WrongTcp, ALateAnswerCostsNoConnection)
{
    const auto late = std::make_shared<QByteArray>();
    m_way.peer.reactBy([late](const SeenRequest &request) {
        const QByteArray right = rightReaction(request).bytes;
        return Reaction{std::exchange(*late, right).isEmpty() ? QByteArray() : *late + right};
    });
    Registers read(2);
    EXPECT_EQ(m_port.read(RegisterArea::input, 20, read).error().kind, ErrorKind::noAnswer);
    nextAnswersAreRight();
    EXPECT_EQ(m_way.peer.connections(), 1);
}

TEST_F(WrongTcp, HeadersThatAreNotModbus)
{
    const auto changed = [](qsizetype byte, char value) {
        return [byte, value](const SeenRequest &request) {
            return Reaction{rightReaction(request).bytes.replace(byte, 1, QByteArray(1, value))};
        };
    };
    for (const auto &[byte, value] : {std::pair{2, 1}, {3, 1}, {4, 2}, {5, 0}, {5, 1}, {5, 4}, {5, 6}}) {
        m_way.peer.reactBy(changed(byte, static_cast<char>(value)));
        isWrong(readingFails());
    }
}

TEST_F(WrongTcp, APeerThatHangsUpHasClosed)
{
    for (const qsizetype cut : {0, 1, 4, 8}) {
        m_way.peer.reactBy([cut](const SeenRequest &request) {
            return Reaction{rightReaction(request).bytes.left(cut), true};
        });
        EXPECT_EQ(readingFails().kind, ErrorKind::closed) << cut;
        EXPECT_EQ(readingFails().kind, ErrorKind::closed) << "until it is opened";
        reactRightly();
        ASSERT_TRUE(m_port.open());
        nextAnswersAreRight();
    }
}

TEST_F(WrongTcp, AnAnswerBeforeHangingUpCounts)
{
    m_way.peer.reactBy([](const SeenRequest &request) {
        return Reaction{rightReaction(request).bytes, true};
    });
    Registers read(2);
    ASSERT_TRUE(m_port.read(RegisterArea::input, 20, read));
    EXPECT_EQ(read, (Registers{20, 21}));
    reactRightly();
    ASSERT_TRUE(m_port.open()); // its end may still be on its way, and would cross the next request
    nextAnswersAreRight();
}

TEST_F(WrongTcp, AllUnitsCanBeAsked)
{
    for (const int number : {0, 1, 247, 248, 254, 255}) {
        CrookedPeer peer([](const SeenRequest &request) {
            return Reaction{
                CrookedPeer::tcpFrame(request.transaction, request.unit, rightAnswer(request.message))};
        });
        ModbusPort port(
            {.host = QStringLiteral("127.0.0.1"), .tcpPort = peer.port(), .unit = number, .timeOut = 10s});
        ASSERT_TRUE(port.open());
        Registers read(1);
        EXPECT_TRUE(port.read(RegisterArea::input, 0, read)) << number;
    }
}

// However much of it comes: the time-out is that of the answer that is awaited.
TEST_F(WrongTcp, AnOldAnswerThatIsRepeatedWithoutAPauseIsNoAnswer)
{
    nextAnswersAreRight();
    m_way.peer.reactBy([](const SeenRequest &request) {
        return Reaction{.bytes = CrookedPeer::tcpFrame(static_cast<quint16>(request.transaction - 1), unit,
                                                       rightAnswer(request.message)),
                        .endlessly = true};
    });
    Registers read(2);
    const Instant begun = m_port.now();
    EXPECT_FALSE(m_port.read(RegisterArea::input, 20, read));
    EXPECT_LT(m_port.now() - begun, 10 * m_way.settings.timeOut);
}

using WrongLine = WrongAnswers<CrookedLine>;

// From a driver that is switched late, before and behind.
TEST_F(WrongLine, StrayBytesAroundAnAnswerArePassedOver)
{
    for (const QByteArray &stray : {QByteArray(1, '\0'), QByteArray(1, '\xFF'),
                                    QByteArray(1, static_cast<char>(unit)), QByteArray(5, '\x04')}) {
        for (const bool isBehind : {false, true}) {
            m_way.peer.reactBy([stray, isBehind](const SeenRequest &request) {
                const QByteArray right = rightReaction(request).bytes;
                return Reaction{isBehind ? right + stray : stray + right};
            });
            nextAnswersAreRight();
            EXPECT_TRUE(m_port.write(40, Registers{1, 2, 3}));
        }
    }
}

TEST_F(WrongLine, TheEchoOfAnAdapterIsPassedOver)
{
    m_way.peer.reactBy([](const SeenRequest &request) {
        return Reaction{CrookedPeer::lineFrame(unit, request.message) + rightReaction(request).bytes};
    });
    nextAnswersAreRight();
    EXPECT_TRUE(m_port.write(40, Registers{1, 2, 3}));
    Registers read(1);
    EXPECT_TRUE(m_port.read(RegisterArea::holding, 0x300, read));
    EXPECT_EQ(read.front(), 0x300);
}

// An echo alone is no answer.
TEST_F(WrongLine, AnEchoWithoutAnAnswerIsNone)
{
    m_way.peer.reactBy(
        [](const SeenRequest &request) { return Reaction{CrookedPeer::lineFrame(unit, request.message)}; });
    Registers read(2);
    EXPECT_FALSE(m_port.read(RegisterArea::input, 20, read));
    EXPECT_FALSE(m_port.write(40, Registers{1, 2, 3}));
}

TEST_F(WrongLine, ALateAnswerOfAnotherFormIsPassedOver)
{
    const auto late = std::make_shared<QByteArray>();
    m_way.peer.reactBy([late](const SeenRequest &request) {
        const QByteArray right = rightReaction(request).bytes;
        return Reaction{std::exchange(*late, right).isEmpty() ? QByteArray() : *late + right};
    });
    Registers two(2);
    EXPECT_EQ(m_port.read(RegisterArea::input, 20, two).error().kind, ErrorKind::noAnswer);
    Registers three(3);
    EXPECT_TRUE(m_port.read(RegisterArea::input, 30, three));
    EXPECT_EQ(three, (Registers{30, 31, 32}));
}

TEST_F(WrongLine, AnswersThatAreAlwaysTooLateAreNamedSo)
{
    for (const auto lateness : {600ms, 1'000ms}) { // while the line has to be quiet; within the next request
        m_way.peer.reactBy([lateness](const SeenRequest &request) {
            std::this_thread::sleep_for(lateness);
            return rightReaction(request);
        });
        ASSERT_TRUE(m_port.open());
        Registers read(2);
        EXPECT_FALSE(m_port.read(RegisterArea::input, 20, read).error().isLate) << "none has come yet";
        bool isLate = false;
        for (int requests = 0; requests < 2 && !isLate; ++requests)
            if (const auto done = m_port.read(RegisterArea::input, 20, read); !done)
                isLate = done.error().isLate;
        EXPECT_TRUE(isLate) << lateness.count();
    }
}

TEST_F(WrongLine, SilenceIsNotCalledLate)
{
    m_way.peer.reactBy([](const SeenRequest &) { return Reaction{}; });
    Registers read(2);
    for (int requests = 0; requests < 3; ++requests)
        EXPECT_FALSE(m_port.read(RegisterArea::input, 20, read).error().isLate);
}

TEST_F(WrongLine, ADamagedAnswer)
{
    for (const qsizetype byte : {3, 5, 7, 8}) {
        m_way.peer.reactBy([byte](const SeenRequest &request) {
            Reaction damaged = rightReaction(request);
            damaged.bytes[byte] = static_cast<char>(damaged.bytes[byte] ^ 4);
            return damaged;
        });
        const RegisterError error = readingFails();
        isWrong(error);
    }
}

// The time-out is that of the unit: it begins when the request has been sent, at 110 characters a second.
TEST(SlowLine, SilenceIsToldAfterTheTimeOutAndTheTimeOfTheRequest)
{
    PtyPair pty;
    GatewaySettings settings{
        .transport = GatewaySettings::Transport::rtu, .serialPort = pty.path(), .timeOut = 1ms};
    settings.serial.baudRate = 1'200;
    ModbusPort port(settings);
    ASSERT_TRUE(port.open());
    Registers read(2);
    const Instant begun = port.now();
    EXPECT_EQ(port.read(RegisterArea::input, 20, read).error().kind, ErrorKind::noAnswer);
    EXPECT_GE(port.now() - begun, 73ms);
}

// As gateways do that have room for few connections.
class ClosingGateway : public testing::Test
{
protected:
    static Reaction answer(const SeenRequest &request, bool hangsUp)
    {
        return {.bytes =
                    CrookedPeer::tcpFrame(request.transaction, request.unit, rightAnswer(request.message)),
                .hangsUp = hangsUp};
    }
    bool readsRightly(ModbusPort &port)
    {
        Registers registers(4);
        return port.read(RegisterArea::input, 7, registers) && registers == Registers{7, 8, 9, 10};
    }
    GatewaySettings settingsOf(CrookedPeer &peer)
    {
        return {.host = QStringLiteral("127.0.0.1"), .tcpPort = peer.port(), .unit = unit, .timeOut = 400ms};
    }
};

TEST_F(ClosingGateway, AfterEachAnswerIsLearnedAndCounted)
{
    CrookedPeer peer([](const SeenRequest &request) { return answer(request, true); });
    ModbusPort port(settingsOf(peer));
    ASSERT_TRUE(port.open());
    int failures = 0; // where the end of the connection crossed the request
    for (int i = 0; i < 20; ++i) {
        if (readsRightly(port))
            continue;
        ++failures;
        ASSERT_TRUE(port.open());
    }
    EXPECT_LE(failures, 1);
    EXPECT_TRUE(port.noticed().closesAfterEach);
    EXPECT_TRUE(port.noticed().keepsNone);
    EXPECT_GE(port.noticed().closedAfterEach, 5u);
    EXPECT_TRUE(port.write(3, Registers{1, 2})) << "connected anew before it is sent";
}

// Its end crosses the next request.
TEST_F(ClosingGateway, AWhileBehindEachAnswerLosesNoRequest)
{
    for (const auto deafFor : {1ms, 15ms}) {
        CrookedPeer peer([deafFor](const SeenRequest &request) {
            Reaction reaction = answer(request, true);
            reaction.deafFor = deafFor;
            return reaction;
        });
        ModbusPort port(settingsOf(peer));
        ASSERT_TRUE(port.open());
        for (int i = 0; i < 50; ++i)
            ASSERT_TRUE(readsRightly(port)) << i;
        EXPECT_TRUE(port.noticed().closesAfterEach);
        EXPECT_TRUE(port.write(3, Registers{1, 2}));
    }
}

TEST_F(ClosingGateway, ThatKeepsConnectionsAgainIsNotLeftAnyMore)
{
    std::atomic<bool> hangsUp = true;
    CrookedPeer peer([&](const SeenRequest &request) { return answer(request, hangsUp); });
    ModbusPort port(settingsOf(peer));
    ASSERT_TRUE(port.open());
    const auto readOften = [&](int times) {
        for (int i = 0; i < times; ++i) {
            const bool isRead = readsRightly(port);
            ASSERT_TRUE(isRead || port.open());
        }
    };
    readOften(10);
    ASSERT_TRUE(port.noticed().closesAfterEach);
    hangsUp = false;
    readOften(40);
    EXPECT_FALSE(port.noticed().closesAfterEach);
    const auto before = port.noticed().reconnections;
    const int connections = peer.connections();
    readOften(40);
    EXPECT_EQ(port.noticed().reconnections, before);
    EXPECT_EQ(peer.connections(), connections);
}

TEST_F(ClosingGateway, WhileIdleIsConnectedAnewBeforeARead)
{
    std::atomic<bool> hangsUp = false;
    CrookedPeer peer([&](const SeenRequest &request) { return answer(request, hangsUp); });
    ModbusPort port(settingsOf(peer));
    ASSERT_TRUE(port.open());
    ASSERT_TRUE(readsRightly(port));
    hangsUp = true;
    ASSERT_TRUE(readsRightly(port));
    hangsUp = false;
    std::this_thread::sleep_for(longestHangingUp);
    EXPECT_TRUE(readsRightly(port));
    EXPECT_EQ(port.noticed(), (RegisterPort::Noticed{.renewals = 1, .reconnections = 1}));
}

// Its outputs may be others by then: whoever writes has to look first.
TEST_F(ClosingGateway, WhileIdleIsNotWrittenToUnseen)
{
    std::atomic<bool> hangsUp = false;
    CrookedPeer peer([&](const SeenRequest &request) { return answer(request, hangsUp); });
    ModbusPort port(settingsOf(peer));
    ASSERT_TRUE(port.open());
    ASSERT_TRUE(readsRightly(port));
    hangsUp = true;
    ASSERT_TRUE(readsRightly(port));
    std::this_thread::sleep_for(longestHangingUp);
    const auto written = port.write(3, Registers{1, 2});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, ErrorKind::closed);
    EXPECT_FALSE(written.error().isSent);
}

} // namespace
} // namespace codewheel
