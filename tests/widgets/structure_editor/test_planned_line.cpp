// SPDX-License-Identifier: GPL-3.0-or-later
// Buses planned by address: a serial line, and a kind added at run time.
#include "catalog/catalog.h"
#include "project/bus_kind.h"
#include "project/bus_plans.h"
#include "project/plan_rules.h"
#include "tests/support/model_tester.h"
#include "widgets/look/inline_message.h"
#include "widgets/structure_editor/plan_model.h"
#include "widgets/structure_editor/structure_editor.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeView>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr BusId line{4};

class PlannedLine : public testing::Test
{
protected:
    PlannedLine()
    {
        Project project;
        planBus(project, line, *busKind(u"esc"));
        document.setProject(project, {});
        editor.resize(900, 620);
        editor.show();
        editor.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&editor));
        editor.setBus(line);
    }

    void insert()
    {
        editor.openInsertPanel();
        QTest::keyClick(&child<QLineEdit>("catalogSearch"), Qt::Key_Return);
    }
    QString places(BusId bus = line) const
    {
        QStringList texts;
        for (const ProjectDevice &device : devicesOn(document.project(), bus))
            texts << device.place().toString();
        return texts.join(u' ');
    }
    QModelIndex cell(int row, PlanField field) const
    {
        auto &model = static_cast<PlanModel &>(*tree.model());
        int column = 0;
        while (model.columnAt(column).field != field)
            ++column;
        return model.index(row, column);
    }
    void type(int row, PlanField field, const QString &text)
    {
        tree.setCurrentIndex(cell(row, field));
        tree.edit(cell(row, field));
        auto *input = tree.viewport()->findChild<QLineEdit *>();
        ASSERT_NE(input, nullptr);
        input->selectAll();
        QTest::keyClicks(input, text);
        QTest::keyClick(input, Qt::Key_Return);
        QCoreApplication::processEvents(); // the input is taken afterwards
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    template <typename Widget>
    Widget &child(const char *name) const
    {
        return *editor.findChild<Widget *>(QLatin1String(name));
    }
    QString message() const
    {
        const auto *shown = editor.findChild<InlineMessage *>();
        return shown->isVisible() ? shown->sentence() : QString();
    }

    Catalog catalog = Catalog::builtIn();
    ProjectDocument document;
    StructureEditor editor{document, catalog};
    QTreeView &tree = *editor.findChild<QTreeView *>(QStringLiteral("plan"));
    test::ModelTester tester{*tree.model()};
};

TEST_F(PlannedLine, EncodersAreInsertedAtTheNextFreeAddress)
{
    editor.openInsertPanel();
    const auto &devices = child<QListWidget>("catalogDevices");
    ASSERT_GT(devices.count(), 0);
    for (int i = 0; i < devices.count(); ++i)
        EXPECT_TRUE(devices.item(i)->text().contains(QStringLiteral("LIMES"), Qt::CaseInsensitive) ||
                    devices.item(i)->text().contains(QStringLiteral("Kübler")))
            << devices.item(i)->text().toStdString();
    EXPECT_FALSE(child<QLineEdit>("insertIdCode").isVisible()) << "nothing has codes here";
    insert();
    insert();
    EXPECT_EQ(places(), QStringLiteral("esc:01 esc:02"));
    type(1, PlanField::place, QStringLiteral("1f"));
    EXPECT_EQ(places(), QStringLiteral("esc:01 esc:1F"));
    insert();
    EXPECT_EQ(places(), QStringLiteral("esc:01 esc:02 esc:1F")) << "behind the last, from the start";
    EXPECT_TRUE(catalog.find(document.device({line, NodeId("esc:02")}).participant.deviceKey));
    EXPECT_EQ(document.undoStack().count(), 4) << "one step each";
    while (document.undoStack().canUndo())
        document.undoStack().undo();
    EXPECT_EQ(places(), QString());
}

TEST_F(PlannedLine, WhatWasSearchedInTheCatalogOfAnotherBusIsForgotten)
{
    Project project = document.project();
    planBus(project, firstBus, *busKind(u"interbus"));
    document.setProject(project, {});
    editor.setBus(firstBus);
    editor.openInsertPanel();
    auto &search = child<QLineEdit>("catalogSearch");
    QTest::keyClicks(&search, QStringLiteral("OCD-IB K2"));
    const auto &devices = child<QListWidget>("catalogDevices");
    ASSERT_GT(devices.count(), 0);
    editor.setBus(line);
    EXPECT_EQ(search.text(), QString());
    EXPECT_GT(devices.count(), 0);
}

TEST_F(PlannedLine, AnAddressThatIsTakenOrNoneIsToldOnTheSpot)
{
    insert();
    insert();
    type(0, PlanField::station, QStringLiteral("Hoist"));
    const int steps = document.undoStack().count();
    for (const auto &[typed, told] :
         {std::pair(u"01", u"\"Hoist\" is planned at 01."),
          std::pair(u"20", u"\"20\" is not an address of an encoder on a serial line."),
          std::pair(u"00", u"Every encoder answers to address 00: it is for an encoder that is alone on its "
                           u"line, and there is 01 too.")}) {
        type(1, PlanField::place, QString::fromUtf16(typed));
        EXPECT_TRUE(message().startsWith(QString::fromUtf16(told))) << message().toStdString();
        QTest::keyClick(tree.viewport()->findChild<QLineEdit *>(), Qt::Key_Escape);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    EXPECT_EQ(places(), QStringLiteral("esc:01 esc:02"));
    EXPECT_EQ(document.undoStack().count(), steps);
}

TEST_F(PlannedLine, WhatIsKnownOfAnEncoderGoesWithItsAddress)
{
    insert();
    insert();
    type(0, PlanField::station, QStringLiteral("Hoist"));
    type(0, PlanField::serialNumber, QStringLiteral("2041700"));
    type(0, PlanField::place, QStringLiteral("0A"));
    EXPECT_EQ(places(), QStringLiteral("esc:02 esc:0A"));
    const ProjectDevice &moved = document.device({line, NodeId("esc:0A")});
    EXPECT_EQ(moved.station, QStringLiteral("Hoist"));
    EXPECT_EQ(moved.label.serialNumber, QStringLiteral("2041700"));
    EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("Address of esc:01"));
    EXPECT_EQ(tree.currentIndex().siblingAtColumn(0).data().toString(), QStringLiteral("esc:0A"))
        << "it stays chosen";
    QTest::keyClick(&tree, Qt::Key_Delete, Qt::ControlModifier);
    EXPECT_EQ(places(), QStringLiteral("esc:02"));
    document.undoStack().undo();
    EXPECT_EQ(document.device({line, NodeId("esc:0A")}).station, QStringLiteral("Hoist"));
}

TEST_F(PlannedLine, AnotherDeviceKeepsThePlaceAndNotTheLabel)
{
    insert();
    type(0, PlanField::station, QStringLiteral("Hoist"));
    type(0, PlanField::serialNumber, QStringLiteral("2041700"));
    auto &devices = child<QListWidget>("catalogDevices");
    ASSERT_GT(devices.count(), 1);
    devices.setCurrentRow(1);
    const QString before = document.device({line, NodeId("esc:01")}).participant.deviceKey;
    QTest::mouseClick(&child<QPushButton>("changeDevice"), Qt::LeftButton);
    const ProjectDevice &changed = document.device({line, NodeId("esc:01")});
    EXPECT_NE(changed.participant.deviceKey, before);
    EXPECT_EQ(changed.station, QStringLiteral("Hoist"));
    EXPECT_EQ(changed.label, DeviceLabel());
}

TEST_F(PlannedLine, NothingOfARingIsOffered)
{
    insert();
    for (const QAction *action : editor.actions())
        EXPECT_TRUE(!action->isVisible() || action->text() == QStringLiteral("Insert…") ||
                    action->text() == QStringLiteral("Remove"))
            << action->text().toStdString();
    EXPECT_FALSE(tree.model()->flags(cell(0, PlanField::place)) & Qt::ItemIsDragEnabled);
    EXPECT_EQ(child<QLineEdit>("structureSearch").placeholderText(),
              QStringLiteral("Address, name, station"));
    editor.setBus(firstBus);
    EXPECT_TRUE(editor.actions().last()->isVisible());
}

TEST_F(PlannedLine, TheBusIsChosenInTheEditorToo)
{
    insert();
    auto &bus = child<QComboBox>("plannedBus");
    ASSERT_TRUE(bus.isVisible());
    EXPECT_EQ(bus.currentText(), QStringLiteral("Line"));
    QSignalSpy chosen(&editor, &StructureEditor::busChosen);
    bus.setFocus();
    QTest::keyClick(&bus, Qt::Key_Up);
    EXPECT_EQ(bus.currentText(), QStringLiteral("Ring"));
    EXPECT_EQ(chosen.count(), 1);
    EXPECT_EQ(tree.model()->rowCount(), 0);
    editor.setBus(line);
    EXPECT_EQ(bus.currentText(), QStringLiteral("Line"));
    EXPECT_EQ(tree.model()->rowCount(), 1);
}

TEST_F(PlannedLine, ABusThatIsNotInTheProjectIsPlannedWithItsFirstDevice)
{
    document.setProject({}, {});
    editor.setBus(firstLine, QStringLiteral("esc"));
    insert();
    EXPECT_EQ(places(firstLine), QStringLiteral("esc:01"));
    EXPECT_EQ(findBus(document.project(), firstLine)->kind, QStringLiteral("esc"));
    document.undoStack().undo();
    EXPECT_EQ(findBus(document.project(), firstLine), nullptr);
    insert();
    EXPECT_EQ(places(firstLine), QStringLiteral("esc:01"));
}

// Three places with plain numbers, for any encoder.
class HookRules final : public PlanRules
{
    std::vector<NodeId> places() const override
    {
        return {NodeId("hook:1"), NodeId("hook:2"), NodeId("hook:3")};
    }
    bool isOffered(const DeviceDescription &) const override { return true; }
};

class HookKind final : public BusKind
{
public:
    QString key() const override { return QStringLiteral("hooks"); }
    QString title() const override { return QStringLiteral("Hooks"); }
    QString usualName() const override { return title(); }
    KindData usual() const override { return KindData(3); }
    QString linkText(const KindData &) const override { return {}; }
    bool isTraining(const KindData & /*settings*/) const override { return true; }
    std::unique_ptr<BusOutline> outline(const Project &, BusId, const Catalog &) const override { return {}; }
    KindData read(const JsonObject &, std::vector<ProjectDevice> &) const override { return usual(); }
    void write(ProjectWriter &, const KindData &, std::span<const ProjectDevice>) const override {}
    const PlanRules &planRules() const override { return m_rules; }

private:
    HookRules m_rules;
};

TEST_F(PlannedLine, AKindThatIsAddedIsPlannedByItsPlaces)
{
    addBusKind(std::make_unique<HookKind>());
    constexpr BusId hooks{9};
    editor.setBus(hooks, QStringLiteral("hooks"));
    for (int i = 0; i < 3; ++i)
        insert();
    EXPECT_EQ(places(hooks), QStringLiteral("hook:1 hook:2 hook:3"));
    EXPECT_FALSE(child<QPushButton>("insertDevice").isEnabled());
    EXPECT_EQ(child<QLabel>("insertReading").text(), QStringLiteral("Every place of this bus is taken."));
    type(2, PlanField::place, QStringLiteral("4"));
    EXPECT_EQ(message(), QStringLiteral("\"4\" is not an address of this bus: type one from 1 to 3."));
}

} // namespace
} // namespace codewheel
