// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/label_text.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(LabelText, ReadsWithoutTheMarkOfItsKey)
{
    EXPECT_EQ(plainLabel(QStringLiteral("Save &as...")), QStringLiteral("Save as..."));
    EXPECT_EQ(plainLabel(QStringLiteral("Save")), QStringLiteral("Save"));
    EXPECT_EQ(plainLabel({}), QString());
}

TEST(LabelText, KeepsWhatIsMeantAsAnAmpersand)
{
    EXPECT_EQ(asLabel(QStringLiteral("Doors & gates")), QStringLiteral("Doors && gates"));
    EXPECT_EQ(plainLabel(QStringLiteral("&Remove \"Doors && gates\"")),
              QStringLiteral("Remove \"Doors & gates\""));
    EXPECT_EQ(plainLabel(asLabel(QStringLiteral("&&&"))), QStringLiteral("&&&"));
}

} // namespace
} // namespace codewheel
