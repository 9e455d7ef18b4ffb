// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/completion/complete.h"
#include "cli/kinds/canopen/canopen_link.h"
#include "kinds/canopen/protocol/canopen_address.h"
#include "tests/cli/cli_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::Contains;
using testing::IsSupersetOf;

CanopenLink canLink(const char *text)
{
    const auto link = canopenLinkMeant(*LinkText::parse(QString::fromLatin1(text)));
    EXPECT_TRUE(link) << text;
    return link.value_or(CanopenLink());
}

std::string refusalOfCanLink(const char *text)
{
    const auto links = linksMeant(QString::fromLatin1(text), nullptr);
    return links ? std::string() : links.error().key.toStdString();
}

std::vector<std::string> canCompletions(const QStringList &words)
{
    std::vector<std::string> texts;
    for (const Candidate &one : candidates(words))
        texts.push_back(one.text.toStdString());
    return texts;
}

TEST(CliCanLink, IsAnInterfaceASerialAdapterOrTheTrainingBus)
{
    EXPECT_TRUE(canLink("canopen:training").isSimulated());
    EXPECT_EQ(canLink("can:can0").settings.link, QStringLiteral("can:can0"));
    EXPECT_FALSE(canLink("can:can0").isSimulated());
    const CanopenLink serial = canLink("slcan:ttyACM0,rate=250000,baud=921600");
    EXPECT_EQ(serial.settings, (CanopenSettings{QStringLiteral("slcan:ttyACM0,baud=921600"), 250'000}));
    EXPECT_EQ(serial.at.rate, 250'000);
}

TEST(CliCanLink, AgreementsStandBehindItAndAreYesOrLeftOut)
{
    const CanopenLink link = canLink("can:can0,unsure-watch=yes,beside-master=yes,may-stop=yes");
    EXPECT_TRUE(link.takesUnsureWatch && link.sendsBesideOthers && link.mayStopNodes);
    EXPECT_FALSE(canLink("can:can0").takesUnsureWatch);
    EXPECT_EQ(refusalOfCanLink("can:can0,unsure-watch=no"), "canAgreementWrong");
}

TEST(CliCanLink, WhatItCannotBeIsRefused)
{
    EXPECT_EQ(refusalOfCanLink("slcan:ttyACM0"), "canRateMissing");
    EXPECT_EQ(refusalOfCanLink("slcan:ttyACM0,rate=123"), "canRateWrong");
    EXPECT_EQ(refusalOfCanLink("slcan:ttyACM0,rate=250000,speed=1"), "canSettingUnknown");
    EXPECT_EQ(refusalOfCanLink("can:can0,rate=250000"), "canRateBySystem");
    EXPECT_EQ(refusalOfCanLink("canopen:can0"), "unknownLink");
    EXPECT_EQ(refusalOfCanLink("canopen:training,rate=250000"), "unknownCanSetting");
    EXPECT_EQ(refusalOfCanLink("can:can0,protocol=canopen"), "");
    EXPECT_EQ(refusalOfCanLink("can:can0,protocol=j1939"), "unknownProtocol");
}

TEST(CliCanLink, TrainingLeadsToItToo)
{
    EXPECT_EQ(linksMeant(QStringLiteral("training"), nullptr)->size(), 3U);
    EXPECT_EQ(runLine(QStringLiteral("read can:5 serial-number")).exit, 0);
}

TEST(CliCanLink, OfAProjectIsItsOwn)
{
    Project project;
    project.buses.clear();
    setCanopenPlan(project, firstCanBus, {{QStringLiteral("slcan:ttyACM0"), 500'000}});
    const auto planned = canopenLinkOf(project, firstCanBus, {QStringLiteral("rate=250000")});
    ASSERT_TRUE(planned);
    EXPECT_EQ(planned->settings, (CanopenSettings{QStringLiteral("slcan:ttyACM0"), 250'000}));
    EXPECT_EQ(canopenLinkOf(project, firstCanBus)->at.rate, 500'000);
    setCanopenPlan(project, firstCanBus, {{QStringLiteral("gone:x"), 500'000}});
    ASSERT_TRUE(canopenLinkOf(project, firstCanBus));
    EXPECT_TRUE(canopenLinkOf(project, firstCanBus)->whyNot);
}

TEST(CliCanLink, IsCompleted)
{
    EXPECT_THAT(
        canCompletions({QStringLiteral("scan"), QStringLiteral("--link"), QStringLiteral("canopen:")}),
        IsSupersetOf({"canopen:training", "canopen:project"}));
    EXPECT_THAT(
        canCompletions({QStringLiteral("scan"), QStringLiteral("--link"), QStringLiteral("slcan:x,")}),
        IsSupersetOf({"slcan:x,rate=", "slcan:x,unsure-watch="}));
    const QStringList od{QStringLiteral("od"), QStringLiteral("--link"), QStringLiteral("canopen:training"),
                         QString()};
    EXPECT_THAT(canCompletions(od), IsSupersetOf({"can:5", "can:6", "can:7"}));
    EXPECT_THAT(canCompletions({QStringLiteral("read"), QString()}), Contains("can:5"));
    EXPECT_THAT(canCompletions({QStringLiteral("nmt"), QString()}),
                IsSupersetOf({"start", "stop", "pre-operational", "reset"}));
    EXPECT_THAT(canCompletions({QStringLiteral("lss"), QString()}), IsSupersetOf({"show", "scan", "node"}));
}

} // namespace
} // namespace codewheel
