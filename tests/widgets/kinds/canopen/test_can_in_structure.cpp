// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/canopen/bus/canopen_plant.h"
#include "widgets/structure/structure_view.h"

#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class CanInStructure : public test::CanopenPlant
{
protected:
    StructureView tree;
};

TEST_F(CanInStructure, WhereNothingIsChosenItsFirstEncoderIsThoughItComesLater)
{
    ASSERT_TRUE(bus->open({}, EncoderBus::Start::watching, EncoderBus::Drive::byHand));
    tree.addBus(*bus);
    ASSERT_TRUE(bus->add(5, QStringLiteral("canopen-406-single-turn")));
    EXPECT_FALSE(tree.current());
    QTest::qWait(1);
    EXPECT_EQ(tree.current(), five);
    tree.removeBus(bus->id());
}

} // namespace
} // namespace codewheel
