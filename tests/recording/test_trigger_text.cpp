// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/trigger_text.h"

#include <gmock/gmock.h>

namespace codewheel {
namespace {

class TriggerText : public testing::TestWithParam<const char *>
{};

TEST_P(TriggerText, IsReadAsItIsWritten)
{
    const QString text = QString::fromLatin1(GetParam());
    const auto trigger = parseTrigger(text);
    ASSERT_TRUE(trigger);
    EXPECT_EQ(triggerKey(*trigger), text);
}

INSTANTIATE_TEST_SUITE_P(All, TriggerText,
                         testing::Values("1.0/in.0", "1.0/in.25", "1.0/out.31=0", "3/1.0/cams.7",
                                         "1.0/position>1000", "esc:05/position<-5", "4/esc:05/speed>12.5",
                                         "1.0/speed<-0.001", "1.0/speed>0", "fault", "attention",
                                         "information", "1.0/fault", "esc:05/attention", "bus:3/fault"));

TEST(TriggerTexts, WhatTheySay)
{
    const auto bit = std::get<BitTrigger>(parseTrigger(QStringLiteral("2.0/in.25=0")).value());
    EXPECT_EQ(bit.place.key(), QStringLiteral("2.0"));
    EXPECT_EQ(bit.channel, Channel::in);
    EXPECT_EQ(bit.bit, 25U);
    EXPECT_FALSE(bit.rising);
    EXPECT_TRUE(std::get<BitTrigger>(parseTrigger(QStringLiteral("2.0/in.25=1")).value()).rising);
    const auto speed = std::get<ThresholdTrigger>(parseTrigger(QStringLiteral("05/speed<-1.5")).value());
    EXPECT_EQ(speed.place.key(), QStringLiteral("esc:05"));
    EXPECT_EQ(speed.threshold, -1'500) << "thousandths of a step per second";
    EXPECT_FALSE(speed.rising);
    EXPECT_EQ(std::get<MessageTrigger>(parseTrigger(QStringLiteral("fault")).value()).place, std::nullopt);
    EXPECT_EQ(std::get<MessageTrigger>(parseTrigger(QStringLiteral("bus:3/attention")).value()).place,
              (Place{{3}, {}}));
}

struct Nonsense
{
    const char *text;
    TriggerFault fault;
};

TEST(TriggerTexts, WhatIsWrongWithOthers)
{
    using enum TriggerFault;
    for (const auto &[text, fault] : {Nonsense{"", form},
                                      {"nonsense", form},
                                      {"1.0", form},
                                      {"Fault", form},
                                      {"1.0/position", form},
                                      {"1.0/in", form},
                                      {"1.0/in>5", form},
                                      {"1.0/in.5=2", form},
                                      {"1.0/in.5=", form},
                                      {"1.0/position=5", form},
                                      {"/in.5", place},
                                      {"nowhere/in.5", place},
                                      {"bus:0/fault", place},
                                      {"bus:3/in.5", place},
                                      {"bus:3/position>5", place},
                                      {"1.0/", channel},
                                      {"1.0/turns>5", channel},
                                      {"1.0/inn.5", channel},
                                      {"1.0/>5", channel},
                                      {"1.0/in.32", bit},
                                      {"1.0/in.05", bit},
                                      {"1.0/in.-1", bit},
                                      {"1.0/cams.8", bit},
                                      {"1.0/position>", number},
                                      {"1.0/position>1.5", number},
                                      {"1.0/position>>5", number},
                                      {"1.0/position>9223372036854775808", number},
                                      {"1.0/speed>1,5", number},
                                      {"1.0/speed>nan", number},
                                      {"1.0/speed>1e13", number}}) {
        const auto trigger = parseTrigger(QString::fromLatin1(text));
        ASSERT_FALSE(trigger) << text;
        EXPECT_EQ(trigger.error(), fault) << text;
    }
}

TEST(TriggerTexts, ThePlaceMayBeWrittenAsPeopleNameIt)
{
    const auto placeOf = [](const QString &text) {
        return text == QStringLiteral("Crane 2/Hoist") ? Place::parse(u"3/1.0") : std::nullopt;
    };
    const auto trigger = parseTrigger(QStringLiteral("Crane 2/Hoist/position>1000"), placeOf);
    ASSERT_TRUE(trigger);
    EXPECT_EQ(triggerKey(*trigger), QStringLiteral("3/1.0/position>1000"));
    EXPECT_EQ(parseTrigger(QStringLiteral("1.0/fault"), placeOf).error(), TriggerFault::place);
}

} // namespace
} // namespace codewheel
