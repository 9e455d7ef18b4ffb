// SPDX-License-Identifier: GPL-3.0-or-later
// A class, each at a ring of its own: what the trainer sees of a seat, and does to it.
#include "tests/app/offer_test.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QTabWidget>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::fraba;
using test::ModbusClient;
using test::partOf;

constexpr std::uint16_t inRun = 0x00E0;
enum SeatColumn : std::uint8_t { inColumn = 3, outColumn, faultsColumn };

class SeatsOfClass : public test::OfferTest
{
protected:
    void offerSeats(int count)
    {
        offer(count);
        partOf<QTabWidget>(offerPage(), "offeredTables")
            .setCurrentWidget(&partOf<QWidget>(offerPage(), "seatPage"));
        EXPECT_TRUE(waitFor([&] { return seats().model()->rowCount() == count; }));
    }
    QTableView &seats() { return partOf<QTableView>(offerPage(), "seatTable"); }
    void choose(int seat)
    {
        QTest::mouseClick(seats().viewport(), Qt::LeftButton, {},
                          seats().visualRect(seats().model()->index(seat - 1, 0)).center());
        window().showFrame();
    }
    QWidget &panel() { return partOf<QWidget>(offerPage(), "seatPanel"); }
    QCheckBox &box(const char *text)
    {
        for (auto *box : panel().findChildren<QCheckBox *>())
            if (box->text() == QLatin1String(text))
                return *box;
        qFatal("no %s", text);
    }
    QString inSeat(int seat, SeatColumn column) { return inTable("seatTable", seat - 1, column); }
};

TEST_F(SeatsOfClass, AFaultIsForTheChosenSeatOnly)
{
    offerSeats(3);
    EXPECT_FALSE(panel().isVisible());
    choose(2);
    ASSERT_TRUE(panel().isVisible());
    box("Wire break before it").click();
    ModbusClient first(port(), 1);
    ModbusClient second(port(), 2);
    EXPECT_TRUE(waitFor([&] { return second.readInput(8'192, 1) != std::vector{inRun}; }));
    EXPECT_EQ(first.readInput(8'192, 1), std::vector{inRun});
    EXPECT_TRUE(waitFor([&] {
        return inSeat(2, faultsColumn) == QStringLiteral("1.0: Wire break before it");
    })) << inSeat(2, faultsColumn).toStdString();
    EXPECT_EQ(inSeat(1, faultsColumn), QString());
    EXPECT_TRUE(isSaid(QStringLiteral("Seat 2: 1.0: Wire break before it")));
    choose(3);
    EXPECT_FALSE(box("Wire break before it").isChecked()) << "what is shown is the seat's own";
    EXPECT_EQ(partOf<QLabel>(panel(), "seatTreated").text(), QStringLiteral("Seat 3"));
    box("Power on").click();
    EXPECT_TRUE(isSaid(QStringLiteral("Seat 3, 1.0: Power off.")));
    EXPECT_TRUE(
        waitFor([&] { return inSeat(3, faultsColumn) == QStringLiteral("1.0: Encoder switched off"); }));
}

TEST_F(SeatsOfClass, ASeatThatStartsAfreshIsTreatedAnew)
{
    offerSeats(2);
    choose(1);
    box("Device without supply").click();
    EXPECT_TRUE(waitFor([&] {
        return inSeat(1, faultsColumn) == QStringLiteral("1.0: Device without supply");
    })) << inSeat(1, faultsColumn).toStdString();
    click("restartSeat");
    EXPECT_TRUE(waitFor([&] { return inSeat(1, faultsColumn).isEmpty(); }));
    EXPECT_FALSE(box("Device without supply").isChecked());
    box("Power on").click();
    EXPECT_TRUE(waitFor([&] { return !ring().offer().controls(1)->shafts().front().powered; }));
    EXPECT_TRUE(ring().offer().controls(2)->shafts().front().powered);
    click("stopOffering");
    EXPECT_FALSE(panel().isVisible());
    EXPECT_EQ(ring().offer().controls(1), nullptr);
}

TEST_F(SeatsOfClass, WordsOfTheChosenDeviceAreInTheTable)
{
    offerSeats(2);
    ModbusClient second(port(), 2);
    ASSERT_EQ(second.write(0, {0x0200, 0x00FF}), 0);
    EXPECT_TRUE(waitFor([&] { return inSeat(2, outColumn) == QStringLiteral("020000FF"); }));
    EXPECT_TRUE(waitFor([&] { return inSeat(2, inColumn) == QStringLiteral("C20000FF"); }));
    EXPECT_EQ(inSeat(1, outColumn), QStringLiteral("00000000"));
    auto &device = partOf<QComboBox>(offerPage(), "seatDevice");
    EXPECT_TRUE(device.currentText().startsWith(QStringLiteral("1.0")));
    EXPECT_EQ(device.count(), 6) << "without the bus terminal";
    device.setCurrentIndex(1);
    EXPECT_TRUE(waitFor([&] { return inSeat(2, outColumn) == QStringLiteral("00000000"); }));
    ASSERT_EQ(second.write(2, {0, 7}), 0);
    EXPECT_TRUE(waitFor([&] { return inSeat(2, outColumn) == QStringLiteral("00000007"); }));
    choose(2);
    box("Wire break before it").click();
    EXPECT_TRUE(waitFor([&] { return inSeat(2, inColumn) == QStringLiteral("\u2013"); })) << "not of now";
}

TEST_F(SeatsOfClass, AFaultPlanInASeatIsTold)
{
    offerSeats(2);
    ring().offer().controls(2)->startFaultPlan(
        {{}, {{std::chrono::milliseconds(1), TrainingFault::peripheralFault, NodeId("1.0"), 1}}});
    EXPECT_TRUE(waitFor([&] { return isSaid(QStringLiteral("Seat 2: 1.0: Peripheral fault")); }));
}

} // namespace
} // namespace codewheel
