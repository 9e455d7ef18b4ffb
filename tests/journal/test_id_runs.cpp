// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/id_runs.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

std::vector<qint64> all(const IdRuns &runs)
{
    std::vector<qint64> ids;
    for (qint64 row = 0; row < runs.size(); ++row)
        ids.push_back(runs.at(row));
    return ids;
}

TEST(IdRuns, GrowsAtBothEnds)
{
    IdRuns runs;
    runs.prepend({10, 11, 13});
    runs.append({14, 20});
    runs.prepend({3, 8, 9});
    runs.append(21, 23);
    EXPECT_EQ(all(runs), (std::vector<qint64>{3, 8, 9, 10, 11, 13, 14, 20, 21, 22, 23}));
    EXPECT_EQ(runs.front(), 3);
    EXPECT_EQ(runs.back(), 23);
}

TEST(IdRuns, ForgetsTheOldest)
{
    IdRuns runs;
    runs.append(1, 1'000'000);
    runs.append({2'000'000});
    EXPECT_EQ(runs.dropBelow(1), 0);
    EXPECT_EQ(runs.dropBelow(999'999), 999'998);
    EXPECT_EQ(all(runs), (std::vector<qint64>{999'999, 1'000'000, 2'000'000}));
    runs.prepend({5});
    EXPECT_EQ(runs.at(0), 5);
    EXPECT_EQ(runs.dropBelow(1'500'000), 3);
    EXPECT_EQ(all(runs), (std::vector<qint64>{2'000'000}));
    EXPECT_EQ(runs.dropBelow(3'000'000), 1);
    EXPECT_TRUE(runs.isEmpty());
    EXPECT_EQ(runs.size(), 0);
}

} // namespace
} // namespace codewheel
