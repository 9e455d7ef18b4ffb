// SPDX-License-Identifier: GPL-3.0-or-later
// The training ring of the window offered to others: clients of libmodbus use it while the trainer looks on.
#include "app/window/files/project_files.h"
#include "language.h"
#include "tests/app/kinds/interbus/offer_test.h"
#include "tests/app/question.h"
#include "tests/support/register_bank.h"
#include "widgets/kinds/interbus/offer/offer_form.h"

#include <QDockWidget>
#include <QLocale>
#include <QMessageBox>
#include <QStatusBar>
#include <QTabWidget>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>
#include <thread>

namespace codewheel {
namespace {

using test::fraba;
using test::ModbusClient;
using test::partOf;

class OfferInWindow : public test::OfferTest
{
protected:
    QMessageBox *question() { return window().findChild<QMessageBox *>(QStringLiteral("offerQuestion")); }
    bool isInTrace(const QString &word)
    {
        const auto *rows = window()
                               .findChild<QDockWidget *>(QStringLiteral("traceDock"))
                               ->findChild<QTableView *>()
                               ->model();
        for (int row = 0; row < rows->rowCount(); ++row)
            for (int column = 0; column < rows->columnCount(); ++column)
                if (rows->index(row, column).data().toString().contains(word))
                    return true;
        return false;
    }
};

constexpr int illegalFunction = MODBUS_ENOBASE + 1;
constexpr int noSuchUnit = MODBUS_ENOBASE + 11;
constexpr std::uint16_t high = 0x0200;
constexpr std::uint16_t low = 0x00FF;
constexpr int statusRegister = 8'192;
constexpr std::uint16_t ofRunningRing = 0x00E0;
constexpr std::uint16_t ofStandingRing = 0x00C0;

TEST_F(OfferInWindow, WhatAClientWritesIsOnTheRingAndIsSeen)
{
    offer();
    EXPECT_TRUE(waitFor([&] { return status().endsWith(QStringLiteral("0 clients")); }));
    ModbusClient client(port());
    ASSERT_TRUE(client.isConnected());
    ASSERT_EQ(client.write(0, {high, low}), 0);
    EXPECT_TRUE(waitFor([&] { return out(fraba) == 0x0200'00FFu; }));
    EXPECT_TRUE(waitFor([&] {
        return inTable("servedClients", 0, 2).startsWith(QStringLiteral("1.0  020000FF"));
    })) << inTable("servedClients", 0, 2).toStdString();
    EXPECT_TRUE(waitFor([&] { return isInTrace(QStringLiteral("020000FF")); }));
    EXPECT_EQ(inTable("servedClients", 0, 4), QStringLiteral("1"));
    EXPECT_EQ(inTable("servedRegisters", 1, 1), QStringLiteral("2\u20133"));
    EXPECT_TRUE(isSaid(QStringLiteral("is connected to the offered ring")));
    actions().monitors->trigger();
    EXPECT_TRUE(status().startsWith(QStringLiteral("Offered at 127.0.0.1:%1, 1").arg(port())))
        << status().toStdString();
}

TEST_F(OfferInWindow, TheStatusLineIsWholeInASmallWindowWhileAllOfItIsRecorded)
{
    Language language;
    language.use(QStringLiteral("de"));
    open(); // in this language
    bus().startThread(std::chrono::milliseconds(1));
    resizeTo({1024, 640});
    offer();
    RecordingPlan plan;
    plan.settings.file = folder.filePath(QStringLiteral("night.cwrec"));
    ASSERT_TRUE(shown->plant().recording().begin(plan));
    EXPECT_TRUE(waitFor([&] { return status().endsWith(QStringLiteral("0 Clients")); }))
        << status().toStdString();
    const QStatusBar &bar = *window().statusBar();
    const auto isWhole = [&bar](const QWidget *part) {
        return !part->isVisible() || part->objectName() == QStringLiteral("hint") ||
               (bar.rect().contains(part->geometry()) && part->width() >= part->minimumSizeHint().width());
    };
    const auto parts = bar.findChildren<QWidget *>(Qt::FindDirectChildrenOnly);
    EXPECT_TRUE(QTest::qWaitFor([&] { return std::ranges::all_of(parts, isWhole); }));
    QLocale::setDefault(QLocale::c());
}

TEST_F(OfferInWindow, TheTrainersFaultsAreTheClients)
{
    offer();
    ModbusClient client(port());
    EXPECT_EQ(client.readInput(8'192, 1), std::vector<std::uint16_t>{0x00E0});
    shown->controls().setFault(TrainingFault::wireBreak, NodeId("4.0"), 1);
    EXPECT_TRUE(waitFor([&] { return (client.readInput(8'192, 1).at(0) & 0x0020) == 0; }));
    EXPECT_NE(client.write(0, {0, 1}), 0);
}

TEST_F(OfferInWindow, APortInUseIsSaidWhereItWasAskedFor)
{
    const auto taken = listenAt({});
    ASSERT_TRUE(taken);
    ringActions().offer->trigger();
    partOf<QSpinBox>(offerPage(), "offerPort").setValue(placeOf(*taken).port);
    click("offer");
    EXPECT_FALSE(ring().offer().isOn());
    EXPECT_TRUE(problem().contains(QStringLiteral("is used by another program"))) << problem().toStdString();
    EXPECT_EQ(status(), QString());
}

TEST_F(OfferInWindow, AnAddressOfAnotherComputerIsRefused)
{
    ringActions().offer->trigger();
    offerPage().form().show({.address = QStringLiteral("192.0.2.1"), .port = 0});
    click("offer");
    EXPECT_FALSE(ring().offer().isOn());
    EXPECT_TRUE(problem().contains(QStringLiteral("192.0.2.1"))) << problem().toStdString();
}

TEST_F(OfferInWindow, EachSeatHasARingOfItsOwn)
{
    offer(2);
    ModbusClient first(port(), 1);
    ModbusClient second(port(), 2);
    ModbusClient third(port(), 3);
    ASSERT_EQ(first.write(0, {high, low}), 0);
    ASSERT_EQ(second.write(2, {0, 7}), 0);
    EXPECT_EQ(third.write(0, {high, low}), noSuchUnit);
    EXPECT_EQ(first.readHolding(0, 4), (std::vector<std::uint16_t>{high, low, 0, 0}));
    EXPECT_EQ(second.readHolding(0, 4), (std::vector<std::uint16_t>{0, 0, 0, 7}));
    EXPECT_EQ(out(fraba), 0u) << "the ring of the window is nobody's seat";
    partOf<QTabWidget>(offerPage(), "offeredTables")
        .setCurrentWidget(&partOf<QWidget>(offerPage(), "seatPage"));
    EXPECT_TRUE(
        waitFor([&] { return inTable("seatTable", 1, 4).startsWith(QStringLiteral("2.0  00000007")); }));
    EXPECT_EQ(inTable("seatTable", 0, 1), QStringLiteral("1"));

    auto &table = partOf<QTableView>(offerPage(), "seatTable");
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                      table.visualRect(table.model()->index(1, 1)).center());
    click("restartSeat");
    ASSERT_NE(question(), nullptr);
    EXPECT_TRUE(question()->informativeText().contains(QStringLiteral("Connected clients: 1")))
        << question()->informativeText().toStdString();
    EXPECT_EQ(second.readHolding(2, 2), (std::vector<std::uint16_t>{0, 7})) << "not yet";
    for (auto *button : question()->findChildren<QPushButton *>())
        if (button->text() == QStringLiteral("&Start afresh"))
            QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_TRUE(waitFor([&] { return second.readHolding(0, 4) == std::vector<std::uint16_t>{0, 0, 0, 0}; }));
    EXPECT_EQ(first.readHolding(0, 2), (std::vector<std::uint16_t>{high, low})) << "the others go on";
    EXPECT_EQ(second.readInput(statusRegister, 1), std::vector{ofStandingRing});
    EXPECT_EQ(first.readInput(statusRegister, 1), std::vector{ofRunningRing});
    EXPECT_TRUE(waitFor([&] { return second.readInput(statusRegister, 1) == std::vector{ofRunningRing}; }));
}

TEST_F(OfferInWindow, ClientsThatMayOnlyReadAreRefused)
{
    ringActions().offer->trigger();
    offerPage().form().show({.port = 0, .readOnly = true});
    click("offer");
    ModbusClient client(port());
    EXPECT_EQ(client.write(0, {high, low}), illegalFunction);
    EXPECT_EQ(client.readHolding(0, 2), (std::vector<std::uint16_t>{0, 0}));
}

TEST_F(OfferInWindow, ANewProjectIsAskedAboutWhileOthersAreConnected)
{
    offer();
    ModbusClient client(port());
    ASSERT_EQ(client.readHolding(0, 2).size(), 2U);
    {
        const auto question = test::Question::answeredBy(QStringLiteral("Cancel"));
        EXPECT_FALSE(window().files().makeNew());
        EXPECT_TRUE(question.text().contains(QStringLiteral("Connected clients: 1")))
            << question.text().toStdString();
    }
    EXPECT_TRUE(ring().offer().isOn());
    const auto question = test::Question::answeredBy(QStringLiteral("Disconnect them"));
    EXPECT_TRUE(window().files().makeNew());
    EXPECT_TRUE(waitFor([&] { return !ring().offer().isOn(); }));
}

TEST_F(OfferInWindow, StoppingDisconnectsAll)
{
    offer();
    ModbusClient client(port());
    ASSERT_EQ(client.readHolding(0, 2).size(), 2U);
    click("stopOffering");
    ASSERT_NE(question(), nullptr);
    EXPECT_EQ(question()->defaultButton(), question()->button(QMessageBox::Cancel));
    EXPECT_TRUE(question()->informativeText().contains(QStringLiteral("clients: 1.")))
        << question()->informativeText().toStdString();
    question()->button(QMessageBox::Cancel)->click();
    EXPECT_TRUE(waitFor([&] { return question() == nullptr; }));
    EXPECT_TRUE(ring().offer().isOn());
    EXPECT_EQ(client.readHolding(0, 2).size(), 2U);
    click("stopOffering");
    ASSERT_NE(question(), nullptr);
    for (QAbstractButton *button : question()->buttons())
        if (question()->buttonRole(button) == QMessageBox::AcceptRole) {
            button->click();
            break;
        }
    EXPECT_FALSE(ring().offer().isOn());
    EXPECT_TRUE(client.readHolding(0, 2).empty());
    EXPECT_EQ(status(), QString());
    EXPECT_TRUE(isSaid(QStringLiteral("No longer offered")));
    EXPECT_TRUE(bus().isOpen()) << "the ring itself goes on";
}

TEST_F(OfferInWindow, WithoutClientsItStopsAtOnce)
{
    offer();
    click("stopOffering");
    EXPECT_EQ(question(), nullptr);
    EXPECT_FALSE(ring().offer().isOn());
}

TEST_F(OfferInWindow, AnotherProjectEndsItAndSaysSo)
{
    offer();
    ModbusClient client(port());
    ASSERT_EQ(client.readHolding(0, 2).size(), 2U);
    shown->project().setProject({}, {});
    EXPECT_FALSE(ring().offer().isOn());
    EXPECT_TRUE(client.readHolding(0, 2).empty());
    EXPECT_TRUE(isSaid(QStringLiteral("Another project was opened")));
}

TEST_F(OfferInWindow, ARingThatIsDisconnectedIsNoLongerOffered)
{
    offer();
    ModbusClient client(port());
    ASSERT_EQ(client.readHolding(0, 2).size(), 2U);
    ringActions().disconnectBus->trigger();
    ASSERT_FALSE(bus().isOpen());
    EXPECT_FALSE(ring().offer().isOn());
    EXPECT_TRUE(client.readHolding(0, 2).empty());
    EXPECT_TRUE(isSaid(QStringLiteral("The ring was disconnected")));
}

TEST_F(OfferInWindow, ARingWithOtherDevicesIsNoLongerOffered)
{
    offer();
    ModbusClient client(port());
    ASSERT_EQ(client.readHolding(0, 2).size(), 2U);
    shown->controls().setFault(TrainingFault::wireBreak, NodeId("6.0"), 1);
    EXPECT_TRUE(waitFor([&] { return !bus().isRunning(); }));
    EXPECT_TRUE(ring().offer().isOn()) << "a fault alone is the clients' affair";
    ringActions().readIn->trigger();
    EXPECT_TRUE(waitFor([&] { return bus().structure().size() == 5U; }));
    EXPECT_FALSE(ring().offer().isOn());
    EXPECT_TRUE(client.readHolding(0, 2).empty());
    EXPECT_TRUE(isSaid(QStringLiteral("The ring has other devices now")));
}

TEST_F(OfferInWindow, SeatsGoOnWithoutTheRingButNotBesideARealOne)
{
    offer(2);
    ModbusClient client(port(), 2);
    ASSERT_EQ(client.write(0, {high, low}), 0);
    ringActions().disconnectBus->trigger();
    ASSERT_FALSE(bus().isOpen());
    EXPECT_TRUE(ring().offer().isOn());
    EXPECT_EQ(client.readHolding(0, 2), (std::vector<std::uint16_t>{high, low}));

    auto gateway = std::make_shared<test::RegisterBank>();
    ring().setPorts(
        [&](const GatewaySettings &) { return std::make_unique<test::RegisterBankPort>(gateway); });
    planGateway();
    ringActions().connectBus->trigger();
    EXPECT_FALSE(bus().isSimulated());
    EXPECT_FALSE(ring().offer().isOn());
    EXPECT_TRUE(client.readHolding(0, 2).empty());
    EXPECT_TRUE(isSaid(QStringLiteral("This ring is a real one now")));
    EXPECT_EQ(gateway->writes, 0) << "nothing of a client reaches it";
}

TEST_F(OfferInWindow, ARealRingIsNeverOffered)
{
    ringActions().disconnectBus->trigger();
    planGateway();
    window().showFrame();
    EXPECT_FALSE(ringActions().offer->isEnabled());
    EXPECT_TRUE(ringActions().offer->toolTip().contains(QStringLiteral("never offered")));
    EXPECT_FALSE(ring().offer().begin({.port = 0}));
}

TEST_F(OfferInWindow, TheLastSettingsAreKeptAndNothingBeginsByItself)
{
    offer(3);
    open(); // another start of the program
    EXPECT_FALSE(ring().offer().isOn());
    EXPECT_EQ(status(), QString());
    EXPECT_EQ(offerPage().form().wish(), (OfferWish{.port = 0, .hasSeats = true, .seats = 3}));
}

TEST_F(OfferInWindow, TheProgramCanBeClosedWhileAClientWorks)
{
    offer();
    std::atomic<int> answers{0};
    std::thread working([&answers, client = std::make_shared<ModbusClient>(port())] {
        while (client->write(0, {high, low}) == 0)
            ++answers;
    });
    EXPECT_TRUE(waitFor([&] { return answers > 10; }));
    shown.reset();
    working.join();
}

TEST_F(OfferInWindow, AThousandConnectionsDoNotFloodTheMessages)
{
    offer();
    const auto before = shown->messages().rowCount();
    for (int i = 0; i < 1'000; ++i) {
        EXPECT_TRUE(ModbusClient(port()).isConnected());
        window().showFrame();
    }
    EXPECT_TRUE(waitFor([&] {
        const ClientCounts counts = ring().offer().counts();
        return counts.came == counts.left && counts.came + counts.refused == 1'000;
    }));
    EXPECT_LE(shown->messages().rowCount() - before, 100);
}

} // namespace
} // namespace codewheel
