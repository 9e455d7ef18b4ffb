// SPDX-License-Identifier: GPL-3.0-or-later
// A kind of bus that the window does not know, added at run time.
#include "app/window/buses/plant.h"
#include "app/window/kinds/window_kinds.h"
#include "project/bus_plans.h"
#include "tests/app/window_test.h"
#include "tests/kinds/plain/plain_bus.h"
#include "widgets/dial/code_disc.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/parameters/value_input.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/structure/structure_model.h"
#include "widgets/structure/structure_view.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTreeView>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

class PlainBusAtWork final : public BusAtWork
{
public:
    PlainBusAtWork(BusId id, const Surroundings &its)
        : BusAtWork(id, its)
        , m_bus(its.catalog)
    {
        tellMessagesOf(m_bus);
    }

    QString kind() const override { return QStringLiteral("plain"); }
    test::PlainBus *bus() const override { return &m_bus; }

private:
    mutable test::PlainBus m_bus;
};

constexpr Panel plainPanel{"plainDock", "Plain panel", Qt::ALT | Qt::SHIFT | Qt::Key_P,
                           "README.md#the-window", Panel::Behind::state};
constexpr std::array plainPanels{&plainPanel};

class PlainViews final : public BusViews
{
public:
    PlainViews(const WindowParts &parts, QObject *parent)
        : BusViews(parent)
        , m_page(own(new QLabel(QStringLiteral("plain page"), &parts.pages)))
        , m_comparison(own(new QLabel(&parts.pages)))
    {
        parts.pages.addWidget(m_comparison);
    }

    std::vector<std::pair<const Panel *, QWidget *>> pages() const override
    {
        return {{&plainPanel, m_page}};
    }
    QWidget *comparison() const override { return m_comparison; }
    void open() override { Q_EMIT panelRequested(plainPanel); }

    QLabel *const m_page;

private:
    void showCurrent() override {}

    QLabel *const m_comparison;
};

class PlainBusInWindow : public test::WindowTest
{
protected:
    static void SetUpTestSuite()
    {
        addBusKind(std::make_unique<test::PlainKind>());
        addWindowKind({QStringLiteral("plain"),
                       [](BusId id, const BusAtWork::Surroundings &its) -> std::unique_ptr<BusAtWork> {
                           return std::make_unique<PlainBusAtWork>(id, its);
                       },
                       [](BusAtWork &, const WindowParts &parts, QObject *parent) -> BusViews * {
                           return new PlainViews(parts, parent);
                       },
                       plainPanels});
    }

    PlainBusInWindow()
    {
        Project project = shown->project().project();
        planBus(project, test::plainId, *busKind(u"plain")).name = QStringLiteral("Yard");
        shown->project().edit(project, QStringLiteral("Plan it"));
    }

    BusAtWork *plain() { return shown->plant().find(test::plainId); }
    StructureView &tree() { return *window().findChild<StructureView *>(); }
    std::string cell(Place place, StructureModel::Column column)
    {
        const auto &model = static_cast<const StructureModel &>(*tree().findChild<QTreeView *>()->model());
        return model.indexOf(place).siblingAtColumn(column).data().toString().toStdString();
    }
};

TEST_F(PlainBusInWindow, ItsNodesStandInTheTree)
{
    EXPECT_EQ(cell(test::plainHoist, StructureModel::deviceColumn), "n:1  Hoist encoder");
    EXPECT_EQ(cell(test::plainLamp, StructureModel::deviceColumn), "n:3  Lamp");
    EXPECT_EQ(cell(test::plainHoist, StructureModel::positionColumn), "1001");
    advance(500);
    EXPECT_EQ(cell(test::plainHoist, StructureModel::positionColumn), "1501");
}

TEST_F(PlainBusInWindow, ItsEncoderIsOnTheDial)
{
    const auto text = [&] { return window().findChild<CodeDisc *>()->valueText().toStdString(); };
    tree().choose(test::plainGate);
    advance(100);
    EXPECT_THAT(text(), testing::HasSubstr("1101"));
    advance(400);
    EXPECT_THAT(text(), testing::HasSubstr("1501"));
}

TEST_F(PlainBusInWindow, ItsKindBringsAPanel)
{
    ASSERT_NE(plain(), nullptr);
    Q_EMIT tree().busOpened(test::plainId);
    const auto pages = window().findChildren<QLabel *>();
    const auto page = std::ranges::find(pages, QStringLiteral("plain page"), &QLabel::text);
    ASSERT_NE(page, pages.end());
    EXPECT_TRUE((*page)->isVisible());
    EXPECT_FALSE((*page)->visibleRegion().isEmpty());
    EXPECT_NE(window().findChild<QDockWidget *>(QStringLiteral("plainDock")), nullptr);
}

TEST_F(PlainBusInWindow, ItsValuesAreTypedReviewedAndWritten)
{
    auto &its = *static_cast<test::PlainBus *>(plain()->bus());
    its.setOperate(true);
    tree().choose(test::plainHoist);
    auto &panel = *window().findChild<ParameterPanel *>();
    auto &table = *panel.findChild<ParameterTable *>();
    const auto want = [&](Parameter parameter, const QString &text) {
        panel.showParameter(parameter);
        table.edit(table.currentIndex().siblingAtColumn(ParameterModel::wantedColumn));
        auto *field = qobject_cast<ValueInput *>(QApplication::focusWidget());
        ASSERT_NE(field, nullptr);
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
        QCoreApplication::processEvents();
    };
    const auto says = [&](const QString &text) {
        return std::ranges::any_of(panel.findChildren<QLabel *>(), [&](const QLabel *label) {
            return label->isVisibleTo(&panel) && label->text().contains(text);
        });
    };
    want(test::plainFilter(), QStringLiteral("-5"));
    want(test::plainName(), QStringLiteral("Hoist 2"));
    for (auto *button : panel.findChildren<QPushButton *>())
        if (button->text() == QStringLiteral("&Write…"))
            QTest::mouseClick(button, Qt::LeftButton);
    advance(50);
    EXPECT_TRUE(its.node(test::plainHoist).heard().empty()) << "it is only reviewed";
    QTest::mouseClick(panel.findChild<QPushButton *>(QStringLiteral("confirmWrite")), Qt::LeftButton);
    advance(100);
    EXPECT_EQ(its.node(test::plainHoist).inForce("2000:1"), "-5");
    EXPECT_EQ(its.node(test::plainHoist).inForce("1008"), "Hoist%202");
    EXPECT_EQ(its.node(test::plainHoist).writes(), 1);
    EXPECT_TRUE(says(QStringLiteral("Filter, Node name")) || says(QStringLiteral("Node name, Filter")));
}

TEST_F(PlainBusInWindow, TheWizardTakesItStepByStep)
{
    auto &its = *static_cast<test::PlainBus *>(plain()->bus());
    its.setOperate(true);
    const auto click = [this](const char *button) {
        const auto all =
            window().findChild<ParameterWizard *>()->findChildren<QAbstractButton *>(QLatin1String(button));
        ASSERT_FALSE(all.empty()) << button;
        ASSERT_TRUE(all.front()->isVisible() && all.front()->isEnabled()) << button;
        all.front()->click();
        advance(50);
    };
    tree().choose(test::plainHoist);
    window().findChild<WantedValues *>()->set(test::plainHoist, test::plainFilter(), -5);
    actions().wizard->trigger();
    click("wizardNext");
    click("readAll");
    const auto *nextStep = window().findChild<QAbstractButton *>(QStringLiteral("nextStep"));
    for (int page = 0; page < 6 && !nextStep->isVisible(); ++page)
        click("wizardNext");
    for (const QByteArray &line : its.node(test::plainHoist).heard())
        EXPECT_TRUE(line.startsWith("get ")) << line.toStdString();
    for (int step = 0; step < 3; ++step) // set, go, keep
        click("nextStep");
    advance(200);
    ASSERT_FALSE(window().findChild<ParameterWizard *>()->isBusy());
    EXPECT_EQ(its.node(test::plainHoist).inForce("2000:1"), "-5");
    EXPECT_EQ(its.node(test::plainHoist).writes(), 1);
}

// Nothing meant for other kinds is done to it.
TEST_F(PlainBusInWindow, ChoosingAndOpeningItDoesNoHarm)
{
    tree().choose(test::plainId);
    advance(50);
    EXPECT_TRUE(bus().isOperating());
    actions().watch->trigger();
    EXPECT_TRUE(bus().isOperating()) << "the switch means the chosen bus";
    tree().choose(test::plainHoist);
    Q_EMIT tree().opened(test::plainHoist);
    actions().alarmStop->trigger();
    advance(50);
    EXPECT_EQ(cell(test::plainHoist, StructureModel::positionColumn), "1101");
}

TEST_F(PlainBusInWindow, WhatThePlantHasOfItGoesWithIt)
{
    tree().choose(test::plainHoist);
    plain()->bus()->close();
    Project other = shown->project().project();
    other.title = QStringLiteral("Other");
    std::erase_if(other.buses, [](const PlannedBus &bus) { return bus.id == test::plainId; });
    shown->project().edit(other, QStringLiteral("Without it"));
    advance(50);
    EXPECT_EQ(plain(), nullptr);
    EXPECT_EQ(cell(test::plainHoist, StructureModel::deviceColumn), "");
}

} // namespace
} // namespace codewheel
