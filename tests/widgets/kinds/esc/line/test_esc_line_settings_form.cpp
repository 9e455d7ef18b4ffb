// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/plan/esc_line_plan.h"
#include "tests/widgets/kinds/esc/line/esc_line_bench.h"
#include "widgets/connect/connect_page.h"
#include "widgets/connect/port_field.h"
#include "widgets/connect/port_row.h"
#include "widgets/kinds/esc/line/esc_line_settings_form.h"
#include "widgets/look/inline_message.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class EscLineSettingsFormTest : public testing::Test
{
protected:
    EscLineSettingsFormTest()
    {
        page.addForm(&form);
        page.resize(600, 500);
        page.show();
        QObject::connect(&page, &ConnectPage::connectWanted, &page, [this](const KindData &plan) {
            wanted.push_back(plan.as<EscLinePlan>()->settings);
        });
    }
    template <typename Field>
    Field &field(const char *name) const
    {
        for (auto *found : page.findChildren<Field *>())
            if (found->accessibleName() == QLatin1String(name))
                return *found;
        ADD_FAILURE() << "no field " << name;
        return *page.findChild<Field *>();
    }
    void connectNow() { test::button(page, QStringLiteral("Connect"))->click(); }
    QString said() const
    {
        for (const auto *message : page.findChildren<InlineMessage *>())
            if (message->isVisible())
                return message->sentence();
        return {};
    }

    ConnectPage page;
    EscLineSettingsForm &form = *new EscLineSettingsForm(&page);
    std::vector<EscLineSettings> wanted;
    const std::vector<PortRow> ports{
        {QStringLiteral("/dev/ttyUSB0"), QStringLiteral("USB Serial"), QStringLiteral("FT12345")},
        {QStringLiteral("/dev/ttyS0"), {}, {}}};
};

TEST_F(EscLineSettingsFormTest, BeginsWithTheSettingsOfTheFactory)
{
    form.setPorts(ports);
    connectNow();
    ASSERT_EQ(wanted.size(), 1U);
    EscLineSettings factory;
    factory.port = QStringLiteral("/dev/ttyUSB0");
    EXPECT_EQ(wanted.front(), factory);
    EXPECT_EQ(field<QComboBox>("Port").currentText(), QStringLiteral("/dev/ttyUSB0"));
}

TEST_F(EscLineSettingsFormTest, TheAdapterStandsBelowTheNameOfItsPortAndBesideItInTheList)
{
    form.setPorts(ports);
    auto &list = field<QComboBox>("Port");
    const auto *adapter = form.findChild<QLabel *>(QStringLiteral("adapter"));
    EXPECT_EQ(adapter->text(), QStringLiteral("USB Serial, serial number FT12345"));
    EXPECT_EQ(list.accessibleDescription(), adapter->text());
    EXPECT_EQ(list.itemData(0, Qt::AccessibleTextRole).toString(),
              QStringLiteral("/dev/ttyUSB0, USB Serial, serial number FT12345"));
    list.setCurrentIndex(1);
    EXPECT_EQ(adapter->text(), list.toolTip()) << "nothing is known of it";
    EXPECT_EQ(list.accessibleDescription(), QString());
    list.setEditText(QStringLiteral("/dev/ttyUSB0"));
    EXPECT_EQ(adapter->text(), QStringLiteral("USB Serial, serial number FT12345")) << "typed";
}

// Pressing the button by its key leaves the focus where it is.
TEST_F(EscLineSettingsFormTest, WhatIsTypedIsTakenOrRefusedBeforeTheLineIsOpened)
{
    form.setPorts(ports);
    auto &timeOut = field<QSpinBox>("Time-out");
    timeOut.setFocus();
    timeOut.selectAll();
    QTest::keyClicks(&timeOut, QStringLiteral("250"));
    connectNow();
    ASSERT_EQ(wanted.size(), 1U);
    EXPECT_EQ(wanted.back().timing.answerTimeOut, 250ms);
    timeOut.selectAll();
    QTest::keyClicks(&timeOut, QStringLiteral("2,5x"));
    connectNow();
    EXPECT_EQ(wanted.size(), 1U);
    EXPECT_EQ(said(), QStringLiteral("\"2,5x\" is not a number."));
}

TEST_F(EscLineSettingsFormTest, InAWideWindowItsFieldsStayNearTheirLabels)
{
    page.resize(1200, 500);
    QCoreApplication::processEvents();
    EXPECT_LT(field<QSpinBox>("Time-out").width(), 600);
}

TEST_F(EscLineSettingsFormTest, APathMayBeTyped)
{
    form.setPorts(ports);
    field<QComboBox>("Port").setEditText(QStringLiteral(" /dev/pts/7 "));
    EXPECT_EQ(form.settings().port, QStringLiteral("/dev/pts/7"));
    form.setPorts({ports.back()});
    EXPECT_EQ(form.settings().port, QStringLiteral("/dev/pts/7"));
}

TEST_F(EscLineSettingsFormTest, APortIsPickedOnceTheUserChoosesOrTypesIt)
{
    form.setPorts(ports);
    EXPECT_FALSE(form.isPicked()) << "it stood there";
    auto &list = field<QComboBox>("Port");
    QTest::keyClick(&list, Qt::Key_Down);
    EXPECT_TRUE(form.isPicked());
    form.setPorts(ports);
    EXPECT_TRUE(form.isPicked()) << "the list was made anew";
    form.setSettings(form.settings());
    EXPECT_FALSE(form.isPicked());
    QTest::keyClicks(list.lineEdit(), QStringLiteral("1"));
    EXPECT_TRUE(form.isPicked());
}

TEST_F(EscLineSettingsFormTest, TheBaudRateThatTheEncodersHaveIsTaken)
{
    const QSignalSpy wantedRate(&form, &EscLineSettingsForm::baudRateWanted);
    form.setPorts(ports);
    form.tellBaudRate(QStringLiteral("Some differ."));
    EXPECT_EQ(test::button(form, QStringLiteral("Set the line to 9600 Bd")), nullptr);
    form.tellBaudRate(QStringLiteral("All have another."), 9'600);
    EXPECT_EQ(said(), QStringLiteral("All have another."));
    test::button(form, QStringLiteral("Set the line to 9600 Bd"))->click();
    EXPECT_EQ(said(), QString());
    EXPECT_EQ(form.settings().serial.baudRate, 9'600);
    ASSERT_EQ(wantedRate.count(), 1);
    EXPECT_EQ(wantedRate.front().front().toInt(), 9'600);
}

TEST_F(EscLineSettingsFormTest, WhatWasChosenStaysWhenTheListIsMadeAnew)
{
    form.setPorts(ports);
    field<QComboBox>("Port").setCurrentIndex(1);
    form.setPorts({ports.back(), ports.front()});
    EXPECT_EQ(form.settings().port, QStringLiteral("/dev/ttyS0"));
}

TEST_F(EscLineSettingsFormTest, AnyBaudRateMayBeTyped)
{
    form.setPorts(ports);
    field<QComboBox>("Baud rate").setEditText(QStringLiteral("38400"));
    EXPECT_EQ(form.settings().serial.baudRate, 38'400);
    EXPECT_EQ(form.settings().timing.character, SerialSettings{.baudRate = 38'400}.timeOf(1));
    field<QComboBox>("Baud rate").setEditText(QString());
    connectNow();
    EXPECT_TRUE(wanted.empty());
    EXPECT_TRUE(said().contains(QLatin1String("baud rate"))) << said().toStdString();
}

TEST_F(EscLineSettingsFormTest, WithoutAPortItAsksForOne)
{
    connectNow();
    EXPECT_TRUE(wanted.empty());
    EXPECT_TRUE(said().startsWith(QLatin1String("Choose a serial port")));
}

TEST_F(EscLineSettingsFormTest, SaysWhenTheListIsEmptyOrRightsAreMissing)
{
    form.setPorts({});
    EXPECT_TRUE(said().startsWith(QLatin1String("No serial port was found."))) << said().toStdString();
    form.setPorts(ports, QStringLiteral("You lack the group dialout."));
    EXPECT_EQ(said(), QStringLiteral("You lack the group dialout."));
    form.setPorts(ports);
    EXPECT_EQ(said(), QString());
}

TEST_F(EscLineSettingsFormTest, GivesBackWhatItWasGiven)
{
    EscLineSettings settings;
    settings.port = QStringLiteral("/dev/ttyS4");
    settings.serial = {.baudRate = 57'600,
                       .dataBits = 7,
                       .parity = SerialSettings::Parity::even,
                       .stopBits = 1,
                       .lowLatency = false};
    settings.timing.character = settings.serial.timeOf(1);
    settings.timing.answerTimeOut = 250ms;
    settings.timing.retries = 5;
    settings.timing.quietAfterWrite = 300ms;
    settings.timing.adapterDelay = 18ms; // not in the form
    settings.pollInterval = 50ms;
    settings.fractionBits = 30;
    settings.topSpeed = 3'000;
    form.setSettings(settings);
    EXPECT_EQ(form.settings(), settings);
}

// The form shows and returns everything the command line and the project's file accept.
TEST_F(EscLineSettingsFormTest, GoesAsFarAsTheCommandLine)
{
    EscLineSettings settings;
    settings.port = QStringLiteral("/dev/ttyS4");
    settings.serial.baudRate = 10'000'000;
    settings.timing.character = settings.serial.timeOf(1);
    settings.timing.answerTimeOut = 60s;
    settings.timing.retries = 20;
    settings.timing.quietAfterWrite = 60s;
    settings.pollInterval = 60s;
    form.setSettings(settings);
    EXPECT_EQ(form.settings(), settings);
    connectNow();
    EXPECT_EQ(wanted.size(), 1U);
    field<QComboBox>("Baud rate").setEditText(QStringLiteral("49"));
    connectNow();
    EXPECT_EQ(wanted.size(), 1U);
    EXPECT_EQ(said(), QStringLiteral("The baud rate is a number from 50 to 10000000."));
}

TEST_F(EscLineSettingsFormTest, PositionsAreNotAskedForFasterThanTheManualAllows)
{
    field<QSpinBox>("Poll interval").setValue(1);
    EXPECT_EQ(form.settings().pollInterval, 10ms);
}

// Before the form is seen it has no fields.
TEST_F(EscLineSettingsFormTest, WhatItWasGivenBeforeItIsSeenIsInItsFields)
{
    EscLineSettingsForm unseen;
    EXPECT_EQ(unseen.settings(), form.settings());
    EXPECT_EQ(unseen.complaint(), form.complaint());
    EscLineSettings settings;
    settings.port = QStringLiteral("/dev/ttyS4");
    settings.serial.baudRate = 57'600;
    settings.timing.adapterDelay = 18ms; // not in the form
    unseen.setSettings(settings);
    unseen.setPort(QStringLiteral("/dev/ttyS0"));
    unseen.setFractionBits(30);
    unseen.setCanDetermine(true);
    unseen.setPorts(ports);
    unseen.tellBaudRate({});
    settings.port = QStringLiteral("/dev/ttyS0");
    settings.fractionBits = 30;
    settings.timing.character = settings.serial.timeOf(1);
    EXPECT_EQ(unseen.settings(), settings);
    EXPECT_FALSE(unseen.isPicked());
    EXPECT_EQ(unseen.complaint(), QString());
    EXPECT_TRUE(unseen.findChildren<QWidget *>().isEmpty());
    unseen.makeFields();
    EXPECT_EQ(unseen.settings(), settings);
    EXPECT_FALSE(unseen.isPicked());
    EXPECT_TRUE(test::button(unseen, QStringLiteral("Determine"))->isEnabled());
    EXPECT_EQ(unseen.findChild<PortField *>()->findChild<QComboBox *>()->count(), 2);
}

TEST_F(EscLineSettingsFormTest, ABaudRateIsToldBeforeItIsSeen)
{
    EscLineSettingsForm unseen;
    EscLineSettings settings;
    settings.serial.baudRate = 49;
    unseen.setSettings(settings);
    EXPECT_EQ(unseen.wrong(), QStringLiteral("The baud rate is a number from 50 to 10000000."));
    unseen.tellBaudRate(QStringLiteral("All have another."), 9'600);
    test::button(unseen, QStringLiteral("Set the line to 9600 Bd"))->click();
    EXPECT_EQ(unseen.settings().serial.baudRate, 9'600);
    EXPECT_EQ(unseen.wrong(), QString());
}

TEST_F(EscLineSettingsFormTest, TheFormatOfTheFactorIsDeterminedByTheCaller)
{
    const QSignalSpy wantedBits(&form, &EscLineSettingsForm::fractionBitsWanted);
    auto *determine = test::button(form, QStringLiteral("Determine"));
    EXPECT_FALSE(determine->isEnabled());
    form.setCanDetermine(true);
    determine->click();
    EXPECT_EQ(wantedBits.count(), 1);
    form.setFractionBits(28);
    EXPECT_EQ(form.settings().fractionBits, 28);
}

TEST_F(EscLineSettingsFormTest, AProblemGoesWithItsCause)
{
    form.setPorts(ports);
    page.setProblem(QStringLiteral("The port is used by another program."));
    EXPECT_EQ(said(), QStringLiteral("The port is used by another program."));
    field<QComboBox>("Port").setEditText(QStringLiteral("/dev/ttyS1"));
    EXPECT_EQ(said(), QString());
}

TEST_F(EscLineSettingsFormTest, RefreshIsTheCallers)
{
    const QSignalSpy refresh(&form, &EscLineSettingsForm::portsWanted);
    test::button(form, QStringLiteral("Refresh"))->click();
    EXPECT_EQ(refresh.count(), 1);
    test::expectAccessible(page);
}

} // namespace
} // namespace codewheel
