// SPDX-License-Identifier: GPL-3.0-or-later
// What a master may report that the simulated one does not.
#include "kinds/interbus/ring/master_watch.h"
#include "kinds/interbus/ring/ring_messages.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(AMasterWatch, CallsConfirmedOnlyWhatWasConfirmedFromHere)
{
    MasterWatch watch;
    const std::vector<NodeId> ring{NodeId("1.0"), NodeId("2.0")};
    MasterStatus status;
    status.devices.resize(2);
    status.devices[1].peripheralFault = true;
    ASSERT_EQ(watch.look(status, ring, {}).size(), 1U);
    status.devices[1].peripheralFault = false;
    EXPECT_TRUE(watch.look(status, ring, {}).empty());

    status.devices[1].peripheralFault = true;
    std::ignore = watch.look(status, ring, {});
    watch.confirmedByService();
    status.devices[1].peripheralFault = false;
    const auto told = watch.look(status, ring, {});
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0].id, RingMessageId::peripheralFaultConfirmed);
    EXPECT_EQ(told[0].place, Place{.node = NodeId("2.0")});
}

} // namespace
} // namespace codewheel
