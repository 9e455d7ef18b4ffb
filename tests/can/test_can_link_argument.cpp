// SPDX-License-Identifier: GPL-3.0-or-later
#include "can/can_link_argument.h"
#include "can/can_refusals.h"
#include "vocabulary/refusal_text.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

std::string canLinkRefusal(const QString &typed)
{
    const auto link = parseCanLink(typed);
    return link ? "none" : refusalText(link.error()).toStdString();
}

TEST(CanLinkArgument, IsAnInterfaceOrAPortWithItsRate)
{
    EXPECT_EQ(parseCanLink(QStringLiteral("can:can0")).value(),
              (CanLinkArgument{.where = QStringLiteral("can0")}));
    const CanLinkArgument adapter{
        .isSerial = true, .where = QStringLiteral("ttyACM0"), .rate = 250'000, .baudRate = 115'200};
    EXPECT_EQ(parseCanLink(QStringLiteral("slcan:ttyACM0,rate=250000")).value(), adapter);
    const CanLinkArgument byPath{
        .isSerial = true, .where = QStringLiteral("/dev/ttyUSB0"), .rate = 10'000, .baudRate = 57'600};
    EXPECT_EQ(parseCanLink(QStringLiteral("slcan:/dev/ttyUSB0,baud=57600,rate=10000")).value(), byPath);
}

TEST(CanLinkArgument, IsTypedAsItIsRead)
{
    for (const char *typed :
         {"can:vcan0", "slcan:ttyACM0,rate=1000000", "slcan:/dev/x,rate=125000,baud=57600"})
        EXPECT_EQ(parseCanLink(QString::fromLatin1(typed)).value().text().toStdString(), typed);
}

TEST(CanLinkArgument, SaysWhatIsWrong)
{
    EXPECT_EQ(canLinkRefusal(QStringLiteral("slcan:ttyACM0,rate=250")),
              "\"250\" is not a rate that serial CAN adapters have. Give one of these, in Bd: 10000, 20000, "
              "50000, 100000, 125000, 250000, 500000, 800000, 1000000.");
    const auto idOf = [](const char *typed) {
        const auto link = parseCanLink(QString::fromLatin1(typed));
        return link ? RefusalCode(RefusalId::nothingToDo) : link.error().id;
    };
    EXPECT_EQ(idOf("slcan:ttyACM0,rate=250k"), CanRefusalId::rateWrong);
    EXPECT_EQ(idOf("slcan:ttyACM0,rate=83300"), CanRefusalId::rateWrong);
    EXPECT_EQ(idOf("slcan:ttyACM0,rate="), CanRefusalId::rateWrong);
    EXPECT_EQ(idOf("slcan:ttyACM0"), CanRefusalId::rateMissing);
    EXPECT_EQ(idOf("slcan:,rate=250000"), CanRefusalId::linkNotUnderstood);
    EXPECT_EQ(idOf("slcan:ttyACM0,rate=250000,baud=fast"), CanRefusalId::baudRateWrong);
    EXPECT_EQ(idOf("slcan:ttyACM0,rate=250000,speed=1"), CanRefusalId::settingUnknown);
    EXPECT_EQ(idOf("can:can0,rate=250000"), CanRefusalId::rateBySystem);
    EXPECT_EQ(idOf("can:can0,x=1"), CanRefusalId::linkNotUnderstood);
    EXPECT_EQ(idOf("can:"), CanRefusalId::linkNotUnderstood);
    EXPECT_EQ(idOf("can:../mem"), CanRefusalId::linkNotUnderstood);
    EXPECT_EQ(idOf("can:a0123456789abcdef"), CanRefusalId::linkNotUnderstood);
    EXPECT_EQ(idOf("can0"), CanRefusalId::linkNotUnderstood);
}

} // namespace
} // namespace codewheel
