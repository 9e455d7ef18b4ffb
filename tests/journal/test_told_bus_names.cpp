// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/message_fields.h"
#include "journal/told_bus_names.h"

#include <QScopeGuard>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

const Place deviceOfRing2{BusId{2}, NodeId("1.0")};
const Place ring2{BusId{2}, {}};

void callRing2(const QString &name)
{
    setBusNames({{BusId{2}, name}}, {{BusId{2}, name}});
}

TEST(ToldBusNames, WhatWasToldKeepsTheNameOfThen)
{
    const auto noNames = qScopeGuard([] { setBusNames({}); });
    ToldBusNames told;
    callRing2(QStringLiteral("Ring"));
    told.note(BusId{2}, 1'000);
    callRing2(QStringLiteral("Ring, seat 2"));
    EXPECT_EQ(told.placeName(deviceOfRing2, 1'000), QStringLiteral("Ring/1.0"));
    EXPECT_EQ(told.placeName(ring2, 1'500), QStringLiteral("Ring"));
    told.note(BusId{2}, 2'000);
    EXPECT_EQ(told.placeName(ring2, 1'500), QStringLiteral("Ring"));
    EXPECT_EQ(told.placeName(ring2, 2'000), QStringLiteral("Ring, seat 2"));
    EXPECT_EQ(told.placeName(deviceOfRing2, 2'000), QStringLiteral("Ring, seat 2/1.0"));
}

TEST(ToldBusNames, ABusThatNeededNoNameKeepsItsPlacesBare)
{
    const auto noNames = qScopeGuard([] { setBusNames({}); });
    ToldBusNames told;
    setBusNames({}, {});
    told.note(BusId{2}, 1'000);
    callRing2(QStringLiteral("Ring, seat 2"));
    EXPECT_EQ(told.placeName(deviceOfRing2, 1'000), QStringLiteral("1.0"));
    EXPECT_EQ(told.placeName(ring2, 1'000), nameOfNamelessBus());
}

TEST(ToldBusNames, WhatIsFromBeforeTheProgramStartedHasTheNameOfNow)
{
    const auto noNames = qScopeGuard([] { setBusNames({}); });
    ToldBusNames told;
    callRing2(QStringLiteral("Ring"));
    told.note(BusId{2}, 1'000);
    callRing2(QStringLiteral("Crane"));
    EXPECT_EQ(told.placeName(deviceOfRing2, 999), QStringLiteral("Crane/1.0"));
    EXPECT_EQ(told.placeName({}, 1'000), QString());
}

} // namespace
} // namespace codewheel
