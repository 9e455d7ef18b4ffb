// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/ring/id_code.h"
#include "tests/support/model_tester.h"
#include "tests/support/places.h"
#include "tests/support/plans.h"
#include "tests/widgets/structure_editor/plan_test.h"
#include "widgets/structure_editor/plan_edits.h"
#include "widgets/structure_editor/plan_model.h"

#include <QMimeData>
#include <QSignalSpy>

#include <memory>
#include <random>

namespace codewheel {
namespace {

class PlanModelTest : public test::PlanTest
{
protected:
    QString text(const QString &number, int column) const
    {
        return model.indexOf(id(number), column).data().toString();
    }
    // The visible tree: "1.0 2.0(2.1 2.2 3.0) 4.0".
    static QString tree(const QAbstractItemModel &of, const QModelIndex &parent = {})
    {
        QStringList texts;
        for (int row = 0; row < of.rowCount(parent); ++row) {
            const QModelIndex index = of.index(row, 0, parent);
            texts << index.data().toString() +
                         (of.rowCount(index) > 0 ? u'(' + tree(of, index) + u')' : QString());
        }
        return texts.join(u' ');
    }
    void drop(const QStringList &numbers, const QString &onto, int row)
    {
        QModelIndexList dragged;
        for (const QString &number : numbers)
            dragged << model.indexOf(id(number));
        const std::unique_ptr<QMimeData> data(model.mimeData(dragged));
        const QModelIndex parent = onto.isEmpty() ? QModelIndex() : model.indexOf(id(onto));
        EXPECT_FALSE(model.dropMimeData(data.get(), Qt::MoveAction, row, 0, parent));
    }

    PlanEdits edits{document, catalog};
    PlanModel model{edits};
    test::ModelTester tester{model};
};

TEST_F(PlanModelTest, ShowsLocalBusAndBranchBelowTheirTerminal)
{
    EXPECT_EQ(tree(model), QStringLiteral("1.0 2.0(2.1 2.2 3.0 4.0) 5.0 6.0 7.0"));
    EXPECT_EQ(text(QStringLiteral("1.0"), test::deviceColumn), QStringLiteral("K3, make not known"));
    EXPECT_EQ(text(QStringLiteral("2.0"), test::deviceColumn), QStringLiteral("bus terminal"));
    EXPECT_EQ(text(QStringLiteral("7.0"), test::deviceColumn), QStringLiteral("analog input and output"));
    EXPECT_EQ(text(QStringLiteral("1.0"), test::idCodeColumn), QStringLiteral("37h = 55"));
    EXPECT_EQ(text(QStringLiteral("3.0"), test::wordsColumn), QStringLiteral("1 / 0"));
    EXPECT_EQ(text(QStringLiteral("2.1"), test::inColumn), QStringLiteral("4"));
    EXPECT_EQ(text(QStringLiteral("3.0"), test::outColumn), QString());
}

TEST_F(PlanModelTest, TellsOfOneRowWhereOneChanged)
{
    QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
    QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
    document.editDevice("5.0"_ring, {},
                        [](ProjectDevice &device) { device.station = QStringLiteral("hoist"); });
    ASSERT_EQ(changes.count(), 1);
    EXPECT_EQ(changes.first().at(0).toModelIndex().row(), 2);
    EXPECT_EQ(changes.first().at(1).toModelIndex().row(), 2);
    EXPECT_EQ(resets.count(), 0);
}

TEST_F(PlanModelTest, AMoveIsAMoveAndNothingElse)
{
    QSignalSpy moves(&model, &QAbstractItemModel::rowsMoved);
    QSignalSpy inserts(&model, &QAbstractItemModel::rowsInserted);
    QSignalSpy removals(&model, &QAbstractItemModel::rowsRemoved);
    const QPersistentModelIndex moved = model.indexOf(id(QStringLiteral("1.0")));
    ASSERT_TRUE(edits.move({id(QStringLiteral("1.0"))}, where({{}, false, 99})));
    EXPECT_EQ(moves.count(), 1);
    EXPECT_EQ(moved.row(), 4) << "who looked at it still does";
    document.undoStack().undo();
    EXPECT_EQ(moves.count(), 2);
    EXPECT_EQ(moved.row(), 0);
    ASSERT_TRUE(edits.move({id(QStringLiteral("5.0"))}, where({1, true, 1})));
    EXPECT_EQ(tree(model), QStringLiteral("1.0 2.0(2.1 2.2 2.3 3.0 4.0) 5.0 6.0"));
    EXPECT_EQ(moves.count(), 3);
    EXPECT_EQ(inserts.count() + removals.count(), 0);
}

TEST_F(PlanModelTest, StationGroupAndAddressesAreEditedInPlace)
{
    const auto edit = [&](const QString &number, int column, const QString &text) {
        return model.setData(model.indexOf(id(number), column), text);
    };
    EXPECT_TRUE(edit(QStringLiteral("1.0"), test::stationColumn, QStringLiteral(" Crane 1 ")));
    EXPECT_TRUE(edit(QStringLiteral("1.0"), test::groupColumn, QStringLiteral("A")));
    EXPECT_TRUE(edit(QStringLiteral("1.0"), test::inColumn, QStringLiteral("128")));
    const ProjectDevice &device = document.device("1.0"_ring);
    EXPECT_EQ(device.station, QStringLiteral("Crane 1"));
    EXPECT_EQ(device.group, QStringLiteral("A"));
    EXPECT_EQ(device.its<GivenAddresses>().in, 128);
    EXPECT_EQ(document.undoStack().count(), 3);
    EXPECT_TRUE(edit(QStringLiteral("2.0"), test::noteColumn, QStringLiteral("behind the door")));
    EXPECT_TRUE(edit(QStringLiteral("1.0"), test::serialColumn, QStringLiteral("20417")));
    EXPECT_EQ(document.device("1.0"_ring).label.serialNumber, QStringLiteral("20417"));
    EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("Serial number of 1.0"));
    EXPECT_EQ(model.find(QStringLiteral("2041")), std::vector{id(QStringLiteral("1.0"))});
    EXPECT_FALSE(model.flags(model.indexOf(id(QStringLiteral("2.0")), test::serialColumn)) &
                 Qt::ItemIsEditable)
        << "a bus terminal";
    EXPECT_EQ(document.device("2.0"_ring).note, QStringLiteral("behind the door"));
    EXPECT_EQ(model.find(QStringLiteral("door")), std::vector{id(QStringLiteral("2.0"))});
    EXPECT_TRUE(edit(QStringLiteral("1.0"), test::inColumn, {}));
    EXPECT_EQ(document.device("1.0"_ring).its<GivenAddresses>().in, std::nullopt) << "counted again";
    EXPECT_TRUE(edit(QStringLiteral("1.0"), test::outColumn, QStringLiteral("0")));
    EXPECT_EQ(document.device("1.0"_ring).its<GivenAddresses>().out, std::nullopt) << "only looked at";

    QSignalSpy complaints(&model, &PlanModel::badInput);
    edit(QStringLiteral("1.0"), test::inColumn, QStringLiteral("twelve"));
    ASSERT_EQ(complaints.count(), 1);
    EXPECT_TRUE(complaints.first().first().toString().contains(QStringLiteral("twelve")));
    EXPECT_EQ(document.device("1.0"_ring).its<GivenAddresses>().in, std::nullopt);
    EXPECT_FALSE(model.flags(model.indexOf(id(QStringLiteral("3.0")), test::outColumn)) & Qt::ItemIsEditable);
}

TEST_F(PlanModelTest, AddressesAreShownInWordsIfWanted)
{
    Project after = document.project();
    changeRing(after, [&](RingPlan &ring) { ring.addresses.unit = AddressRules::Unit::word; });
    QSignalSpy headers(&model, &QAbstractItemModel::headerDataChanged);
    document.edit(after, {});
    EXPECT_EQ(text(QStringLiteral("2.1"), test::inColumn), QStringLiteral("2"));
    EXPECT_EQ(headers.count(), 1);
    EXPECT_EQ(model.headerData(test::inColumn, Qt::Horizontal, Qt::DisplayRole).toString(),
              QStringLiteral("IN word"));
}

TEST_F(PlanModelTest, WhatIsWrongStandsBesideTheDevice)
{
    document.editDevice("1.0"_ring, {}, [](ProjectDevice &device) { device.set(GivenAddresses{.in = 128}); });
    document.editDevice("5.0"_ring, {}, [](ProjectDevice &device) { device.set(GivenAddresses{.in = 130}); });
    EXPECT_EQ(text(QStringLiteral("1.0"), test::findingsColumn),
              QStringLiteral("IN at 128 overlaps that of 5.0."));
    EXPECT_EQ(text(QStringLiteral("2.1"), test::findingsColumn), QString());
}

TEST_F(PlanModelTest, FindsByNumberNameIdCodeAndStation)
{
    document.editDevice("7.0"_ring, {},
                        [](ProjectDevice &device) { device.station = QStringLiteral("Hoist"); });
    const auto numbers = [&](const char *wanted) {
        QStringList found;
        for (const PlanModel::Id each : model.find(QString::fromLatin1(wanted)))
            found << document.device(each)->place().toString();
        return found.join(u' ');
    };
    EXPECT_EQ(numbers("2.1"), QStringLiteral("2.1"));
    EXPECT_EQ(numbers("2."), QStringLiteral("2.0 2.1 2.2"));
    EXPECT_EQ(numbers("terminal"), QStringLiteral("2.0 6.0"));
    EXPECT_EQ(numbers("b3h"), QStringLiteral("2.1 2.2"));
    EXPECT_EQ(numbers("0237h"), QStringLiteral("1.0 4.0"));
    EXPECT_EQ(numbers("hoist"), QStringLiteral("7.0"));
    EXPECT_EQ(numbers(" "), QString());
}

TEST_F(PlanModelTest, DroppedDevicesGoWhereTheyBelong)
{
    drop({QStringLiteral("1.0")}, {}, 3); // before 6.0
    EXPECT_EQ(tree(model), QStringLiteral("1.0(1.1 1.2 2.0 3.0) 4.0 5.0 6.0 7.0"));
    EXPECT_EQ(at(QStringLiteral("5.0")).deviceCode, 0x0237U);
    drop({QStringLiteral("5.0")}, QStringLiteral("6.0"), -1); // onto a terminal: in its branch
    EXPECT_EQ(tree(model), QStringLiteral("1.0(1.1 1.2 2.0 3.0) 4.0 5.0(6.0) 7.0"));
    drop({QStringLiteral("1.1")}, QStringLiteral("5.0"), -1); // Loop 2: on its local bus
    EXPECT_EQ(tree(model), QStringLiteral("1.0(1.1 2.0 3.0) 4.0 5.0(5.1 6.0) 7.0"));
    drop({QStringLiteral("6.0")}, QStringLiteral("1.0"), 1); // between local bus and branch
    EXPECT_EQ(at(QStringLiteral("2.0")).deviceCode, 0x0237U);
    drop({QStringLiteral("2.0"), QStringLiteral("3.0")}, {}, 0);
    EXPECT_EQ(at(QStringLiteral("1.0")).level, 0);
    EXPECT_EQ(tree(model), QStringLiteral("1.0 2.0 3.0(3.1 4.0) 5.0 6.0(6.1) 7.0"));
    EXPECT_EQ(document.undoStack().count(), 5);
}

TEST_F(PlanModelTest, ADropThatCannotBeIsRefused)
{
    QSignalSpy refused(&model, &PlanModel::refused);
    drop({QStringLiteral("2.0")}, QStringLiteral("2.0"), -1);
    drop({QStringLiteral("6.0")}, QStringLiteral("2.0"), 0); // a terminal on a local bus
    EXPECT_EQ(refused.count(), 2);
    EXPECT_EQ(document.undoStack().count(), 0);
}

// Whatever the edits: the rows show the project, and undo restores them.
TEST_F(PlanModelTest, RandomEditsAndUndoAreFollowed)
{
    std::mt19937 random(5);
    const auto below = [&](std::size_t end) {
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
    };
    for (int step = 0; step < 400; ++step) {
        const auto planned = document.ids(firstBus);
        const std::vector<PlanModel::Id> ids(planned.begin(), planned.end());
        RingPlace place{.terminal = {}, .onLocalBus = below(2) == 0, .row = below(5)};
        if (!ids.empty() && below(2) == 0)
            place.terminal = below(ids.size());
        switch (below(6)) {
        case 0:
            (void)edits.insert(deviceOf(below(2) == 0 ? busTerminalIdCode : 0x0237), where(place));
            break;
        case 1:
            if (!ids.empty())
                (void)edits.remove({ids[below(ids.size())]});
            break;
        case 2:
        case 3:
            if (!ids.empty())
                (void)edits.move({ids[below(ids.size())], ids[below(ids.size())]}, where(place));
            break;
        case 4:
            document.undoStack().undo();
            break;
        default:
            document.undoStack().redo();
        }
        const PlanModel fresh(edits);
        ASSERT_EQ(tree(model), tree(fresh)) << step;
    }
}

TEST_F(PlanModelTest, AnotherProjectTakesTheRowsPlace)
{
    document.setProject(projectOf(writtenRing("K1 BT .DI")), {});
    EXPECT_EQ(tree(model), QStringLiteral("1.0 2.0(2.1)"));
    document.setProject({}, {});
    EXPECT_EQ(model.rowCount(), 0);
}

} // namespace
} // namespace codewheel
