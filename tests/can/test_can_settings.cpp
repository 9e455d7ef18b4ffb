// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_refusals.h"
#include "can/can_settings.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

// A setting that is added has to be taken from the command line as its row says.
TEST(CanSettings, AreTakenFromALinkAsTheirRowsSay)
{
    for (const CanSetting &one : canSettings()) {
        const auto typed = [&one](int value) {
            const QString rate =
                one.its == &CanLinkArgument::rate ? QString() : QStringLiteral(",rate=125000");
            return QStringLiteral("slcan:ttyACM0%1,%2=%3").arg(rate, QString::fromLatin1(one.key)).arg(value);
        };
        const std::string name = one.key;
        ASSERT_TRUE(one.hasAdapter(one.usual)) << name;
        const auto usual = parseCanLink(typed(one.usual));
        ASSERT_TRUE(usual) << name;
        EXPECT_EQ((*usual).*(one.its), one.usual) << name;
        for (const int wrong : {one.least - 1, one.most + 1}) {
            const auto refused = parseCanLink(typed(wrong));
            ASSERT_FALSE(refused) << name << ' ' << wrong;
            EXPECT_EQ(refused.error().id, one.wrong) << name;
        }
        EXPECT_FALSE(one.label().isEmpty() || one.sentence().isEmpty()) << name;
        EXPECT_EQ(canSetting(QString::fromLatin1(one.key)), &one);
    }
    EXPECT_EQ(canSetting(u"speed"), nullptr);
}

TEST(CanSettings, TellTheRatesThatSerialAdaptersHave)
{
    const CanSetting &rate = *canSetting(u"rate");
    EXPECT_TRUE(rate.isWithin(83'333)); // of an interface
    EXPECT_FALSE(rate.hasAdapter(83'333));
    EXPECT_TRUE(rate.hasAdapter(250'000));
}

} // namespace
} // namespace codewheel
