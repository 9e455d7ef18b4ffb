// SPDX-License-Identifier: GPL-3.0-or-later
// A kind of bus that the window does not know, added at run time.
#include "app/window/plant.h"
#include "tests/app/window_test.h"
#include "tests/support/plain_bus.h"
#include "widgets/dial/code_disc.h"
#include "widgets/structure/structure_model.h"
#include "widgets/structure/structure_view.h"

#include <QAction>
#include <QTreeView>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

class PlainBusAtWork final : public BusAtWork
{
public:
    PlainBusAtWork(const Surroundings &its, std::unique_ptr<test::PlainBus> bus)
        : BusAtWork(test::plainId, its)
        , m_bus(std::move(bus))
    {
        tellMessagesOf(*m_bus);
    }

    QString kind() const override { return QStringLiteral("plain"); }
    test::PlainBus *bus() const override { return m_bus.get(); }

private:
    std::unique_ptr<test::PlainBus> m_bus;
};

class PlainBusInWindow : public test::WindowTest
{
protected:
    static void SetUpTestSuite() { addBusKind(std::make_unique<test::PlainKind>()); }

    PlainBusInWindow()
    {
        auto own = std::make_unique<test::PlainBus>(shown->plant().catalog());
        plain = own.get();
        const BusAtWork::Surroundings its{shown->plant().catalog(), shown->project(), folder.path(), false,
                                          [] { return TrainingWindow::begin(); }};
        shown->plant().add(std::make_unique<PlainBusAtWork>(its, std::move(own)));
    }

    StructureView &tree() { return *window().findChild<StructureView *>(); }
    std::string cell(Place place, StructureModel::Column column)
    {
        const auto &model = static_cast<const StructureModel &>(*tree().findChild<QTreeView *>()->model());
        return model.indexOf(place).siblingAtColumn(column).data().toString().toStdString();
    }

    test::PlainBus *plain = nullptr;
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

// Nothing of the other kinds is done to it, and its own kind has no views.
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
    plain->close();
    shown->project().edit(shown->project().project(), QStringLiteral("anything"));
    Project other = shown->project().project();
    other.title = QStringLiteral("Other");
    shown->project().edit(other, QStringLiteral("Title"));
    advance(50);
    EXPECT_EQ(shown->plant().find(test::plainId), nullptr);
    EXPECT_EQ(cell(test::plainHoist, StructureModel::deviceColumn), "");
}

} // namespace
} // namespace codewheel
