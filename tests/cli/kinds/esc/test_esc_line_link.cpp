// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/esc/esc_line_link.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "tests/support/plans.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

EscLineLink lineLink(const char *text)
{
    const auto link = lineMeant(*LinkText::parse(QString::fromLatin1(text)));
    EXPECT_TRUE(link) << text;
    return *link;
}

Checked<EscLineLink> lineOnLink(const QString &text, const Project *project)
{
    return lineMeant(*LinkText::parse(text), project);
}

std::string refusal(const char *text)
{
    const auto link = linksMeant(QString::fromLatin1(text), nullptr);
    return link ? std::string() : link.error().key.toStdString();
}

TEST(CliLineLink, APortStandsByItselfOrWithSettings)
{
    EXPECT_EQ(linksMeant(QStringLiteral("training"), nullptr)->size(), 3U);
    EXPECT_TRUE(lineLink("esc:training").isSimulated());
    EXPECT_EQ(lineLink("esc:ttyUSB0").settings.port, QStringLiteral("ttyUSB0"));
    EXPECT_EQ(lineLink("esc:ttyUSB0").settings.serial, SerialSettings());
    const EscLineLink all =
        lineLink("esc:/dev/pts/5,baud=9600,format=7e1,time-out=250,retries=0,quiet=0,poll=20,"
                 "top-speed=3000,fraction-bits=28,swap-warnings=1,low-latency=0");
    EXPECT_EQ(all.settings.port, QStringLiteral("/dev/pts/5"));
    EXPECT_EQ(all.settings.serial, (SerialSettings{9'600, 7, SerialSettings::Parity::even, 1, false}));
    EXPECT_EQ(all.settings.timing.answerTimeOut, 250ms);
    EXPECT_EQ(all.settings.timing.retries, 0);
    EXPECT_EQ(all.settings.timing.quietAfterWrite, 0ms);
    EXPECT_EQ(all.driver().positionInterval, 20ms);
    EXPECT_EQ(all.driver().topSpeed, 3'000);
    EXPECT_EQ(all.driver().fractionBits, 28);
    EXPECT_TRUE(all.explainOptions().swaps({5}));
    EXPECT_FALSE(lineLink("esc:ttyUSB0").explainOptions().swaps({5}));
    EXPECT_TRUE(lineLink("esc:ttyUSB0,fraction-bits=device").asksForFractionBits);
}

// The same limits as in the project's file and in the form.
TEST(CliLineLink, SettingsGoAsFarAsInTheProject)
{
    const EscLineLink most =
        lineLink("esc:ttyUSB0,baud=10000000,time-out=60000,retries=20,quiet=60000,poll=60000");
    EXPECT_EQ(most.settings.serial.baudRate, 10'000'000);
    EXPECT_EQ(most.settings.timing.retries, 20);
    EXPECT_EQ(lineLink("esc:ttyUSB0,baud=50").settings.serial.baudRate, 50);
    for (const char *beyond :
         {"esc:ttyUSB0,baud=10000001", "esc:ttyUSB0,baud=49", "esc:ttyUSB0,time-out=60001",
          "esc:ttyUSB0,retries=21", "esc:ttyUSB0,quiet=60001"})
        EXPECT_EQ(refusal(beyond), "lineSettingOutOfRange") << beyond;
}

TEST(CliLineLink, TheLineOfAProjectKeepsItsSettingsSaveThoseTyped)
{
    Project project;
    EscLinePlan line;
    line.settings.port = QStringLiteral("/dev/ttyUSB3");
    line.settings.fractionBits = 28;
    line.settings.serial.baudRate = 4'800;
    line.adapter.serialNumber = QStringLiteral("A50285BI");
    setLinePlan(project, firstLine, line);
    for (const EscLineAddress address : {EscLineAddress{3}, EscLineAddress{5}})
        project.devices.emplace_back().standAt(placeOnLine(address));
    project.devices[1].set(EscEncoderSettings{.swapsWarningBytes = true});
    const auto link = lineOf(project, firstLine, {QStringLiteral("fraction-bits=30")});
    ASSERT_TRUE(link);
    EXPECT_EQ(link->settings.port, QStringLiteral("/dev/ttyUSB3"));
    EXPECT_EQ(link->settings.serial.baudRate, 4'800);
    EXPECT_EQ(link->settings.fractionBits, 30);
    EXPECT_EQ(link->adapter, line.adapter);
    EXPECT_FALSE(link->explainOptions().swaps({3}));
    EXPECT_TRUE(link->explainOptions().swaps({5}));
    EXPECT_TRUE(lineOnLink(QStringLiteral("esc:ttyUSB1"), &project)->explainOptions().swaps({5}))
        << "whatever the port";
    const auto none = lineOf(project, firstLine, {QStringLiteral("swap-warnings=0")});
    EXPECT_FALSE(none->explainOptions().swaps({5}));

    const Project without;
    EXPECT_EQ(linksMeant(QStringLiteral("esc:project"), &without).error().key, QStringLiteral("noBuses"));
    EXPECT_EQ(refusal("esc:project"), "noProject");
}

TEST(CliLineLink, WhatIsWrongIsNamed)
{
    EXPECT_EQ(refusal("serial"), "unknownLink");
    EXPECT_EQ(refusal("esc"), "unknownLink");
    EXPECT_EQ(refusal("esc:"), "portMissing");
    EXPECT_EQ(refusal("esc:,baud=9600"), "portMissing");
    EXPECT_EQ(refusal("esc:ttyUSB0,bauds=9600"), "unknownLineSetting");
    EXPECT_EQ(refusal("esc:ttyUSB0,"), "unknownLineSetting");
    EXPECT_EQ(refusal("esc:ttyUSB0,baud"), "lineSettingOutOfRange");
    EXPECT_EQ(refusal("esc:ttyUSB0,baud=0"), "lineSettingOutOfRange");
    EXPECT_EQ(refusal("esc:ttyUSB0,poll=9"), "lineSettingOutOfRange"); // the manual's 10 ms
    EXPECT_EQ(refusal("esc:ttyUSB0,fraction-bits=31"), "lineSettingOutOfRange");
    EXPECT_EQ(refusal("esc:ttyUSB0,format=9N1"), "lineFormatWrong");
    EXPECT_EQ(refusal("esc:ttyUSB0,format=8N"), "lineFormatWrong");
    EXPECT_EQ(refusal("esc:ttyUSB0,baud=9600,baud=19200"), "linkSettingGivenTwice");
    EXPECT_EQ(refusal("esc:ttyUSB0,format=8N1,format=8N1"), "linkSettingGivenTwice");
}

} // namespace
} // namespace codewheel
