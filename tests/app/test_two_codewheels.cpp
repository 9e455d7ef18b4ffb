// SPDX-License-Identifier: GPL-3.0-or-later
// Two Codewheels: the wizard of one sets up an encoder of the ring that the other offers. And the program
// that offers one while its window is made anew.
#include "app/window/program.h"
#include "tests/app/kinds/interbus/offer_test.h"
#include "tests/app/press_connect.h"
#include "tests/app/screen_reader.h"
#include "widgets/connect/connect_page.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QLocale>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::fraba;
using test::ModbusClient;
using test::partOf;

// The wizard of a second Codewheel, which reaches this ring as it would reach one behind a gateway.
class TwoCodewheels : public test::OfferTest
{
protected:
    TwoCodewheels()
        : other(std::make_unique<TrainingWindow>(others.filePath(QStringLiteral("other.ini"))))
    {
        offer();
        other->window().show();
        other->window().activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&other->window()));
    }

    void pass(int milliseconds) // in the other one
    {
        other->advance(milliseconds);
        window().showFrame();
    }
    void connectOther()
    {
        const RingActions &its = *other->window().findChild<RingActions *>();
        its.disconnectBus->trigger();
        its.connection->trigger();
        const auto &connection = *other->window().findChild<ConnectPage *>(QStringLiteral("ringConnection"));
        partOf<QComboBox>(connection, "link").setCurrentText(QStringLiteral("Modbus/TCP gateway"));
        auto &host = partOf<QLineEdit>(connection, "host");
        host.setFocus();
        QTest::keyClicks(&host, QStringLiteral("127.0.0.1"));
        partOf<QSpinBox>(connection, "tcpPort").setValue(port());
        test::pressConnect(connection);
        pass(20);
        ASSERT_TRUE(other->bus().isOpen());
        ASSERT_FALSE(other->bus().isSimulated());
        other->bus().setOperate(true);
        pass(20);
        ASSERT_TRUE(other->bus().isOperating());
    }
    ParameterWizard &wizard() { return *other->window().findChild<ParameterWizard *>(); }

    QTemporaryDir others;
    std::unique_ptr<TrainingWindow> other;
};

TEST_F(TwoCodewheels, TheWizardOfOneSetsUpAnEncoderOfTheOther)
{
    ASSERT_NO_FATAL_FAILURE(connectOther());
    const test::ScreenReader reader(other->window());
    reader.press(QStringLiteral("Parameter wizard"));
    reader.press(QStringLiteral("Next"));
    reader.press(QStringLiteral("Read from encoder"));
    pass(2'000);
    reader.press(QStringLiteral("It is in position mode")); // which nobody has told the other one
    pass(66);
    reader.press(QStringLiteral("Next"));
    reader.press(QStringLiteral("Next"));
    reader.type(QStringLiteral("Steps"), QStringLiteral("255"));
    reader.type(QStringLiteral("Revolutions"), QStringLiteral("1"));
    reader.type(QStringLiteral("Preset"), QStringLiteral("0"));
    reader.press(QStringLiteral("Next"));
    ASSERT_EQ(wizard().page(), ParameterWizard::review);
    reader.press(QStringLiteral("Start the handshake"));
    for (int i = 0; i < 60 && wizard().isBusy(); ++i) {
        pass(600); // position 0 has to last
        if (wizard().isBusy())
            reader.press(QStringLiteral("Next step"));
    }
    pass(66);
    EXPECT_FALSE(wizard().isBusy());
    EXPECT_TRUE(waitFor([&] {
        const auto steps = bus().encoder(fraba)->known(Parameter::steps);
        const auto revolutions = bus().encoder(fraba)->known(Parameter::revolutions);
        return steps && steps->value == 255 && revolutions && revolutions->value == 1 &&
               bus().encoder(fraba)->latest().position == 0;
    }));
    EXPECT_EQ(out(fraba), 0u);
    EXPECT_EQ(other->bus().encoder(fraba)->known(Parameter::steps)->value, 255);
}

TEST(OfferInProgram, AnotherLanguageMakesTheWindowAnewWhileItIsOffered)
{
    const QLocale before;
    const QTemporaryDir folder;
    Program program(*qApp, folder.filePath(QStringLiteral("program.ini")));
    const auto waitFor = [](auto what) { return QTest::qWaitFor(what, test::longestOfferWait); };
    program.openWindow();
    program.window()->show();
    ASSERT_TRUE(waitFor([&] { return program.plant() != nullptr; }));
    RingOffer &offer = program.plant()->first<RingAtWork>()->offer();
    ASSERT_TRUE(offer.begin({.port = 0}));
    ModbusClient client(offer.place().address.section(u':', -1).toInt());
    ASSERT_EQ(client.write(0, {0x0200, 0x00FF}), 0);
    const auto isTold = [&](const char *clients) {
        const auto &status = partOf<RoleLabel>(*program.window(), "offerState");
        return status.isVisible() && status.word().contains(QLatin1String(clients));
    };
    EXPECT_TRUE(waitFor([&] { return isTold(", 1"); }));
    Q_EMIT program.window()->languageChosen(QStringLiteral("de"));
    ASSERT_TRUE(waitFor([&] { return QLocale().language() == QLocale::German; }));
    EXPECT_TRUE(waitFor([&] { return isTold(", 1"); }));
    EXPECT_EQ(client.readHolding(0, 2), (std::vector<std::uint16_t>{0x0200, 0x00FF}));
    ASSERT_EQ(client.write(0, {0, 0}), 0);
    Q_EMIT program.window()->languageChosen(QStringLiteral("en"));
    ASSERT_TRUE(waitFor([&] { return QLocale().language() == QLocale::English; }));
    EXPECT_TRUE(offer.isOn());
    QLocale::setDefault(before);
}

} // namespace
} // namespace codewheel
