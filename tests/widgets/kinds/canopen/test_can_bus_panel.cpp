// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/canopen/bus/canopen_plant.h"
#include "widgets/kinds/canopen/can_bus_panel.h"
#include "widgets/kinds/canopen/can_node_model.h"
#include "widgets/kinds/canopen/nmt_texts.h"
#include "widgets/look/icons.h"
#include "widgets/look/label_text.h"
#include "widgets/look/role_label.h"

#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class CanBusPanelTest : public test::CanopenPlant
{
protected:
    CanBusPanelTest()
    {
        panel.setBus(bus.get());
        panel.show();
        QObject::connect(
            &panel, &CanBusPanel::commandWanted, &panel,
            [this](int node, canopen::NmtCommand command) { wanted.emplace_back(node, command); });
    }
    ~CanBusPanelTest() override { panel.setBus(nullptr); }

    QTableView &table() { return *panel.findChild<QTableView *>(); }
    QString cell(int node, int column)
    {
        const auto *model = static_cast<const CanNodeModel *>(table().model());
        return model->index(model->rowOf(node), column).data().toString();
    }
    QString since(int node) { return cell(node, CanNodeModel::state).section(u'\n', -1); }
    int columnOf(const QString &title)
    {
        for (int column = 0; column < table().model()->columnCount(); ++column)
            if (table().model()->headerData(column, Qt::Horizontal).toString() == title)
                return column;
        ADD_FAILURE() << title.toStdString();
        return 0;
    }
    QString fact(const QString &label)
    {
        for (const auto *text : panel.findChildren<QLabel *>())
            if (text->accessibleName() == label)
                return text->text();
        ADD_FAILURE() << label.toStdString();
        return {};
    }
    QPushButton &button(const char *key) { return *panel.findChild<QPushButton *>(QString::fromLatin1(key)); }

    std::vector<std::pair<int, canopen::NmtCommand>> wanted;
    CanBusPanel panel;
};

// The panel is scrolled, not its table as well.
TEST_F(CanBusPanelTest, AllNodesOfASmallBusAreShownAtOnce)
{
    panel.resize(340, 300);
    open(EncoderBus::Start::watching);
    bus->advance(1500ms);
    QTest::qWait(50);
    ASSERT_EQ(table().model()->rowCount(), 3);
    EXPECT_LE(table().verticalScrollBar()->maximum(), 1) << "its lower edge";
}

TEST_F(CanBusPanelTest, WithoutALinkWhatWasHeardIsOfBefore)
{
    const auto load = [this] {
        const auto labels = panel.findChildren<QLabel *>();
        return *std::ranges::find(labels, QStringLiteral("Load"), &QLabel::accessibleName);
    };
    open(EncoderBus::Start::watching);
    bus->advance(1500ms);
    EXPECT_FALSE(cell(6, CanNodeModel::state).contains(QStringLiteral("before")));
    EXPECT_TRUE(load()->isEnabled());
    link->isGone = true;
    bus->advance(1s);
    EXPECT_TRUE(cell(6, CanNodeModel::state).startsWith(QStringLiteral("before the link was lost:")))
        << cell(6, CanNodeModel::state).toStdString();
    EXPECT_FALSE(load()->isEnabled());
    link->isGone = false;
    bus->advance(3s);
    EXPECT_FALSE(cell(6, CanNodeModel::state).contains(QStringLiteral("before")));
    EXPECT_TRUE(load()->isEnabled());
}

TEST_F(CanBusPanelTest, ListsEncodersAndWhoeverIsHeard)
{
    EXPECT_EQ(table().model()->rowCount(), 0);
    open(EncoderBus::Start::watching);
    bus->advance(1500ms);
    ASSERT_EQ(table().model()->rowCount(), 3); // 5 and 6 are encoders of the bus, 7 is heard
    EXPECT_EQ(cell(6, CanNodeModel::node),
              QStringLiteral("6 (06h)\n") + bus->encoder(six)->device().fullName());
    EXPECT_EQ(cell(7, CanNodeModel::node), QStringLiteral("7 (07h)"));
    EXPECT_TRUE(
        cell(6, columnOf(QStringLiteral("State"))).startsWith(QStringLiteral("pre-operational\nHeartbeat: ")))
        << cell(6, columnOf(QStringLiteral("State"))).toStdString();
    EXPECT_TRUE(since(6).startsWith(QStringLiteral("since 12:00:"))) << since(6).toStdString();
}

TEST_F(CanBusPanelTest, TellsErrorsWithTheirTimeAndFigures)
{
    operate();
    const QString before = since(6);
    bus->advance(5s);
    EXPECT_EQ(since(6), before);
    plant->withEncoder(1, [](canopen::SimulatedNode &node) { node.setAlarms(1); });
    bus->advance(200ms);
    EXPECT_NE(cell(6, columnOf(QStringLiteral("Error"))), QStringLiteral("\u2013"));
    EXPECT_NE(since(6), before);
    EXPECT_EQ(fact(QStringLiteral("Rate")), QStringLiteral("125 kBit/s"));
    EXPECT_TRUE(fact(QStringLiteral("Load")).endsWith(u'%'));
    EXPECT_NE(fact(QStringLiteral("Received")), QStringLiteral("0"));
    EXPECT_EQ(panel.findChild<RoleLabel *>()->word(), QStringLiteral("Open, in Operate"));
}

TEST_F(CanBusPanelTest, ABootUpIsATimeOfItsOwnAndAStoppedNodeIsNotWell)
{
    operate();
    const QString before = since(6);
    bus->advance(5s);
    bus->send(canopen::NmtRequest{canopen::NmtCommand::resetNode, 6}.frame());
    bus->advance(1s);
    EXPECT_TRUE(cell(6, CanNodeModel::state).startsWith(QStringLiteral("boot-up\n")));
    EXPECT_NE(since(6), before);
    const auto shows = [this](Icon icon, Role role) {
        const auto *model = static_cast<const CanNodeModel *>(table().model());
        const auto shown = model->index(model->rowOf(6), CanNodeModel::node).data(Qt::DecorationRole);
        const QSize size(16, 16);
        return shown.value<QIcon>().pixmap(size).toImage() == lineIcon(icon, role).pixmap(size).toImage();
    };
    bus->send(canopen::NmtRequest{canopen::NmtCommand::start, 6}.frame());
    bus->advance(2s);
    EXPECT_TRUE(shows(Icon::running, Role::running));
    bus->send(canopen::NmtRequest{canopen::NmtCommand::stop, 6}.frame());
    bus->advance(2s);
    EXPECT_TRUE(shows(Icon::attention, Role::attention));
}

TEST_F(CanBusPanelTest, CommandsNeedOperateAndAChosenNode)
{
    open(EncoderBus::Start::watching);
    bus->advance(1500ms);
    panel.chooseNode(6);
    EXPECT_EQ(panel.chosenNode(), 6);
    EXPECT_FALSE(button("nmtStop").isEnabled());
    EXPECT_TRUE(button("nmtStop").toolTip().contains(QStringLiteral("Operate")));
    bus->setOperate(true);
    bus->advance(200ms);
    EXPECT_EQ(panel.chosenNode(), 6);
    ASSERT_TRUE(button("nmtStop").isEnabled());
    QTest::mouseClick(&button("nmtStop"), Qt::LeftButton);
    QTest::mouseClick(&button("nmtReset"), Qt::LeftButton);
    EXPECT_EQ(wanted, (std::vector<std::pair<int, canopen::NmtCommand>>{
                          {6, canopen::NmtCommand::stop}, {6, canopen::NmtCommand::resetNode}}));
    table().clearSelection();
    EXPECT_FALSE(button("nmtStop").isEnabled());
}

TEST_F(CanBusPanelTest, AClosedBusHasNoNodesAndNoFigures)
{
    operate();
    bus->close();
    EXPECT_EQ(table().model()->rowCount(), 0);
    EXPECT_EQ(fact(QStringLiteral("Load")), QStringLiteral("\u2013"));
    EXPECT_EQ(panel.findChild<RoleLabel *>()->word(), QStringLiteral("Not connected"));
}

TEST_F(CanBusPanelTest, EveryCommandSaysWhatItDoesAndIsAskedAbout)
{
    for (const NmtAction &action : nmtActions()) {
        EXPECT_FALSE(action.label().isEmpty() || action.toolTip().isEmpty());
        EXPECT_TRUE(action.question(6).contains(QStringLiteral("6 (06h)")));
        EXPECT_EQ(&nmtAction(action.command), &action);
    }
    EXPECT_FALSE(table().accessibleName().isEmpty() || table().toolTip().isEmpty());
}

} // namespace
} // namespace codewheel
