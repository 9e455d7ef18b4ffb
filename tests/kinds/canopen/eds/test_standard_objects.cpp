// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/standard_objects.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel::canopen {
namespace {

TEST(StandardObjects, SayTypeAndAccess)
{
    const DeviceFile file = standardObjects();
    const FileObject *range = file.find({0x6002, 0});
    ASSERT_NE(range, nullptr);
    EXPECT_EQ(range->name, QStringLiteral("Total measuring range"));
    EXPECT_EQ(range->type, DataType::u32);
    EXPECT_TRUE(range->canBeWritten());
    const FileObject *position = file.find({0x6004, 0});
    ASSERT_NE(position, nullptr);
    EXPECT_EQ(position->access, FileAccess::readOnly);
    EXPECT_TRUE(position->isMapped);
    EXPECT_EQ(file.find({0x6005, 9}), nullptr);
}

TEST(StandardObjects, AreInOrderAndOnce)
{
    const DeviceFile file = standardObjects();
    EXPECT_GT(file.objects.size(), 90U);
    EXPECT_TRUE(std::ranges::is_sorted(file.objects, std::ranges::less(),
                                       [](const FileObject &each) { return orderOf(each.object); }));
    EXPECT_EQ(std::ranges::adjacent_find(file.objects, {}, &FileObject::object), file.objects.end());
}

TEST(StandardObjects, AreNumberedWhereTheyAreAlike)
{
    const DeviceFile file = standardObjects();
    ASSERT_NE(file.find({0x6317, 1}), nullptr);
    EXPECT_EQ(file.find({0x6317, 1})->name, QStringLiteral("Low limit of cam 8"));
    EXPECT_EQ(file.find({0x1801, 5})->name, QStringLiteral("Event timer of TPDO2, in ms"));
    EXPECT_EQ(file.find({0x1A00, 3})->name, QStringLiteral("Object 3 in TPDO1"));
    EXPECT_EQ(standardObjectName({0x6317, 1}), QStringLiteral("Low limit of cam 8"));
    EXPECT_EQ(standardObjectName({0x2000, 0}), QString());
}

} // namespace
} // namespace codewheel::canopen
