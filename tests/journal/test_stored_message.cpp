// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/stored_message.h"
#include "tests/support/places.h"
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
