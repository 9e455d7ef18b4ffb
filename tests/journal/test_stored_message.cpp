// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/stored_message.h"
#include "kinds/esc/protocol/esc_messages.h"
#include "kinds/esc/simulator/line_training_acts.h"
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/simulator/ring_training_acts.h"
#include "tests/support/places.h"
#include "vocabulary/message_items.h"
#include "vocabulary/mode_text.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/texts_of_kinds.h"

#include <QLocale>

#include <gtest/gtest.h>
#include <span>

namespace codewheel {
namespace {

const QDateTime noonAndSevenMs(QDate(2026, 3, 1), QTime(12, 0, 0, 7), Qt::UTC);

TEST(StoredMessage, GivesBackEveryMessage)
{
    for (const MessageCode &code : codesOf(messageFamilies())) {
        Message message{.place = "6.1"_ring,
                        .severity = Severity::attention,
                        .id = code,
                        .arguments = {std::int64_t{3}, Word{0x86000000}, QStringLiteral("x")}};
        EXPECT_EQ(messageOf(storedMessage(message, noonAndSevenMs)), message) << code.row().key;
    }
}

TEST(StoredMessage, GivesBackEveryRefusal)
{
    for (const RefusalCode &code : codesOf(refusalFamilies())) {
        Message message{.severity = Severity::attention};
        message.refusal = Refusal{RefusalKind::device, code, {Parameter::steps, std::int64_t{-1}, Word{1}}};
        const StoredMessage stored = storedMessage(message, noonAndSevenMs);
        EXPECT_EQ(messageOf(stored), message) << code.row().key;
        EXPECT_EQ(codeOf(stored), refusalKey(code));
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

struct StoredRow
{
    MessageCode id;
    std::vector<RefusalArgument> arguments;
    const char *stored;
    const char *text;
};

void expectStoredAndTold(std::span<const StoredRow> rows)
{
    for (const StoredRow &row : rows) {
        const StoredMessage stored =
            storedMessage({.id = row.id, .arguments = row.arguments}, noonAndSevenMs);
        EXPECT_EQ(stored.arguments.toStdString(), row.stored);
        EXPECT_EQ(messageText(stored).toStdString(), row.text);
    }
}

TEST(StoredMessage, KeepsKeysOfWhatATrainerDidAndOfAMode)
{
    const StoredRow rows[] = {
        {MessageId::training, ringAct(RingAct::shaftTurns, {1'234.5}), R"(["shaftTurns",{"double":1234.5}])",
         "Shaft turns at 1234.5 rpm."},
        {MessageId::training, ringAct(RingAct::magnetMovedTo, {12.5}), R"(["magnetMovedTo",{"double":12.5}])",
         "Magnet moved to 12.50 mm."},
        {MessageId::training, actAtSeat(2, NodeId("1.0"), ringAct(RingAct::poweredOff)),
         R"(["seat",2,"1.0","poweredOff"])", "Seat 2, 1.0: Power off."},
        {MessageId::training, actAtSeat(2, {}, faultAct(TrainingFault::crcErrors, NodeId("3.0"), 7)),
         R"(["seat",2,"","fault","crcErrors","3.0",7])",
         "Seat 2: 3.0: CRC errors in the segment, 7 of 1000 cycles"},
        {RingMessageId::faultPlan, faultAct(TrainingFault::wireBreak, NodeId("3.0"), 0),
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
    expectStoredAndTold(rows);
}

TEST(StoredMessage, KeepsWhatAMessageListsAsValuesAndKeys)
{
    MessageItems values{std::int64_t{2}, std::int64_t{2}};
    addItem(values, Parameter::steps, std::int64_t{7200});
    addItem(values, Parameter::direction, QStringLiteral("cw"));
    MessageItems doubts{std::int64_t{4}, std::int64_t{1}};
    addItem(doubts, MessageItem::factorySettings);
    addItem(doubts, MessageItem::position);
    addItem(doubts, MessageItem::camProgram, {std::int64_t{3}});
    addItem(doubts, MessageItem::typed, {QStringLiteral("05GP00001770"), std::int64_t{24}});
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
    const StoredRow rows[] = {
        {MessageId::parametersWritten, values,
         R"([2,2,{"parameter":"steps"},7200,{"parameter":"direction"},"cw"])",
         "Written and activated: Steps = 7.200, Direction = cw (parameters: 2, EEPROM writes: 2)."},
        {MessageId::restoredReadBack, values,
         R"([2,2,{"parameter":"steps"},7200,{"parameter":"direction"},"cw"])",
         "The earlier values were written again and read back: Steps = 7.200, Direction = cw (EEPROM "
         "writes: 2)."},
        {MessageId::inDoubt, doubts,
         R"([4,1,"factorySettings","position","camProgram",3,"typed","05GP00001770",24])",
         "It is not known whether the encoder has this: factory settings, position, cam program 3, 05: set "
         "preset to 1770h = 6.000 (05GP00001770). Read it to know."},
        {EscMessageId::typedWritten,
         {QStringLiteral("05GP00001770"), std::int64_t{24}},
         R"(["05GP00001770",24])",
         "Written by hand: 05: set preset to 1770h = 6.000 (05GP00001770). EEPROM writes: 1."},
        {MessageId::outLeft,
         {QStringLiteral("02000100"), QStringLiteral("80000000")},
         R"(["02000100","80000000"])",
         "OUT may still hold 02000100 or 80000000: the encoder may give no position. Bring it back once the "
         "bus runs again."},
        {MessageId::recordingEnded,
         {QStringLiteral("/tmp/a.cwrec"), std::int64_t{614'400}},
         R"(["/tmp/a.cwrec",614400])",
         "The recording has ended: /tmp/a.cwrec, 614,4 kB."},
        {EscMessageId::lineOpened,
         {QStringLiteral("training"), std::int64_t{19'200}},
         R"(["training",19200])",
         "The serial line training line is open at 19.200 Bd."},
    };
    expectStoredAndTold(rows);
    QLocale::setDefault(before);
}

TEST(StoredMessage, ShowsTheTextsOfAnEarlierVersionAsTheyAre)
{
    const StoredRow rows[] = {
        {MessageId::parametersWritten,
         {std::int64_t{1}, std::int64_t{1}, QStringLiteral("Schritte = 7.200")},
         R"([1,1,"Schritte = 7.200"])",
         "Written and activated: Schritte = 7.200 (parameters: 1, EEPROM writes: 1)."},
        {MessageId::restoredConfirmed,
         {QStringLiteral("Nockenprogramm 1, 3"), std::int64_t{2}},
         R"(["Nockenprogramm 1, 3",2])",
         "The earlier values were written again, confirmed and activated, but cannot be read: "
         "Nockenprogramm 1, 3 (EEPROM writes: 2)."},
        {MessageId::inDoubt,
         {QStringLiteral("position"), std::int64_t{1}},
         R"(["position",1])",
         "It is not known whether the encoder has this: position. Read it to know."},
        {EscMessageId::typedWritten,
         {QStringLiteral("05: Preset auf 1770h = 6.000 setzen (05GP00001770)")},
         R"x(["05: Preset auf 1770h = 6.000 setzen (05GP00001770)"])x",
         "Written by hand: 05: Preset auf 1770h = 6.000 setzen (05GP00001770). EEPROM writes: 1."},
        {MessageId::outLeft,
         {QStringLiteral("02000100 oder 80000000")},
         R"(["02000100 oder 80000000"])",
         "OUT may still hold 02000100 oder 80000000: the encoder may give no position. Bring it back once "
         "the bus runs again."},
        {MessageId::recordingEnded,
         {QStringLiteral("/tmp/a.cwrec"), QStringLiteral("614,4 kB")},
         R"(["/tmp/a.cwrec","614,4 kB"])",
         "The recording has ended: /tmp/a.cwrec, 614,4 kB."},
        {MessageId::valuesRestored,
         {QStringLiteral("29.11.26 14:02"), std::int64_t{3}},
         R"(["29.11.26 14:02",3])",
         "Values of 29.11.26 14:02 were restored: 3."},
    };
    expectStoredAndTold(rows);
}

TEST(StoredMessage, TellsTheTimeOfRestoredValuesInTheLanguageOfItsReader)
{
    const QDateTime at(QDate(2026, 3, 1), QTime(12, 0), Qt::UTC);
    const QString told = messageText(
        {.id = MessageId::valuesRestored, .arguments = {at.toString(Qt::ISODate), std::int64_t{3}}});
    EXPECT_EQ(told, QStringLiteral("Values of %1 were restored: 3.")
                        .arg(QLocale().toString(at.toLocalTime(), QLocale::ShortFormat)));
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
