// SPDX-License-Identifier: GPL-3.0-or-later
// The common head of all pages: what it says, and how it closes a page, with mouse and keys.
#include "language.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/connect/link_form.h"
#include "widgets/kinds/esc/line/esc_line_settings_form.h"
#include "widgets/look/page.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/structure/structure_view.h"
#include "widgets/structure_editor/structure_editor.h"
#include "widgets/transfer/replace_page.h"
#include "widgets/transfer/transfer_page.h"
#include "widgets/wizard/parameter_wizard.h"

#include <QAbstractScrollArea>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSpinBox>
#include <QToolButton>
#include <QTreeView>

#include <algorithm>

namespace codewheel {
namespace {

using test::baumer;
using test::fraba;

class PagesTest : public test::WindowTest
{
protected:
    QString head(const char *part)
    {
        return window().findChild<QWidget *>(QLatin1String(part))->accessibleName();
    }
    void choose(Place place) { window().findChild<StructureView *>()->choose(place); }
    bool isOpen() { return window().findChild<QWidget *>(QStringLiteral("pageHead"))->isVisible(); }
    void clickClose()
    {
        auto *close = window().findChild<QToolButton *>(QStringLiteral("closePage"));
        ASSERT_TRUE(close->isVisible());
        QTest::mouseClick(close, Qt::LeftButton);
    }
    void press(Qt::Key key) { QTest::keyClick(QApplication::focusWidget(), key); }
    template <typename Widget>
    Widget &find(const char *name)
    {
        return *window().findChild<Widget *>(QLatin1String(name));
    }
    // That writes steps.
    const TransferPage &transferringPage()
    {
        shown->project().editDevice(fraba, QStringLiteral("want"), [](ProjectDevice &device) {
            device.wanted = {{Parameter::steps, 4096}};
        });
        actions().transfer->trigger();
        QTest::mouseClick(&find<QPushButton>("transferBegin"), Qt::LeftButton);
        advance(4);
        return *window().findChild<TransferPage *>();
    }
    // 255 steps, by hand.
    ParameterWizard &toHandshake()
    {
        actions().wizard->trigger();
        auto &wizard = *window().findChild<ParameterWizard *>();
        while (wizard.page() < ParameterWizard::handshake) {
            if (wizard.page() == ParameterWizard::values)
                QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("255"));
            QTest::mouseClick(&find<QPushButton>("wizardNext"), Qt::LeftButton);
        }
        advance(60);
        return wizard;
    }
    QList<QAction *> opening()
    {
        const WindowActions &its = actions();
        return {its.trend,   its.wizard,   its.cams,           its.structureEditor,
                its.compare, its.transfer, its.replaceEncoder, its.projectPage};
    }
};

TEST_F(PagesTest, EachHasAHeadAndIsClosedByMouseAndByKeys)
{
    choose(fraba);
    QList<QAction *> all = opening();
    all << lineActions().settings << lineActions().search << canActions().settings << canActions().search
        << canActions().unnumbered;
    QStringList titles;
    for (QAction *open : all) {
        const std::string name = open->text().toStdString();
        open->trigger();
        EXPECT_TRUE(isOpen()) << name;
        EXPECT_FALSE(head("pageTitle").isEmpty()) << name;
        EXPECT_TRUE(head("pageEffect").endsWith(u'.')) << name;
        titles << head("pageTitle");
        clickClose();
        EXPECT_EQ(page(), &monitors()) << name;
        EXPECT_FALSE(isOpen()) << name;

        open->trigger();
        press(Qt::Key_Escape);
        EXPECT_EQ(page(), &monitors()) << name << " by Esc";
        open->trigger();
        QTest::keyClick(&window(), Qt::Key_W, Qt::ControlModifier);
        EXPECT_EQ(page(), &monitors()) << name << " by Ctrl+W";
    }
    EXPECT_EQ(titles.removeDuplicates(), 0);
    EXPECT_TRUE(titles.contains(QStringLiteral("Cams \u2013 1.0  FRABA OCD-IB K3")))
        << titles.join(u'|').toStdString();
    EXPECT_TRUE(titles.contains(QStringLiteral("Bus structure \u2013 Ring")))
        << titles.join(u'|').toStdString();
    EXPECT_TRUE(bus().isOperating()) << "Ctrl+W closes, and nothing else";
}

// Most people never see most forms, and each of them is some hundred widgets.
TEST_F(PagesTest, AFormOfALinkHasFieldsOnceItIsSeen)
{
    const auto forms = window().findChildren<LinkForm *>();
    const auto made = [&] { return std::ranges::count_if(forms, &LinkForm::hasFields); };
    ASSERT_GE(forms.size(), 5) << "of a ring and a line";
    EXPECT_EQ(made(), 0);
    lineActions().settings->trigger();
    EXPECT_EQ(made(), 1);
    const auto &form = *window().findChild<EscLineSettingsForm *>();
    EXPECT_TRUE(form.hasFields());
    EXPECT_TRUE(form.findChild<QSpinBox *>()->isVisible());
}

TEST_F(PagesTest, APageForTransfersIsMadeWhenItIsFirstOpened)
{
    choose(fraba);
    EXPECT_EQ(window().findChild<TransferPage *>(), nullptr);
    EXPECT_EQ(window().findChild<ReplacePage *>(), nullptr);
    actions().transfer->trigger();
    EXPECT_EQ(page(), window().findChild<TransferPage *>());
    EXPECT_EQ(window().findChild<ReplacePage *>(), nullptr);
    actions().replaceEncoder->trigger();
    EXPECT_EQ(page(), window().findChild<ReplacePage *>());
    actions().transfer->trigger();
    EXPECT_EQ(window().findChildren<TransferPage *>().size(), 1) << "once";
}

TEST_F(PagesTest, TheCamEditorIsMadeWhenItIsFirstOpenedForTheEncoderThatIsChosen)
{
    choose(fraba);
    EXPECT_EQ(window().findChild<CamEditor *>(), nullptr);
    actions().cams->trigger();
    const auto *cams = window().findChild<CamEditor *>();
    ASSERT_EQ(page(), cams);
    EXPECT_TRUE(cams->about().contains(fraba.shown())) << cams->about().toStdString();
    EXPECT_EQ(window().findChildren<CamEditor *>().size(), 1);
}

TEST_F(PagesTest, TheWizardIsMadeWhenItIsFirstOpenedForTheEncoderThatIsChosen)
{
    choose(fraba);
    choose(baumer);
    EXPECT_EQ(window().findChild<ParameterWizard *>(), nullptr);
    actions().wizard->trigger();
    const auto *wizard = window().findChild<ParameterWizard *>();
    ASSERT_EQ(page(), wizard);
    EXPECT_EQ(wizard->encoder()->place(), baumer);
    EXPECT_TRUE(find<QWidget>("encoders").hasFocus());
    actions().monitors->trigger();
    choose(fraba);
    EXPECT_EQ(wizard->encoder()->place(), fraba);
    EXPECT_EQ(window().findChildren<ParameterWizard *>().size(), 1);
}

TEST_F(PagesTest, WithoutAPageTheKeysDoNothing)
{
    QTest::keyClick(&window(), Qt::Key_W, Qt::ControlModifier);
    QTest::keyClick(&window(), Qt::Key_Escape);
    EXPECT_EQ(page(), &monitors());
    EXPECT_TRUE(bus().isOperating());
    EXPECT_FALSE(actions().closePage->isEnabled());
}

TEST_F(PagesTest, TheStationStandsInTheHead)
{
    choose(fraba);
    shown->project().editDevice(fraba, QStringLiteral("name"),
                                [](ProjectDevice &device) { device.station = QStringLiteral("Hoist"); });
    for (QAction *open : {actions().wizard, actions().cams, actions().replaceEncoder}) {
        open->trigger();
        EXPECT_TRUE(head("pageTitle").endsWith(QStringLiteral("1.0  Hoist  FRABA OCD-IB K3")))
            << head("pageTitle").toStdString();
    }
}

TEST_F(PagesTest, EscIsForTheFieldFirst)
{
    actions().projectPage->trigger();
    auto &title = find<QLineEdit>("projectTitle");
    title.setFocus();
    QTest::keyClicks(&title, QStringLiteral("Crane"));
    press(Qt::Key_Escape);
    EXPECT_TRUE(isOpen());
    EXPECT_TRUE(title.text().isEmpty());
    press(Qt::Key_Escape);
    EXPECT_FALSE(isOpen());
    EXPECT_TRUE(shown->project().project().title.isEmpty());
}

TEST_F(PagesTest, WhatIsTypedIsTakenWhenThePageIsClosed)
{
    actions().projectPage->trigger();
    auto &title = find<QLineEdit>("projectTitle");
    title.setFocus();
    QTest::keyClicks(&title, QStringLiteral("Crane"));
    clickClose();
    EXPECT_FALSE(isOpen());
    EXPECT_EQ(shown->project().project().title, QStringLiteral("Crane"));
}

TEST_F(PagesTest, EscEndsTheFieldOfACellBeforeThePage)
{
    choose(fraba);
    actions().structureEditor->trigger();
    auto &tree = find<QTreeView>("plan");
    QModelIndex cell = tree.currentIndex();
    while (!cell.flags().testFlag(Qt::ItemIsEditable))
        cell = cell.siblingAtColumn(cell.column() + 1);
    tree.edit(cell);
    ASSERT_NE(QApplication::focusWidget(), &tree);
    press(Qt::Key_Escape);
    EXPECT_TRUE(isOpen());
    EXPECT_EQ(QApplication::focusWidget(), &tree);
    press(Qt::Key_Escape);
    EXPECT_FALSE(isOpen());
}

TEST_F(PagesTest, EscClosesAListBeforeThePage)
{
    actions().transfer->trigger();
    auto *what = window().findChild<TransferPage *>()->findChild<QComboBox *>();
    what->showPopup();
    ASSERT_NE(QApplication::activePopupWidget(), nullptr);
    QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Escape);
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
    EXPECT_TRUE(isOpen());
}

TEST_F(PagesTest, WhatIsRefusedIsAskedAbout)
{
    lineActions().settings->trigger();
    auto &form = *window().findChild<EscLineSettingsForm *>();
    const EscLineSettings before = form.settings();
    auto *number = form.findChild<QSpinBox *>();
    number->setFocus();
    number->selectAll();
    QTest::keyClicks(number, QStringLiteral("999999"));
    {
        const auto question = test::Question::answeredBy(QStringLiteral("Stay"));
        clickClose();
        EXPECT_TRUE(isOpen());
        EXPECT_TRUE(question.text().contains(QStringLiteral("will be discarded")))
            << question.text().toStdString();
    }
    const auto question = test::Question::answeredBy(QStringLiteral("Close the page"));
    clickClose();
    EXPECT_FALSE(isOpen());
    EXPECT_EQ(form.settings(), before);
    EXPECT_FALSE(number->text().contains(QStringLiteral("999999"))) << number->text().toStdString();
}

TEST_F(PagesTest, TheWizardAsksBeforeItTakesBackWhatWasSet)
{
    choose(fraba);
    actions().wizard->trigger();
    auto &wizard = *window().findChild<ParameterWizard *>();
    auto &next = find<QPushButton>("wizardNext");
    const ProjectDevice before = shown->project().device(fraba);
    while (wizard.page() != ParameterWizard::values)
        QTest::mouseClick(&next, Qt::LeftButton);
    for (const auto &[name, value] : {std::pair("steps", "255"), std::pair("revolutions", "1")}) {
        const auto fields = wizard.findChildren<QLineEdit *>(QLatin1String(name));
        QLineEdit &field = **std::ranges::find_if(fields, &QWidget::isVisible);
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, QLatin1String(value));
    }
    QTest::mouseClick(&next, Qt::LeftButton);
    ASSERT_EQ(wizard.page(), ParameterWizard::review);
    {
        const auto question = test::Question::answeredBy(QStringLiteral("Stay"));
        press(Qt::Key_Escape);
        EXPECT_TRUE(question.text().contains(QStringLiteral("Steps"))) << question.text().toStdString();
    }
    EXPECT_EQ(wizard.page(), ParameterWizard::review);
    actions().monitors->trigger();
    actions().wizard->trigger();
    EXPECT_EQ(wizard.page(), ParameterWizard::review) << "monitors were looked at meanwhile";
    const auto question = test::Question::answeredBy(QStringLiteral("Close the page"));
    clickClose();
    EXPECT_EQ(page(), &monitors());
    EXPECT_EQ(wizard.page(), ParameterWizard::device);
    EXPECT_EQ(shown->project().device(fraba).wanted, before.wanted);
}

// In the whole window: what is read, set and drawn beside the wizard is of the same encoder.
TEST_F(PagesTest, AnEncoderChosenInTheWizardIsChosenInTheStructureToo)
{
    choose(fraba);
    actions().wizard->trigger();
    auto &wizard = *window().findChild<ParameterWizard *>();
    const auto &structure = *window().findChild<StructureView *>();
    press(Qt::Key_Down);
    ASSERT_EQ(wizard.encoder()->place(), baumer);
    EXPECT_EQ(structure.current(), baumer);
    const auto &parameters = *window().findChild<ParameterTable *>()->model();
    EXPECT_EQ(parameters.match(parameters.index(0, 0), Qt::DisplayRole, QStringLiteral("Coding")).size(), 1)
        << "the panel beside it shows that of a Baumer encoder";
    EXPECT_TRUE(find<QWidget>("encoders").hasFocus()) << "keys go on there";
    QTest::mouseClick(&find<QPushButton>("wizardNext"), Qt::LeftButton);
    clickClose();
    EXPECT_EQ(structure.current(), baumer);
    actions().wizard->trigger();
    EXPECT_EQ(wizard.encoder()->place(), baumer);
}

TEST_F(PagesTest, TheWizardBeginsWithTheEncoderThatIsChosenThen)
{
    choose(fraba);
    actions().wizard->trigger();
    auto &wizard = *window().findChild<ParameterWizard *>();
    QTest::mouseClick(&find<QPushButton>("wizardNext"), Qt::LeftButton);
    choose(baumer);
    EXPECT_EQ(wizard.encoder()->place(), fraba) << "it stays with its encoder";
    clickClose();
    actions().wizard->trigger();
    EXPECT_EQ(wizard.page(), ParameterWizard::device);
    EXPECT_EQ(wizard.encoder()->place(), baumer);
}

TEST_F(PagesTest, AHandshakeIsNotLeftWithoutAWord)
{
    choose(fraba);
    auto &wizard = toHandshake();
    QTest::mouseClick(&find<QPushButton>("nextStep"), Qt::LeftButton);
    advance(60);
    {
        const auto question = test::Question::answeredBy(QStringLiteral("Stay"));
        press(Qt::Key_Escape);
        EXPECT_TRUE(question.text().contains(QStringLiteral("the encoder may give no position")))
            << question.text().toStdString();
    }
    EXPECT_EQ(page(), &wizard);
    {
        const auto question = test::Question::answeredBy(QStringLiteral("Close the page"));
        clickClose();
        EXPECT_TRUE(question.wasAsked());
    }
    EXPECT_EQ(page(), &monitors());
    actions().wizard->trigger();
    EXPECT_EQ(wizard.page(), ParameterWizard::handshake);
    EXPECT_TRUE(wizard.isBusy());
}

class PagesInLanguage : public PagesTest, public testing::WithParamInterface<const char *>
{
protected:
    PagesInLanguage()
    {
        language.use(QLatin1String(GetParam()));
        open();
        resizeTo({1024, 640});
    }
    ~PagesInLanguage() override { QLocale::setDefault(QLocale::c()); }

private:
    Language language;
};

TEST_P(PagesInLanguage, AHandshakeDoesNotScrollSidewaysInASmallWindow)
{
    choose(fraba);
    auto &wizard = toHandshake();
    auto &next = find<QPushButton>("nextStep");
    for (int step = 0; wizard.isBusy() && step < 20; ++step) {
        for (int i = 0; i < 10; ++i)
            QCoreApplication::processEvents();
        for (const auto *area : wizard.findChildren<QAbstractScrollArea *>())
            EXPECT_FALSE(area->isVisible() && area->horizontalScrollBar()->isVisible())
                << area->objectName().toStdString() << " at step " << step;
        if (next.isEnabled())
            QTest::mouseClick(&next, Qt::LeftButton);
        advance(60);
    }
    EXPECT_FALSE(wizard.isBusy());
}

INSTANTIATE_TEST_SUITE_P(, PagesInLanguage, testing::Values("en", "de"));

TEST_F(PagesTest, AReplacementThatHasBegunIsAskedAbout)
{
    choose(fraba);
    actions().replaceEncoder->trigger();
    QTest::mouseClick(&find<QPushButton>("replaceNext"), Qt::LeftButton);
    const auto question = test::Question::answeredBy(QStringLiteral("Close the page"));
    press(Qt::Key_Escape);
    EXPECT_TRUE(question.wasAsked());
    EXPECT_EQ(page(), &monitors());
}

TEST_F(PagesTest, AJobOfAPageThatIsClosedGoesOn)
{
    const TransferPage &transfer = transferringPage();
    ASSERT_TRUE(transfer.isBusy());
    const auto question = test::Question::answeredBy(QStringLiteral("Close the page"));
    press(Qt::Key_Escape);
    EXPECT_TRUE(question.text().contains(QStringLiteral("only Cancel ends it")))
        << question.text().toStdString();
    EXPECT_EQ(page(), &monitors());
    EXPECT_TRUE(transfer.isBusy());
    advance(500);
    EXPECT_FALSE(transfer.isBusy());
    EXPECT_EQ(bus().encoder(fraba)->known(Parameter::steps)->value, 4096);
}

// The result is shown by then, and was not asked about.
TEST_F(PagesTest, AQuestionWhoseReasonHasGoneClosesNothing)
{
    const TransferPage &transfer = transferringPage();
    ASSERT_TRUE(transfer.isBusy());
    const test::Question question([&](QWidget &box) {
        advance(500);
        EXPECT_FALSE(transfer.isBusy());
        for (auto *button : box.findChildren<QPushButton *>())
            if (button->text().remove(u'&') == QStringLiteral("Close the page"))
                QTest::mouseClick(button, Qt::LeftButton);
    });
    press(Qt::Key_Escape);
    EXPECT_TRUE(question.wasAsked());
    EXPECT_EQ(page(), &transfer);
}

} // namespace
} // namespace codewheel
