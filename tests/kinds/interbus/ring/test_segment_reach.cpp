// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "kinds/interbus/ring/numbering.h"
#include "kinds/interbus/ring/ring_session.h"
#include "tests/kinds/interbus/ring/written_ring.h"
#include "tests/support/faulty_ring.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SegmentReach, OnTheMainLineAllThatFollowsGoesWithIt)
{
    const RingStructure ring = writtenRing("K3 BT .K3L /K1 /K3 K2");
    EXPECT_THAT(placesBehindSegment(ring, 1), ElementsAre(0, 1, 2, 3, 4, 5));
    EXPECT_THAT(placesBehindSegment(ring, 2), ElementsAre(1, 2, 3, 4, 5));
    EXPECT_THAT(placesBehindSegment(ring, 5), ElementsAre(5));
}

TEST(SegmentReach, OfABranchOnlyTheBranch)
{
    const RingStructure ring = writtenRing("K3 BT .K3L /K1 /K3 K2");
    EXPECT_THAT(placesBehindSegment(ring, 3), ElementsAre(3, 4));
    EXPECT_THAT(placesBehindSegment(ring, 4), ElementsAre(4));
}

TEST(SegmentReach, OfASegmentThatIsNotThereNothing)
{
    EXPECT_THAT(placesBehindSegment(writtenRing("K3"), 2), IsEmpty());
    EXPECT_THAT(placesBehindSegment({}, 1), IsEmpty());
}

// What is announced before a segment is switched off has to be what happens.
TEST(SegmentReach, IsWhatTheSimulatedMasterTakesOut)
{
    const Catalog catalog = Catalog::builtIn();
    FaultyRing simulated;
    RingSession bus(std::move(simulated.link), catalog, QDateTime());
    ASSERT_TRUE(bus.open(RingSession::Start::operating));
    bus.advance(5);
    for (int segment = 1; segment <= 6; ++segment) {
        bus.switchSegment(segment, false);
        bus.advance(5);
        std::vector<std::size_t> out;
        for (std::size_t place = 0; place < bus.latest().devices.size(); ++place)
            if (!bus.latest().devices[place].inRing)
                out.push_back(place);
        EXPECT_EQ(placesBehindSegment(bus.structure(), segment), out) << segment;
        bus.switchSegment(segment, true);
        bus.advance(5);
    }
}

} // namespace
} // namespace codewheel
