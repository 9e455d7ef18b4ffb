// SPDX-License-Identifier: GPL-3.0-or-later
// The page that says why there is no data: what opens it, what it says, and what its button does.
#include "app/window/buses/plant.h"
#include "app/window/kinds/esc/esc_line_at_work.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/esc/simulator/simulated_esc_line.h"
#include "kinds/interbus/gateway/gateway_settings.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "language.h"
#include "tests/app/window_test.h"
#include "tests/support/plans.h"
#include "tests/support/pty_pair.h"
#include "tests/support/register_bank.h"
#include "widgets/comparison/comparison_page.h"
#include "widgets/help/help_topic.h"
#include "widgets/kinds/interbus/gateway/registers_page.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/look/role_label.h"
#include "widgets/structure/structure_model.h"
#include "widgets/structure/structure_view.h"
#include "widgets/why/why_page.h"

#include <QAction>
#include <QLocale>
#include <QPushButton>
#include <QTableView>
#include <QTreeView>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class WhyInWindowTest : public test::WindowTest
{
protected:
    WhyInWindowTest() { advance(200); }
    ~WhyInWindowTest() override { QLocale::setDefault(QLocale::c()); }

    void befall(TrainingFault fault, Place place)
    {
        shown->controls().setFault(fault, place.node, 1);
        advance(500);
    }
    StructureView &structure() { return *window().findChild<StructureView *>(); }
    QTreeView &tree() { return *window().findChild<QTreeView *>(QStringLiteral("structure")); }
    QPoint spot(Place row, int column)
    {
        const auto &model = *static_cast<const StructureModel *>(tree().model());
        const QModelIndex index = row.isEmpty() ? model.indexOf(row.bus) : model.indexOf(row);
        tree().scrollTo(index);
        return tree().visualRect(index.siblingAtColumn(column)).center();
    }
    void doubleClick(Place row)
    {
        const QPoint where = spot(row, StructureModel::deviceColumn);
        QTest::mouseClick(tree().viewport(), Qt::LeftButton, {}, where);
        QTest::mouseDClick(tree().viewport(), Qt::LeftButton, {}, where);
        advance(50);
    }
    void clickState(Place row)
    {
        QTest::mouseClick(tree().viewport(), Qt::LeftButton, {}, spot(row, StructureModel::stateColumn));
        advance(50);
    }
    void ask(Place row)
    {
        structure().chooseRow(row);
        actions().whyNoData->trigger();
        advance(50);
    }
    WhyPage &why() { return *window().findChild<WhyPage *>(); }
    bool isOpen() { return page() == &why(); }
    QString outcome() { return why().findChild<RoleLabel *>()->word(); }
    QString told() { return why().findChild<InlineMessage *>()->sentence(); }
    QPushButton *button()
    {
        for (auto *each : why().findChild<InlineMessage *>()->findChildren<QPushButton *>())
            if (each->isVisible())
                return each;
        return nullptr;
    }
    void press(const QString &text)
    {
        ASSERT_NE(button(), nullptr);
        EXPECT_EQ(button()->text(), text);
        QTest::mouseClick(button(), Qt::LeftButton);
        advance(200);
    }
    QString came(int row)
    {
        const QAbstractItemModel &model = *why().findChild<QTableView *>()->model();
        return model.index(row, model.columnCount() - 1).data().toString();
    }
    QString allThatCame()
    {
        QStringList all;
        for (int row = 0; row < why().findChild<QTableView *>()->model()->rowCount(); ++row)
            all << came(row);
        return all.join(u'\n');
    }
    QString stateOf(Place place)
    {
        const auto &model = *static_cast<const StructureModel *>(tree().model());
        return model.indexOf(place).siblingAtColumn(StructureModel::stateColumn).data().toString();
    }
    // Instead of the training bus, a gateway with these registers.
    void connectGateway(const std::shared_ptr<test::RegisterBank> &bank)
    {
        ringActions().disconnectBus->trigger();
        shown->plant().first<RingAtWork>()->setPorts(
            [bank](const GatewaySettings &) { return std::make_unique<test::RegisterBankPort>(bank); });
        const GatewaySettings gateway{.host = QStringLiteral("gateway.hall")};
        Project planned = shown->project().project();
        changeRing(planned, [&](RingPlan &ring) { ring.link = {linkKindOf(gateway), linkTexts(gateway)}; });
        shown->project().setProject(planned, {});
        ringActions().connectBus->trigger();
        ASSERT_TRUE(bus().isOpen());
    }
};

TEST_F(WhyInWindowTest, ADoubleClickOnARedRowOpensItWithThePlace)
{
    befall(TrainingFault::wireBreak, "4.0"_ring);
    doubleClick(Place{firstBus});
    ASSERT_TRUE(isOpen());
    EXPECT_EQ(why().about(), QStringLiteral("Ring"));
    EXPECT_EQ(outcome(), QStringLiteral("What differs first: Ring"));
    EXPECT_TRUE(told().contains(QStringLiteral("between 3.0 and 4.0"))) << told().toStdString();
    EXPECT_TRUE(came(1).contains(QStringLiteral("4.0"))) << came(1).toStdString();
}

TEST_F(WhyInWindowTest, SoDoesEnterOnIt)
{
    befall(TrainingFault::wireBreak, "4.0"_ring);
    structure().choose(firstBus);
    tree().setFocus();
    QTest::keyClick(&tree(), Qt::Key_Return);
    EXPECT_TRUE(isOpen());
}

TEST_F(WhyInWindowTest, AClickOnARedStateOpensItAndThatOnAnotherDoesNot)
{
    clickState(baumer);
    EXPECT_FALSE(isOpen());
    befall(TrainingFault::wireBreak, "4.0"_ring);
    clickState(Place{firstBus});
    ASSERT_TRUE(isOpen());
    EXPECT_EQ(structure().row(), Place{firstBus});
    EXPECT_TRUE(told().contains(QStringLiteral("between 3.0 and 4.0"))) << told().toStdString();
}

TEST_F(WhyInWindowTest, SoDoesAClickOnAYellowOne)
{
    send(fraba, 0x0200'1000);
    clickState(fraba);
    ASSERT_TRUE(isOpen());
    EXPECT_EQ(outcome(), QStringLiteral("What differs first: State of the encoder"));
    EXPECT_TRUE(told().contains(QStringLiteral("80000000 (run)"))) << told().toStdString();
}

TEST_F(WhyInWindowTest, ADoubleClickOnAnyOtherRowOpensItsMonitor)
{
    window().showTrend();
    doubleClick(baumer);
    EXPECT_EQ(page(), &monitors());
}

TEST_F(WhyInWindowTest, OfARedEncoderItNamesTheState)
{
    send(baumer, 0x0400'4E20); // more than it can count
    send(baumer, 0x8000'0000);
    advance(200);
    doubleClick(baumer);
    ASSERT_TRUE(isOpen());
    EXPECT_TRUE(why().about().startsWith(QStringLiteral("2.0"))) << why().about().toStdString();
    EXPECT_EQ(outcome(), QStringLiteral("What differs first: State of the encoder"));
    EXPECT_TRUE(told().contains(QStringLiteral("error"), Qt::CaseInsensitive)) << told().toStdString();
    press(plainLabel(actions().openMonitor->text()));
    EXPECT_EQ(page(), &monitors());
}

TEST_F(WhyInWindowTest, OfAnErrorItSaysTheNumberAndTheWord)
{
    befall(TrainingFault::codeDiscFault, baumer);
    doubleClick(baumer);
    ASSERT_TRUE(isOpen());
    EXPECT_EQ(outcome(), QStringLiteral("What differs first: State of the encoder"));
    EXPECT_TRUE(told().startsWith(QStringLiteral("2.0: Error 15: "))) << told().toStdString();
    EXPECT_TRUE(allThatCame().contains(QStringLiteral("error 15 (IN 9E000000)")))
        << allThatCame().toStdString();
}

TEST_F(WhyInWindowTest, ParameterizationIsTold)
{
    send(baumer, 0x0200'00FF);
    advance(200);
    ask(baumer);
    EXPECT_EQ(outcome(), QStringLiteral("What differs first: State of the encoder"));
    EXPECT_TRUE(told().startsWith(QStringLiteral("The encoder is in parameterization")))
        << told().toStdString();
    press(plainLabel(actions().openMonitor->text()));
    EXPECT_EQ(page(), &monitors());
}

TEST_F(WhyInWindowTest, AnotherIdCodeThanTheProjectHasIsToldWithTheComparison)
{
    befall(TrainingFault::wrongDevice, baumer);
    ringActions().readIn->trigger();
    advance(500);
    ASSERT_TRUE(bus().isRunning());
    ask(baumer);
    EXPECT_TRUE(told().startsWith(QStringLiteral("2.0: configured is "))) << told().toStdString();
    EXPECT_TRUE(told().contains(QStringLiteral("found was K2"))) << told().toStdString();
    EXPECT_TRUE(allThatCame().contains(QStringLiteral("36h"))) << allThatCame().toStdString();
    press(plainLabel(actions().compare->text()));
    EXPECT_NE(qobject_cast<const ComparisonPage *>(page()), nullptr);
}

TEST_F(WhyInWindowTest, AWrongWordOrderOfAGatewayIsSeenInTheTreeAndLeadsToItsRegisters)
{
    const auto bank = std::make_shared<test::RegisterBank>();
    bank->input[0] = 0x04D2; // 1234 with its low word first
    connectGateway(bank);
    advance(50);
    EXPECT_NE(stateOf(fraba), QStringLiteral("doubtful")) << "one word may be torn";
    advance(1'500);
    EXPECT_EQ(stateOf(fraba), QStringLiteral("doubtful"));
    ask(fraba);
    EXPECT_TRUE(told().contains(QStringLiteral("It can with low word first"))) << told().toStdString();
    press(plainLabel(ringActions().registers->text()));
    EXPECT_NE(qobject_cast<const RegistersPage *>(page()), nullptr);
}

TEST_F(WhyInWindowTest, OfADeviceBehindABreakItNamesThePlaceToo)
{
    befall(TrainingFault::wireBreak, "4.0"_ring);
    ask("5.0"_ring);
    EXPECT_TRUE(why().about().startsWith(QStringLiteral("5.0"))) << why().about().toStdString();
    EXPECT_TRUE(told().contains(QStringLiteral("between 3.0 and 4.0"))) << told().toStdString();
}

TEST_F(WhyInWindowTest, AnEncoderThatMayHaveNoSupplyIsWorthKnowing)
{
    befall(TrainingFault::powerOff, baumer);
    ask(baumer);
    EXPECT_TRUE(outcome().startsWith(QStringLiteral("Data comes"))) << outcome().toStdString();
    EXPECT_TRUE(told().startsWith(QStringLiteral("IN of 2.0 fell to 00000000"))) << told().toStdString();
}

TEST_F(WhyInWindowTest, FollowsTheChosenRowAndWhatHappens)
{
    ask(baumer);
    EXPECT_TRUE(outcome().startsWith(QStringLiteral("Everything is as expected"))) << outcome().toStdString();
    structure().choose(fraba);
    advance(50);
    EXPECT_TRUE(isOpen());
    EXPECT_TRUE(why().about().startsWith(QStringLiteral("1.0"))) << why().about().toStdString();
    bus().setRunning(false);
    advance(200);
    EXPECT_EQ(outcome(), QStringLiteral("What differs first: Ring"));
    press(plainLabel(actions().start->text()));
    EXPECT_TRUE(bus().isRunning());
    EXPECT_TRUE(outcome().startsWith(QStringLiteral("Everything is as expected"))) << outcome().toStdString();
    EXPECT_EQ(button(), nullptr);
}

TEST_F(WhyInWindowTest, WatchIsARemarkWithTheWayToOperate)
{
    bus().setOperate(false);
    ask(baumer);
    EXPECT_TRUE(outcome().startsWith(QStringLiteral("Data comes. Position"))) << outcome().toStdString();
    EXPECT_FALSE(bus().isOperating()) << "only the button does it";
    press(plainLabel(actions().operate->text()));
    EXPECT_TRUE(bus().isOperating());
    EXPECT_TRUE(told().isEmpty()) << told().toStdString();
}

TEST_F(WhyInWindowTest, ASilentEncoderOfALineIsNamed)
{
    const Place silent = placeOnLine({5});
    shown->line().training()->withEncoder(
        {5}, [](SimulatedEscEncoder &encoder) { encoder.condition().powered = false; });
    advance(3'000);
    doubleClick(silent);
    ASSERT_TRUE(isOpen());
    EXPECT_EQ(outcome(), QStringLiteral("What differs first: Answer of the encoder"));
    EXPECT_TRUE(told().contains(QStringLiteral("05"))) << told().toStdString();
    press(plainLabel(lineActions().settings->text()));
    EXPECT_EQ(page()->objectName(), QStringLiteral("lineSettings"));
}

TEST_F(WhyInWindowTest, OfASilentLineItSaysWhatItsEncodersShare)
{
    shown->line().training()->setSilent(true);
    advance(5'000);
    ask(Place{firstLine});
    EXPECT_EQ(outcome(), QStringLiteral("What differs first: Bytes"));
    EXPECT_TRUE(told().startsWith(QStringLiteral("No encoder answers on training line at 19200 Bd.")))
        << told().toStdString();
    press(plainLabel(lineActions().settings->text()));
    EXPECT_EQ(page()->objectName(), QStringLiteral("lineSettings"));
}

TEST_F(WhyInWindowTest, OfAnAdapterThatWasUnpluggedItNamesThePort)
{
    PtyPair adapter;
    shown->line().setPortList([] { return std::vector<PortInfo>(); });
    shown->line().close();
    Project planned = shown->project().project();
    EscLinePlan line;
    line.settings.port = adapter.path();
    setLinePlan(planned, firstLine, line);
    shown->project().setProject(planned, {});
    shown->line().open(KindData(line));
    ASSERT_TRUE(QTest::qWaitFor([this] { return !shown->line().isOpening(); }));
    ASSERT_EQ(shown->line().session()->state(), BusState::open);
    adapter.unplug();
    ASSERT_TRUE(QTest::qWaitFor(
        [this] {
            advance(33);
            return shown->line().session()->state() == BusState::lost;
        },
        20'000));
    ask(Place{firstLine});
    EXPECT_EQ(outcome(), QStringLiteral("What differs first: Link"));
    EXPECT_TRUE(told().contains(adapter.path())) << told().toStdString();
    ASSERT_NE(button(), nullptr);
    EXPECT_EQ(button()->text(), plainLabel(lineActions().settings->text()));
    shown->line().close();
}

TEST_F(WhyInWindowTest, ABusThatIsOfflineOffersToConnectIt)
{
    bus().close();
    advance(50);
    ask(Place{firstBus});
    EXPECT_EQ(outcome(), QStringLiteral("What differs first: Link"));
    EXPECT_EQ(told(), QStringLiteral("The bus is not connected. Connect it."));
    press(plainLabel(ringActions().connectBus->text()));
    EXPECT_TRUE(bus().isOpen());
    EXPECT_TRUE(outcome().startsWith(QStringLiteral("Everything is as expected"))) << outcome().toStdString();
}

TEST_F(WhyInWindowTest, OfAPortThatWasRefusedItSaysWhy)
{
    shown->line().setPortList([] { return std::vector<PortInfo>(); });
    shown->line().close();
    Project planned = shown->project().project();
    EscLinePlan line;
    line.settings.port = QStringLiteral("/dev/codewheel-none");
    setLinePlan(planned, firstLine, line);
    shown->project().setProject(planned, {});
    advance(50);
    ask(Place{firstLine});
    EXPECT_EQ(told(), QStringLiteral("The bus is not connected. Connect it."));
    shown->line().open(KindData(line));
    EXPECT_TRUE(QTest::qWaitFor([this] { return !shown->line().isOpening(); }));
    advance(50);
    EXPECT_TRUE(told().contains(QStringLiteral("/dev/codewheel-none"))) << told().toStdString();
    EXPECT_TRUE(came(0).contains(QStringLiteral("not connected")));
}

TEST_F(WhyInWindowTest, OfALineWithoutEncodersItLeadsToTheSearch)
{
    while (!shown->line().session()->places().empty()) {
        structure().choose(shown->line().session()->places().front());
        lineActions().remove->trigger();
        advance(50);
    }
    ask(Place{firstLine});
    EXPECT_EQ(outcome(), QStringLiteral("What differs first: Devices"));
    press(plainLabel(lineActions().search->text()));
    EXPECT_NE(page(), &why());
}

TEST_F(WhyInWindowTest, HasAnEntryWithAKeyAndItsPageOfTheManual)
{
    EXPECT_EQ(plainLabel(actions().whyNoData->text()), QStringLiteral("Why is there no data?"));
    QTest::keyClick(&window(), Qt::Key_F12);
    EXPECT_TRUE(isOpen());
    EXPECT_EQ(helpTopicOf(&why()), QStringLiteral("why.md"));
}

TEST_F(WhyInWindowTest, SpeaksGerman)
{
    Language language;
    language.use(QStringLiteral("de"));
    open(); // in this language
    advance(200);
    befall(TrainingFault::wireBreak, "4.0"_ring);
    EXPECT_EQ(plainLabel(actions().whyNoData->text()), QStringLiteral("Warum kommen keine Daten?"));
    doubleClick(Place{firstBus});
    ASSERT_TRUE(isOpen());
    EXPECT_EQ(outcome(), QStringLiteral("Erste Abweichung: Ring"));
    EXPECT_TRUE(told().contains(QStringLiteral("zwischen 3.0 und 4.0"))) << told().toStdString();
    ASSERT_NE(button(), nullptr);
    EXPECT_EQ(button()->text(), plainLabel(actions().start->text()));
}

} // namespace
} // namespace codewheel
