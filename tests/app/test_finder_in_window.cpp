// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/kinds/canopen/can_interface_rows.h"
#include "app/window/kinds/window_kinds.h"
#include "kinds/interbus/plan/gateway_plan.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "tests/app/kinds/esc/esc_line_at_port_test.h"
#include "tests/app/press_connect.h"
#include "tests/support/modbus_server.h"
#include "widgets/find/find_page.h"
#include "widgets/find/finder_news_model.h"
#include "widgets/kinds/esc/line/esc_line_search.h"
#include "widgets/kinds/esc/line/found_encoder_model.h"

#include <QListWidget>
#include <QSpinBox>
#include <QTableView>

namespace codewheel {
namespace {

class FinderInWindowTest : public test::EscLineAtPortTest
{
protected:
    FindPage &page() { return *window().findChild<FindPage *>(); }
    void lookAt(const QString &port)
    {
        actions().findEncoders->trigger();
        advance(50);
        ASSERT_TRUE(page().isVisible());
        page().setPorts({{port, {}, {}}}, {});
        click(page(), QStringLiteral("Search"));
        ASSERT_TRUE(comes([&] { return !page().isSearching(); }));
    }
};

TEST_F(FinderInWindowTest, AnEncoderIsFoundAndConnectedWithItsSettings)
{
    const QString port = startPeer(QStringLiteral("--addresses 05"));
    lookAt(port);
    EXPECT_EQ(page().news().rowCount(), 1) << "the line is silent";
    click(page(), QStringLiteral("Ask"));
    EXPECT_TRUE(page().isSearching());
    ASSERT_TRUE(comes([&] { return !page().isSearching(); }));
    click(page(), QStringLiteral("Connect"));
    EXPECT_NE(shown->line().training(), nullptr) << "only after asking";
    test::agreeToReplace(connection());
    ASSERT_TRUE(
        comes([&] { return shown->line().training() == nullptr && shown->line().session() != nullptr; }));
    EXPECT_EQ(line().linkName(), port);
    EXPECT_FALSE(line().isOperating());
    EXPECT_TRUE(window().findChild<EscLineSearch *>()->isVisible()) << "its encoders are taken over there";
}

TEST_F(FinderInWindowTest, TheEncodersThatWereFoundNeedNotBeSearchedForAgain)
{
    lookAt(startPeer(QStringLiteral("--addresses 03,05,12")));
    click(page(), QStringLiteral("Ask"));
    ASSERT_TRUE(comes([&] { return !page().isSearching(); }));
    click(page(), QStringLiteral("Connect"));
    test::agreeToReplace(connection());
    const auto &search = *window().findChild<EscLineSearch *>();
    ASSERT_TRUE(comes([&] { return search.isVisible(); }));
    const QAbstractItemModel &found = *search.findChild<QTableView *>()->model();
    ASSERT_EQ(found.rowCount(), 3);
    EXPECT_TRUE(search.findChild<QTableView *>()->isVisible());
    EXPECT_EQ(found.index(1, FoundEncoderModel::serialNumber).data().toString(),
              QStringLiteral("1234181 (12D505h)"));
    click(search, QStringLiteral("Take over"));
    EXPECT_TRUE(answers(placeOnLine({3})) && answers(placeOnLine({5})) && answers(placeOnLine({0x12})));
}

TEST_F(FinderInWindowTest, AGatewayIsFoundAtAHostAndConnected)
{
    ModbusServer server;
    actions().findEncoders->trigger();
    advance(50);
    page().setPorts({}, {});
    QTest::keyClicks(page().findChild<QLineEdit *>(QStringLiteral("findHost")), QStringLiteral("127.0.0.1"));
    page().findChild<QSpinBox *>()->setValue(server.port());
    click(page(), QStringLiteral("Search"));
    ASSERT_TRUE(comes([&] { return !page().isSearching(); }));
    EXPECT_EQ(server.requests(4), 0) << "nothing is sent before that was agreed to";
    click(page(), QStringLiteral("Ask"));
    ASSERT_TRUE(comes([&] { return !page().isSearching(); }));
    EXPECT_GT(server.requests(4), 0);
    click(page(), QStringLiteral("Connect"));
    const auto &ring = *window().findChild<ConnectPage *>(QStringLiteral("ringConnection"));
    EXPECT_TRUE(bus().isSimulated()) << "only after asking";
    test::agreeToReplace(ring);
    ASSERT_TRUE(comes([&] { return bus().isOpen() && !bus().isSimulated(); }));
    EXPECT_FALSE(bus().isOperating());
    const ProjectLink link = ringPlan(project(), firstBus).link;
    EXPECT_EQ(link.kind, QStringLiteral("modbus-tcp"));
    const auto planned = plannedGateway(project(), firstBus);
    ASSERT_TRUE(planned && *planned);
    EXPECT_EQ((*planned)->tcpPort, server.port());
    ringActions().disconnectBus->trigger();
}

TEST_F(FinderInWindowTest, ASearchCanBeCancelled)
{
    const QString port = startPeer(QStringLiteral("--addresses 05"));
    actions().findEncoders->trigger();
    page().setPorts({{port, {}, {}}}, {});
    click(page(), QStringLiteral("Search"));
    click(page(), QStringLiteral("Cancel"));
    ASSERT_TRUE(comes([&] { return !page().isSearching(); }));
    EXPECT_EQ(said(), QString()) << "nothing is asked after that";
}

// What the test kind of bus can listen to.
struct Interfaces
{
    PortRows rows;
    int listenedTo = 0;
};
Interfaces &interfaces()
{
    static Interfaces all;
    return all;
}

class InterfaceListener final : public PlaceFinder
{
public:
    bool isDone() const override { return m_isDone; }
    FinderNews next() override
    {
        m_isDone = true;
        return {FinderNews::Kind::nobody, QStringLiteral("bus0"), QStringLiteral("Nobody is heard.")};
    }
    void interrupt() override {}

private:
    bool m_isDone = false;
};

std::unique_ptr<PlaceFinder> listenAtInterface(const QString &name)
{
    if (name != QStringLiteral("bus0"))
        return nullptr;
    ++interfaces().listenedTo;
    return std::make_unique<InterfaceListener>();
}

class FinderAtInterfaces : public FinderInWindowTest
{
protected:
    FinderAtInterfaces()
    {
        static const bool isAdded = [] {
            WindowKind kind{.bus = QStringLiteral("interfaces"), .make = nullptr};
            kind.interfaces = [] { return interfaces().rows; };
            kind.listenAt = listenAtInterface;
            addWindowKind(kind);
            return true;
        }();
        EXPECT_TRUE(isAdded);
        interfaces().rows = {
            {{QStringLiteral("bus0"), QStringLiteral("switched off"), {}}},
            {QStringLiteral("bus0 is switched off."), QStringLiteral("ip link set bus0 up")}};
        actions().findEncoders->trigger();
        advance(50);
    }
    ~FinderAtInterfaces() override { interfaces().rows = {}; }

    QString trouble() // the command against it
    {
        for (const auto *message : page().findChildren<InlineMessage *>())
            if (message->isVisibleTo(&page()))
                return message->command();
        return {};
    }
};

TEST_F(FinderAtInterfaces, AreListedWithWhatIsInTheirWayAndListenedTo)
{
    auto &list = *page().findChild<QListWidget *>();
    const auto found = list.findItems(QStringLiteral("bus0, switched off"), Qt::MatchExactly);
    ASSERT_EQ(found.size(), 1);
    if (serialPorts().empty()) { // what is in the way of a port goes first
        EXPECT_EQ(trouble(), QStringLiteral("ip link set bus0 up"));
    }
    for (int row = 0; row < list.count(); ++row)
        list.item(row)->setCheckState(Qt::Unchecked);
    found.front()->setCheckState(Qt::Checked);
    click(page(), QStringLiteral("Search"));
    ASSERT_TRUE(comes([&] { return !page().isSearching(); }));
    EXPECT_EQ(interfaces().listenedTo, 1);
    EXPECT_EQ(page().news().rowCount(), 1);
    EXPECT_EQ(said(), QString()) << "an interface is not asked";
}

TEST(CanInterfacesToHear, ThatAreOffAreListedWithTheCommandThatSwitchesThemOn)
{
    const PortRows listed = canInterfacesToHear(
        {{.name = QStringLiteral("can0"), .isUp = true, .status = {.rate = 250'000, .listensOnly = true}},
         {.name = QStringLiteral("can1")}});
    ASSERT_EQ(listed.rows.size(), 2U);
    EXPECT_EQ(listed.rows[0].name, QStringLiteral("can0"));
    EXPECT_EQ(listed.rows[0].description, QStringLiteral("CAN interface, on, 250 kBit/s, listens only"));
    EXPECT_EQ(listed.rows[1].description, QStringLiteral("CAN interface, switched off"));
    EXPECT_TRUE(listed.trouble.sentence.contains(QStringLiteral("can1")));
    EXPECT_EQ(listed.trouble.command, QStringLiteral("sudo ip link set can1 up type can bitrate 250000"));
}

} // namespace
} // namespace codewheel
