// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/known_keeper.h"
#include "tests/widgets/transfer/transfer_test.h"
#include "vocabulary/refusal_text.h"
#include "widgets/look/inline_message.h"
#include "widgets/transfer/replace_page.h"
#include "widgets/transfer/replace_position_step.h"

#include <QApplication>
#include <QComboBox>
#include <QPushButton>
#include <QRadioButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>

namespace codewheel {
namespace {

using test::fraba;

class ReplacePageTest : public test::TransferTest
{
protected:
    ReplacePageTest()
    {
        QObject::connect(&page, &ReplacePage::messaged, &page, [this](const Message &message) {
            messages << messageText(message);
            told.push_back(message.place);
        });
        project.editDevice(fraba, QStringLiteral("plan"), [](ProjectDevice &device) {
            device.wanted = {{Parameter::steps, 4096}, {Parameter::revolutions, 1}};
            device.label.serialNumber = QStringLiteral("20417");
        });
        show(page);
        pass(200);
    }
    void pass(int milliseconds)
    {
        for (int i = 0; i < milliseconds / 33 + 1; ++i)
            session.bus.advance(33);
    }
    // Swaps the encoder for another one, whose shaft is in a different position.
    void exchange()
    {
        session.controls->setFault(TrainingFault::powerOff, fraba.node, 1);
        pass(2000);
        session.controls->turnBy(fraba.node, 1000);
        session.controls->setFault(TrainingFault::powerOff, fraba.node, 0);
        pass(500);
    }

    void writeLeavingThePosition()
    {
        page.replace(fraba);
        click("replaceNext");
        find<QRadioButton>("positionNone")->setChecked(true);
        click("replaceNext");
        click("replaceNext");
    }

    QStringList messages;
    std::vector<std::optional<Place>> told; // of which place each is
    LastPositions positions{session.buses};
    ReplacePage page{session.buses, session.catalog, project, positions};
};

TEST_F(ReplacePageTest, TheTechniciansNight)
{
    const auto before = session.encoder(fraba).latest().position;
    ASSERT_TRUE(before);
    exchange();
    page.replace(fraba);
    EXPECT_EQ(text("replaceDifferences"),
              QStringLiteral("It fits: as far as the project shows, it is like the previous one."));
    type("replaceSerial", "4711");
    click("replaceNext");
    EXPECT_TRUE(find<QRadioButton>("positionLast")->isChecked());
    EXPECT_TRUE(
        find<QRadioButton>("positionLast")->text().contains(QStringLiteral("before the encoder went away")));
    click("replaceNext");
    EXPECT_TRUE(text("replaceNote").startsWith(QStringLiteral("Values and cam programs to write: 2.")));
    click("replaceNext");
    advanceWhileBusy(page);
    EXPECT_EQ(text("replaceResult"), QStringLiteral("Done."));
    EXPECT_EQ(session.encoder(fraba).latest().position, before);
    EXPECT_EQ(session.encoder(fraba).known(Parameter::steps)->value, 4096);
    EXPECT_EQ(project.device(fraba).label.serialNumber, QStringLiteral("4711"));
    EXPECT_EQ(messages.front(),
              QStringLiteral("The encoder was replaced (serial number before: 20417, now: 4711)."));
    EXPECT_TRUE(account().startsWith(QStringLiteral("Encoder replaced")));
}

TEST_F(ReplacePageTest, AnEncoderThatNoProjectHasIsNamedAsOnTheBus)
{
    project.setProject({}, {});
    page.replace(fraba);
    const QString name = session.encoder(fraba).device().fullName();
    EXPECT_TRUE(page.about().contains(name)) << page.about().toStdString();
    const auto texts = page.findChildren<QLabel *>();
    EXPECT_TRUE(std::ranges::any_of(texts, [&](const QLabel *each) {
        return each->text().contains(QStringLiteral("the bus has: ") + name);
    }));
}

TEST_F(ReplacePageTest, TheSecondOfTwoQuickPressesDoesNotWrite)
{
    page.replace(fraba);
    click("replaceNext");
    find<QRadioButton>("positionNone")->setChecked(true);
    QApplication::setDoubleClickInterval(10 * 60 * 1'000);
    click("replaceNext");
    click("replaceNext");
    EXPECT_FALSE(page.isBusy());
    EXPECT_TRUE(messages.isEmpty());
    QApplication::setDoubleClickInterval(0);
    click("replaceNext");
    EXPECT_TRUE(page.isBusy());
    advanceWhileBusy(page);
}

// What was given for the new encoder is in the project by then: an empty field would take it out again.
TEST_F(ReplacePageTest, ASecondTryBeginsWithWhatWasGivenInTheFirst)
{
    const auto begin = [this] {
        page.replace(fraba);
        const QString serial = find<QLineEdit>("replaceSerial")->text();
        type("replaceSerial", "4711");
        click("replaceNext");
        find<QRadioButton>("positionNone")->setChecked(true);
        click("replaceNext");
        click("replaceNext");
        return serial;
    };
    EXPECT_EQ(begin(), QString());
    click("cancelJob");
    advanceWhileBusy(page);
    ASSERT_NE(text("replaceResult"), QStringLiteral("Done."));
    EXPECT_EQ(begin(), QStringLiteral("4711"));
    advanceWhileBusy(page);
    EXPECT_EQ(text("replaceResult"), QStringLiteral("Done."));
    EXPECT_EQ(begin(), QString()) << "another replacement";
    advanceWhileBusy(page);
}

TEST_F(ReplacePageTest, AfterAFailureItIsRepeatedFromItsPage)
{
    page.replace(fraba);
    type("replaceSerial", "4711");
    click("replaceNext");
    find<QRadioButton>("positionNone")->setChecked(true);
    click("replaceNext");
    click("replaceNext");
    click("cancelJob");
    advanceWhileBusy(page);
    ASSERT_NE(text("replaceResult"), QStringLiteral("Done."));
    click("replaceBack");
    EXPECT_EQ(find<QLineEdit>("replaceSerial")->text(), QStringLiteral("4711"));
    click("replaceNext");
    find<QRadioButton>("positionNone")->setChecked(true);
    click("replaceNext");
    click("replaceNext");
    advanceWhileBusy(page);
    ASSERT_EQ(text("replaceResult"), QStringLiteral("Done."));
    EXPECT_FALSE(find<QPushButton>("replaceBack")->isEnabled()) << "nothing is left to be done";
}

TEST_F(ReplacePageTest, SaysWhereValuesThatAreMissingAreEntered)
{
    project.editDevice(fraba, QStringLiteral("plan"), [](ProjectDevice &device) { device.wanted = {}; });
    page.replace(fraba);
    click("replaceNext");
    find<QRadioButton>("positionNone")->setChecked(true);
    click("replaceNext");
    EXPECT_TRUE(text("replaceNote").contains(QStringLiteral("enter them in the panel Parameters first.")));
}

// It would refuse it, with the scale written.
TEST_F(ReplacePageTest, APositionBeyondTheWantedRangeIsRefusedBeforeAnythingIsWritten)
{
    project.editDevice(fraba, QStringLiteral("plan"), [](ProjectDevice &device) {
        device.wanted = {{Parameter::steps, 8'192}, {Parameter::revolutions, 4'096}};
    });
    page.replace(fraba);
    click("replaceNext");
    type("positionValue", "8192");
    click("replaceNext");
    EXPECT_EQ(page.title(), QStringLiteral("Replace encoder 2/4"));
    const QString said = page.findChild<ReplacePositionStep *>()->findChild<InlineMessage *>()->sentence();
    EXPECT_TRUE(said.contains(QStringLiteral("8191"))) << said.toStdString();
    type("positionValue", "8191");
    click("replaceNext");
    EXPECT_EQ(page.title(), QStringLiteral("Replace encoder 3/4"));
}

// The panel beside it goes on changing what is wanted.
TEST_F(ReplacePageTest, OtherWantedValuesAskForThePositionOnceMore)
{
    const auto want = [this](std::int64_t steps, std::int64_t revolutions) {
        project.editDevice(fraba, QStringLiteral("plan"), [&](ProjectDevice &device) {
            device.wanted = {{Parameter::steps, steps}, {Parameter::revolutions, revolutions}};
        });
    };
    const auto said = [this] {
        return page.findChild<ReplacePositionStep *>()->findChild<InlineMessage *>()->sentence();
    };
    want(8'192, 4'096);
    exchange();
    page.replace(fraba);
    click("replaceNext");
    type("positionValue", "4000");
    click("replaceNext");
    ASSERT_EQ(page.title(), QStringLiteral("Replace encoder 3/4"));
    project.editDevice(fraba, QStringLiteral("station"),
                       [](ProjectDevice &device) { device.station = QStringLiteral("Lift"); });
    EXPECT_EQ(page.title(), QStringLiteral("Replace encoder 3/4"));
    want(4'096, 4'096);
    EXPECT_EQ(page.title(), QStringLiteral("Replace encoder 2/4")) << "with these it is another place";
    EXPECT_TRUE(said().contains(QStringLiteral("once more"))) << said().toStdString();
    click("replaceNext");
    ASSERT_EQ(page.title(), QStringLiteral("Replace encoder 3/4"));
    want(2'048, 4'096);
    EXPECT_EQ(page.title(), QStringLiteral("Replace encoder 2/4"));
    click("replaceNext");
    EXPECT_EQ(page.title(), QStringLiteral("Replace encoder 2/4")) << "it is beyond the range";
}

// Esc is no Cancel. What came of it is shown when the page is opened again.
TEST_F(ReplacePageTest, WhileItIsWrittenClosingIsAskedAboutAndTheResultWaits)
{
    writeLeavingThePosition();
    ASSERT_TRUE(page.isBusy());
    EXPECT_TRUE(page.lostByClosing().contains(QStringLiteral("only Cancel ends it")));
    page.hide();
    page.leave();
    advanceWhileBusy(page);
    page.replace(fraba);
    page.show();
    EXPECT_EQ(page.title(), QStringLiteral("Replace encoder 4/4"));
    EXPECT_EQ(text("replaceResult"), QStringLiteral("Done."));
    page.replace(fraba);
    EXPECT_EQ(page.title(), QStringLiteral("Replace encoder 1/4")) << "it was seen";
}

// The new encoder is away once more, or died as well: the technician says which of the two is replaced.
TEST_F(ReplacePageTest, InASecondLossThePositionBeforeTheFirstIsOfferedAndNoneIsPreselected)
{
    const auto before = session.encoder(fraba).latest().position;
    exchange();
    const auto since = session.encoder(fraba).latest().position;
    ASSERT_TRUE(before && since);
    const auto offers = [this](const char *button, std::int64_t position) {
        const QString text = find<QRadioButton>(button)->text();
        EXPECT_TRUE(text.contains(QLocale().toString(qlonglong{position}))) << text.toStdString();
    };
    const auto open = [&] {
        page.replace(fraba);
        click("replaceNext");
        offers("positionLast", *before);
        offers("positionNewest", *since);
    };
    session.controls->setFault(TrainingFault::powerOff, fraba.node, 1);
    pass(3000);
    open();
    EXPECT_TRUE(find<QRadioButton>("positionTyped")->isChecked());
    session.controls->setFault(TrainingFault::powerOff, fraba.node, 0);
    pass(500);
    open();
    EXPECT_TRUE(find<QRadioButton>("positionLast")->isChecked());
}

// The technician says which of the two encoders showed it.
TEST_F(ReplacePageTest, ThePositionSinceThenIsOfferedToo)
{
    exchange();
    const auto since = session.encoder(fraba).latest().position;
    ASSERT_TRUE(since);
    page.replace(fraba);
    type("replaceSerial", "4711");
    click("replaceNext");
    auto *newest = find<QRadioButton>("positionNewest");
    ASSERT_TRUE(newest->isVisible());
    EXPECT_TRUE(newest->text().contains(QLocale().toString(qlonglong{*since})))
        << newest->text().toStdString();
    newest->click();
    click("replaceNext");
    click("replaceNext");
    advanceWhileBusy(page);
    EXPECT_EQ(text("replaceResult"), QStringLiteral("Done."));
    EXPECT_EQ(session.encoder(fraba).latest().position, since);
}

// Another encoder may have been there then, but this one shows a position and was never away.
TEST_F(ReplacePageTest, NothingOfThePastIsPreselectedAfterAPauseOfTheComputer)
{
    for (const int milliseconds : {3'000, 60'000}) {
        session.bus.advance(milliseconds);
        pass(200);
        page.replace(fraba);
        click("replaceNext");
        EXPECT_TRUE(find<QRadioButton>("positionTyped")->isChecked());
        EXPECT_FALSE(find<QRadioButton>("positionLast")
                         ->text()
                         .contains(QStringLiteral("before the encoder went away")));
    }
    EXPECT_TRUE(find<QRadioButton>("positionLast")->text().contains(QStringLiteral("nobody saw")));
}

// It was chosen under another sentence.
TEST_F(ReplacePageTest, AStopIsFollowedWhileThePositionsAreShown)
{
    page.replace(fraba);
    click("replaceNext");
    auto *last = find<QRadioButton>("positionLast");
    EXPECT_TRUE(last->text().contains(QStringLiteral("not away since")));
    click("positionLast");
    session.bus.setRunning(false);
    pass(500);
    EXPECT_TRUE(last->text().contains(QStringLiteral("nobody saw"))) << last->text().toStdString();
    EXPECT_FALSE(last->isChecked());
    session.controls->turnBy(fraba.node, 1000);
    session.bus.setRunning(true);
    pass(500);
    EXPECT_TRUE(last->text().contains(QStringLiteral("nobody saw"))) << last->text().toStdString();
    auto *newest = find<QRadioButton>("positionNewest");
    EXPECT_TRUE(newest->isVisible());
    EXPECT_TRUE(
        newest->text().contains(QLocale().toString(qlonglong{*session.encoder(fraba).latest().position})))
        << newest->text().toStdString();
    click("replaceNext");
    EXPECT_TRUE(last->isVisible()) << "nothing is chosen";
    const QString said = page.findChild<ReplacePositionStep *>()->findChild<InlineMessage *>()->sentence();
    EXPECT_TRUE(said.contains(QStringLiteral("The bus was stopped"))) << said.toStdString();

    click("positionNewest");
    session.bus.setRunning(false);
    pass(500);
    EXPECT_FALSE(newest->isChecked());
}

TEST_F(ReplacePageTest, TheKeyOfTheTypedPositionLeadsToItsNumber)
{
    page.replace(fraba);
    click("replaceNext");
    find<QRadioButton>("positionNone")->setChecked(true);
    find<QRadioButton>("positionNone")->setFocus();
    QTest::keyClick(&page, Qt::Key_S, Qt::AltModifier);
    EXPECT_TRUE(find<QRadioButton>("positionTyped")->isChecked());
    EXPECT_TRUE(find<QLineEdit>("positionValue")->hasFocus());
}

TEST_F(ReplacePageTest, WhileItWritesThereIsOneCancel)
{
    writeLeavingThePosition();
    EXPECT_FALSE(find<QAbstractButton>("replaceCancel")->isVisible());
    EXPECT_TRUE(find<QAbstractButton>("cancelJob")->isVisible());
    advanceWhileBusy(page);
}

TEST_F(ReplacePageTest, OfAnEncoderThatTheProjectDoesNotNameNothingIsSaidToFit)
{
    project.editDevice(fraba, QStringLiteral("plan"),
                       [](ProjectDevice &device) { device.participant.deviceKey.clear(); });
    page.replace(fraba);
    EXPECT_TRUE(text("replaceDifferences").startsWith(QStringLiteral("The project does not say which")))
        << text("replaceDifferences").toStdString();
}

TEST_F(ReplacePageTest, TheResultSaysThatTheEncoderWasLeftInCamMode)
{
    project.editDevice(fraba, QStringLiteral("plan"), [](ProjectDevice &device) {
        device.wanted.clear();
        device.wantedCams = {CamProgram{}};
    });
    writeLeavingThePosition();
    for (int i = 0; i < 300 && session.encoder(fraba).latest().mode != Mode::cam; ++i)
        session.bus.advance(1);
    ASSERT_EQ(session.encoder(fraba).latest().mode, Mode::cam);
    session.bus.alarmStop();
    pass(200);
    EXPECT_TRUE(text("replaceResult").contains(QStringLiteral("was left in cam mode, program 1")))
        << text("replaceResult").toStdString();
    EXPECT_TRUE(account().contains(QStringLiteral("left in cam mode, program 1"))) << account().toStdString();
}

TEST_F(ReplacePageTest, APositionFromBeforeAnotherScaleIsNotPreselected)
{
    session.encoder(fraba).tell(Parameter::steps, 300);
    pass(100);
    exchange();
    ASSERT_TRUE(
        session.encoder(fraba).start(WriteParameters{.values = {{Parameter::steps, 2048}}, .previous = {}}));
    pass(2000);
    page.replace(fraba);
    click("replaceNext");
    EXPECT_TRUE(find<QRadioButton>("positionTyped")->isChecked());
    EXPECT_TRUE(find<QRadioButton>("positionLast")->text().contains(QStringLiteral("scaled otherwise")));
}

// What is written to the new encoder makes another position of it.
TEST_F(ReplacePageTest, APositionOfAnotherScaleThanTheWantedOneIsNotPreselected)
{
    session.encoder(fraba).tell(Parameter::steps, 8'192);
    pass(100);
    exchange();
    page.replace(fraba);
    click("replaceNext");
    EXPECT_TRUE(find<QRadioButton>("positionTyped")->isChecked());
    EXPECT_TRUE(
        find<QRadioButton>("positionLast")->text().contains(QStringLiteral("another scale than the wanted")))
        << find<QRadioButton>("positionLast")->text().toStdString();
}

// Nothing known of the old encoder is taken for the new one's, and nothing is forgotten before Write.
TEST_F(ReplacePageTest, WhatIsKnownIsForgottenWhenWritingBegins)
{
    KnownKeeper keeper;
    keeper.watch(session.bus);
    session.encoder(fraba).tell(Parameter::steps, 4096);
    session.encoder(fraba).tell(Parameter::zeroOffset, 12);
    pass(100);
    const auto position = session.encoder(fraba).latest().position;
    ASSERT_TRUE(position);
    page.replace(fraba);
    type("replaceSerial", "555");
    click("replaceNext");
    find<QRadioButton>("positionNone")->setChecked(true);
    click("replaceNext");
    pass(100);
    EXPECT_TRUE(text("replaceNote").startsWith(QStringLiteral("Values and cam programs to write: 2.")));
    EXPECT_EQ(session.encoder(fraba).latest().position, position) << "the mode is still known";
    EXPECT_TRUE(session.encoder(fraba).known(Parameter::zeroOffset));
    click("replaceNext");
    EXPECT_FALSE(session.encoder(fraba).known(Parameter::zeroOffset));
    EXPECT_FALSE(session.encoder(fraba).knownBefore());
    advanceWhileBusy(page);
    EXPECT_EQ(text("replaceResult"), QStringLiteral("Done."));
    EXPECT_EQ(session.encoder(fraba).known(Parameter::steps)->evidence, Evidence::read);
}

TEST_F(ReplacePageTest, AnEncoderThatHasLostItsParametersGetsAllOfThem)
{
    want(fraba, {{Parameter::steps, 4096},
                 {Parameter::revolutions, 1},
                 {Parameter::direction, 3},
                 {Parameter::preset, 100}});
    page.replace(fraba);
    click("replaceNext");
    find<QRadioButton>("positionNone")->setChecked(true);
    click("replaceNext");
    session.controls->setFault(TrainingFault::parametersLost, fraba.node, 1); // while the plan is read
    pass(100);
    click("replaceNext");
    advanceWhileBusy(page);
    EXPECT_EQ(text("replaceResult"), QStringLiteral("Done."));
    EXPECT_EQ(session.encoder(fraba).latest().state, EncoderState::operation);
}

TEST_F(ReplacePageTest, OfOneThatHasLostItsParametersItSaysWhereMissingValuesAreEntered)
{
    want(fraba, {{Parameter::steps, 4096}});
    session.controls->setFault(TrainingFault::parametersLost, fraba.node, 1);
    pass(100);
    page.replace(fraba);
    click("replaceNext");
    find<QRadioButton>("positionNone")->setChecked(true);
    click("replaceNext");
    EXPECT_TRUE(text("replaceNote").contains(QStringLiteral("Without a value: ")))
        << text("replaceNote").toStdString();
    EXPECT_TRUE(text("replaceNote").contains(QStringLiteral("enter them in the panel Parameters first.")));
}

TEST_F(ReplacePageTest, APositionCanBeTypedOrLeft)
{
    page.replace(fraba);
    click("replaceNext");
    EXPECT_TRUE(find<QRadioButton>("positionTyped")->isChecked()); // it was never away
    click("replaceNext");
    EXPECT_EQ(page.title(), QStringLiteral("Replace encoder 2/4"));
    type("positionValue", "3000");
    click("replaceNext");
    click("replaceNext");
    advanceWhileBusy(page);
    EXPECT_EQ(session.encoder(fraba).latest().position, 3000);
}

TEST_F(ReplacePageTest, APositionWithDecimalsOrOfTwoMeaningsIsRefused)
{
    QLocale::setDefault(QLocale(QLocale::German));
    page.replace(fraba);
    click("replaceNext");
    click("replaceNext");
    for (const char *position : {"2.5", "1.000", "abc"}) {
        find<QLineEdit>("positionValue")->clear();
        type("positionValue", position);
        click("replaceNext");
        EXPECT_EQ(page.title(), QStringLiteral("Replace encoder 2/4")) << position;
    }
}

// The encoder died before the program started.
TEST_F(ReplacePageTest, ThePositionOfTheProjectIsOffered)
{
    page.replace(fraba);
    click("replaceNext");
    EXPECT_FALSE(find<QRadioButton>("positionKept")->isVisible());
    project.editDevice(fraba, QStringLiteral("keep"), [](ProjectDevice &device) {
        device.lastPosition = {4711, QDateTime(QDate(2026, 2, 28), QTime(17, 30))};
    });
    page.replace(fraba);
    click("replaceNext");
    auto *kept = find<QRadioButton>("positionKept");
    EXPECT_TRUE(kept->text().contains(QStringLiteral("4,711")) ||
                kept->text().contains(QStringLiteral("4711")))
        << kept->text().toStdString();
    EXPECT_TRUE(kept->text().contains(QStringLiteral("28"))) << kept->text().toStdString();
    EXPECT_FALSE(kept->isChecked()); // somebody has to confirm that the shaft has not moved
    kept->click();
    click("replaceNext");
    click("replaceNext");
    advanceWhileBusy(page);
    EXPECT_EQ(session.encoder(fraba).latest().position, 4711);
}

// What was known of its scale when it was kept is compared like that of any other position.
TEST_F(ReplacePageTest, AKeptPositionOfAnotherScaleSaysSo)
{
    const auto textWith = [this](const ParameterValues &scale) {
        project.editDevice(fraba, QStringLiteral("keep"), [&](ProjectDevice &device) {
            device.lastPosition = {4711, QDateTime(QDate(2026, 2, 28), QTime(17, 30)), scale};
        });
        page.replace(fraba);
        click("replaceNext");
        return find<QRadioButton>("positionKept")->text();
    };
    const auto says = [&](const ParameterValues &scale, const char *what) {
        const QString text = textWith(scale);
        EXPECT_TRUE(text.contains(QLatin1String(what))) << text.toStdString();
    };
    says({}, "scaled then is not known:");
    says({{Parameter::steps, 4096}}, "not known in full");
    says({{Parameter::steps, 4096}, {Parameter::revolutions, 2}}, "another scale than the wanted");
    const QString same = textWith({{Parameter::steps, 4096}, {Parameter::revolutions, 1}});
    EXPECT_FALSE(same.contains(QStringLiteral("scale"))) << same.toStdString();
    session.encoder(fraba).tell(Parameter::revolutions, 2);
    const QString asWritten = textWith({{Parameter::steps, 4096}, {Parameter::revolutions, 1}});
    EXPECT_EQ(asWritten, same) << "the new encoder gets that scale";
    session.encoder(fraba).tell(Parameter::zeroOffset, 7);
    says({{Parameter::steps, 4096}, {Parameter::revolutions, 1}, {Parameter::zeroOffset, 5}},
         "scaled otherwise then");
    want(fraba, {{Parameter::steps, 4096}});
    says({{Parameter::steps, 4096}, {Parameter::revolutions, 1}}, "scaled otherwise then");
}

TEST_F(ReplacePageTest, OtherWantedValuesAskForAKeptPositionOnceMore)
{
    for (const ParameterValues &scale :
         {ParameterValues(), ParameterValues{{Parameter::steps, 4096}, {Parameter::revolutions, 1}}}) {
        project.editDevice(fraba, QStringLiteral("keep"), [&](ProjectDevice &device) {
            device.wanted = {{Parameter::steps, 4096}, {Parameter::revolutions, 1}};
            device.lastPosition = {1000, QDateTime(QDate(2026, 2, 28), QTime(17, 30)), scale};
        });
        page.replace(fraba);
        click("replaceNext");
        find<QRadioButton>("positionKept")->click();
        click("replaceNext");
        ASSERT_EQ(page.title(), QStringLiteral("Replace encoder 3/4"));
        want(fraba, {{Parameter::steps, 4096}, {Parameter::revolutions, 2}});
        EXPECT_EQ(page.title(), QStringLiteral("Replace encoder 2/4")) << "with these it is another place";
    }
}

// What it is now must not be written by a mere Next.
TEST_F(ReplacePageTest, APositionThatTurnsIntoAnotherOneIsNoLongerChosen)
{
    project.editDevice(fraba, QStringLiteral("keep"), [](ProjectDevice &device) {
        device.lastPosition = {1000,
                               QDateTime(QDate(2026, 2, 28), QTime(17, 30)),
                               {{Parameter::steps, 4096}, {Parameter::revolutions, 1}}};
    });
    page.replace(fraba);
    click("replaceNext");
    auto *kept = find<QRadioButton>("positionKept");
    kept->click();
    want(fraba, {{Parameter::steps, 4096}, {Parameter::revolutions, 2}});
    for (const char *choice : {"positionLast", "positionKept", "positionTyped", "positionNone"})
        EXPECT_FALSE(find<QRadioButton>(choice)->isChecked()) << choice;
    const auto *said = page.findChild<ReplacePositionStep *>()->findChild<InlineMessage *>();
    EXPECT_TRUE(said->sentence().contains(QStringLiteral("once more"))) << said->sentence().toStdString();
    click("replaceNext");
    EXPECT_EQ(page.title(), QStringLiteral("Replace encoder 2/4"));
    kept->click(); // it is the one all the same
    click("replaceNext");
    EXPECT_EQ(page.title(), QStringLiteral("Replace encoder 3/4"));
    click("replaceBack");
    EXPECT_TRUE(kept->isChecked());
}

// Saving is no edit, and the page shows what the file has now.
TEST_F(ReplacePageTest, ThePositionOfTheProjectIsTheOneThatWasSavedLast)
{
    const auto save = [this](std::int64_t position) {
        Project saved = project.project();
        findDevice(saved, fraba)->lastPosition = {position, QDateTime(QDate(2026, 2, 28), QTime(17, 30))};
        project.takeLastPositions(saved);
    };
    save(4711);
    page.replace(fraba);
    click("replaceNext");
    auto *kept = find<QRadioButton>("positionKept");
    EXPECT_TRUE(kept->text().contains(QStringLiteral("711"))) << kept->text().toStdString();
    save(3533);
    EXPECT_TRUE(kept->text().contains(QStringLiteral("533"))) << kept->text().toStdString();
}

// The question that Cancel asks closes when the encoder is done with the preset; what comes after it is not
// begun.
TEST_F(ReplacePageTest, ACancelledReplacementSaysThatThePositionWasSet)
{
    want(fraba, {{Parameter::preset, 0}});
    session.controls->setFault(TrainingFault::slowConfirmation, fraba.node, 1);
    page.replace(fraba);
    click("replaceNext");
    type("positionValue", "16");
    click("replaceNext");
    click("replaceNext");
    const auto isTaken = [this] {
        return session.encoder(fraba).latest().state == EncoderState::parameterization;
    };
    for (int i = 0; i < 2000 && !isTaken(); ++i)
        session.bus.advance(10);
    QTimer::singleShot(0, &page, [this] {
        for (int i = 0; i < 2000 && QApplication::activeModalWidget() != nullptr; ++i)
            session.bus.advance(10);
    });
    click("cancelJob");
    ASSERT_FALSE(page.isBusy());
    EXPECT_EQ(text("replaceResult"),
              QStringLiteral("The job was cancelled. The position was set to 16 all the same."));
    const QString said = account();
    EXPECT_TRUE(said.contains(QRegularExpression(QStringLiteral("Setting the position: +Set\n"))))
        << said.toStdString();
    EXPECT_TRUE(said.contains(QRegularExpression(QStringLiteral("Position before: +12,?345\n"))))
        << said.toStdString();
    EXPECT_TRUE(said.contains(QRegularExpression(QStringLiteral("Preset +0 \\(read\\) +16 +Written"))))
        << said.toStdString();
    EXPECT_EQ(messages.last(),
              QStringLiteral("The transfer was cancelled, but the position was set to 16 (encoders that have "
                             "all of it: 0, values written: 1, already there: 0, EEPROM writes: 2)."));
}

TEST_F(ReplacePageTest, ACancelledReplacementThatSetNothingSaysSo)
{
    writeLeavingThePosition();
    click("cancelJob");
    advanceWhileBusy(page);
    EXPECT_TRUE(messages.last().startsWith(QStringLiteral("The transfer was cancelled (")))
        << messages.last().toStdString();
    EXPECT_EQ(told.back(), fraba);
}

TEST_F(ReplacePageTest, TheReportKnowsThePositionBefore)
{
    page.replace(fraba);
    click("replaceNext");
    type("positionValue", "16");
    click("replaceNext");
    click("replaceNext");
    advanceWhileBusy(page);
    ASSERT_EQ(text("replaceResult"), QStringLiteral("Done."));
    EXPECT_FALSE(account().contains(QRegularExpression(QStringLiteral("Position before: +not known"))))
        << account().toStdString();
}

TEST_F(ReplacePageTest, AnotherMakeIsTold)
{
    page.replace(fraba);
    auto *choice = find<QComboBox>("replaceChoice");
    choice->setCurrentIndex(choice->findText(QStringLiteral("Baumer GXP6W K3")));
    EXPECT_EQ(text("replaceDifferences"),
              QStringLiteral("A FRABA OCD-IB K3 was planned; the new one is a Baumer GXP6W K3."));
    EXPECT_EQ(choice->findText(QStringLiteral("FRABA OCD-IB K3 Loop 2")), -1);
}

TEST_F(ReplacePageTest, AKeyThatIsNotUnderstoodStopsHere)
{
    page.replace(fraba);
    type("replaceKey", "XYZ");
    click("replaceNext");
    EXPECT_TRUE(page.title().contains(QStringLiteral("1/4")));
}

TEST_F(ReplacePageTest, InWatchNothingIsWritten)
{
    session.bus.setOperate(false);
    session.bus.advance(5);
    page.replace(fraba);
    click("replaceNext");
    find<QRadioButton>("positionNone")->setChecked(true);
    click("replaceNext");
    EXPECT_FALSE(isEnabled("replaceNext"));
    EXPECT_TRUE(text("replaceNote").contains(QStringLiteral("only watches")));
    session.bus.setOperate(true);
    session.bus.advance(5);
    EXPECT_TRUE(isEnabled("replaceNext"));
}

// What was shown before is of another connection: nothing of it is offered.
TEST_F(ReplacePageTest, WhileTheRingStartsNothingIsOfferedAndThenItBeginsAnew)
{
    const auto said = [this] { return find<InlineMessage>("replaceWait")->sentence(); };
    page.replace(fraba);
    type("replaceSerial", "4711");
    click("replaceNext");
    EXPECT_TRUE(said().isEmpty());
    session.bus.close();
    EXPECT_TRUE(said().contains(QStringLiteral("1.0 is not connected"))) << said().toStdString();
    ASSERT_TRUE(session.bus.open(RingSession::Start::operating, Pacing{std::chrono::milliseconds(1)}));
    ASSERT_EQ(session.bus.state(), BusState::opening);
    EXPECT_TRUE(said().contains(QStringLiteral("The bus of 1.0 is starting"))) << said().toStdString();
    EXPECT_FALSE(find<QRadioButton>("positionNone")->isVisible());
    EXPECT_FALSE(isEnabled("replaceNext"));
    EXPECT_FALSE(isEnabled("replaceBack"));
    EXPECT_TRUE(isEnabled("replaceCancel"));
    ASSERT_TRUE(QTest::qWaitFor([&] {
        session.bus.pump();
        return session.bus.isOpen();
    }));
    EXPECT_TRUE(said().isEmpty()) << said().toStdString();
    EXPECT_EQ(page.title(), QStringLiteral("Replace encoder 1/4"));
    EXPECT_EQ(find<QLineEdit>("replaceSerial")->text(), QStringLiteral("4711"));
    EXPECT_TRUE(isEnabled("replaceNext"));
    session.bus.close();
}

TEST_F(ReplacePageTest, LongLinesBreakInANarrowWindow)
{
    exchange();
    page.resize(420, 520);
    page.replace(fraba);
    click("replaceNext");
    QCoreApplication::processEvents(); // for the layout
    const auto *last = find<QRadioButton>("positionLast");
    EXPECT_GT(last->height(), find<QRadioButton>("positionTyped")->height());
    const auto areas = page.findChildren<QScrollArea *>();
    EXPECT_FALSE(areas.isEmpty());
    for (const QScrollArea *area : areas)
        EXPECT_FALSE(area->horizontalScrollBar()->isVisible());
}

// Edits made beside the page are written.
TEST_F(ReplacePageTest, ThePlanFollowsTheProject)
{
    page.replace(fraba);
    click("replaceNext");
    find<QRadioButton>("positionNone")->setChecked(true);
    click("replaceNext");
    want(fraba, {{Parameter::steps, 2000}});
    EXPECT_TRUE(text("replaceNote").startsWith(QStringLiteral("Values and cam programs to write: 1.")));
    click("replaceNext");
    advanceWhileBusy(page);
    EXPECT_EQ(text("replaceResult"), QStringLiteral("Done."));
    EXPECT_EQ(session.encoder(fraba).known(Parameter::steps)->value, 2000);
    EXPECT_FALSE(session.encoder(fraba).known(Parameter::revolutions));
    EXPECT_EQ(messages.front(),
              QStringLiteral("The encoder was replaced (serial number before: 20417, now: \u2013)."));
}

// Values of one project must not be written to an encoder of another.
TEST_F(ReplacePageTest, AnotherProjectEndsIt)
{
    int closed = 0;
    QObject::connect(&page, &ReplacePage::closeRequested, &page, [&] { ++closed; });
    Project other = project.project();
    other.title = QStringLiteral("Other");
    other.devices.front().wanted = {{Parameter::steps, 555}};
    page.replace(fraba);
    type("replaceSerial", "4711");
    click("replaceNext");
    find<QRadioButton>("positionNone")->setChecked(true);
    click("replaceNext");
    project.setProject(other, {});
    EXPECT_EQ(closed, 1);
    EXPECT_TRUE(page.title().contains(QStringLiteral("1/4")));
    EXPECT_TRUE(find<QLineEdit>("replaceSerial")->text().isEmpty());
    EXPECT_EQ(project.project(), other);
}

TEST_F(ReplacePageTest, TheAccountIsOfTheProjectThatWasWritten)
{
    Project crane = project.project();
    crane.title = QStringLiteral("Crane");
    project.edit(crane, QStringLiteral("title"));
    writeLeavingThePosition();
    ASSERT_TRUE(page.isBusy());
    crane.title = QStringLiteral("Other");
    project.setProject(crane, {});
    advanceWhileBusy(page);
    EXPECT_EQ(text("replaceResult"), QStringLiteral("Done."));
    EXPECT_TRUE(account().contains(QStringLiteral("Crane")));
    EXPECT_FALSE(account().contains(QStringLiteral("Other")));
}

// After a first replacement, even an interrupted one, there is just as much to write again.
TEST_F(ReplacePageTest, WhatWasStoredCanBeWrittenAgain)
{
    project.editDevice(fraba, QStringLiteral("store"), [](ProjectDevice &device) {
        device.wanted.clear();
        device.stored = {{Parameter::steps, 1000, Evidence::read, {}}};
    });
    for (int time = 0; time < 2; ++time) {
        page.replace(fraba);
        click("replaceNext");
        find<QRadioButton>("positionNone")->setChecked(true);
        click("replaceNext");
        EXPECT_TRUE(text("replaceNote").startsWith(QStringLiteral("Values and cam programs to write: 1.")));
        click("replaceNext");
        advanceWhileBusy(page);
    }
    project.undoStack().undo();
    EXPECT_EQ(project.device(fraba).stored.size(), 1u);
}

} // namespace
} // namespace codewheel
