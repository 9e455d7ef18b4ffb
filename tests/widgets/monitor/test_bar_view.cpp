// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/roles.h"
#include "widgets/monitor/bar_view.h"

#include <QAccessible>
#include <QImage>
#include <QLocale>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class Bar : public testing::Test
{
protected:
    Bar()
    {
        bar.setPlace(QStringLiteral("IN 1.0"));
        bar.setLocale(QLocale::c());
        bar.setRange(0, 8191);
        bar.resize(402, bar.sizeHint().height());
        bar.show();
    }

    // Pixels inside the rim that are not empty.
    int filled()
    {
        const QImage image = bar.grab().toImage();
        int count = 0;
        for (int x = 1; x < image.width() - 1; ++x)
            count += image.pixel(x, 4) != bar.palette().base().color().rgb() ? 1 : 0;
        return count;
    }
    QString said() { return QAccessible::queryAccessibleInterface(&bar)->text(QAccessible::Description); }

    BarView bar;
};

TEST_F(Bar, IsAsLongAsTheValueIsFarInTheRange)
{
    for (const auto &[value, width] : {std::pair{0, 0}, {2048, 100}, {4096, 200}, {8191, 400}}) {
        bar.setValue(value);
        EXPECT_NEAR(filled(), width, 2) << value;
    }
}

TEST_F(Bar, AValueOutsideTheRangeStaysInsideTheBar)
{
    bar.setValue(1'000'000);
    EXPECT_EQ(filled(), 400);
    bar.setValue(-5);
    EXPECT_NEAR(filled(), 0, 2);
}

TEST_F(Bar, AnUnknownValueIsNotZero)
{
    bar.setValue(0);
    const QImage zero = bar.grab().toImage();
    bar.setValue({});
    EXPECT_NE(bar.grab().toImage(), zero);
    EXPECT_EQ(said(), QStringLiteral("Not known"));
}

TEST_F(Bar, SaysValueAndRange)
{
    bar.setValue(4096);
    EXPECT_EQ(QAccessible::queryAccessibleInterface(&bar)->text(QAccessible::Name),
              QStringLiteral("IN 1.0 bar"));
    EXPECT_EQ(said(), QStringLiteral("4096 of 0 to 8191"));
}

} // namespace
} // namespace codewheel
