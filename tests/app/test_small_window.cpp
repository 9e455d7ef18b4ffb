// SPDX-License-Identifier: GPL-3.0-or-later
// 960 x 600 logical pixels are enough for every page and panel, for gloves too.
#include "kinds/esc/line/esc_line_session.h"
#include "language.h"
#include "tests/app/window_test.h"
#include "tests/support/cut_off.h"
#include "widgets/job/cancel_question.h"
#include "widgets/job/known_before_bar.h"
#include "widgets/kinds/esc/line/esc_line_terminal.h"
#include "widgets/kinds/esc/line/request_field.h"
#include "widgets/look/appearance.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/monitor/word_card.h"
#include "widgets/monitor/word_sender.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/parameters/wanted_values.h"
#include "widgets/parameters/write_review.h"
#include "widgets/structure/structure_columns.h"
#include "widgets/structure/structure_model.h"
#include "widgets/structure/structure_view.h"
#include "widgets/structure_editor/structure_editor.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QKeySequence>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QPoint>
#include <QPushButton>
#include <QRect>
#include <QRegion>
#include <QScrollArea>
#include <QScrollBar>
#include <QSize>
#include <QStatusBar>
#include <QTableView>
#include <QTest>
#include <QTreeView>

#include <gtest/gtest.h>
#include <set>

namespace codewheel {
namespace {

constexpr QSize smallest(960, 600); // 1920 x 1200 at 200 %
constexpr int titleBar = 30;        // of a typical desktop, taken from the height

struct Case
{
    const char *name;
    const char *language;
    bool largeControls;
};

void PrintTo(const Case &tested, std::ostream *out)
{
    *out << tested.name;
}

class SmallWindow : public test::WindowTest, public testing::WithParamInterface<Case>
{
protected:
    SmallWindow()
    {
        applyAppearance(*qApp, {.scheme = Scheme::light, .largeControls = GetParam().largeControls});
        language.use(QString::fromLatin1(GetParam().language));
        open(); // in this language
        window().resize(smallest);
        actions().defaultLayout->trigger(); // the one for a low window
        window().resize(smallest);
        advance(50);
    }
    ~SmallWindow() override
    {
        applyAppearance(*qApp, {.scheme = Scheme::light});
        QLocale::setDefault(QLocale::c());
    }

    void startFromItsPage();
    void expectSmall(const QString &what)
    {
        advance(50);
        EXPECT_EQ(window().size(), smallest) << what.toStdString();
        EXPECT_LE(window().minimumSizeHint().width(), smallest.width()) << what.toStdString();
        EXPECT_LE(window().minimumSizeHint().height(), smallest.height() - titleBar) << what.toStdString();
    }
    static void expectWhole(const QWidget &part)
    {
        EXPECT_EQ(part.visibleRegion().boundingRect(), part.rect()) << part.objectName().toStdString();
    }
    // Of the first encoder, in front.
    QDockWidget &parameterPanel()
    {
        window().findChild<StructureView *>()->choose(test::fraba);
        auto &panel = *window().findChild<QDockWidget *>(QStringLiteral("parametersDock"));
        panel.show();
        panel.raise();
        advance(50);
        return panel;
    }

private:
    Language language;
};

void SmallWindow::startFromItsPage()
{
    ringActions().disconnectBus->trigger();
    lineActions().disconnectBus->trigger();
    advance(50);
    auto *terminal = window().findChild<QDockWidget *>(QStringLiteral("terminalDock"));
    terminal->show();
    terminal->raise();
    expectSmall(QStringLiteral("start page"));
    QTest::mouseClick(window().findChild<QPushButton *>(QStringLiteral("startTraining")), Qt::LeftButton);
    EXPECT_TRUE(QTest::qWaitFor([this] { return window().size() == smallest; }))
        << "it may grow for a moment";
    expectSmall(QStringLiteral("training bus"));
}

TEST_P(SmallWindow, HoldsEveryPage)
{
    std::set<const QWidget *> seen;
    for (QAction *action : {actions().monitors, actions().showInTrend, actions().wizard, actions().cams,
                            actions().structureEditor, actions().compare, actions().transfer,
                            actions().replaceEncoder, actions().projectPage}) {
        action->trigger();
        EXPECT_TRUE(seen.insert(page()).second) << action->text().toStdString() << " opens its page";
        expectSmall(action->text());
    }
}

TEST_P(SmallWindow, HoldsEveryPanel)
{
    const auto panels = window().findChildren<QDockWidget *>();
    EXPECT_GE(panels.size(), 8);
    for (auto *panel : panels) {
        panel->show();
        panel->raise();
        expectSmall(panel->windowTitle());
        EXPECT_FALSE(panel->visibleRegion().isEmpty()) << panel->windowTitle().toStdString();
    }
}

// Below a page it is unfolded again.
TEST_P(SmallWindow, HoldsEveryPanelAtTheBottomBelowEveryPage)
{
    for (QAction *action : {actions().monitors, actions().showInTrend, actions().wizard, actions().cams,
                            actions().structureEditor, actions().compare, actions().transfer,
                            actions().replaceEncoder, actions().projectPage}) {
        action->trigger();
        for (auto *panel : window().findChildren<QDockWidget *>())
            if (window().dockWidgetArea(panel) == Qt::BottomDockWidgetArea)
                for (QAction *shows : actions().docks->actions())
                    if (shows->text() == panel->windowTitle()) {
                        shows->trigger();
                        expectSmall(QStringLiteral("%1, %2").arg(action->text(), panel->windowTitle()));
                    }
    }
}

// Whatever panel is open beside or below it.
TEST_P(SmallWindow, LeavesWriteInSight)
{
    for (auto *panel : window().findChildren<QDockWidget *>()) {
        panel->show();
        panel->raise();
        QTest::keyClick(&window(), Qt::Key_1, Qt::ControlModifier); // to the words
        advance(50);
        const auto *card = monitors().card(test::fraba);
        ASSERT_NE(card, nullptr);
        for (auto *button : card->findChildren<QPushButton *>())
            if (button->isVisible() && plainLabel(button->text()) == WordSender::tr("Write")) {
                button->setFocus(Qt::TabFocusReason); // a card of large controls scrolls
                advance(50);
                const QPoint middle = button->mapTo(&window(), button->rect().center());
                EXPECT_EQ(window().childAt(middle), button) << panel->windowTitle().toStdString();
                EXPECT_TRUE(QTest::qWaitFor( // once the panels have settled
                    [&] { return button->visibleRegion().boundingRect() == button->rect(); }))
                    << panel->windowTitle().toStdString();
            }
    }
}

// Rows and notes scroll; what it costs and the buttons stay.
TEST_P(SmallWindow, AReviewShowsTwoRowsWhatItCostsAndItsButtons)
{
    window().findChild<WantedValues *>()->replace(test::fraba,
                                                  {{Parameter::steps, 255},
                                                   {Parameter::revolutions, 1},
                                                   {Parameter::direction, 3},
                                                   {Parameter::preset, 100}},
                                                  QStringLiteral("Test"));
    auto &panel = parameterPanel();
    panel.findChild<QPushButton *>(QStringLiteral("writeParameters"))->click();
    expectSmall(QStringLiteral("review"));
    const auto &review = *panel.findChild<WriteReview *>();
    ASSERT_TRUE(review.isVisible());
    const auto &table = *review.findChild<QTableView *>();
    ASSERT_EQ(table.model()->rowCount(), 4);
    const QRect twoRows(0, 0, table.viewport()->width(), table.rowViewportPosition(1) + table.rowHeight(1));
    EXPECT_TRUE(QRegion(twoRows).subtracted(table.viewport()->visibleRegion()).isEmpty())
        << table.viewport()->visibleRegion().boundingRect().height() << " of " << twoRows.height();
    EXPECT_TRUE(
        review.findChild<QLabel *>(QStringLiteral("eepromCost"))->text().contains(QStringLiteral("200")))
        << "what the manual states";
    for (const char *id : {"eepromCost", "confirmWrite"})
        expectWhole(*review.findChild<QWidget *>(QLatin1String(id)));
    QScrollBar &bar = *review.findChild<QScrollArea *>()->verticalScrollBar();
    for (int at = bar.minimum();; at += bar.pageStep()) {
        bar.setValue(at);
        for (const QString &cut : test::cutOff(panel))
            ADD_FAILURE() << cut.toStdString();
        if (at >= bar.maximum())
            break;
    }
    const auto *count = review.findChild<QWidget *>(QStringLiteral("eepromCount"));
    EXPECT_TRUE(count->visibleRegion().boundingRect().bottom() == count->rect().bottom())
        << "the last of the notes";
}

TEST_P(SmallWindow, TheQuestionHowToCancelShowsItsButtons)
{
    auto &panel = parameterPanel();
    shown->controls().setFault(TrainingFault::slowConfirmation, test::fraba.node, 1);
    EncoderSession &encoder = *bus().encoder(test::fraba);
    encoder.tell(Parameter::startUpMode, 1); // position mode
    ASSERT_TRUE(encoder.start(
        WriteParameters{.values = {{Parameter::steps, 255}, {Parameter::revolutions, 1}}, .previous = {}}));
    bool hasTaken = false;
    const QObject listener;
    QObject::connect(&encoder, &EncoderSession::progressed, &listener,
                     [&](const Progress &progress) { hasTaken = !progress.confirmed.empty(); });
    for (int i = 0; i < 3'000 && !hasTaken; ++i)
        advance(1);
    ASSERT_TRUE(hasTaken);
    panel.findChild<QPushButton *>(QStringLiteral("cancelJob"))->click();
    expectSmall(QStringLiteral("how to cancel"));
    const auto &question = *panel.findChild<CancelQuestion *>();
    ASSERT_TRUE(question.isVisible());
    for (const auto *button : question.findChildren<QPushButton *>())
        if (!GetParam().largeControls || button->hasFocus()) { // others can be scrolled to
            expectWhole(*button);
        }
    for (const QString &cut : test::cutOff(panel))
        ADD_FAILURE() << cut.toStdString();
    const auto *text = question.findChild<QLabel *>();
    EXPECT_GE(text->visibleRegion().boundingRect().height(), 2 * text->fontMetrics().height());
    EXPECT_GE(text->height(), text->heightForWidth(text->width())) << "the rest can be scrolled to";
    question.findChildren<QPushButton *>().last()->click(); // go on
    EXPECT_TRUE(panel.findChild<ParameterTable *>()->isVisible());
}

TEST_P(SmallWindow, TheQuestionBeforeAWriteOnTheLineIsWhole)
{
    auto &terminal = *window().findChild<EscLineTerminal *>();
    auto *dock = window().findChild<QDockWidget *>(QStringLiteral("terminalDock"));
    ASSERT_NE(dock, nullptr);
    dock->show();
    dock->raise();
    shown->line().session()->setOperate(true);
    advance(2'000);
    auto *field = terminal.findChild<RequestField *>();
    field->setFocus();
    field->setText(QStringLiteral("05GP000003E9"));
    QTest::keyClick(field, Qt::Key_Return);
    advance(50);
    expectSmall(QStringLiteral("question of the terminal"));
    const InlineMessage *question = nullptr;
    for (const auto *message : terminal.findChildren<InlineMessage *>())
        if (message->isVisible())
            question = message;
    ASSERT_NE(question, nullptr);
    EXPECT_TRUE(question->sentence().contains(QStringLiteral("1B 30 35 47 50")))
        << question->sentence().toStdString();
    expectWhole(*question);
    for (const QString &cut : test::cutOff(terminal))
        ADD_FAILURE() << cut.toStdString();
    for (const auto *button : question->findChildren<QPushButton *>())
        EXPECT_TRUE(button->isHidden() || button->toolTip().isEmpty() ||
                    Qt::mightBeRichText(button->toolTip()))
            << "it wraps: " << button->toolTip().toStdString();
}

TEST_P(SmallWindow, HoldsTheInsertPanelOfTheStructureEditor)
{
    actions().structureEditor->trigger();
    for (QAction *action : window().findChild<StructureEditor *>()->actions())
        if (action->shortcut() == QKeySequence(Qt::Key_Insert))
            action->trigger();
    auto *search = window().findChild<QLineEdit *>(QStringLiteral("catalogSearch"));
    ASSERT_TRUE(search->isVisible());
    expectSmall(QStringLiteral("insert panel"));
    EXPECT_FALSE(search->visibleRegion().isEmpty()) << "what one opens is in sight";
}

TEST_P(SmallWindow, StaysAsItWasLeftWhenThePagesGiveWayInTheNextRun)
{
    window().saveWindow();
    open();
    startFromItsPage();
}

TEST_P(SmallWindow, StaysAsItIsWhenThePagesGiveWayToAnother)
{
    startFromItsPage();
}

TEST_P(SmallWindow, HoldsTheQuestionWhetherItIsTheSameEncoder)
{
    auto &panel = parameterPanel();
    EncoderSession &encoder = *bus().encoder(test::fraba);
    encoder.setKnownBefore(
        KnownBefore{.values = {{Parameter::steps, 8192, Evidence::read, QDateTime::currentDateTime()},
                               {Parameter::revolutions, 1, Evidence::read, QDateTime::currentDateTime()}}});
    advance(200);
    EXPECT_TRUE(QTest::qWaitFor([this] { return window().size() == smallest; }))
        << "it may grow for a moment";
    expectSmall(QStringLiteral("question"));
    const auto &question = *panel.findChild<KnownBeforeBar *>();
    ASSERT_TRUE(question.isVisible());
    for (const auto *button : question.findChildren<QPushButton *>())
        if (button->isVisible()) {
            expectWhole(*button);
        }
    for (const QString &cut : test::cutOff(panel))
        ADD_FAILURE() << cut.toStdString();
}

TEST_P(SmallWindow, TheNameInTheTreeKeeps16Characters)
{
    auto *tree = window().findChild<QTreeView *>(QStringLiteral("structure"));
    const auto *model = static_cast<const StructureModel *>(tree->model());
    const QFontMetrics font = tree->fontMetrics();
    for (const Place place : shown->buses().places()) {
        QStyleOptionViewItem cell;
        cell.initFrom(tree->viewport());
        cell.rect = tree->visualRect(model->indexOf(place));
        cell.features = QStyleOptionViewItem::HasDecoration | QStyleOptionViewItem::HasDisplay;
        cell.decorationSize = tree->iconSize();
        cell.text = QString(16, u'n');
        const int room = tree->style()->subElementRect(QStyle::SE_ItemViewItemText, &cell, tree).width() -
                         2 * (tree->style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, tree) + 1);
        EXPECT_GE(room, font.horizontalAdvance(QStringLiteral("Kranhubwerk 12AB")))
            << place.shown().toStdString();
        EXPECT_GE(room, widthOfCharacters(font, 16)) << place.shown().toStdString();
    }
    EXPECT_FALSE(tree->isColumnHidden(StructureModel::positionColumn));
}

TEST_P(SmallWindow, TheStatusLineLeavesOutWhatHasNoRoom)
{
    window().findChild<StructureView *>()->choose(placeOnLine({0x05}));
    expectSmall(QStringLiteral("encoder on the serial line"));
    const QRect bar = window().statusBar()->rect();
    int seen = 0;
    for (auto *label : window().statusBar()->findChildren<QLabel *>()) {
        if (!label->isVisible() || label->text().isEmpty() ||
            label->objectName() == QStringLiteral("hint")) // status tips get what is left
            continue;
        ++seen;
        const QRect place(label->mapTo(window().statusBar(), QPoint()), label->size());
        EXPECT_TRUE(bar.contains(place)) << label->text().toStdString();
        EXPECT_GE(label->width(), label->sizeHint().width()) << label->text().toStdString();
    }
    EXPECT_GE(seen, 3);
}

INSTANTIATE_TEST_SUITE_P(Controls, SmallWindow,
                         testing::Values(Case{"Usual", "en", false}, Case{"Large", "en", true},
                                         Case{"UsualGerman", "de", false}, Case{"LargeGerman", "de", true}),
                         [](const auto &tested) { return tested.param.name; });

} // namespace
} // namespace codewheel
