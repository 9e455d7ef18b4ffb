// SPDX-License-Identifier: GPL-3.0-or-later
// A gateway that ends connections while it is asked. What is in OUT and which words it has had is held
// against what was sent.
#include "kinds/interbus/gateway/gateway_link.h"
#include "kinds/interbus/links/modbus_port.h"
#include "tests/kinds/interbus/gateway/gateway_ring.h"
#include "tests/links/crooked_peer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

constexpr int firstOfOut = 100;

// One encoder: IN counts its reads, and OUT is what was written.
class ClosingRing
{
public:
    enum class Ends { never, behindEachAnswer, aMomentBehindEachAnswer, inPlaceOfOneAnswerToAWrite };

    void end(Ends how)
    {
        const std::scoped_lock lock(m_mutex);
        m_ends = how;
    }
    std::vector<Word> words()
    {
        const std::scoped_lock lock(m_mutex);
        return m_words;
    }
    int connections() { return m_peer.connections(); }
    GatewaySettings settings() const
    {
        return {.host = QStringLiteral("127.0.0.1"),
                .tcpPort = m_peer.port(),
                .outFirst = firstOfOut,
                .pollInterval = 0ms,
                .timeOut = 10s};
    }

private:
    static Word wordIn(const QByteArray &message, qsizetype at)
    {
        Word word = 0;
        for (const char byte : message.mid(at, 4))
            word = word << 8 | static_cast<quint8>(byte);
        return word;
    }
    Reaction react(const SeenRequest &request)
    {
        const std::scoped_lock lock(m_mutex);
        const bool writes = request.message[0] == 16;
        const bool reads = request.message[0] == 3;
        if (writes && (m_words.empty() || m_words.back() != wordIn(request.message, 6)))
            m_words.push_back(wordIn(request.message, 6));
        QByteArray message = rightAnswer(request.message);
        if (reads && !m_words.empty())
            for (int i = 0; i < 4; ++i)
                message[2 + i] = static_cast<char>(m_words.back() >> (24 - 8 * i) & 0xFF);
        else if (reads)
            message.replace(2, 4, QByteArray(4, '\0'));
        if (writes && m_ends == Ends::inPlaceOfOneAnswerToAWrite) {
            m_ends = Ends::never;
            return {.hangsUp = true};
        }
        Reaction reaction{CrookedPeer::tcpFrame(request.transaction, request.unit, message)};
        if (m_ends == Ends::behindEachAnswer) {
            reaction.hangsUp = true;
            reaction.deafFor = 2ms;
        }
        if (m_ends == Ends::aMomentBehindEachAnswer) {
            reaction.hangsUp = true;
            reaction.deafFor = std::chrono::milliseconds(m_moment = (m_moment + 7) % 30);
        }
        return reaction;
    }

    std::mutex m_mutex;
    Ends m_ends = Ends::never;
    int m_moment = 0;
    std::vector<Word> m_words; // that were in OUT, one after the other
    CrookedPeer m_peer{[this](const SeenRequest &request) { return react(request); }};
};

class ClosingWhileAsked : public testing::Test
{
protected:
    void open()
    {
        ASSERT_TRUE(link.open());
        ASSERT_TRUE(link.readBackOut());
    }
    // Words that follow each other, each for some exchanges.
    void send(Word first, Word last)
    {
        for (Word word = first; word <= last; ++word) {
            expected.push_back(word);
            for (int i = 0; i < 3; ++i)
                ASSERT_TRUE(exchange(word)) << word;
        }
    }
    // The same, until the link stays on one connection again.
    void keepConnection(Word word)
    {
        for (int before = -1; before != ring.connections(); ++word) {
            before = ring.connections();
            expected.push_back(word);
            ASSERT_TRUE(exchange(word)) << word;
        }
    }
    bool exchange(Word word)
    {
        std::vector<Word> in(1);
        return link.exchange(std::vector<Word>{word}, in).has_value();
    }

    ClosingRing ring;
    GatewayLink link{std::make_unique<ModbusPort>(ring.settings()), ring.settings(), test::k3Ring(1)};
    std::vector<Word> expected;
};

TEST_F(ClosingWhileAsked, BehindEachAnswerEachWordIsInOutOnce)
{
    ring.end(ClosingRing::Ends::behindEachAnswer);
    open();
    send(1, 20);
    EXPECT_EQ(ring.words(), expected);
}

TEST_F(ClosingWhileAsked, ByOneThatHasDoneSoOftenAWriteIsSentAgain)
{
    ring.end(ClosingRing::Ends::behindEachAnswer);
    open();
    send(1, 20);
    ring.end(ClosingRing::Ends::never);
    keepConnection(21);
    ring.end(ClosingRing::Ends::inPlaceOfOneAnswerToAWrite);
    send(100, 105);
    EXPECT_EQ(ring.words(), expected);
}

TEST_F(ClosingWhileAsked, EachConnectionIsCounted)
{
    for (const auto how : {ClosingRing::Ends::behindEachAnswer, ClosingRing::Ends::aMomentBehindEachAnswer}) {
        ring.end(how);
        open();
        send(1, 20);
        link.close();
        EXPECT_EQ(link.figures()->connections, static_cast<unsigned>(ring.connections()));
        EXPECT_TRUE(link.figures()->closesAfterEach);
        EXPECT_GT(2 * link.figures()->closedAfterEach, link.figures()->connections);
    }
}

// By one that never did so before: what was sent may have arrived, and OUT may be another by now.
TEST_F(ClosingWhileAsked, AWriteIsNotSentAgain)
{
    open();
    send(1, 3);
    ring.end(ClosingRing::Ends::inPlaceOfOneAnswerToAWrite);
    EXPECT_FALSE(exchange(4));
}

} // namespace
} // namespace codewheel
