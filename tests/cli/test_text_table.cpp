// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/text_table.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(TextTable, AlignsColumnsAndLeavesNoTrailingSpaces)
{
    TextTable table({TextTable::Align::right, TextTable::Align::left});
    table.add({QStringLiteral("cycle"), QStringLiteral("OUT"), QStringLiteral("meaning")});
    table.add({QStringLiteral("7"), QStringLiteral("020000FF"), QString()});
    EXPECT_EQ(table.toString(1), QStringLiteral(" cycle  OUT       meaning\n"
                                                "     7  020000FF\n"));
}

TEST(TextTable, LinesMayHaveFewerColumns)
{
    TextTable table;
    table.add({QStringLiteral("a")});
    table.add({});
    table.add({QStringLiteral("bcd"), QStringLiteral("e")});
    EXPECT_EQ(table.toString(), QStringLiteral("a\n\nbcd  e\n"));
}

} // namespace
} // namespace codewheel
