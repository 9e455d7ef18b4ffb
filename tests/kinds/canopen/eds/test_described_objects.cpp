// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/canopen/eds/standard_objects.h"
#include "kinds/canopen/protocol/canopen_reach.h"

#include <gtest/gtest.h>

namespace codewheel::canopen {
namespace {

TEST(DescribedObjects, OfNoMakeAreThoseOfTheStandards)
{
    const Catalog catalog = Catalog::builtIn();
    const std::size_t standard = standardObjects().objects.size();
    EXPECT_EQ(describedObjects(nullptr).objects.size(), standard);
    EXPECT_EQ(describedObjects(catalog.find(QStringLiteral("canopen-406-multi-turn"))).objects.size(),
              standard);
}

TEST(DescribedObjects, OfAMakeHaveItsLimitsAndItsOwnObjects)
{
    const Catalog catalog = Catalog::builtIn();
    DeviceDescription device = *catalog.find(QStringLiteral("canopen-406-multi-turn"));
    device.vendor = QStringLiteral("Rotor Works");
    for (ParameterDescription &parameter : device.parameters)
        if (parameter.parameter == Parameter::steps)
            parameter.maximum = 4096;
    ParameterDescription depth;
    depth.parameter = Parameter::of(u"2101", {{{QStringLiteral("en"), QStringLiteral("Filter depth")}}});
    depth.reach = KindData(CanopenReach{.object = {0x2101, 0}, .type = ObjectType::u8});
    depth.canBeRead = true;
    depth.maximum = 255;
    device.parameters.push_back(std::move(depth));
    const DeviceFile file = describedObjects(&device);
    ASSERT_NE(file.find({0x2101, 0}), nullptr);
    EXPECT_EQ(file.find({0x2101, 0})->name, QStringLiteral("Filter depth"));
    EXPECT_EQ(file.find({0x2101, 0})->type, DataType::u8);
    EXPECT_FALSE(file.find({0x2101, 0})->canBeWritten());
    EXPECT_EQ(file.find({0x6001, 0})->maximum, FileValue{std::int64_t{4096}});
    EXPECT_EQ(file.find({0x6001, 0})->name, standardObjectName({0x6001, 0}));
    EXPECT_TRUE(file.find({0x6003, 0})->canBeWritten()) << "the preset is no value that a job writes";
}

} // namespace
} // namespace codewheel::canopen
