// SPDX-License-Identifier: GPL-3.0-or-later
// The table "What it says" of the manual: each of its sentences is said of a peer that has just this fault,
// on a real port, and of no row nobody knows what says it.
#include "kinds/interbus/gateway/gateway_link.h"
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/links/modbus_port.h"
#include "tests/kinds/interbus/gateway/gateway_ring.h"
#include "tests/links/crooked_peer.h"
#include "tests/support/pty_pair.h"
#include "vocabulary/refusal_text.h"

#include <QFile>

#include <array>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <thread>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

constexpr quint8 askedUnit = 1;
constexpr Instant longEnough = 5s;
constexpr std::size_t encodersTold = 3;
constexpr char readsInput = 4;
constexpr char readsHolding = 3;
constexpr char writesHolding = 16;

// The first thing that a link says which connects, reads OUT back, and then writes the same for a while.
std::string firstSaid(const GatewaySettings &settings)
{
    GatewayLink link(std::make_unique<ModbusPort>(settings), settings, test::k3Ring(encodersTold));
    if (const auto opened = link.open(); !opened)
        return refusalText(opened.error()).toStdString();
    std::vector<Word> in(encodersTold);
    const auto back = link.readBackOut();
    if (!back && back.error().id != GatewayRefusalId::outNotReadBack)
        return refusalText(back.error()).toStdString();
    const std::vector<Word> out(encodersTold, 1);
    for (const Instant end = link.now() + longEnough; link.now() < end;) {
        if (const auto done = link.exchange(out, in); !done)
            return refusalText(done.error()).toStdString();
        if (link.toldRing() && link.toldRing()->stands())
            return refusalText(link.toldRing()->whyItStands()).toStdString();
    }
    return "nothing";
}

GatewaySettings impatient()
{
    return {.host = QStringLiteral("127.0.0.1"), .unit = askedUnit, .timeOut = 200ms, .patience = 500ms};
}

std::string saidOverTcp(const CrookedPeer::React &react, GatewaySettings settings = impatient())
{
    CrookedPeer peer(react);
    settings.tcpPort = peer.port();
    return firstSaid(settings);
}

std::string saidOnLine(const CrookedPeer::React &react)
{
    PtyPair pty;
    CrookedPeer peer(react, pty.descriptor());
    GatewaySettings settings = impatient();
    settings.timeOut = 600ms; // the peer is a thread, and has to be heard
    settings.transport = GatewaySettings::Transport::rtu;
    settings.serialPort = pty.path();
    return firstSaid(settings);
}

Reaction rightOverTcp(const SeenRequest &request)
{
    return {CrookedPeer::tcpFrame(request.transaction, askedUnit, rightAnswer(request.message))};
}

// Refuses what `isMeant`, and answers everything else.
CrookedPeer::React refusing(int exception, const std::function<bool(const QByteArray &)> &isMeant)
{
    return [exception, isMeant](const SeenRequest &request) {
        if (!isMeant(request.message))
            return rightOverTcp(request);
        const QByteArray message =
            QByteArray(1, static_cast<char>(request.message[0] | 0x80)) + static_cast<char>(exception);
        return Reaction{CrookedPeer::tcpFrame(request.transaction, askedUnit, message)};
    };
}

CrookedPeer::React refusing(int exception, char function)
{
    return refusing(exception, [function](const QByteArray &message) { return message[0] == function; });
}

std::string saidOfUnplugged()
{
    PtyPair pty;
    GatewaySettings settings = impatient();
    settings.transport = GatewaySettings::Transport::rtu;
    settings.serialPort = pty.path();
    const CrookedPeer peer(
        [&pty](const SeenRequest &) {
            pty.unplug();
            return Reaction();
        },
        pty.descriptor());
    return firstSaid(settings);
}

std::string saidOfStatus(Register status)
{
    GatewaySettings settings = impatient();
    settings.statusRegister = status; // each register has its own number as its value
    settings.runBit = 5;
    settings.faultBits = 1U << 2;
    return saidOverTcp(rightOverTcp, settings);
}

std::string saidOfNobody()
{
    GatewaySettings settings = impatient();
    settings.tcpPort = [] {
        const CrookedPeer gone(rightOverTcp);
        return gone.port();
    }();
    return firstSaid(settings);
}

// By the text in the first column of the table.
std::map<std::string, std::function<std::string()>> peersOfTable()
{
    return {
        {"does not answer", [] { return saidOverTcp([](const SeenRequest &) { return Reaction(); }); }},
        {"answers too late",
         [] {
             return saidOverTcp([](const SeenRequest &request) {
                 std::this_thread::sleep_for(300ms);
                 return rightOverTcp(request);
             });
         }},
        {"the gateway does not repeat the number of the request",
         [] {
             return saidOverTcp([](const SeenRequest &request) {
                 return Reaction{CrookedPeer::tcpFrame(4711, askedUnit, rightAnswer(request.message))};
             });
         }},
        {"it is of unit",
         [] {
             return saidOnLine([](const SeenRequest &request) {
                 return Reaction{CrookedPeer::lineFrame(askedUnit + 1, rightAnswer(request.message))};
             });
         }},
        {"it is damaged or incomplete",
         [] {
             return saidOnLine([](const SeenRequest &request) {
                 QByteArray frame = CrookedPeer::lineFrame(askedUnit, rightAnswer(request.message));
                 frame.back() = static_cast<char>(~frame.back());
                 return Reaction{frame};
             });
         }},
        {"it is incomplete",
         [] {
             return saidOverTcp(
                 [](const SeenRequest &request) { return Reaction{rightOverTcp(request).bytes.chopped(1)}; });
         }},
        {"it is not Modbus",
         [] { return saidOverTcp([](const SeenRequest &) { return Reaction{"220 ready for mail\r\n"}; }); }},
        {"something on the line does not stop sending",
         [] {
             return saidOnLine([](const SeenRequest &) {
                 return Reaction{.bytes = QByteArray(64, 'U'), .endlessly = true};
             });
         }},
        {"it does not have this function", [] { return saidOverTcp(refusing(1, readsInput)); }},
        {"it does not have these registers", [] { return saidOverTcp(refusing(2, readsInput)); }},
        {"it does not accept this value or this number of registers",
         [] { return saidOverTcp(refusing(3, writesHolding)); }},
        {"The watchdog of its outputs may have tripped",
         [] { return saidOverTcp(refusing(4, writesHolding)); }},
        {"it is busy", [] { return saidOverTcp(refusing(6, readsInput)); }},
        {"the gateway has no path to the unit", [] { return saidOverTcp(refusing(10, readsInput)); }},
        {"the unit behind the gateway does not answer", [] { return saidOverTcp(refusing(11, readsInput)); }},
        {"0 is no exception code", [] { return saidOverTcp(refusing(0, readsInput)); }},
        {"this code is not in the standard",
         [] { return saidOverTcp(refusing(9, readsInput)) + saidOverTcp(refusing(12, readsInput)); }},
        {"does not have all OUT registers of the ring as planned",
         [] {
             return saidOverTcp(refusing(2, [](const QByteArray &message) {
                 const int end = message[2] + message[4];
                 return message[0] == readsHolding && end > 4;
             }));
         }},
        {"has closed the connection",
         [] {
             return saidOverTcp([](const SeenRequest &request) {
                 return request.message[0] == writesHolding ? Reaction{.hangsUp = true}
                                                            : rightOverTcp(request);
             });
         }},
        {"closes the connection without an answer",
         [] { return saidOverTcp([](const SeenRequest &) { return Reaction{.hangsUp = true}; }); }},
        {"refuses the connection", saidOfNobody},
        {"is gone", saidOfUnplugged},
        {"Somebody else writes to", [] { return saidOverTcp(rightOverTcp); }},
        {"its ring does not run, its ring has failed",
         [] { return saidOfStatus(0x0080) + saidOfStatus(0x00A4); }},
    };
}

QStringList sentencesOfManual()
{
    QFile page(QStringLiteral(CODEWHEEL_GATEWAY_MANUAL));
    EXPECT_TRUE(page.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(page.readAll());
    const QString table =
        text.section(QStringLiteral("## What it says"), 1).section(QStringLiteral("## "), 0, 0);
    QStringList sentences;
    for (const QString &line : table.split(u'\n'))
        if (line.startsWith(QStringLiteral("| ")))
            sentences << line.section(u'|', 1, 1).trimmed();
    sentences.removeFirst(); // the head
    return sentences;
}

TEST(GatewaySentences, AreSaidOfAPeerWithJustThisFault)
{
    const auto peers = peersOfTable();
    for (const auto &[sentence, said] : peers) {
        const std::string text = said();
        for (const QString &part : QString::fromStdString(sentence).split(QStringLiteral(", ")))
            EXPECT_THAT(text, HasSubstr(part.toStdString()));
    }
}

// Only where it has answered nothing.
TEST(GatewaySentences, FewClientsAreNoCauseWhereAnswersCameBefore)
{
    const std::string closed = peersOfTable().at("has closed the connection")();
    EXPECT_THAT(closed, testing::Not(HasSubstr("few clients")));
    EXPECT_THAT(peersOfTable().at("closes the connection without an answer")(), HasSubstr("few clients"));
}

// Whatever number it is: one of our own requests', or none.
TEST(GatewaySentences, OfAGatewayWithOneNumberForAllNameThat)
{
    for (const quint16 number : std::array<quint16, 4>{0, 1, 2, 0x1234}) {
        const std::string said = saidOverTcp([number](const SeenRequest &request) {
            return Reaction{CrookedPeer::tcpFrame(number, askedUnit, rightAnswer(request.message))};
        });
        EXPECT_THAT(said, HasSubstr("the gateway does not repeat the number of the request")) << number;
    }
}

TEST(GatewaySentences, OnALineNameLateAnswersToo)
{
    for (const auto lateness : {900ms, 1'500ms}) {
        const std::string said = saidOnLine([lateness](const SeenRequest &request) {
            std::this_thread::sleep_for(lateness);
            return Reaction{CrookedPeer::lineFrame(askedUnit, rightAnswer(request.message))};
        });
        EXPECT_THAT(said, HasSubstr("answers too late")) << lateness.count();
    }
}

TEST(GatewaySentences, AreThoseOfTheManual)
{
    std::vector<std::string> tried;
    for (const auto &[sentence, said] : peersOfTable())
        tried.push_back(sentence);
    std::vector<std::string> told;
    for (const QString &sentence : sentencesOfManual())
        told.push_back(sentence.toStdString());
    EXPECT_THAT(told, testing::UnorderedElementsAreArray(tried));
}

} // namespace
} // namespace codewheel
