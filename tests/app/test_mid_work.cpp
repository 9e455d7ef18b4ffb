// SPDX-License-Identifier: GPL-3.0-or-later
// What is half done while the language changes, or another device is chosen.
#include "app/window/buses/plant.h"
#include "app/window/kinds/interbus/ring_actions.h"
#include "app/window/kinds/interbus/ring_at_work.h"
#include "app/window/main_window.h"
#include "app/window/program.h"
#include "app/window/window_actions.h"
#include "bus/buses.h"
#include "bus/word_channel.h"
#include "tests/app/window_test.h"
#include "widgets/connect/connect_page.h"
#include "widgets/input/text_fields.h"
#include "widgets/job/step_table.h"
#include "widgets/look/appearance.h"
#include "widgets/look/inline_message.h"
#include "widgets/models/traffic_model.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/parameters/value_input.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/structure/structure_model.h"
#include "widgets/structure/structure_view.h"
#include "widgets/trace/trace_view.h"
#include "widgets/transfer/transfer_page.h"
#include "widgets/wizard/parameter_wizard.h"
#include "widgets/wizard/values_page.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPointer>
#include <QPushButton>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeView>

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr int patience = 60'000; // ms

// The program as it runs, with the training plant in real time.
class LanguageInMidWork : public testing::Test
{
protected:
    LanguageInMidWork()
    {
        program = std::make_unique<Program>(*qApp, folder.filePath(QStringLiteral("program.ini")));
        program->openWindow();
        window().show();
        window().activateWindow();
        EXPECT_TRUE(QTest::qWaitFor([this] { return program->plant() != nullptr; }, patience));
        window().findChild<StructureView *>()->choose(test::fraba);
    }
    ~LanguageInMidWork() override
    {
        program.reset();
        applyAppearance(*qApp, {.scheme = Scheme::light});
        QLocale::setDefault(QLocale::c());
    }

    MainWindow &window() { return *program->window(); }
    EncoderSession &encoder() { return *program->plant()->buses().encoder(test::fraba); }
    ParameterWizard &wizard() { return *window().findChild<ParameterWizard *>(); }
    void becomeGerman() { become("de"); }
    void becomeEnglish() { become("en"); }
    void become(const char *wanted)
    {
        const QPointer<MainWindow> before(program->window());
        for (QAction *language : window().actions().language->actions())
            if (language->data() == QLatin1String(wanted))
                language->trigger();
        ASSERT_TRUE(QTest::qWaitFor([&] { return before.isNull(); }, patience));
        QCoreApplication::processEvents();
    }
    QPushButton &button(const char *id) { return *wizard().findChild<QPushButton *>(QLatin1String(id)); }
    void press(QPushButton &its)
    {
        ASSERT_TRUE(QTest::qWaitFor([&] { return its.isVisible() && its.isEnabled(); }, 5000))
            << its.text().toStdString() << " on page " << wizard().page() << its.isVisible();
        QTest::mouseClick(&its, Qt::LeftButton);
    }
    void goTo(ParameterWizard::Page page)
    {
        window().actions().wizard->trigger();
        while (wizard().page() < page && !HasFailure())
            press(button("wizardNext"));
    }
    ValueInput &steps()
    {
        return *wizard().findChild<ValuesPage *>()->findChild<ValueInput *>(QStringLiteral("steps"));
    }

    const StepTable &handshake()
    {
        return *static_cast<StepTable *>(wizard().findChild<QTableView *>(QStringLiteral("steps"))->model());
    }

    QTemporaryDir folder;
    std::unique_ptr<Program> program;
};

TEST_F(LanguageInMidWork, AHandshakeByHandGoesOnWhereItWas)
{
    goTo(ParameterWizard::values);
    steps().setFocus();
    QTest::keyClicks(&steps(), QStringLiteral("255"));
    goTo(ParameterWizard::handshake);
    press(button("nextStep"));
    const StepTable *table = &handshake();
    ASSERT_TRUE(QTest::qWaitFor([&] { return table->current() > 0; }, patience));
    const int rows = table->rowCount();
    const int current = table->current();
    becomeGerman();
    EXPECT_TRUE(wizard().isVisible());
    EXPECT_EQ(wizard().page(), ParameterWizard::handshake);
    EXPECT_TRUE(wizard().isBusy());
    const StepTable *german = &handshake();
    EXPECT_EQ(german->rowCount(), rows);
    EXPECT_EQ(german->current(), current);
    EXPECT_TRUE(german->rowAt(0).in) << "what the encoder answered";
    EXPECT_NE(german->rowAt(0).what, QString());
    for (int i = 0; i < 50 && wizard().isBusy(); ++i)
        if (QTest::qWaitFor([&] { return !wizard().isBusy() || button("nextStep").isEnabled(); }, patience) &&
            wizard().isBusy())
            press(button("nextStep"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !wizard().isBusy(); }, patience));
    const auto known = encoder().known(Parameter::steps);
    ASSERT_TRUE(known);
    EXPECT_EQ(known->value, 255);
    press(button("wizardNext"));
    EXPECT_EQ(wizard().page(), ParameterWizard::report);
}

TEST_F(LanguageInMidWork, WhatIsBeingTypedInTheWizardIsStillBeingTyped)
{
    goTo(ParameterWizard::values);
    steps().setFocus();
    QTest::keyClicks(&steps(), QStringLiteral("25"));
    becomeGerman();
    EXPECT_EQ(wizard().page(), ParameterWizard::values);
    EXPECT_EQ(steps().text(), QStringLiteral("25"));
    EXPECT_FALSE(window().findChild<WantedValues *>()->value(test::fraba, Parameter::steps)) << "not taken";
}

TEST_F(LanguageInMidWork, WhatIsBeingTypedInAFormOfALinkIsStillBeingTyped)
{
    window().findChild<RingActions *>()->connection->trigger();
    const auto page = [this] { return window().findChild<ConnectPage *>(QStringLiteral("ringConnection")); };
    const auto host = [&] { return page()->findChild<QLineEdit *>(QStringLiteral("host")); };
    page()->findChild<QComboBox *>(QStringLiteral("link"))->setCurrentIndex(1);
    host()->setFocus();
    QTest::keyClicks(host(), QStringLiteral("gateway.h"));
    becomeGerman();
    ASSERT_TRUE(page()->isVisible());
    ASSERT_TRUE(host() != nullptr && host()->isVisible()) << "its link is chosen";
    EXPECT_EQ(host()->text(), QStringLiteral("gateway.h"));
}

// However many pages have been opened before.
TEST_F(LanguageInMidWork, ThePageThatIsOpenIsStillOpen)
{
    window().actions().transfer->trigger();
    window().actions().replaceEncoder->trigger();
    window().findChild<RingActions *>()->connection->trigger();
    becomeGerman();
    EXPECT_TRUE(window().findChild<ConnectPage *>(QStringLiteral("ringConnection"))->isVisible());
    EXPECT_EQ(window().findChild<ParameterWizard *>(), nullptr) << "it was not opened";
    window().actions().transfer->trigger();
    becomeEnglish();
    const auto *page = window().findChild<TransferPage *>();
    ASSERT_NE(page, nullptr);
    EXPECT_TRUE(page->isVisible());
    window().actions().wizard->trigger();
    becomeGerman();
    ASSERT_NE(window().findChild<ParameterWizard *>(), nullptr);
    EXPECT_TRUE(wizard().isVisible());
    EXPECT_EQ(wizard().encoder(), &encoder());
}

TEST_F(LanguageInMidWork, ABusThatNoProjectNamesIsCalledInTheNewLanguage)
{
    const auto says = [this](const QString &name) {
        return QTest::qWaitFor(
            [&] {
                window().findChild<StructureView *>()->choose(placeOnLine({5}));
                const auto labels = window().statusBar()->findChildren<QLabel *>();
                return std::ranges::any_of(
                    labels, [&](const QLabel *label) { return label->text().startsWith(name + u':'); });
            },
            5000);
    };
    EXPECT_TRUE(says(QStringLiteral("Line")));
    becomeGerman();
    EXPECT_TRUE(says(QStringLiteral("Leitung")));
}

TEST_F(LanguageInMidWork, WhatCanBeUndoneIsNamedInTheNewLanguage)
{
    auto &wanted = *window().findChild<WantedValues *>();
    wanted.set(test::fraba, Parameter::steps, Value(255));
    EXPECT_EQ(window().actions().undo->text(), QStringLiteral("&Undo Steps wanted for 1.0"));
    becomeGerman();
    const QString undo = window().actions().undo->text();
    EXPECT_FALSE(undo.contains(QStringLiteral("wanted"))) << undo.toStdString();
    EXPECT_TRUE(undo.contains(QStringLiteral("1.0"))) << undo.toStdString();
    QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(window().findChild<WantedValues *>()->values(test::fraba).empty());
}

TEST_F(LanguageInMidWork, TheTraceKeepsItsRows)
{
    auto *channel = program->plant()->buses().channel(test::fraba);
    channel->stage(0x0200'00FF);
    ASSERT_TRUE(channel->write());
    const auto rows = [this] { return window().findChild<TraceView *>()->model(test::fraba)->rowCount(); };
    ASSERT_TRUE(QTest::qWaitFor([&] { return rows() > 1; }, patience));
    const int before = rows();
    becomeGerman();
    EXPECT_GE(rows(), before);
    EXPECT_TRUE(window().findChild<TraceView *>()->hasRows());
}

class HalfTyped : public test::WindowTest
{
protected:
    HalfTyped()
    {
        tree().choose(test::fraba);
        auto *dock = window().findChild<QDockWidget *>(QStringLiteral("parametersDock"));
        dock->show();
        dock->raise();
        advance(50);
        QTest::mouseClick(
            table().viewport(), Qt::LeftButton, {},
            table().visualRect(table().model()->index(0, ParameterModel::wantedColumn)).center());
        field()->selectAll();
        QTest::keyClicks(field(), QStringLiteral("10"));
    }
    StructureView &tree() { return *window().findChild<StructureView *>(); }
    ParameterPanel &panel() { return *window().findChild<ParameterPanel *>(); }
    ParameterTable &table() { return *panel().findChild<ParameterTable *>(); }
    ValueInput *field() { return table().viewport()->findChild<ValueInput *>(); }
    ParameterValues wanted(Place place) { return shown->project().device(place).wanted; }
    void clickInTree(Place place)
    {
        auto &rows = *tree().findChild<QTreeView *>(QStringLiteral("structure"));
        const auto *model = static_cast<const StructureModel *>(rows.model());
        QTest::mouseClick(rows.viewport(), Qt::LeftButton, {},
                          rows.visualRect(model->indexOf(place)).center());
        advance(50);
    }
};

TEST_F(HalfTyped, IsNotTakenByChoosingAnotherDevice)
{
    clickInTree(test::baumer);
    ASSERT_EQ(tree().current(), test::baumer);
    EXPECT_TRUE(wanted(test::fraba).empty());
    EXPECT_TRUE(wanted(test::baumer).empty());
    const auto *message = panel().findChild<InlineMessage *>(QStringLiteral("panelMessage"));
    ASSERT_TRUE(message->isVisible());
    EXPECT_TRUE(message->sentence().contains(QStringLiteral("Steps 10")))
        << message->sentence().toStdString();
}

TEST_F(HalfTyped, WaitsWhileSomethingElseIsLookedAt)
{
    clickInTree(test::fraba); // the focus is in the tree
    ASSERT_NE(field(), nullptr);
    EXPECT_EQ(field()->text(), QStringLiteral("10"));
    EXPECT_TRUE(wanted(test::fraba).empty());
    table().setFocus(); // back in the panel
    advance(50);
    EXPECT_EQ(wanted(test::fraba), (ParameterValues{{Parameter::steps, 10}}));
}

TEST_F(HalfTyped, IsTakenWithinThePanel)
{
    QTest::keyClick(field(), Qt::Key_Return);
    advance(50); // the table takes it once the event loop runs
    EXPECT_EQ(wanted(test::fraba), (ParameterValues{{Parameter::steps, 10}}));
}

// As Ctrl+S does before it saves.
TEST_F(HalfTyped, IsTakenWithWhatIsSaved)
{
    takeFocusedField();
    EXPECT_EQ(wanted(test::fraba), (ParameterValues{{Parameter::steps, 10}}));
}

class WizardFields : public test::WindowTest
{
protected:
    WizardFields()
    {
        window().findChild<StructureView *>()->choose(test::fraba);
        actions().wizard->trigger();
        while (wizard().page() < ParameterWizard::values)
            QTest::mouseClick(wizard().findChild<QPushButton *>(QStringLiteral("wizardNext")),
                              Qt::LeftButton);
        steps().setFocus();
    }
    ParameterWizard &wizard() { return *window().findChild<ParameterWizard *>(); }
    ValueInput &steps()
    {
        return *wizard().findChild<ValuesPage *>()->findChild<ValueInput *>(QStringLiteral("steps"));
    }
    bool isWanted() { return !shown->project().device(test::fraba).wanted.empty(); }
};

TEST_F(WizardFields, CtrlZUndoesWhatWasTaken)
{
    QTest::keyClicks(&steps(), QStringLiteral("255"));
    QTest::keyClick(&steps(), Qt::Key_Return);
    ASSERT_TRUE(isWanted());
    steps().setFocus();
    QTest::keyClick(&steps(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(isWanted());
    EXPECT_EQ(steps().text(), QString());
    steps().setFocus();
    QTest::keySequence(&steps(), QKeySequence::Redo);
    EXPECT_TRUE(isWanted());
    EXPECT_EQ(steps().text(), QStringLiteral("255"));
}

TEST_F(WizardFields, CtrlZTakesBackWhatIsBeingTypedFirst)
{
    QTest::keyClicks(&steps(), QStringLiteral("25"));
    QTest::keyClick(&steps(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(steps().text(), QString());
    EXPECT_FALSE(isWanted());
}

TEST_F(WizardFields, WhatIsBeingTypedIsTakenWithWhatIsSaved)
{
    QTest::keyClicks(&steps(), QStringLiteral("25"));
    takeFocusedField();
    EXPECT_TRUE(isWanted());
    EXPECT_TRUE(steps().hasFocus());
}

TEST_F(WizardFields, TheLetterOfADisabledButtonIsNotTyped)
{
    QTest::keyClicks(&steps(), QStringLiteral("99999999"));
    QTest::keyClick(&steps(), Qt::Key_Tab);
    ASSERT_FALSE(wizard().findChild<QPushButton *>(QStringLiteral("wizardNext"))->isEnabled());
    steps().setFocus();
    steps().deselect();
    const QString typed = steps().text();
    QTest::keyClick(&steps(), Qt::Key_N, Qt::AltModifier);
    EXPECT_EQ(steps().text(), typed);
    EXPECT_EQ(wizard().page(), ParameterWizard::values);
    QTest::keyClick(&steps(), Qt::Key_1);
    EXPECT_EQ(steps().text(), typed + u'1');
}

TEST_F(WizardFields, AHalfTypedValueIsNotTakenByChoosingAnotherDevice)
{
    QTest::keyClicks(&steps(), QStringLiteral("25"));
    window().findChild<QTreeView *>(QStringLiteral("structure"))->setFocus();
    window().findChild<StructureView *>()->choose(test::baumer);
    advance(50);
    EXPECT_FALSE(isWanted());
}

} // namespace
} // namespace codewheel
