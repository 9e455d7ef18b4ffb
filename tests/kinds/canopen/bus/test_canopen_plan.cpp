// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/bus_outline.h"
#include "catalog/catalog.h"
#include "kinds/canopen/plan/canopen_plan.h"
#include "kinds/canopen/protocol/canopen_address.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "project/plan_rules.h"
#include "project/project_file.h"

#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(CanopenAddress, IsWrittenInDecimal)
{
    EXPECT_EQ(CanopenAddress{5}.place(), NodeId("can:5"));
    EXPECT_EQ(CanopenAddress{127}.shown(), QStringLiteral("127 (7Fh)"));
    EXPECT_EQ(CanopenAddress::read(u"can:127"), CanopenAddress{127});
    for (const char16_t *wrong : {u"can:0", u"can:128", u"can:05", u"can:", u"5", u"esc:05", u"can:5 "})
        EXPECT_FALSE(CanopenAddress::read(wrong)) << QString::fromUtf16(wrong).toStdString();
    EXPECT_EQ(Place::parse(u"can:5"), (Place{firstCanBus, NodeId("can:5")}));
    EXPECT_EQ((Place{{7}, NodeId("can:5")}.key()), QStringLiteral("7/can:5"));
}

class CanopenPlanFile : public testing::Test
{
protected:
    CanopenPlanFile()
    {
        setCanopenPlan(project, firstCanBus,
                       {.settings = {.link = QStringLiteral("can:can0"), .rate = 250'000}});
        std::vector<ProjectDevice> devices(2);
        devices[0].standAt({firstCanBus, NodeId("can:5")});
        devices[0].participant.deviceKey = QStringLiteral("canopen-406-single-turn");
        devices[1].standAt({firstCanBus, NodeId("can:17")});
        devices[1].participant.deviceKey = QStringLiteral("canopen-406-multi-turn");
        setDevicesOn(project, firstCanBus, std::move(devices));
    }
    QByteArray written()
    {
        EXPECT_TRUE(saveProject(project, path));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll();
    }
    bool opens(QByteArray text, const char *what, const char *with)
    {
        EXPECT_EQ(text.count(what), 1) << what;
        text.replace(what, with);
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        return loadProject(path).has_value();
    }

    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("can.codewheel"));
    const Catalog catalog = Catalog::builtIn();
    Project project;
};

TEST_F(CanopenPlanFile, IsKeptThroughSavingAndOpening)
{
    const QByteArray text = written();
    EXPECT_TRUE(text.contains("\"link\": \"can:can0\"")) << text.constData();
    EXPECT_TRUE(text.contains("\"rate\": 250000"));
    EXPECT_TRUE(text.contains("\"place\": \"can:17\""));
    const auto opened = loadProject(path);
    ASSERT_TRUE(opened);
    EXPECT_EQ(*opened, project);
    EXPECT_EQ(canopenPlan(*opened, firstCanBus)->settings.rate, 250'000);
    EXPECT_FALSE(plansTraining(*opened, firstCanBus));
}

TEST_F(CanopenPlanFile, TheFileOfAnEncoderIsKept)
{
    const QString file = QStringLiteral("/home/rotor/R\u00f6tor 12.eds");
    devicesOn(project, firstCanBus)[1].set(CanopenEncoderSettings{.file = file});
    const QByteArray text = written();
    EXPECT_EQ(text.count("\"file\""), 1);
    const auto opened = loadProject(path);
    ASSERT_TRUE(opened);
    EXPECT_EQ(*opened, project);
    EXPECT_EQ(devicesOn(*opened, firstCanBus)[1].its<CanopenEncoderSettings>().file, file);
}

TEST_F(CanopenPlanFile, WhatCannotBeIsRefused)
{
    const QByteArray text = written();
    EXPECT_FALSE(opens(text, "250000", "9"));
    EXPECT_FALSE(opens(text, "can:17", "can:5"));
    EXPECT_FALSE(opens(text, "can:17", "can:128"));
    EXPECT_FALSE(opens(text, "can:17", "esc:05"));
    EXPECT_TRUE(opens(text, "can:17", "can:127"));
}

TEST_F(CanopenPlanFile, IsShownAsPlanned)
{
    const BusKind &kind = *busKind(QString::fromLatin1(canopenKind));
    EXPECT_EQ(kind.linkText(findBus(project, firstCanBus)->settings), QStringLiteral("can:can0, 250 kBit/s"));
    const auto outline = kind.outline(project, firstCanBus, catalog);
    const auto nodes = outline->nodes();
    ASSERT_EQ(nodes.size(), 2U);
    EXPECT_EQ(nodes[1].code, QStringLiteral("17 (11h)"));
    EXPECT_EQ(nodes[1].profile, QStringLiteral("CiA-406"));
    EXPECT_TRUE(kind.isTraining(kind.usual()));
}

TEST_F(CanopenPlanFile, NodesArePlannedByTheirNumbers)
{
    const PlanRules &rules = busKind(QString::fromLatin1(canopenKind))->planRules();
    const Place seventeen{firstCanBus, NodeId("can:17")};
    const PlanColumn column = rules.columns(project, firstCanBus).front();
    EXPECT_EQ(rules.complaint(project, seventeen, column, QStringLiteral("18")), QString());
    EXPECT_NE(rules.complaint(project, seventeen, column, QStringLiteral("5")), QString()) << "taken";
    EXPECT_NE(rules.complaint(project, seventeen, column, QStringLiteral("128")), QString());
    const auto edited = rules.type(project, seventeen, column, QStringLiteral("2"));
    ASSERT_TRUE(edited);
    EXPECT_EQ(edited->devices.front().place().node, NodeId("can:2"));
    for (const Participant &device : rules.offered(catalog))
        EXPECT_EQ(catalog.find(device.deviceKey)->profile.name(), "CiA-406")
            << device.deviceKey.toStdString();
    EXPECT_FALSE(rules.offered(catalog).empty());
}

TEST(CanopenSettingsOfALink, AreReadBackAsTheLink)
{
    for (const char *typed :
         {"can:can0", "slcan:ttyACM0,rate=250000", "slcan:/dev/ttyUSB0,rate=10000,baud=57600"}) {
        const CanLinkArgument link = parseCanLink(QString::fromLatin1(typed)).value();
        const CanopenSettings settings = canopenSettings(link, 500'000);
        EXPECT_EQ(settings.rate, link.isSerial ? link.rate : 500'000) << typed;
        EXPECT_FALSE(settings.link.contains(QStringLiteral("rate"))) << typed;
        EXPECT_EQ(canLinkOf(settings).value(), link) << typed;
    }
    EXPECT_FALSE(canLinkOf(CanopenSettings()));
    EXPECT_FALSE(canLinkOf({QStringLiteral("gone:x"), 125'000}));
}

} // namespace
} // namespace codewheel
