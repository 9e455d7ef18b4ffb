// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/buses.h"
#include "tests/support/places.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/device/device_html.h"
#include "widgets/device/device_panel.h"
#include "widgets/look/inline_message.h"
#include "widgets/structure/structure_view.h"

#include <QComboBox>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTextBrowser>

namespace codewheel {
namespace {

using test::fraba;

class DevicePanelTest : public testing::Test
{
protected:
    DevicePanelTest()
    {
        buses.add(ring.bus);
        panel.resize(320, 600);
        panel.show();
    }
    QString page() const { return panel.findChild<QTextBrowser *>()->toPlainText(); }
    bool showsPage() const { return panel.findChild<QTextBrowser *>()->isVisible(); }
    QLineEdit *key() const { return panel.findChild<QLineEdit *>(QStringLiteral("labelKey")); }
    QComboBox *makes() const { return panel.findChild<QComboBox *>(QStringLiteral("makes")); }
    InlineMessage *message() const { return panel.findChild<InlineMessage *>(); }
    void type(const char *text)
    {
        key()->clear();
        QTest::keyClicks(key(), QString::fromLatin1(text));
    }
    void clickName()
    {
        QTest::mouseClick(panel.findChild<QPushButton *>(QStringLiteral("nameIt")), Qt::LeftButton);
    }
    void chooseMake(const char *deviceKey)
    {
        const int row = makes()->findData(QString::fromLatin1(deviceKey));
        ASSERT_GE(row, 0) << deviceKey;
        makes()->setCurrentIndex(row);
    }

    test::TrainingBusSession ring;
    Buses buses;
    DevicePanel panel{buses, ring.catalog};
};

TEST_F(DevicePanelTest, WithoutADeviceSaysWhatBelongsHere)
{
    EXPECT_FALSE(showsPage());
    EXPECT_FALSE(makes()->isEnabled());
}

TEST_F(DevicePanelTest, ShowsTheTablesOfTheManual)
{
    panel.setPlace(fraba);
    ASSERT_TRUE(showsPage());
    const QString text = page();
    for (const char *part :
         {"FRABA OCD-IB K3", "+ 12-30 V DC", "RBDA", "BA blinking", "max. 3.5 W", "OCD-IBA1B-1213-C100-PRI",
          "Zero offset", "Manual: 3.3", "Notes and assumptions"})
        EXPECT_TRUE(text.contains(QLatin1String(part))) << part << "\n" << text.toStdString();
}

TEST_F(DevicePanelTest, APageThatWasNotSeenIsWrittenWhenItIs)
{
    panel.setPlace(test::baumer);
    ASSERT_TRUE(page().contains(QStringLiteral("Baumer")));
    panel.hide();
    panel.setPlace(fraba);
    EXPECT_EQ(page(), QString()) << "nobody waits for it";
    panel.show();
    EXPECT_TRUE(QTest::qWaitFor([this] { return page().contains(QStringLiteral("FRABA OCD-IB K3")); }));
}

TEST(DeviceHtml, IsWrittenForEveryDeviceOfTheCatalog)
{
    const Catalog catalog = Catalog::builtIn();
    for (const DeviceDescription &device : catalog.devices()) {
        const QString html = deviceHtml(device);
        EXPECT_TRUE(html.contains(device.fullName().toHtmlEscaped())) << qPrintable(device.key);
        EXPECT_FALSE(html.contains(QStringLiteral("%1"))) << qPrintable(device.key);
    }
}

// Kübler manual, read command F; which bits these are depends on the line's format.
TEST(DeviceHtml, TheScalingFactorHasTheRangeOfTheManual)
{
    const Catalog catalog = Catalog::builtIn();
    EXPECT_TRUE(deviceHtml(*catalog.find(u"kuebler-esc-rs485")).contains(QStringLiteral("0.00001 ... 1.0")));
}

TEST_F(DevicePanelTest, ATypedLabelKeyShowsItsDevice)
{
    type("GXP6W.0 10 A0 01");
    EXPECT_TRUE(page().contains(QStringLiteral("Baumer GXP6W K3")));
    key()->clear();
    EXPECT_FALSE(showsPage());
}

// A 12-bit single-turn encoder from a family described with 13 + 12 bits.
TEST_F(DevicePanelTest, ATypedLabelKeyShowsItsDeviceWithItsTurnsAndSteps)
{
    const auto row = [this](const char *name) {
        const QStringList lines = page().split(u'\n');
        return QLocale().toInt(lines.value(lines.indexOf(QString::fromLatin1(name)) + 1));
    };
    type("OCD-IBA1B-0012-C100-PRI");
    EXPECT_EQ(row("Steps per turn"), 4096) << page().left(400).toStdString();
    EXPECT_EQ(row("Turns"), 1);
    type("OCD-IBA1B-1213-C100-PRI");
    EXPECT_EQ(row("Steps per turn"), 8192);
    EXPECT_EQ(row("Turns"), 4096);
}

TEST_F(DevicePanelTest, APartThatIsNotUnderstoodIsToldAtOnceAndGoesWithItsCause)
{
    type("GXP6W.0 3");
    ASSERT_FALSE(message()->isHidden());
    EXPECT_TRUE(message()->sentence().contains(QStringLiteral("\"3\" in")));
    QTest::keyClick(key(), Qt::Key_Backspace);
    EXPECT_TRUE(message()->isHidden()) << "a key that is being typed is no mistake";
    QTest::keyClick(key(), Qt::Key_Return);
    ASSERT_FALSE(message()->isHidden());
    EXPECT_TRUE(message()->sentence().contains(QStringLiteral("ends too early")));
}

TEST_F(DevicePanelTest, NamesAndUnNamesTheEncoder)
{
    ASSERT_TRUE(ring.bus.name(fraba, {}));
    ring.bus.advance(2);
    panel.setPlace(fraba);
    EXPECT_EQ(makes()->currentData().toString(), QString());
    type("ocd-iba1b-0012-c100-pri");
    EXPECT_EQ(makes()->currentData().toString(), QStringLiteral("fraba-ocd-ib"));
    clickName();
    EXPECT_EQ(ring.encoder(fraba).device().key, QStringLiteral("fraba-ocd-ib"));
    EXPECT_EQ(ring.encoder(fraba).device().physicalTurns, 1);
    EXPECT_TRUE(page().contains(QStringLiteral("FRABA OCD-IB K3")));
    EXPECT_TRUE(key()->text().isEmpty());

    chooseMake("");
    clickName();
    EXPECT_TRUE(ring.encoder(fraba).device().isGeneric());
    EXPECT_TRUE(page().contains(QStringLiteral("K3, make not known")));
}

TEST_F(DevicePanelTest, TheKeyOfADeviceWithAnotherCodeNamesNothing)
{
    panel.setPlace(fraba);
    type("8.5882.xx3x.3001");
    EXPECT_FALSE(message()->isHidden());
    EXPECT_TRUE(message()->sentence().contains(QStringLiteral("another kind of bus")))
        << message()->sentence().toStdString();
    EXPECT_EQ(makes()->currentData().toString(), QStringLiteral("fraba-ocd-ib"));
}

TEST_F(DevicePanelTest, ARunningJobKeepsTheName)
{
    panel.setPlace(fraba);
    ASSERT_TRUE(ring.encoder(fraba).start(SendWords{.words = {0x0200'00FF}, .holdCycles = 100}));
    chooseMake("baumer-gxp6w");
    clickName();
    EXPECT_EQ(ring.encoder(fraba).device().key, QStringLiteral("fraba-ocd-ib"));
    EXPECT_FALSE(message()->isHidden());
}

TEST_F(DevicePanelTest, TheTreeAsksForTheMakeUntilItIsNamed)
{
    StructureView tree;
    tree.addBus(ring.bus);
    tree.show();
    auto *question = tree.findChild<InlineMessage *>(QStringLiteral("makeQuestion"));
    tree.choose(fraba);
    EXPECT_TRUE(question->isHidden());
    ASSERT_TRUE(ring.bus.name(fraba, {}));
    ASSERT_FALSE(question->isHidden());
    EXPECT_TRUE(question->sentence().contains(QStringLiteral("1.0")));
    QSignalSpy requests(&tree, &StructureView::namingRequested);
    QTest::mouseClick(question->findChild<QPushButton *>(), Qt::LeftButton);
    EXPECT_EQ(requests.count(), 1);
    ASSERT_TRUE(ring.bus.name(fraba, QStringLiteral("fraba-ocd-ib")));
    EXPECT_TRUE(question->isHidden());
}

// Analog modules have the same code as the LA-66: without a name there is no driver for it.
TEST_F(DevicePanelTest, TheTreeAsksWhatAnUnnamedRodIsAndNeverABusTerminal)
{
    constexpr Place la66 = "5.0"_ring;
    StructureView tree;
    tree.addBus(ring.bus);
    tree.show();
    auto *question = tree.findChild<InlineMessage *>(QStringLiteral("makeQuestion"));
    ASSERT_TRUE(ring.bus.name(la66, {}));
    ASSERT_EQ(ring.bus.encoder(la66), nullptr);
    tree.choose(la66);
    EXPECT_FALSE(question->isHidden());
    tree.choose("6.0"_ring);
    EXPECT_TRUE(question->isHidden());
}

} // namespace
} // namespace codewheel
