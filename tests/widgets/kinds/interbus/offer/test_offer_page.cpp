// SPDX-License-Identifier: GPL-3.0-or-later
// The page on which a ring is offered to others, without a ring.
#include "widgets/kinds/interbus/offer/offer_form.h"
#include "widgets/kinds/interbus/offer/offer_page.h"
#include "widgets/kinds/interbus/offer/offered_view.h"
#include "widgets/kinds/interbus/offer/seats_view.h"
#include "widgets/look/inline_message.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <QTableView>
#include <QTabWidget>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class OfferPageTest : public testing::Test
{
protected:
    OfferPageTest()
    {
        page.resize(700, 500);
        page.show();
        page.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&page));
        QObject::connect(&page, &OfferPage::offerWanted, &page,
                         [this](const OfferWish &wish) { wanted.push_back(wish); });
    }

    template <class Widget>
    Widget &part(const char *name)
    {
        auto *found = page.findChild<Widget *>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    void click(const char *button)
    {
        ASSERT_TRUE(part<QPushButton>(button).isVisible() && part<QPushButton>(button).isEnabled());
        QTest::mouseClick(&part<QPushButton>(button), Qt::LeftButton);
    }
    QString problem()
    {
        for (const auto *message : page.findChildren<InlineMessage *>())
            if (message->isVisible())
                return message->sentence();
        return {};
    }

    OfferPage page;
    std::vector<OfferWish> wanted;
};

TEST_F(OfferPageTest, OffersToThisComputerOnlyUnlessAnAddressIsNamed)
{
    click("offer");
    ASSERT_EQ(wanted.size(), 1U);
    EXPECT_EQ(wanted[0], OfferWish());
    EXPECT_EQ(wanted[0].address, QStringLiteral("127.0.0.1"));
    EXPECT_EQ(wanted[0].port, 1'502);
    EXPECT_FALSE(wanted[0].hasSeats);
}

TEST_F(OfferPageTest, NamingAnAddressSaysThatThereIsNoPassword)
{
    EXPECT_FALSE(part<QLabel>("offerWarning").text().contains(QStringLiteral("password")));
    page.form().setAddresses({QStringLiteral("192.168.0.12")});
    auto &where = part<QComboBox>("offerAddress");
    where.setCurrentIndex(where.findData(QStringLiteral("192.168.0.12")));
    EXPECT_TRUE(part<QLabel>("offerWarning").text().contains(QStringLiteral("no password")));
    click("offer");
    ASSERT_EQ(wanted.size(), 1U);
    EXPECT_EQ(wanted[0].address, QStringLiteral("192.168.0.12"));
}

TEST_F(OfferPageTest, AnAddressThatIsGoneStaysChosen)
{
    page.form().show({.address = QStringLiteral("10.9.8.7")});
    page.form().setAddresses({QStringLiteral("192.168.0.12")});
    EXPECT_EQ(page.form().wish().address, QStringLiteral("10.9.8.7"));
}

TEST_F(OfferPageTest, WhatIsHalfTypedOffersNothing)
{
    auto &port = part<QSpinBox>("offerPort");
    port.setFocus();
    port.selectAll();
    QTest::keyClicks(&port, QStringLiteral("70000"));
    click("offer");
    EXPECT_TRUE(wanted.empty());
    EXPECT_FALSE(problem().isEmpty());
    port.selectAll();
    QTest::keyClicks(&port, QStringLiteral("5020"));
    click("offer");
    ASSERT_EQ(wanted.size(), 1U);
    EXPECT_EQ(wanted[0].port, 5'020);
}

TEST_F(OfferPageTest, SeatsCountOnlyWhereEachHasARing)
{
    EXPECT_FALSE(part<QSpinBox>("seats").isEnabled());
    QTest::mouseClick(&part<QRadioButton>("eachSeat"), Qt::LeftButton, {}, {8, 8});
    EXPECT_TRUE(part<QSpinBox>("seats").isEnabled());
    part<QSpinBox>("seats").setValue(20);
    part<QCheckBox>("readOnly").click();
    click("offer");
    ASSERT_EQ(wanted.size(), 1U);
    EXPECT_TRUE(wanted[0].hasSeats);
    EXPECT_EQ(wanted[0].seats, 20);
    EXPECT_TRUE(wanted[0].readOnly);
}

TEST_F(OfferPageTest, ARefusalStandsUntilSomethingIsChanged)
{
    page.setProblem(QStringLiteral("Port 1502 is used."));
    EXPECT_EQ(problem(), QStringLiteral("Port 1502 is used."));
    part<QSpinBox>("offerPort").setValue(1'503);
    EXPECT_EQ(problem(), QString());
}

TEST_F(OfferPageTest, WhatCannotBeOfferedSaysWhy)
{
    page.setWhyNot(QStringLiteral("A real ring is never offered."));
    EXPECT_FALSE(part<QPushButton>("offer").isEnabled());
    EXPECT_EQ(part<QPushButton>("offer").toolTip(), QStringLiteral("A real ring is never offered."));
    page.setWhyNot({});
    EXPECT_TRUE(part<QPushButton>("offer").isEnabled());
}

TEST_F(OfferPageTest, WhileOfferedItShowsWhereAndWho)
{
    page.setPlace(OfferedPlace{.address = QStringLiteral("127.0.0.1:1502")});
    EXPECT_FALSE(page.form().isVisible());
    EXPECT_FALSE(part<QPushButton>("offer").isVisible());
    page.offered().showClients({}, {.came = 3, .left = 3, .refused = 1});
    EXPECT_EQ(part<QLabel>("clientCounts").text(),
              QStringLiteral("Nobody is connected (3 came, 1 refused)."));
    page.offered().showClients({{.id = 4, .address = QStringLiteral("127.0.0.1:50000"), .since = {}}},
                               {.came = 4, .left = 3, .refused = 1});
    EXPECT_EQ(part<QTableView>("servedClients").model()->rowCount(), 1);
    QApplication::clipboard()->clear();
    click("copyAddress");
    EXPECT_EQ(QApplication::clipboard()->text(), QStringLiteral("127.0.0.1:1502"));
    int ended = 0;
    QObject::connect(&page, &OfferPage::endWanted, &page, [&ended] { ++ended; });
    click("stopOffering");
    EXPECT_EQ(ended, 1);
}

TEST_F(OfferPageTest, TheChosenSeatIsStartedAfresh)
{
    auto &tables = part<QTabWidget>("offeredTables");
    page.setPlace(OfferedPlace{.address = QStringLiteral("127.0.0.1:1502")});
    auto *seats = page.findChild<QWidget *>(QStringLiteral("seatPage"));
    EXPECT_FALSE(tables.isTabVisible(tables.indexOf(seats))) << "one ring has no seats";
    page.setPlace(OfferedPlace{.address = QStringLiteral("127.0.0.1:1502"), .seats = 2});
    ASSERT_TRUE(tables.isTabVisible(tables.indexOf(seats)));
    page.offered().seats().show({{.unit = 1, .state = {}}, {.unit = 2, .state = {}}});
    tables.setCurrentWidget(seats);
    EXPECT_FALSE(part<QPushButton>("restartSeat").isEnabled()) << "none is chosen";
    std::vector<int> restarted;
    QObject::connect(&page.offered().seats(), &SeatsView::restartWanted, &page,
                     [&](int unit) { restarted.push_back(unit); });
    auto &table = part<QTableView>("seatTable");
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                      table.visualRect(table.model()->index(1, 1)).center());
    click("restartSeat");
    EXPECT_EQ(restarted, std::vector{2});
}

} // namespace
} // namespace codewheel
