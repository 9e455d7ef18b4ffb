// SPDX-License-Identifier: GPL-3.0-or-later
// The program's settings in their dialog: choices take effect at once, and Cancel undoes them.
#include "app/window/main_window.h"
#include "app/window/program.h"
#include "app/window/window_actions.h"
#include "journal/ledger_writer.h"
#include "widgets/look/appearance.h"
#include "widgets/settings/settings_dialog.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QLineEdit>
#include <QLocale>
#include <QPointer>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

constexpr int mostWait = 60'000; // ms

class Settings : public testing::Test
{
protected:
    Settings() { start(); }
    ~Settings() override
    {
        program.reset();
        applyAppearance(*qApp, {.scheme = Scheme::light});
        QLocale::setDefault(QLocale::c());
    }

    void start()
    {
        program.reset();
        program = std::make_unique<Program>(*qApp, folder.filePath(QStringLiteral("program.ini")));
        program->openWindow();
        program->window()->show();
        EXPECT_TRUE(QTest::qWaitFor([this] { return program->plant() != nullptr; }, mostWait));
    }
    const WindowActions &actions() { return program->window()->actions(); }
    SettingsDialog *dialog() { return program->window()->findChild<SettingsDialog *>(); }
    SettingsDialog &open()
    {
        actions().settings->trigger();
        return *dialog();
    }
    void choose(const char *box, const QVariant &value)
    {
        auto *its = dialog()->findChild<QComboBox *>(QLatin1String(box));
        its->setCurrentIndex(its->findData(value));
    }
    void type(const char *field, const QString &text, Qt::Key end)
    {
        auto *its = dialog()->findChild<QSpinBox *>(QLatin1String(field));
        its->setFocus();
        its->selectAll();
        QTest::keyClicks(its, text);
        QTest::keyClick(its, end);
    }
    // The window is rebuilt.
    void chooseLanguage(const QString &language)
    {
        const QPointer<MainWindow> before(program->window());
        choose("settingsLanguage", language);
        ASSERT_TRUE(QTest::qWaitFor([&] { return before.isNull() && dialog() != nullptr; }, mostWait));
    }

    QTemporaryDir folder;
    std::unique_ptr<Program> program;
};

TEST_F(Settings, StandBesideTheWindowWhoseAlarmStopStaysInReach)
{
    EXPECT_EQ(actions().settings->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_Comma));
    EXPECT_FALSE(open().isModal());
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    EXPECT_EQ(&open(), dialog()) << "there is one";
}

TEST_F(Settings, TheThemeActsAtOnceAgreesWithTheMenuAndIsTakenBackByCancel)
{
    open();
    choose("settingsTheme", static_cast<int>(Scheme::dark));
    EXPECT_EQ(shadeOf(qApp->palette()), Shade::dark);
    EXPECT_EQ(actions().scheme->checkedAction()->data().toInt(), static_cast<int>(Scheme::dark));
    actions().largeControls->trigger();
    EXPECT_TRUE(dialog()->findChild<QCheckBox *>(QStringLiteral("settingsLargeControls"))->isChecked());
    EXPECT_GT(controlFactor(*program->window()), 1);
    dialog()->reject();
    EXPECT_EQ(controlFactor(*program->window()), 1);
    EXPECT_EQ(actions().scheme->checkedAction()->data().toInt(), static_cast<int>(Scheme::system));
}

TEST_F(Settings, NeedNoScrollingSidewaysWithLargeControls)
{
    open();
    actions().largeControls->trigger();
    QCoreApplication::processEvents();
    const auto *area = dialog()
                           ->findChild<QComboBox *>(QStringLiteral("settingsTheme"))
                           ->parentWidget()
                           ->parentWidget()
                           ->parentWidget();
    const auto *scrolled = qobject_cast<const QScrollArea *>(area);
    ASSERT_NE(scrolled, nullptr);
    EXPECT_TRUE(scrolled->verticalScrollBar()->isVisible());
    EXPECT_LE(scrolled->widget()->width(), scrolled->viewport()->width());
}

TEST_F(Settings, GoOnInTheWindowOfAnotherLanguage)
{
    open().setPage(1);
    chooseLanguage(QStringLiteral("de"));
    EXPECT_TRUE(dialog()->isVisible());
    EXPECT_EQ(dialog()->page(), 1);
    EXPECT_EQ(dialog()->windowTitle(), QStringLiteral("Einstellungen"));
    const QPointer<MainWindow> german(program->window());
    dialog()->reject();
    ASSERT_TRUE(QTest::qWaitFor([&] { return german.isNull(); }, mostWait));
    EXPECT_EQ(dialog(), nullptr);
    EXPECT_EQ(actions().settings->text(), QStringLiteral("&Settings…"));
}

TEST_F(Settings, NumbersHaveTheSignThatIsChosen)
{
    open();
    chooseLanguage(QStringLiteral("de"));
    EXPECT_EQ(QLocale().decimalPoint(), QStringLiteral(","));
    const QPointer<MainWindow> before(program->window());
    choose("settingsNumbers", static_cast<int>(DecimalSign::point));
    ASSERT_TRUE(QTest::qWaitFor([&] { return before.isNull() && dialog() != nullptr; }, mostWait));
    EXPECT_EQ(QLocale().decimalPoint(), QStringLiteral("."));
    EXPECT_EQ(QLocale().language(), QLocale::German);
    EXPECT_EQ(dialog()->windowTitle(), QStringLiteral("Einstellungen"));
}

TEST_F(Settings, AreKeptForTheNextStart)
{
    open().setPage(2);
    type("settingsTraceRows", QStringLiteral("5000"), Qt::Key_Return);
    type("settingsMessageFile", QStringLiteral("50"), Qt::Key_Tab);
    type("settingsKeeping", QStringLiteral("1"), Qt::Key_Tab); // too often: not taken
    dialog()->setPage(0);
    choose("settingsFrames", 60);
    program->window()->saveWindow();
    start();
    const ProgramSettings &kept = open().settings();
    EXPECT_EQ(kept.traceRows, 5'000);
    EXPECT_EQ(kept.largestMessageFile, 50);
    EXPECT_EQ(kept.secondsBetweenKeeping, 30);
    EXPECT_EQ(kept.framesPerSecond, 60);
}

TEST_F(Settings, TheNameThatIsTypedIsEnteredWithWrites)
{
    open().setPage(1);
    auto *name = dialog()->findChild<QLineEdit *>(QStringLiteral("settingsUserName"));
    name->setFocus();
    QTest::keyClicks(name, QStringLiteral("Ada"));
    EXPECT_EQ(ledgerWriter().user, QStringLiteral("Ada"));
    dialog()->reject();
    EXPECT_EQ(ledgerWriter().user, QString()) << "Cancel restores it";
}

TEST_F(Settings, OkTakesWhatIsBeingTypedAndStaysWhereThatIsRefused)
{
    open().setPage(1);
    auto *eeprom = dialog()->findChild<QSpinBox *>(QStringLiteral("settingsEeprom"));
    eeprom->setFocus();
    eeprom->selectAll();
    QTest::keyClicks(eeprom, QStringLiteral("90")); // above the maximum
    dialog()->accept();
    ASSERT_TRUE(dialog()->isVisible());
    eeprom->selectAll();
    QTest::keyClicks(eeprom, QStringLiteral("40"));
    dialog()->accept();
    EXPECT_FALSE(QTest::qWaitFor([this] { return dialog() != nullptr && dialog()->isVisible(); }, 50));
    EXPECT_EQ(open().settings().eepromQuestionFrom, 40);
}

TEST_F(Settings, TellTheFoldersAndCopyTheirPaths)
{
    open().setPage(2);
    auto *buttons = dialog()->findChild<FolderRows *>();
    int copies = 0;
    for (auto *button : buttons->findChildren<QToolButton *>())
        if (button->accessibleName().startsWith(QStringLiteral("Copy path"))) {
            button->click();
            ++copies;
            EXPECT_TRUE(QApplication::clipboard()->text().startsWith(u'/'));
        }
    EXPECT_EQ(copies, 4);
    EXPECT_EQ(buttons->findChildren<QLineEdit *>().front()->text(), folder.path());
}

} // namespace
} // namespace codewheel
