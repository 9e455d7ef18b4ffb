// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/stored_message.h"
#include "kinds/esc/simulator/line_training_acts.h"
#include "kinds/interbus/simulator/ring_training_acts.h"
#include "tests/support/places.h"
#include "vocabulary/mode_text.h"
#include "vocabulary/refusal_text.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

const QDateTime noonAndSevenMs(QDate(2026, 3, 1), QTime(12, 0, 0, 7), Qt::UTC);

TEST(StoredMessage, GivesBackEveryMessage)
{
    for (std::size_t i = 0; i < messageCount; ++i) {
        Message message{.place = "6.1"_ring,
                        .severity = Severity::attention,
                        .id = static_cast<MessageId>(i),
                        .arguments = {std::int64_t{3}, Word{0x86000000}, QStringLiteral("x")}};
        EXPECT_EQ(messageOf(storedMessage(message, noonAndSevenMs)), message) << i;
    }
}

TEST(StoredMessage, GivesBackEveryRefusal)
{
    for (std::size_t i = 0; i < refusalCount; ++i) {
        Message message{.severity = Severity::attention};
        message.refusal = Refusal{
            RefusalKind::device, static_cast<RefusalId>(i), {Parameter::steps, std::int64_t{-1}, Word{1}}};
        const StoredMessage stored = storedMessage(message, noonAndSevenMs);
        EXPECT_EQ(messageOf(stored), message) << i;
        EXPECT_EQ(codeOf(stored), refusalKey(static_cast<RefusalId>(i)));
        EXPECT_EQ(messageText(stored), messageText(message));
    }
}

TEST(StoredMessage, KeepsCodesAndNoText)
{
    const StoredMessage stored =
        storedMessage({.severity = Severity::fault,
                       .id = MessageId::deviceFault,
                       .arguments = {std::int64_t{3}, Word{0x86000000}},
                       .refusal = Refusal{RefusalKind::device, RefusalId::parametersLost, {}}},
                      noonAndSevenMs);
    EXPECT_EQ(stored.at, noonAndSevenMs.toMSecsSinceEpoch());
    EXPECT_EQ(stored.code, QStringLiteral("deviceFault"));
    EXPECT_EQ(stored.arguments, QStringLiteral("[3,{\"word\":\"86000000\"}]"));
    EXPECT_EQ(stored.refusal,
              QStringLiteral("{\"arguments\":[],\"code\":\"parametersLost\",\"kind\":\"device\"}"));
}

TEST(StoredMessage, KeepsKeysOfWhatATrainerDidAndOfAMode)
{
    struct Row
    {
        MessageId id;
        std::vector<RefusalArgument> arguments;
        const char *stored;
        const char *text;
    };
    const Row rows[] = {
        {MessageId::training, ringAct(RingAct::shaftTurns, {1'234.5}), R"(["shaftTurns",{"double":1234.5}])",
         "Shaft turns at 1234.5 rpm."},
        {MessageId::training, ringAct(RingAct::magnetMovedTo, {12.5}), R"(["magnetMovedTo",{"double":12.5}])",
         "Magnet moved to 12.50 mm."},
        {MessageId::training, actAtSeat(2, NodeId("1.0"), ringAct(RingAct::poweredOff)),
         R"(["seat",2,"1.0","poweredOff"])", "Seat 2, 1.0: Power off."},
        {MessageId::training, actAtSeat(2, {}, faultAct(TrainingFault::crcErrors, NodeId("3.0"), 7)),
         R"(["seat",2,"","fault","crcErrors","3.0",7])",
         "Seat 2: 3.0: CRC errors in the segment, 7 of 1000 cycles"},
        {MessageId::faultPlan, faultAct(TrainingFault::wireBreak, NodeId("3.0"), 0),
         R"(["fault","wireBreak","3.0",0])", "Fault plan: 3.0: Wire break before it is over"},
        {MessageId::training, lineAct(LineAct::bytesLost, {std::int64_t{5}}), R"(["bytesLost",5])",
         "Lost bytes: 5 of 1000."},
        {MessageId::training, lineTroubleAct(LineTrouble::batteryFlat, true),
         R"(["lineTrouble","batteryFlat",1])", "Battery flat: yes."},
        {MessageId::training,
         {QStringLiteral("Welle angehalten.")},
         R"(["Welle angehalten."])",
         "Welle angehalten."}, // of an earlier version
        {MessageId::modeSwitched, modeArguments({.mode = Mode::cam, .camProgram = 3}), R"(["cam",3])",
         "The encoder was switched: cam mode, program 3."},
        {MessageId::modeSwitched,
         {QStringLiteral("Drehzahlbetrieb")},
         R"(["Drehzahlbetrieb"])",
         "The encoder was switched: Drehzahlbetrieb."},
    };
    for (const Row &row : rows) {
        const StoredMessage stored =
            storedMessage({.id = row.id, .arguments = row.arguments}, noonAndSevenMs);
        EXPECT_EQ(stored.arguments.toStdString(), row.stored);
        EXPECT_EQ(messageText(stored).toStdString(), row.text);
    }
}

TEST(StoredMessage, ShowsACodeThisVersionDoesNotKnow)
{
    StoredMessage stored{.code = QStringLiteral("shaftBroken"),
                         .arguments = QStringLiteral("[7,{\"word\":\"020000FF\"}]")};
    EXPECT_EQ(messageText(stored),
              QStringLiteral("Message \"shaftBroken\" of another version of Codewheel: 7, 020000FF"));
    stored.arguments = QStringLiteral("no JSON");
    EXPECT_EQ(messageText(stored),
              QStringLiteral("Message \"shaftBroken\" of another version of Codewheel."));
}

TEST(StoredMessage, ShowsARefusalThisVersionDoesNotKnow)
{
    const StoredMessage stored{.code = QStringLiteral("refused"),
                               .arguments = QStringLiteral("[]"),
                               .refusal = QStringLiteral("{\"code\":\"tooCold\",\"arguments\":[-40]}")};
    EXPECT_EQ(messageText(stored),
              QStringLiteral("Message \"tooCold\" of another version of Codewheel: -40"));
    EXPECT_EQ(codeOf(stored), QStringLiteral("tooCold"));
}

} // namespace
} // namespace codewheel
