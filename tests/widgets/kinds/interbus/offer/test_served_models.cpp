// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of a ring that is offered: who uses it, the seats, the registers.
#include "tests/support/model_tester.h"
#include "widgets/kinds/interbus/offer/seats_model.h"
#include "widgets/kinds/interbus/offer/served_clients_model.h"
#include "widgets/kinds/interbus/offer/served_registers_model.h"
#include "widgets/kinds/interbus/offer/served_text.h"

#include <QDateTime>
#include <QLocale>
#include <QPersistentModelIndex>
#include <QSignalSpy>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

ServedClient::Time today(int hour, int minute)
{
    const QDateTime at(QDate(2026, 3, 2), QTime(hour, minute, 5));
    return ServedClient::Time(std::chrono::milliseconds(at.toMSecsSinceEpoch()));
}

ServedClient client(unsigned id, std::uint64_t requests = 0)
{
    return {.id = id,
            .address = QStringLiteral("10.0.0.%1:50000").arg(id),
            .since = today(14, 2),
            .requests = requests};
}

QString shownAt(const QAbstractItemModel &model, int row, int column)
{
    return model.index(row, column).data().toString();
}

TEST(ServedClientsModel, ShowsWhatAClientDidLast)
{
    ServedClientsModel model;
    const test::ModelTester tester(model);
    ServedClient one = client(1, 1'234'567);
    one.unit = 3;
    one.writes = 12;
    one.refused = 2;
    one.written = ServedClient::Written{3, {NodeId("2.0"), 0x0200'00FF, {}}, today(15, 7)};
    const QLocale before;
    QLocale::setDefault(QLocale(QLocale::German));
    model.show({one});
    EXPECT_EQ(shownAt(model, 0, ServedClientsModel::address), QStringLiteral("10.0.0.1:50000"));
    EXPECT_EQ(shownAt(model, 0, ServedClientsModel::since), QStringLiteral("14:02:05"));
    EXPECT_EQ(shownAt(model, 0, ServedClientsModel::unit), QStringLiteral("3"));
    EXPECT_EQ(shownAt(model, 0, ServedClientsModel::requests), QStringLiteral("1.234.567"));
    EXPECT_EQ(shownAt(model, 0, ServedClientsModel::writes), QStringLiteral("12"));
    EXPECT_EQ(shownAt(model, 0, ServedClientsModel::refused), QStringLiteral("2"));
    EXPECT_EQ(shownAt(model, 0, ServedClientsModel::written), QStringLiteral("2.0  020000FF  15:07:05"));
    QLocale::setDefault(before);
}

TEST(ServedClientsModel, OneThatHasWrittenNothingShowsADash)
{
    ServedClientsModel model;
    model.show({client(1)});
    EXPECT_EQ(shownAt(model, 0, ServedClientsModel::unit), QStringLiteral("\u2013"));
    EXPECT_EQ(shownAt(model, 0, ServedClientsModel::written), QStringLiteral("\u2013"));
}

TEST(ServedClientsModel, AClientKeepsItsRow)
{
    ServedClientsModel model;
    const test::ModelTester tester(model);
    model.show({client(1), client(2), client(3)});
    const QPersistentModelIndex third(model.index(2, 0));
    const QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
    const QSignalSpy changes(&model, &QAbstractItemModel::dataChanged);
    model.show({client(2), client(3, 7), client(4)});
    EXPECT_EQ(resets.count(), 0);
    EXPECT_EQ(changes.count(), 1) << "only of the one that has changed";
    ASSERT_TRUE(third.isValid());
    EXPECT_EQ(third.row(), 1);
    EXPECT_EQ(shownAt(model, 1, ServedClientsModel::requests), QStringLiteral("7"));
    EXPECT_EQ(model.rowCount(), 3);
    model.show({});
    EXPECT_EQ(model.rowCount(), 0);
}

TEST(SeatsModel, SaysWhichUnitIsWhichSeat)
{
    SeatsModel model;
    const test::ModelTester tester(model);
    std::vector<Seat> seats(2);
    seats[0] = {.unit = 1, .clients = 0, .role = Role::running, .state = QStringLiteral("RUN")};
    seats[1] = {.unit = 2, .clients = 2, .role = Role::fault, .state = QStringLiteral("BUS FAIL")};
    model.show(seats);
    const QPersistentModelIndex second(model.index(1, 0));
    seats[1].written = ServedClient::Written{2, {NodeId("1.0"), 0xFF, {}}, today(14, 3)};
    model.show(seats);
    ASSERT_TRUE(second.isValid());
    EXPECT_EQ(shownAt(model, 1, SeatsModel::unit), QStringLiteral("2"));
    EXPECT_EQ(shownAt(model, 1, SeatsModel::clients), QStringLiteral("2"));
    EXPECT_EQ(shownAt(model, 1, SeatsModel::ring), QStringLiteral("BUS FAIL"));
    EXPECT_EQ(shownAt(model, 1, SeatsModel::written), QStringLiteral("1.0  000000FF  14:03:05"));
    EXPECT_EQ(shownAt(model, 0, SeatsModel::written), QStringLiteral("\u2013"));
}

TEST(ServedRegistersModel, ShowsWhereEachWordIs)
{
    ServedRegistersModel model;
    const test::ModelTester tester(model);
    model.show({{{NodeId("1.0"), {0, 2}, {4'096, 2}, {0, 2}}, QStringLiteral("FRABA")},
                {{NodeId("2.0"), {2, 1}, {4'098, 1}, {2, 0}}, QStringLiteral("K1")}});
    EXPECT_EQ(shownAt(model, 0, ServedRegistersModel::in), QStringLiteral("0\u20131"));
    EXPECT_EQ(shownAt(model, 0, ServedRegistersModel::inHolding), QStringLiteral("4096\u20134097"));
    EXPECT_EQ(shownAt(model, 1, ServedRegistersModel::in), QStringLiteral("2"));
    EXPECT_EQ(shownAt(model, 1, ServedRegistersModel::out), QStringLiteral("\u2013")) << "it has no OUT word";
    EXPECT_EQ(shownAt(model, 1, ServedRegistersModel::name), QStringLiteral("K1"));
}

TEST(ServedText, SaysWhoIsThereAndWhoWas)
{
    EXPECT_EQ(ServedText::clients({}), QStringLiteral("Nobody is connected (0 came, 0 refused)."));
    EXPECT_EQ(ServedText::clients({.came = 3, .left = 1, .refused = 1}),
              QStringLiteral("Connected: 2 (3 came, 1 refused)."));
}

} // namespace
} // namespace codewheel
