// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/message_rows.h"
#include "tests/support/places.h"

#include <QDate>
#include <QTime>

#include <gtest/gtest.h>
#include <random>

namespace codewheel {
namespace {

// "d": a day, "1": a message, "3": three similar ones.
std::string rowsOf(const MessageRows &rows)
{
    std::string text;
    qint64 next = 0;
    for (qint64 row = 0; row < rows.size(); ++row) {
        const MessageRows::Row its = rows.at(row);
        EXPECT_EQ(its.first, next);
        next += its.count;
        text += its.isDay() ? "d" : std::to_string(its.count);
    }
    return text;
}

std::vector<SightedMessage> example(const char *likenesses, qint64 day = 1)
{
    std::vector<SightedMessage> messages;
    for (const char *each = likenesses; *each != '\0'; ++each) {
        if (*each == ' ')
            ++day;
        else
            messages.push_back({static_cast<qint64>(messages.size()) + 1, day, static_cast<quint64>(*each)});
    }
    return messages;
}

MessageRows appended(const std::vector<SightedMessage> &messages)
{
    MessageRows rows;
    for (const SightedMessage &message : messages)
        rows.append(message);
    return rows;
}

TEST(MessageRows, ADayHasARowAndWhatRepeatsIsOne)
{
    EXPECT_EQ(rowsOf({}), "");
    EXPECT_EQ(rowsOf(appended(example("a"))), "d1");
    EXPECT_EQ(rowsOf(appended(example("abbbacc"))), "d1312");
    EXPECT_EQ(rowsOf(appended(example("aa aab b"))), "d2d21d1");
}

TEST(MessageRows, AreTheSameWhereverTheyBegan)
{
    std::mt19937 random(7);
    for (int round = 0; round < 300; ++round) {
        std::string text;
        for (int i = 0; i < 12; ++i)
            text += "aaab "[random() % 5];
        const auto messages = example(text.c_str());
        const auto middle = static_cast<std::ptrdiff_t>(random() % (messages.size() + 1));
        MessageRows rows;
        for (auto each = messages.begin() + middle; each != messages.end(); ++each)
            rows.append(*each);
        for (auto each = messages.begin() + middle; each != messages.begin();)
            rows.prepend(*--each);
        ASSERT_EQ(rowsOf(rows), rowsOf(appended(messages))) << text << middle;
    }
}

TEST(MessageRows, WhatIsLeftBeginsWithItsDay)
{
    const auto messages = example("aaab ab");
    for (std::size_t gone = 0; gone <= messages.size(); ++gone) {
        MessageRows rows = appended(messages);
        rows.dropFirst(static_cast<qint64>(gone));
        const std::vector<SightedMessage> left(messages.begin() + static_cast<std::ptrdiff_t>(gone),
                                               messages.end());
        EXPECT_EQ(rowsOf(rows), rowsOf(appended(left))) << gone;
    }
}

StoredMessage storedAt(Message message)
{
    return storedMessage(message, QDateTime(QDate(2026, 3, 1), QTime(12, 0)));
}

TEST(Likeness, FiguresThatOnlyCountMakeNoDifference)
{
    const auto errors = [](std::int64_t segment, std::int64_t more, std::int64_t all) {
        return likeness(storedAt({.id = MessageId::crcErrors, .arguments = {segment, more, all}}));
    };
    EXPECT_EQ(errors(3, 179, 179), errors(3, 3, 182));
    EXPECT_NE(errors(3, 179, 179), errors(4, 179, 179));
}

TEST(Likeness, PlaceSeverityAndWhatIsSaidDo)
{
    const Message message{.place = "1.0"_ring, .id = MessageId::wordsSent, .arguments = {std::int64_t{3}}};
    Message other = message;
    EXPECT_EQ(likeness(storedAt(message)), likeness(storedAt(other)));
    other.arguments = {std::int64_t{4}};
    EXPECT_NE(likeness(storedAt(message)), likeness(storedAt(other)));
    other = message;
    other.place = "2.0"_ring;
    EXPECT_NE(likeness(storedAt(message)), likeness(storedAt(other)));
    other = message;
    other.severity = Severity::fault;
    EXPECT_NE(likeness(storedAt(message)), likeness(storedAt(other)));
    other.refusal = Refusal{RefusalKind::busy, RefusalId::watchOnly, {}};
    EXPECT_NE(likeness(storedAt(message)), likeness(storedAt(other)));
}

} // namespace
} // namespace codewheel
