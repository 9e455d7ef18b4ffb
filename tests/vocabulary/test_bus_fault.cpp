// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/ring/ring_messages.h"
#include "kinds/interbus/ring/ring_refusals.h"
#include "kinds/interbus/words/bus_fault.h"
#include "vocabulary/refusal_text.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(ADiagnosticParameter, HoldsSegmentAndPositionOrAnOutgoingInterface)
{
    EXPECT_EQ(faultPlaceOf(0x0000), std::nullopt);
    EXPECT_EQ(faultPlaceOf(0x0080), std::nullopt); // not located
    EXPECT_EQ(faultPlaceOf(0x0300), (FaultPlace{NodeId("3.0")}));
    EXPECT_EQ(faultPlaceOf(0x033F), (FaultPlace{NodeId("3.63")}));
    EXPECT_EQ(faultPlaceOf(0xFE80), (FaultPlace{NodeId("254.0"), FaultSpot::outgoingRemoteBus}));
    EXPECT_EQ(faultPlaceOf(0x0281), (FaultPlace{NodeId("2.0"), FaultSpot::outgoingLocalBus}));
    for (const int parameter : {0x0300, 0x0302, 0xFE80, 0x0281})
        EXPECT_EQ(diagnosticParameterOf(*faultPlaceOf(static_cast<std::uint16_t>(parameter))), parameter);
}

TEST(ABusFault, HasOneName)
{
    EXPECT_EQ(busFaultText(0x0BB1, 0x0300).toStdString(), "0BB1 – peripheral fault at 3.0");
    EXPECT_EQ(busFaultText(0x0BDF, 0x0080).toStdString(), "0BDF – the master is looking for the fault");
    EXPECT_EQ(busFaultText(0x0BE1, 0x0080).toStdString(),
              "0BE1 – the bus failed, but the check finds nothing: look at shielding, connectors and supply");
}

// No text is invented for a code that only the firmware manual explains.
TEST(ABusFault, OfAnotherCodeIsItsNumberAndWhereToLookItUp)
{
    EXPECT_EQ(busFaultText(0x0D10, 0x0280).toStdString(),
              "0D10 at outgoing remote bus of 2.0 (see IBS SYS FW G4 UM)");
    EXPECT_EQ(busFaultText(0x0D50, 0x0681).toStdString(),
              "0D50 at outgoing local bus of 6.0 (see IBS SYS FW G4 UM)");
    EXPECT_EQ(busFaultText(0x1234, 0x0080).toStdString(), "1234 (see IBS SYS FW G4 UM)");
}

TEST(ABusFault, IsNamedTheSameInMessageAndRefusal)
{
    const std::vector<RefusalArgument> arguments{Word{0x0BB1}, Word{0x0300}};
    EXPECT_EQ(messageText({.id = RingMessageId::busFault, .arguments = arguments}).toStdString(),
              "Bus fault: 0BB1 – peripheral fault at 3.0.");
    EXPECT_EQ(refusalText({RefusalKind::link, RingRefusalId::busFault, arguments}).toStdString(),
              "The bus does not run: 0BB1 – peripheral fault at 3.0.");
}

} // namespace
} // namespace codewheel
