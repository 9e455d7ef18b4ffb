// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/ledger_keeper.h"
#include "tests/transfer/transfer_bus.h"
#include "transfer/project_places.h"
#include "transfer/values_before.h"

#include <QTimeZone>

namespace codewheel {
namespace {

using test::baumer;

class ValuesFromBefore : public test::TransferBus
{
protected:
    LedgerKeeper keeper{bus, DatabasePlace::memory()};
    FindValuesBefore find = valuesBeforeOf(keeper);
};

TEST_F(ValuesFromBefore, WhatWasWrittenOverCanBeRestored)
{
    EXPECT_TRUE(find(baumer).empty());
    encoder(baumer).tell(Parameter::steps, 8192);
    encoder(baumer).tell(Parameter::revolutions, 1); // not written, so not to be restored
    carryOut(planTransfer(buses, {{.place = baumer, .values = {{Parameter::steps, 4096}}}}));

    const std::vector<ValuesBefore> before = find(baumer);
    ASSERT_EQ(before.size(), 1u);
    EXPECT_EQ(before[0].values, (ParameterValues{{Parameter::steps, 8192}}));
    EXPECT_EQ(before[0].deviceKey, QStringLiteral("baumer-gxp6w"));

    const TransferPlan plan = planTransfer(buses, {wishToRestore(before[0], ProjectPlaces({}, buses))});
    const TransferAccount account = carryOut(plan);
    EXPECT_TRUE(account.isDone());
    EXPECT_EQ(encoder(baumer).known(Parameter::steps)->value, 8192);
    EXPECT_EQ(words(baumer), QStringLiteral("02001000 80000000 02002000 80000000"));
    EXPECT_EQ(find(baumer).size(), 2u); // and back again
}

TEST_F(ValuesFromBefore, AreCalledByTheTimeOfTheWrite)
{
    const QDateTime now(QDate(2026, 3, 1), QTime(18, 0), Qt::UTC);
    const ValuesBefore today{baumer, now.addSecs(-3600), {}, {{Parameter::steps, 8192}}};
    const ValuesBefore lastYear{baumer, now.addYears(-1), {}, {}};
    EXPECT_EQ(timeOf(today, now).left(5), QStringLiteral("17:00"));
    EXPECT_TRUE(timeOf(lastYear, now).contains(QStringLiteral("2025")));
    EXPECT_EQ(textOf(today, nullptr), QStringLiteral("Steps 8192"));
}

} // namespace
} // namespace codewheel
