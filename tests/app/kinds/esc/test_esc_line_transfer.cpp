// SPDX-License-Identifier: GPL-3.0-or-later
// Transfer, replace, restore and report in the window with encoders of ring and line.
#include "app/window/files/project_files.h"
#include "app/window/paper/report_export.h"
#include "kinds/esc/plan/esc_line_plan.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "widgets/structure/structure_view.h"
#include "widgets/transfer/replace_page.h"
#include "widgets/transfer/transfer_page.h"

#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QTableView>
#include <QTest>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using test::baumer;
using testing::HasSubstr;

const Place at03 = placeOnLine({0x03});
const Place at05 = placeOnLine({0x05});

// The project has the ring of the training bus, and 03 and 05 on the line.
class TransferOnLine : public test::WindowTest
{
protected:
    TransferOnLine()
    {
        Project project = shown->project().project();
        setLinePlan(project, firstLine, {});
        for (const Place place : {at03, at05}) {
            ProjectDevice &encoder = project.devices.emplace_back();
            encoder.standAt(place);
            encoder.participant.deviceKey = QStringLiteral("kuebler-esc-rs485");
        }
        shown->project().setProject(project, {});
        advance(1000);
    }
    EncoderSession &encoder(Place place) { return *shown->buses().encoder(place); }
    EscRegisters registers(Place place)
    {
        EscRegisters its;
        EXPECT_TRUE(shown->line().training()->withEncoder(
            EscLineAddress::of(place.node),
            [&](const SimulatedEscEncoder &simulated) { its = simulated.registers(); }));
        return its;
    }
    TransferPage &page() { return *window().findChild<TransferPage *>(); }
    ReplacePage &replacePage() { return *window().findChild<ReplacePage *>(); }
    void choose(Place place) { window().findChild<StructureView *>()->choose(place); }
    void want(Place place, const ParameterValues &values)
    {
        shown->project().editDevice(place, QStringLiteral("want"),
                                    [&](ProjectDevice &device) { device.wanted = values; });
    }
    QString account() { return page().findChild<QPlainTextEdit *>(QStringLiteral("account"))->toPlainText(); }
    template <typename Page>
    void press(Page &on, const char *name)
    {
        auto *button = on.template findChild<QPushButton *>(QLatin1String(name));
        ASSERT_TRUE(QTest::qWaitFor([button] { return button->isEnabled(); })); // the plan follows shortly
        QTest::mouseClick(button, Qt::LeftButton);
        advance(10);
    }
    void untilDone()
    {
        const auto *page = window().findChild<TransferPage *>(); // null: not opened yet
        const auto *replacing = window().findChild<ReplacePage *>();
        const auto isBusy = [&] {
            return (page != nullptr && page->isBusy()) || (replacing != nullptr && replacing->isBusy());
        };
        for (int i = 0; i < 300 && isBusy(); ++i)
            advance(33);
        EXPECT_FALSE(isBusy());
    }
};

TEST_F(TransferOnLine, WhatTheProjectWantsIsWrittenToEncodersOfBoth)
{
    ASSERT_TRUE(encoder(at05).start(ReadParameters{.parameters = {Parameter::scaling}}));
    advance(1000);
    want(baumer, {{Parameter::steps, 4096}});
    want(at05, {{Parameter::steps, 864}});
    actions().transfer->trigger();
    const auto *table = page().findChild<QAbstractItemView *>(QStringLiteral("transferTable"));
    QStringList cells;
    for (int row = 0; row < table->model()->rowCount(); ++row)
        cells << table->model()->index(row, TransferModel::sent).data().toString();
    EXPECT_TRUE(cells.contains(QStringLiteral("05GR00000360"))) << cells.join(u' ').toStdString();
    EXPECT_TRUE(cells.contains(QStringLiteral("02001000")));
    press(page(), "transferBegin");
    untilDone();
    EXPECT_EQ(encoder(baumer).known(Parameter::steps)->value, 4096);
    EXPECT_EQ(registers(at05).stepsPerTurn, 864u);
    EXPECT_THAT(account().toStdString(), HasSubstr("2 of 2 have all of it"));
    EXPECT_EQ(account().count(QStringLiteral("Not in force")), 1) << account().toStdString();
    EXPECT_THAT(account().toStdString(), HasSubstr("Scaling is off: "));
    EXPECT_EQ(encoder(at05).eepromCount().by, CountedBy::serialNumber);
    EXPECT_EQ(encoder(at05).eepromCount().writes, 2);
}

TEST_F(TransferOnLine, OneEncoderGivesItsValuesToAnother)
{
    want(at03, {{Parameter::direction, 1}});
    actions().transfer->trigger();
    press(page(), "transferBegin");
    untilDone();
    page().choose(TransferChoice::What::clone, std::nullopt);
    auto *from = page().findChild<QComboBox *>(QStringLiteral("cloneFrom"));
    from->setCurrentIndex(from->findData(at03.toString()));
    ASSERT_EQ(from->currentText().left(6), QStringLiteral("esc:03"));
    press(page(), "transferBegin");
    untilDone();
    EXPECT_TRUE(registers(at05).countsCcw);
}

TEST_F(TransferOnLine, ValuesFromBeforeAreRestored)
{
    choose(at05);
    EXPECT_FALSE(actions().restoreValues->isEnabled());
    ASSERT_TRUE(encoder(at05).start(ReadParameters{.parameters = {Parameter::direction}}));
    advance(1000);
    want(at05, {{Parameter::direction, 1}});
    actions().transfer->trigger();
    press(page(), "transferBegin");
    untilDone();
    ASSERT_TRUE(registers(at05).countsCcw);
    ASSERT_TRUE(actions().restoreValues->isEnabled()) << actions().restoreValues->toolTip().toStdString();
    actions().restoreValues->trigger();
    press(page(), "transferBegin");
    untilDone();
    EXPECT_FALSE(registers(at05).countsCcw);
}

TEST_F(TransferOnLine, AnEncoderIsReadInWatchAndWhatItHasIsStored)
{
    bus().setOperate(false);
    shown->line().session()->setOperate(false);
    advance(100);
    actions().transfer->trigger();
    page().choose(TransferChoice::What::store, std::nullopt);
    auto *none = page().findChild<QPushButton *>(QStringLiteral("chooseNone"));
    QTest::mouseClick(none, Qt::LeftButton);
    auto *table = page().findChild<QAbstractItemView *>(QStringLiteral("transferTable"));
    for (int row = 0; row < table->model()->rowCount(); ++row)
        if (const QModelIndex cell = table->model()->index(row, TransferModel::place);
            cell.data().toString() == at05.toString())
            table->model()->setData(cell, Qt::Checked, Qt::CheckStateRole);
    press(page(), "transferBegin");
    untilDone();
    const std::vector<StoredValue> stored = shown->project().device(at05).stored;
    EXPECT_NE(std::ranges::find(stored, Parameter::steps, &StoredValue::parameter), stored.end());
}

TEST_F(TransferOnLine, CancelBeginsNoOther)
{
    want(at03, {{Parameter::direction, 1}});
    want(at05, {{Parameter::direction, 1}});
    actions().transfer->trigger();
    press(page(), "transferBegin");
    for (int i = 0; i < 100 && !registers(at03).countsCcw; ++i)
        advance(5);
    ASSERT_TRUE(page().isBusy());
    {
        const auto question = test::Question::answeredBy(QStringLiteral("Leave"));
        auto *cancel = page().findChild<QPushButton *>(QStringLiteral("cancelJob"));
        QTest::mouseClick(cancel, Qt::LeftButton);
        for (int i = 0; i < 100 && page().isBusy(); ++i)
            advance(5);
    }
    EXPECT_FALSE(page().isBusy());
    EXPECT_FALSE(registers(at05).countsCcw);
    EXPECT_THAT(account().toStdString(), HasSubstr("Not started."));
}

TEST_F(TransferOnLine, AnUnpluggedAdapterEndsWhatIsForTheLineAlone)
{
    want(at03, {{Parameter::direction, 1}});
    actions().transfer->trigger();
    press(page(), "transferBegin");
    shown->line().training()->setUnplugged(true);
    untilDone();
    EXPECT_THAT(account().toStdString(), HasSubstr("0 of 1 have all of it"));
}

TEST_F(TransferOnLine, ALineThatIsClosedIsNotListedAnyMore)
{
    want(at03, {{Parameter::direction, 1}});
    actions().transfer->trigger();
    press(page(), "transferBegin");
    shown->line().close();
    advance(100);
    EXPECT_FALSE(page().isBusy());
    page().choose(TransferChoice::What::clone, std::nullopt);
    EXPECT_EQ(page().findChild<QComboBox *>(QStringLiteral("cloneFrom"))->findData(at03.toString()), -1);
    EXPECT_TRUE(encoder(baumer).can().writes); // the ring is as before
}

TEST_F(TransferOnLine, TheChosenEncoderIsReplacedAndGetsItsPosition)
{
    const auto before = encoder(at05).latest().position;
    want(at05, {{Parameter::direction, 1}});
    choose(at05);
    const auto turn = [this](bool silent) {
        shown->line().training()->withEncoder(
            {0x05}, [silent](SimulatedEscEncoder &encoder) { encoder.condition().mute = silent; });
        advance(5000);
    };
    turn(true);
    shown->line().training()->withEncoder(
        {0x05}, [](SimulatedEscEncoder &encoder) { encoder.shaft().turnBy(1'000); }); // of another encoder
    turn(false);
    ASSERT_TRUE(actions().replaceEncoder->isEnabled());
    actions().replaceEncoder->trigger();
    const auto *choice = replacePage().findChild<QComboBox *>(QStringLiteral("replaceChoice"));
    EXPECT_EQ(choice->count(), 2); // RS-485 and RS-422
    press(replacePage(), "replaceNext");
    EXPECT_TRUE(replacePage().findChild<QRadioButton *>(QStringLiteral("positionLast"))->isChecked());
    press(replacePage(), "replaceNext");
    advance(1000);
    press(replacePage(), "replaceNext");
    untilDone();
    EXPECT_EQ(replacePage().findChild<QLabel *>(QStringLiteral("replaceResult"))->text(),
              QStringLiteral("Done."));
    EXPECT_TRUE(registers(at05).countsCcw);
    EXPECT_EQ(registers(at05).preset, static_cast<std::uint32_t>(*before));
}

// Nothing has read it of the new encoder.
TEST_F(TransferOnLine, WhereStepsMayNotActTheReplacementSaysSo)
{
    want(at05, {{Parameter::steps, 864}});
    choose(at05);
    actions().replaceEncoder->trigger();
    press(replacePage(), "replaceNext");
    replacePage().findChild<QRadioButton *>(QStringLiteral("positionNone"))->click();
    press(replacePage(), "replaceNext");
    advance(1000);
    press(replacePage(), "replaceNext");
    untilDone();
    EXPECT_THAT(replacePage().findChild<QLabel *>(QStringLiteral("replaceResult"))->text().toStdString(),
                HasSubstr("Done. It is not known whether scaling is on: "));
}

TEST_F(TransferOnLine, TheReportHasWhatEncodersOfTheLineAreKnownToHave)
{
    ASSERT_TRUE(encoder(at05).start(ReadParameters{.parameters = {Parameter::steps}}));
    advance(1000);
    const QString file = folder.filePath(QStringLiteral("both.html"));
    ASSERT_TRUE(window().findChild<ReportExport *>()->saveTo(file));
    QFile saved(file);
    ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
    const std::string html = saved.readAll().toStdString();
    EXPECT_THAT(html, HasSubstr("of a simulated encoder"));
    EXPECT_THAT(html, HasSubstr("esc:05"));
    EXPECT_THAT(html, HasSubstr("8192"));
}

TEST_F(TransferOnLine, TheLastPositionIsSavedWithTheProject)
{
    const QString file = folder.filePath(QStringLiteral("both.codewheel"));
    shown->project().setFile(file);
    ASSERT_TRUE(window().files().save());
    ASSERT_TRUE(window().files().open(file));
    EXPECT_EQ(shown->project().device(at05).lastPosition->position, 0x1235);
}

} // namespace
} // namespace codewheel
