// SPDX-License-Identifier: GPL-3.0-or-later
// The command palette of the window, by its keys.
#include "language.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "tests/support/typed_text.h"
#include "widgets/help/help_window.h"
#include "widgets/look/label_text.h"
#include "widgets/messages/messages_view.h"
#include "widgets/palette/command_palette.h"
#include "widgets/palette/palette_model.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/structure/structure_view.h"
#include "widgets/transfer/transfer_page.h"
#include "widgets/trend/trend_page.h"

#include <QAction>
#include <QApplication>
#include <QLineEdit>
#include <QListView>
#include <QLocale>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QTableView>
#include <QTest>
#include <QToolBar>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class PaletteTest : public test::WindowTest
{
protected:
    CommandPalette &palette() { return *window().findChild<CommandPalette *>(); }
    QListView &list() { return *palette().findChild<QListView *>(); }

    static void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(QApplication::focusWidget(), key, modifiers);
    }
    void openPalette()
    {
        press(Qt::Key_K, Qt::ControlModifier);
        ASSERT_TRUE(palette().isVisible());
        ASSERT_TRUE(QTest::qWaitFor([this] { return palette().isComplete(); }));
    }
    void type(const QString &text)
    {
        openPalette();
        test::typeText(text);
    }
    void run(const QString &text)
    {
        type(text);
        press(Qt::Key_Return);
        EXPECT_FALSE(palette().isVisible()) << text.toStdString();
    }
    QStringList found(const QString &text)
    {
        type(text);
        QStringList titles;
        for (int row = 0; row < list().model()->rowCount(); ++row)
            titles << list().model()->index(row, 0).data().toString();
        press(Qt::Key_Escape);
        return titles;
    }
    // Goes down to the first row whose second line begins so.
    void goToKind(const QString &kind)
    {
        const auto context = [this] {
            return list().currentIndex().data(PaletteModel::contextRole).toString();
        };
        for (int i = 0; i < list().model()->rowCount() && !context().startsWith(kind); ++i)
            press(Qt::Key_Down);
        EXPECT_TRUE(context().startsWith(kind)) << context().toStdString();
    }
    std::optional<Place> chosenPlace() { return window().findChild<StructureView *>()->current(); }
};

TEST_F(PaletteTest, CtrlKFindsAnActionAndReturnTriggersIt)
{
    run(QStringLiteral("trend"));
    EXPECT_NE(qobject_cast<const TrendPage *>(page()), nullptr);
}

// What a user can choose there, menus within menus too.
void listChoices(const QList<QAction *> &actions, std::vector<const QAction *> &choices)
{
    for (const QAction *action : actions)
        if (action->menu() != nullptr)
            listChoices(action->menu()->actions(), choices);
        else if (action->isVisible() && !action->isSeparator())
            choices.push_back(action);
}

TEST_F(PaletteTest, ItFindsEveryActionOfTheMenus)
{
    openPalette();
    press(Qt::Key_Escape);
    std::vector<const QAction *> choices;
    listChoices(window().menuBar()->actions(), choices);
    for (const QAction *action : choices) {
        const QString title = plainLabel(action->text());
        EXPECT_TRUE(found(title).contains(title)) << title.toStdString();
    }
    EXPECT_GT(choices.size(), 70U);
}

TEST_F(PaletteTest, WhatTheMenuDoesNotOfferDoesNotRun)
{
    ASSERT_FALSE(actions().start->isEnabled());
    type(QStringLiteral("start chosen bus"));
    EXPECT_EQ(list().currentIndex().data().toString(), QStringLiteral("Start"));
    EXPECT_TRUE(list()
                    .currentIndex()
                    .data(PaletteModel::contextRole)
                    .toString()
                    .contains(QStringLiteral("not available")));
    int triggered = 0;
    QObject::connect(actions().start, &QAction::triggered, actions().start, [&] { ++triggered; });
    press(Qt::Key_Return);
    EXPECT_EQ(triggered, 0);
    EXPECT_TRUE(palette().isVisible());
}

TEST_F(PaletteTest, AnActionAsksTheSameAsFromItsMenu)
{
    send(test::fraba, 0x0200'00FF);
    const test::Question question([](QWidget &dialog) { dialog.close(); });
    run(QStringLiteral("stop chosen"));
    EXPECT_TRUE(question.wasAsked());
    EXPECT_TRUE(bus().isRunning());
}

TEST_F(PaletteTest, ButtonsOfThePanelsArePressedWhereTheyAre)
{
    window().findChild<StructureView *>()->choose(test::fraba);
    const Word before = out(test::fraba);
    EXPECT_TRUE(found(QStringLiteral("write")).contains(QStringLiteral("Write\u2026")));
    type(QStringLiteral("write parameters"));
    EXPECT_EQ(list().currentIndex().data().toString(), QStringLiteral("Write\u2026"));
    press(Qt::Key_Return);
    advance(50);
    EXPECT_TRUE(window().findChild<QWidget *>(QStringLiteral("parametersDock"))->isVisible());
    EXPECT_EQ(out(test::fraba), before) << "it asks first, as ever";
}

TEST_F(PaletteTest, WordsOfTheFieldLeadToTheirActions)
{
    const std::pair<QString, QString> all[] = {
        {QStringLiteral("modbus"), QStringLiteral("Connection\u2026")},
        {QStringLiteral("no answer"), QStringLiteral("Why is there no data?")},
        {QStringLiteral("baud rate"), QStringLiteral("Who is there?")},
        {QStringLiteral("rights no port"), QStringLiteral("When a link does not work")}};
    for (const auto &[word, title] : all)
        EXPECT_FALSE(found(word).filter(title).isEmpty()) << word.toStdString();
}

// In both languages, whatever that of the window.
TEST_F(PaletteTest, WordsOfTheOtherLanguageFindTheSame)
{
    const std::pair<const char *, QString> all[] = {
        {"german", QStringLiteral("Deutsch")},
        {"sprache", QStringLiteral("Deutsch")},
        {"csv", QStringLiteral("Export messages")},
        {"meldungen exportieren", QStringLiteral("Export messages")}};
    for (const auto &[word, title] : all)
        EXPECT_FALSE(found(QLatin1String(word)).filter(title).isEmpty()) << word;
}

TEST_F(PaletteTest, WhatSetsAPositionIsFoundByAllItsNames)
{
    const auto findsAll = [this](Place place, const QString &title) {
        window().findChild<StructureView *>()->choose(place);
        advance(50);
        for (const char *word : {"preset", "zero", "set position", "nullpunkt", "position setzen"})
            EXPECT_FALSE(found(QLatin1String(word)).filter(title).isEmpty()) << word;
    };
    findsAll(test::fraba, QStringLiteral("FRABA preset"));
    findsAll(shown->buses().places().back(), QStringLiteral("Set the position"));
}

TEST_F(PaletteTest, EachResultSaysWhatReturnWillDo)
{
    type(QStringLiteral("e"));
    const QAbstractItemModel &rows = *list().model();
    ASSERT_GT(rows.rowCount(), 50);
    for (int row = 0; row < rows.rowCount(); ++row) {
        const QString context = rows.index(row, 0).data(PaletteModel::contextRole).toString();
        EXPECT_GE(context.count(u'\u00B7'), 1) << rows.index(row, 0).data().toString().toStdString();
    }
}

TEST_F(PaletteTest, ADeviceIsChosenInTheBusStructure)
{
    actions().trend->trigger();
    type(QStringLiteral("gxp 2.0"));
    goToKind(QStringLiteral("Device"));
    press(Qt::Key_Return);
    EXPECT_EQ(chosenPlace(), test::baumer);
    EXPECT_NE(qobject_cast<const MonitorArea *>(page()), nullptr);
}

TEST_F(PaletteTest, ADeviceIsFoundByItsStation)
{
    shown->project().editDevice(test::baumer, {},
                                [](ProjectDevice &device) { device.station = QStringLiteral("Förderband"); });
    type(QStringLiteral("foerder"));
    press(Qt::Key_Return);
    EXPECT_EQ(chosenPlace(), test::baumer);
}

TEST_F(PaletteTest, AParameterIsShownAndNothingIsSent)
{
    window().findChild<StructureView *>()->choose(test::fraba);
    const Word before = out(test::fraba);
    type(QStringLiteral("zero offset"));
    goToKind(QStringLiteral("Parameter"));
    press(Qt::Key_Return);
    advance(50);
    const auto *table = window().findChild<ParameterTable *>();
    EXPECT_EQ(QApplication::focusWidget(), table);
    EXPECT_EQ(table->currentIndex().siblingAtColumn(ParameterModel::nameColumn).data().toString(),
              QStringLiteral("Zero offset"));
    EXPECT_EQ(out(test::fraba), before);
    EXPECT_FALSE(window().hasJob());
}

TEST_F(PaletteTest, AMessageIsChosenInItsPanel)
{
    send(test::fraba, 0x0200'00FF);
    shown->messages().catchUp();
    send(test::baumer, 0x0400'4E20);
    shown->messages().catchUp();
    type(QStringLiteral("020000FF"));
    goToKind(QStringLiteral("Message"));
    const QString sentence = list().currentIndex().data().toString();
    press(Qt::Key_Return);
    const auto *table = window().findChild<MessagesView *>()->findChild<QTableView *>();
    EXPECT_TRUE(table->isVisible());
    EXPECT_EQ(table->currentIndex().siblingAtColumn(MessageModel::textColumn).data().toString(), sentence);
    EXPECT_TRUE(sentence.contains(QStringLiteral("020000FF")));
}

TEST_F(PaletteTest, AHeadingOfTheManualOpensIt)
{
    run(QStringLiteral("offline and online"));
    const HelpWindow *help = nullptr;
    for (QWidget *each : QApplication::topLevelWidgets())
        if (auto *its = qobject_cast<HelpWindow *>(each))
            help = its;
    ASSERT_NE(help, nullptr);
    EXPECT_EQ(help->shown(), Manual::url(QStringLiteral("project.md#offline-and-online")));
}

TEST_F(PaletteTest, EscGivesTheFocusBack)
{
    press(Qt::Key_3, Qt::AltModifier);
    const QWidget *before = QApplication::focusWidget();
    openPalette();
    EXPECT_NE(QApplication::focusWidget(), before);
    press(Qt::Key_Escape);
    EXPECT_EQ(QApplication::focusWidget(), before);
}

TEST_F(PaletteTest, CtrlKWorksInATextThatHasTheFocusAndLeavesIt)
{
    actions().projectPage->trigger();
    auto *note = const_cast<QWidget *>(page())->findChild<QPlainTextEdit *>();
    note->setFocus();
    test::typeText(QStringLiteral("hoist"));
    note->moveCursor(QTextCursor::Start);
    openPalette();
    press(Qt::Key_Escape);
    EXPECT_EQ(QApplication::focusWidget(), note);
    EXPECT_EQ(note->toPlainText(), QStringLiteral("hoist"));
}

TEST_F(PaletteTest, EscGivesTheFocusBackToATableWhoseCellWasEdited)
{
    window().findChild<StructureView *>()->choose(test::fraba);
    auto *table = window().findChild<ParameterTable *>();
    table->setFocus();
    table->setCurrentIndex(table->model()->index(0, ParameterModel::wantedColumn));
    press(Qt::Key_F2);
    ASSERT_NE(QApplication::focusWidget(), table);
    test::typeText(QStringLiteral("255"));
    openPalette();
    press(Qt::Key_Escape);
    const QWidget *focus = QApplication::focusWidget();
    ASSERT_NE(focus, nullptr);
    EXPECT_TRUE(table == focus || table->isAncestorOf(focus))
        << focus->metaObject()->className() << " " << focus->objectName().toStdString();
}

TEST_F(PaletteTest, AlarmStopWorksWhileItIsOpen)
{
    send(test::fraba, 0x0200'00FF);
    resizeTo({1024, 640});
    openPalette();
    const auto *bar = window().findChild<QToolBar *>(QStringLiteral("busToolBar"));
    EXPECT_FALSE(palette().geometry().intersects(bar->geometry())) << "a click reaches it, too";
    press(Qt::Key_F12, Qt::ControlModifier);
    advance(10);
    EXPECT_EQ(out(test::fraba), 0U);
}

TEST_F(PaletteTest, WhatWasUsedLastIsKept)
{
    run(QStringLiteral("trend"));
    run(QStringLiteral("bus structure"));
    open();
    openPalette();
    EXPECT_EQ(list().model()->index(0, 0).data().toString(), QStringLiteral("Bus structure"));
    EXPECT_EQ(list().model()->index(1, 0).data().toString(), QStringLiteral("Trend"));
}

class GermanPaletteTest : public PaletteTest
{
protected:
    GermanPaletteTest()
    {
        language.use(QStringLiteral("de"));
        open();
    }
    ~GermanPaletteTest() override { QLocale::setDefault(QLocale::c()); }

private:
    Language language;
};

TEST_F(GermanPaletteTest, GermanWordsAreFoundWithAndWithoutUmlauts)
{
    run(QStringLiteral("uebertrag"));
    EXPECT_NE(qobject_cast<const TransferPage *>(page()), nullptr);
    EXPECT_TRUE(found(QStringLiteral("nullpunkt")).contains(QStringLiteral("Nullpunkt-Verschiebung")));
    for (const char *typed : {"zero", "set position", "preset"})
        EXPECT_FALSE(found(QLatin1String(typed)).filter(QStringLiteral("FRABA-Preset")).isEmpty()) << typed;
    EXPECT_FALSE(found(QStringLiteral("german")).filter(QStringLiteral("Deutsch")).isEmpty());
}

TEST_F(GermanPaletteTest, ThePagesOfTheManualAreFoundInGermanAndEnglish)
{
    for (const QString &typed : {QStringLiteral("nocken"), QStringLiteral("cams")})
        EXPECT_TRUE(found(typed).contains(QStringLiteral("Nocken"))) << typed.toStdString();
}

} // namespace
} // namespace codewheel
