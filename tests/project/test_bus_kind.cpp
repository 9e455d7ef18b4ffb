// SPDX-License-Identifier: GPL-3.0-or-later
// A kind of bus unknown to the program, added at run time (project/bus_kind.h).
#include "catalog/catalog.h"
#include "catalog/json_object.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "project/project_json.h"
#include "project/project_reader.h"
#include "project/project_writer.h"
#include "vocabulary/refusal_text.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

struct LampPlan
{
    int volts = 24;

    friend bool operator==(const LampPlan &, const LampPlan &) = default;
};

class LampOutline final : public BusOutline
{
public:
    explicit LampOutline(std::vector<BusNode> nodes)
        : m_nodes(std::move(nodes))
    {}

    QString title() const override { return QStringLiteral("Lamps"); }
    QString toolTip() const override { return {}; }
    StateWord state() const override { return offline(); }
    std::vector<BusNode> nodes() const override { return m_nodes; }
    NodeState state(std::size_t) const override { return {planned(), {}, false}; }
    QString toolTip(std::size_t, const QString &called) const override { return called; }

private:
    const std::vector<BusNode> m_nodes;
};

class LampKind final : public BusKind
{
public:
    QString key() const override { return QStringLiteral("lamps"); }
    QString title() const override { return QStringLiteral("Lamps in a row"); }
    QString usualName() const override { return QStringLiteral("Lamps"); }
    KindData usual() const override { return KindData(LampPlan()); }
    QString linkText(const KindData &) const override { return QStringLiteral("mains"); }
    bool isTraining(const KindData & /*settings*/) const override { return true; }
    std::unique_ptr<BusOutline> outline(const Project &project, BusId bus, const Catalog &) const override
    {
        std::vector<BusNode> nodes;
        for (const ProjectDevice &device : devicesOn(project, bus))
            nodes.push_back({.node = device.place().node,
                             .parent = {},
                             .name = device.station,
                             .profile = {},
                             .code = {},
                             .words = {}});
        return std::make_unique<LampOutline>(std::move(nodes));
    }
    KindData read(const JsonObject &json, std::vector<ProjectDevice> &devices) const override
    {
        json.allowOnly({"kind", "number", "name", "volts", "devices"});
        for (const JsonObject &row : json.array("devices", {"place", "station"})) {
            ProjectDevice &lamp = devices.emplace_back();
            lamp.participant.number = NodeId(row.text("place").toStdString());
            ProjectReader::readWhatIsKnown(row, lamp);
        }
        return KindData(LampPlan{json.numberOr("volts", 24, 1, 230)});
    }
    void write(ProjectWriter &writer, const KindData &settings,
               std::span<const ProjectDevice> devices) const override
    {
        writer.json().member("volts", settings.as<LampPlan>()->volts);
        writer.json().list("devices", devices, [&](const ProjectDevice &lamp) {
            writer.json().member("place", lamp.place().toString());
            writer.writeNames(lamp);
        });
    }
};

constexpr BusId lamps{7};

class AddedKind : public testing::Test
{
protected:
    static void SetUpTestSuite() { addBusKind(std::make_unique<LampKind>()); }

    static Project project()
    {
        Project project;
        planBus(project, lamps, *busKind(u"lamps")).settings = KindData(LampPlan{48});
        ProjectDevice lamp;
        lamp.standAt({lamps, NodeId("lamp:1")});
        lamp.station = QStringLiteral("gate");
        setDevicesOn(project, lamps, {lamp});
        return project;
    }
};

TEST_F(AddedKind, IsKeptInTheFileOfTheProject)
{
    const auto read = projectFromJson(projectToJson(project()), QStringLiteral("lamps.codewheel"));
    ASSERT_TRUE(read) << refusalText(read.error()).toStdString();
    EXPECT_EQ(*read, project());
    EXPECT_EQ(findBus(*read, lamps)->name, QStringLiteral("Lamps"));
}

TEST_F(AddedKind, IsOfferedWithTheOthers)
{
    ASSERT_TRUE(busKindKeys().contains(QStringLiteral("lamps")));
    EXPECT_EQ(busKind(u"lamps")->title(), QStringLiteral("Lamps in a row"));
    EXPECT_EQ(freeNumber(project(), *busKind(u"lamps")), BusId{8});
    EXPECT_EQ(freeNumber({}, *busKind(u"lamps")), BusId{4}) << "1 to 3 are those of the training";
}

TEST_F(AddedKind, SaysItselfWhatIsWrong)
{
    QByteArray json = projectToJson(project());
    json.replace("\"volts\": 48", "\"volts\": 480");
    const auto read = projectFromJson(json, QStringLiteral("lamps.codewheel"));
    ASSERT_FALSE(read);
    EXPECT_TRUE(refusalText(read.error()).contains(QStringLiteral("buses[1].volts")));
}

TEST_F(AddedKind, IsLookedAtAsEveryBus)
{
    const Catalog catalog;
    const auto outline = busKind(u"lamps")->outline(project(), lamps, catalog);
    ASSERT_EQ(outline->nodes().size(), 1U);
    EXPECT_EQ(outline->nodes()[0].name, QStringLiteral("gate"));
}

} // namespace
} // namespace codewheel
