// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/window_test.h"
#include "tests/support/places.h"
#include "widgets/structure/structure_view.h"
#include "widgets/transfer/replace_page.h"
#include "widgets/transfer/transfer_page.h"

#include <QAction>
#include <QLocale>
#include <QPushButton>
#include <QRadioButton>
#include <QTest>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class TransferInTheWindow : public test::WindowTest
{
protected:
    TransferPage &page() { return *window().findChild<TransferPage *>(); }
    void choose(Place number) { window().findChild<StructureView *>()->choose(number); }
    // Writes what is wanted of the Baumer, using Transfer.
    void write(std::int64_t steps)
    {
        shown->project().editDevice(baumer, QStringLiteral("want"), [=](ProjectDevice &device) {
            device.wanted = {{Parameter::steps, steps}};
        });
        actions().transfer->trigger();
        click("transferBegin");
    }
    void click(const char *name)
    {
        auto *button = page().findChild<QPushButton *>(QLatin1String(name));
        ASSERT_TRUE(QTest::qWaitFor([button] { return button->isEnabled(); })); // the plan follows shortly
        QTest::mouseClick(button, Qt::LeftButton);
        advance(500);
    }
    std::optional<std::int64_t> known() { return knownNumber(*bus().encoder(baumer), Parameter::steps); }
};

TEST_F(TransferInTheWindow, ValuesAreWrittenAndThoseFromBeforeRestored)
{
    choose(baumer);
    EXPECT_FALSE(actions().restoreValues->isEnabled());
    write(2048);
    click("transferBack");
    write(4096);
    EXPECT_EQ(known(), 4096);
    EXPECT_TRUE(actions().restoreValues->isEnabled());
    EXPECT_TRUE(actions().restoreValues->text().startsWith(QStringLiteral("Restore &values of 14:02")));

    actions().restoreValues->trigger();
    click("transferBegin");
    EXPECT_EQ(known(), 2048);
}

TEST_F(TransferInTheWindow, WritesAreCountedOnWhenTheProjectIsSavedUnderAName)
{
    choose(baumer);
    bus().encoder(baumer)->tell(Parameter::steps, 8192);
    write(4096);
    const auto count = [this] { return bus().encoder(baumer)->eepromCount().writes; };
    const int written = count();
    EXPECT_GT(written, 0);
    for (const char *name : {"first.codewheel", "second.codewheel"}) {
        shown->project().setFile(folder.filePath(QLatin1String(name)));
        EXPECT_EQ(count(), written) << name;
        EXPECT_TRUE(actions().restoreValues->isEnabled()) << name;
    }
    shown->project().setProject({}, folder.filePath(QStringLiteral("other.codewheel")));
    EXPECT_EQ(count(), written) << "the simulated encoder is the same";
}

TEST_F(TransferInTheWindow, AlarmStopEndsItAll)
{
    shown->project().editDevice(baumer, QStringLiteral("want"), [](ProjectDevice &device) {
        device.wanted = {{Parameter::steps, 4096}};
    });
    actions().transfer->trigger();
    QTest::mouseClick(page().findChild<QPushButton *>(QStringLiteral("transferBegin")), Qt::LeftButton);
    advance(4);
    ASSERT_TRUE(page().isBusy());
    actions().alarmStop->trigger();
    advance(100);
    EXPECT_FALSE(page().isBusy());
    EXPECT_EQ(out(baumer), 0u);
}

TEST_F(TransferInTheWindow, TheChosenEncoderIsReplaced)
{
    choose(fraba);
    actions().replaceEncoder->trigger();
    EXPECT_TRUE(window().findChild<ReplacePage *>()->isVisible());
    choose("3.0"_ring);
    EXPECT_FALSE(actions().replaceEncoder->isEnabled()); // a K1 has nothing to write
    EXPECT_TRUE(actions().replaceEncoder->toolTip().contains(QStringLiteral("cannot be parameterized")));
}

TEST_F(TransferInTheWindow, APositionThatWasSavedIsOfferedAtOnce)
{
    shown->project().setFile(folder.filePath(QStringLiteral("crane.codewheel")));
    choose(fraba);
    actions().replaceEncoder->trigger();
    auto &replacing = *window().findChild<ReplacePage *>();
    for (const int turnedBy : {0, 100}) {
        shown->controls().turnBy(fraba.node, turnedBy);
        advance(500);
        const auto position = bus().encoder(fraba)->latest().position;
        ASSERT_TRUE(position);
        actions().saveProject->trigger();
        EXPECT_TRUE(shown->project().isSaved());
        if (turnedBy == 0)
            QTest::mouseClick(replacing.findChild<QPushButton *>(QStringLiteral("replaceNext")),
                              Qt::LeftButton);
        const QString offer = replacing.findChild<QRadioButton *>(QStringLiteral("positionKept"))->text();
        EXPECT_TRUE(offer.contains(QLocale().toString(qlonglong{*position}))) << offer.toStdString();
    }
}

TEST_F(TransferInTheWindow, AnotherProjectTakesTheResultOfTheTransferAway)
{
    choose(baumer);
    write(2048);
    ASSERT_TRUE(page().findChild<QPushButton *>(QStringLiteral("transferBack"))->isVisible());
    shown->project().setFile(folder.filePath(QStringLiteral("same.codewheel")));
    EXPECT_TRUE(page().findChild<QPushButton *>(QStringLiteral("transferBack"))->isVisible());
    shown->project().setProject({}, {});
    actions().transfer->trigger();
    EXPECT_FALSE(page().findChild<QPushButton *>(QStringLiteral("transferBack"))->isVisible());
    EXPECT_TRUE(page().findChild<QPushButton *>(QStringLiteral("transferBegin"))->isVisible());
}

TEST_F(TransferInTheWindow, AnotherProjectEndsTheReplacement)
{
    choose(fraba);
    actions().replaceEncoder->trigger();
    shown->project().setProject({}, {});
    EXPECT_FALSE(window().findChild<ReplacePage *>()->isVisible());
    EXPECT_TRUE(monitors().isVisible());
}

} // namespace
} // namespace codewheel
