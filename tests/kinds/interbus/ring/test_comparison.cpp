// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/interbus/ring/numbering.h"
#include "kinds/interbus/ring/take_over.h"
#include "tests/kinds/interbus/ring/written_ring.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace codewheel {
namespace {

QString write(const Comparison &comparison, const RingStructure &configured, const RingStructure &connected)
{
    static const Catalog catalog = Catalog::builtIn();
    QStringList lines;
    for (const ComparisonLine &line : comparison)
        lines << comparisonKindKey(line.kind) + QStringLiteral(" | ") +
                     comparisonText(line, configured, connected, catalog);
    return lines.join(u'\n');
}

struct Row
{
    const char *name;
    const char *configured;
    const char *connected;
    const char *lines;
};

void PrintTo(const Row &row, std::ostream *out)
{
    *out << row.name;
}

class Comparisons : public testing::TestWithParam<Row>
{};

TEST_P(Comparisons, AreToldLineByLine)
{
    const RingStructure configured = writtenRing(GetParam().configured);
    const RingStructure connected = writtenRing(GetParam().connected);
    EXPECT_EQ(write(compareRings(configured, connected), configured, connected).toStdString(),
              GetParam().lines);
}

INSTANTIATE_TEST_SUITE_P(
    Rings, Comparisons,
    testing::Values(
        Row{"Empty", "", "", ""},
        Row{"Same", "K3 K1", "K3 K1",
            "same | 1.0: K3 37h, as configured\n"
            "same | 2.0: K1 36h, as configured"},
        Row{"OtherProfile", "K3 K3 K3", "K3 K3 K2",
            "same | 1.0: K3 37h, as configured\n"
            "same | 2.0: K3 37h, as configured\n"
            "differs | 3.0: configured K3 37h, found K2 36h"},
        Row{"OtherProfileOfTheSameIdCode", "K1", "K2", "differs | 1.0: configured K1 36h, found K2 36h"},
        Row{"OtherWidth", "DI", "DI2",
            "differs | 1.0: configured BEh (device code 81BEh, words: 1 IN, 0 OUT), found BEh (device code "
            "02BEh, words: 2 IN, 0 OUT)"},
        Row{"MissingInTheMiddle", "K3 DI K1", "K3 K1",
            "same | 1.0: K3 37h, as configured\n"
            "missing | 2.0: configured BEh is missing\n"
            "same | 3.0: K1 36h, as configured; its number is 2.0 now"},
        Row{"OneOfEqualOnes", "K3 K3 K3", "K3 K3",
            "same | 1.0: K3 37h, as configured\n"
            "same | 2.0: K3 37h, as configured\n"
            "missing | 3.0: configured K3 37h is missing"},
        Row{"Additional", "K3 K1", "K3 BT .K3L K1",
            "same | 1.0: K3 37h, as configured\n"
            "additional | 2.0: bus terminal 0Ch is additional: it is not configured\n"
            "additional | 2.1: K3 B3h is additional: it is not configured\n"
            "same | 2.0: K1 36h, as configured; its number is 3.0 now"},
        Row{"Exchanged", "K3 K2", "K2 K3",
            "moved | 1.0: K3 37h moved, found at 2.0\n"
            "same | 2.0: K2 36h, as configured; its number is 1.0 now"},
        Row{"MovedToTheEnd", "DI K3 K3 K1", "K3 K3 K1 DI",
            "moved | 1.0: BEh moved, found at 4.0\n"
            "same | 2.0: K3 37h, as configured; its number is 1.0 now\n"
            "same | 3.0: K3 37h, as configured; its number is 2.0 now\n"
            "same | 4.0: K1 36h, as configured; its number is 3.0 now"},
        Row{"MovedToABranch", "K1 BT K3", "K1 BT /K3",
            "same | 1.0: K1 36h, as configured\n"
            "same | 2.0: bus terminal 0Ch, as configured\n"
            "moved | 3.0: K3 37h moved, configured on level 0, found on level 1"},
        Row{"NothingInCommon", "K3 K1 DI", "LA",
            "differs | 1.0: configured K3 37h, found 33h\n"
            "missing | 2.0: configured K1 36h is missing\n"
            "missing | 3.0: configured BEh is missing"}),
    [](const testing::TestParamInfo<Row> &row) { return std::string(row.param.name); });

// What was before it is now after it, and vice versa.
TEST(Comparison, AMoveThatKeepsNumberAndLevelIsToldByItsNeighbours)
{
    const RingStructure configured = writtenRing("K3 K2 K1 DI LA");
    const RingStructure connected = writtenRing("DI LA K1 K3 K2");
    const Comparison comparison = compareRings(configured, connected);
    const auto line = std::ranges::find(
        comparison, std::size_t{2}, [](const ComparisonLine &each) { return each.configured.value_or(0); });
    ASSERT_NE(line, comparison.end());
    EXPECT_EQ(comparisonText(*line, configured, connected, Catalog::builtIn()).toStdString(),
              "3.0: K1 36h moved among its neighbours, its number stayed the same");
}

TEST(Comparison, TheMakeIsNoDifference)
{
    RingStructure configured = writtenRing("K3");
    configured.front().deviceKey = QStringLiteral("fraba-ocd-ib");
    EXPECT_TRUE(areSame(compareRings(configured, writtenRing("K3"))));
}

std::vector<std::size_t> allLines(const Comparison &comparison)
{
    std::vector<std::size_t> lines(comparison.size());
    std::iota(lines.begin(), lines.end(), std::size_t{0});
    return lines;
}

RingStructure randomRing(std::mt19937 &random, std::size_t most)
{
    const QStringList kinds{QStringLiteral("K3"), QStringLiteral("K2"), QStringLiteral("DI"),
                            QStringLiteral("BT .K3L .DI"), QStringLiteral("BT /K3 /K1")};
    QStringList parts;
    for (std::size_t n = random() % (most + 1); n > 0; --n)
        parts << kinds[static_cast<qsizetype>(random() % 5)];
    return writtenRing(parts.join(u' ').toLatin1());
}

TEST(Comparison, HasEachDeviceOnce)
{
    std::mt19937 random(4);
    for (int round = 0; round < 500; ++round) {
        const RingStructure configured = randomRing(random, 12);
        const RingStructure connected = randomRing(random, 12);
        std::vector<int> seenConfigured(configured.size());
        std::vector<int> seenConnected(connected.size());
        for (const ComparisonLine &line : compareRings(configured, connected)) {
            EXPECT_EQ(line.configured.has_value(), line.kind != ComparisonKind::additional);
            EXPECT_EQ(line.connected.has_value(), line.kind != ComparisonKind::missing);
            if (line.configured)
                ++seenConfigured.at(*line.configured);
            if (line.connected)
                ++seenConnected.at(*line.connected);
        }
        EXPECT_THAT(seenConfigured, testing::Each(1));
        EXPECT_THAT(seenConnected, testing::Each(1));
    }
}

TEST(TakeOver, OfAllLinesGivesTheOtherRingEitherWay)
{
    std::mt19937 random(5);
    for (int round = 0; round < 500; ++round) {
        const RingStructure configured = randomRing(random, 12);
        const RingStructure connected = randomRing(random, 12);
        const Comparison comparison = compareRings(configured, connected);
        const auto lines = allLines(comparison);
        EXPECT_EQ(takenOver(configured, connected, comparison, lines), connected);
        EXPECT_EQ(takenOver(connected, configured, mirrored(comparison), lines), configured);
        EXPECT_EQ(takenOver(configured, connected, comparison, {}), configured);
    }
}

// One after the other, comparing again each time, as in the window.
TEST(TakeOver, LineByLineComesToTheSameEnd)
{
    std::mt19937 random(6);
    for (int round = 0; round < 200; ++round) {
        RingStructure ring = randomRing(random, 8);
        const RingStructure connected = randomRing(random, 8);
        for (std::size_t steps = 0;; ++steps) {
            const Comparison comparison = compareRings(ring, connected);
            if (areSame(comparison))
                break;
            ASSERT_LE(steps, 64u);
            std::vector<std::size_t> different;
            for (std::size_t n = 0; n < comparison.size(); ++n)
                if (comparison[n].kind != ComparisonKind::same)
                    different.push_back(n);
            ring =
                takenOver(ring, connected, comparison, std::vector{different[random() % different.size()]});
        }
        EXPECT_EQ(ring, connected);
    }
}

struct TakeOverRow
{
    const char *configured;
    const char *connected;
    std::vector<std::size_t> lines;
    const char *result;
};

TEST(TakeOver, OfOneLineLeavesTheOthers)
{
    const std::vector<TakeOverRow> rows{
        {"K3 DI K1", "K3 K1", {1}, "K3 K1"},                // missing
        {"K3 K1", "K3 BT .K3L K1", {1}, "K3 BT K1"},        // additional
        {"K3 K1", "K3 BT .K3L K1", {2}, "K3 .K3L K1"},      // the local bus without its terminal
        {"DI K3 K3 K1", "K3 K3 K1 DI", {0}, "K3 K3 K1 DI"}, // moved
        {"K3 K2 DI", "K3 K1 LA", {1}, "K3 K1 DI"},          // differs
        {"K3 K2 DI", "K3 K1 LA", {2}, "K3 K2 LA"},
        {"DI K3", "K1 K2 K3", {1}, "DI K2 K3"}, // beside an own device that was not taken over
    };
    for (const TakeOverRow &row : rows) {
        const RingStructure configured = writtenRing(row.configured);
        const RingStructure connected = writtenRing(row.connected);
        const Comparison comparison = compareRings(configured, connected);
        EXPECT_EQ(takenOver(configured, connected, comparison, row.lines), writtenRing(row.result))
            << row.configured << " <- " << row.connected;
    }
}

TEST(TakeOver, KeepsTheMakeOfADeviceThatIsOfTheSameKind)
{
    RingStructure configured = writtenRing("K3 K2 DI");
    for (RingDevice &participant : configured)
        participant.deviceKey = QStringLiteral("named");
    const RingStructure connected = writtenRing("K1 DI K3");
    const Comparison comparison = compareRings(configured, connected);
    QStringList makes;
    for (const RingDevice &participant : takenOver(configured, connected, comparison, allLines(comparison)))
        makes << participant.deviceKey;
    EXPECT_EQ(makes.join(u'|').toStdString(), "|named|named");
}

TEST(Comparison, Of512DevicesWithNothingInItsPlaceIsFound)
{
    RingStructure configured;
    for (int n = 0; n < 512; ++n)
        configured.push_back({{}, n % 2 == 0 ? 0x0237u : 0x0136u, 2, 2, {}});
    numberDevices(configured);
    RingStructure connected(configured.rbegin(), configured.rend());
    numberDevices(connected);
    const Comparison comparison = compareRings(configured, connected);
    EXPECT_EQ(takenOver(configured, connected, comparison, allLines(comparison)), connected);
}

} // namespace
} // namespace codewheel
