// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/ring/id_code.h"
#include "tests/support/places.h"
#include "tests/widgets/structure_editor/plan_test.h"
#include "vocabulary/refusal_text.h"
#include "widgets/structure_editor/plan_edits.h"

namespace codewheel {
namespace {

class PlanEditsTest : public test::PlanTest
{
protected:
    PlanEdits edits{document, catalog};
};

TEST_F(PlanEditsTest, AnInsertedDeviceIsAStepThatNamesIt)
{
    const auto id = edits.insert(deviceOf(0x81BE), where({.terminal = 1, .onLocalBus = true, .row = 0}));
    ASSERT_TRUE(id);
    EXPECT_EQ(at(QStringLiteral("2.1")).deviceCode, 0x81BEU);
    EXPECT_EQ(document.indexOf(*id), 2u);
    EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("Insert Inline digital input"));
    document.undoStack().undo();
    EXPECT_EQ(document.project().devices.size(), 9u);
}

TEST_F(PlanEditsTest, WhatBelongsToADeviceGoesWithIt)
{
    document.editDevice("1.0"_ring, {},
                        [](ProjectDevice &device) { device.station = QStringLiteral("hoist"); });
    ASSERT_TRUE(
        edits.move({id(QStringLiteral("1.0"))}, where({.terminal = {}, .onLocalBus = false, .row = 99})));
    EXPECT_EQ(document.project().devices.back().station, QStringLiteral("hoist"));
    EXPECT_EQ(document.project().devices.back().place(), ("7.0"_ring));
    EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("Move 1.0"));
}

TEST_F(PlanEditsTest, KeysMoveADeviceAmongItsNeighbours)
{
    const QString before = order();
    ASSERT_TRUE(edits.move(id(QStringLiteral("1.0")), PlanStep::up));
    EXPECT_EQ(order(), before) << "it is the first";
    ASSERT_TRUE(edits.move(id(QStringLiteral("1.0")), PlanStep::down));
    EXPECT_EQ(order(), QStringLiteral("1.0=2 1.1=3 1.2=4 2.0=5 3.0=6 4.0=1 5.0=7 6.0=8 7.0=9"));
    ASSERT_TRUE(edits.move(id(QStringLiteral("4.0")), PlanStep::up));
    EXPECT_EQ(order(), before);
    ASSERT_TRUE(edits.move(id(QStringLiteral("7.0")), PlanStep::down));
    EXPECT_EQ(order(), before) << "it is the last";
}

TEST_F(PlanEditsTest, KeysHangADeviceBelowATerminalAndTakeItOut)
{
    const QString before = order();
    const auto k2 = id(QStringLiteral("5.0"));
    ASSERT_TRUE(edits.move(k2, PlanStep::in));
    EXPECT_EQ(ringDevice(document.project().devices.at(6).participant).level, 1);
    ASSERT_TRUE(edits.move(k2, PlanStep::changeBus));
    EXPECT_EQ(at(QStringLiteral("2.3")).deviceCode, 0x0236U);
    ASSERT_TRUE(edits.move(k2, PlanStep::changeBus));
    EXPECT_EQ(at(QStringLiteral("3.0")).deviceCode, 0x0236U) << "the first of the branch";
    ASSERT_TRUE(edits.move(k2, PlanStep::out));
    EXPECT_EQ(order(), before);
    ASSERT_TRUE(edits.move(k2, PlanStep::out));
    EXPECT_EQ(order(), before) << "it is on the main line";
}

TEST_F(PlanEditsTest, WhatCannotBeIsRefusedAndIsNoStep)
{
    const auto into = edits.move(id(QStringLiteral("2.0")), PlanStep::in); // after 1.0, which is no terminal
    ASSERT_FALSE(into);
    EXPECT_EQ(
        refusalText(into.error()),
        QStringLiteral(
            "The bus cannot be built like this: Nothing can hang below 1.0: it is not a bus terminal."));
    EXPECT_FALSE(
        edits.insert(deviceOf(busTerminalIdCode), where({.terminal = 1, .onLocalBus = true, .row = 0})));
    EXPECT_FALSE(edits.change(id(QStringLiteral("2.0")), deviceOf(0x0237)));
    EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(PlanEditsTest, AnotherKindOfDeviceKeepsThePlaceAndNotTheValues)
{
    document.editDevice("1.0"_ring, {}, [](ProjectDevice &device) {
        device.station = QStringLiteral("hoist");
        device.set(GivenAddresses{.in = 128});
        device.wanted = {{Parameter::steps, 255}};
        device.label.turns = 4096;
        device.lastPosition = {4711, {}};
    });
    ASSERT_TRUE(edits.change(id(QStringLiteral("1.0")), deviceOf(0x0236)));
    const ProjectDevice &changed = document.device("1.0"_ring);
    EXPECT_EQ(changed.participant.deviceCode, 0x0236U);
    EXPECT_EQ(changed.station, QStringLiteral("hoist"));
    EXPECT_EQ(changed.its<GivenAddresses>().in, 128);
    EXPECT_TRUE(changed.wanted.empty());
    EXPECT_EQ(changed.label, DeviceLabel());
    EXPECT_FALSE(changed.lastPosition);
}

TEST_F(PlanEditsTest, SeveralAreRemovedInOneStep)
{
    ASSERT_TRUE(edits.remove({id(QStringLiteral("1.0")), id(QStringLiteral("2.0"))}));
    EXPECT_EQ(order(), QStringLiteral("1.0=7 2.0=8 3.0=9"));
    EXPECT_EQ(document.undoStack().undoText(), QStringLiteral("Remove 2 devices"));
    EXPECT_EQ(document.undoStack().count(), 1);
}

} // namespace
} // namespace codewheel
