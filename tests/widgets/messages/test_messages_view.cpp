// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/old_file.h"
#include "tests/support/places.h"
#include "tests/widgets/training_bus_session.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/inline_message.h"
#include "widgets/messages/messages_view.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDateTime>
#include <QDateTimeEdit>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFrame>
#include <QIODevice>
#include <QLabel>
#include <QLatin1Char>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::fraba;

class MessagesViewTest : public testing::Test
{
protected:
    MessagesViewTest()
    {
        messages.setClock(ring.bus);
        view.resize(900, 200);
        view.show();
        view.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&view));
    }

    void add(const char *what, std::optional<Place> place = {}, Severity severity = Severity::information)
    {
        messages.addNow({.place = place,
                         .severity = severity,
                         .id = MessageId::training,
                         .arguments = {QString::fromUtf8(what)}});
        messages.catchUp();
    }
    template <typename Widget>
    Widget &find(const char *name) const
    {
        for (Widget *widget : view.findChildren<Widget *>())
            if (widget->accessibleName().startsWith(QLatin1String(name)))
                return *widget;
        ADD_FAILURE() << "no " << name;
        std::abort();
    }
    void click(const char *name) { QTest::mouseClick(&find<QAbstractButton>(name), Qt::LeftButton); }
    QTableView &table() const { return find<QTableView>("List of messages"); }
    int shownRows()
    {
        messages.catchUp();
        return shownNow();
    }
    int shownNow() const
    {
        int count = 0;
        for (int row = 0; row < messages.rowCount(); ++row)
            count += messages.isDay(row) ? 0 : 1;
        return count;
    }
    void choose(int row)
    {
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {},
                          table().visualRect(messages.index(row, MessageModel::textColumn)).center());
    }
    QString note() const
    {
        const auto *message = view.findChild<InlineMessage *>();
        return message->isVisible() ? message->sentence() : QString();
    }
    void exportTo(const QString &fileName)
    {
        click("Write the messages shown");
        auto *dialog = view.findChild<QFileDialog *>();
        ASSERT_NE(dialog, nullptr);
        dialog->setOption(QFileDialog::DontConfirmOverwrite);
        dialog->findChild<QLineEdit *>()->setText(fileName);
        dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Save)->click();
        EXPECT_TRUE(QTest::qWaitFor([&] { return !note().isEmpty(); }));
    }

    test::TrainingBusSession ring;
    MessageStore store{{}};
    MessageModel messages{store};
    MessagesView view{messages};
    QTemporaryDir folder;
};

TEST_F(MessagesViewTest, AMessageKeepsTheNameThatItsBusHad)
{
    setBusNames({{fraba.bus, QStringLiteral("Ring")}}, {{fraba.bus, QStringLiteral("Ring")}});
    add("cable off", fraba);
    setBusNames({{fraba.bus, QStringLiteral("Seat 2")}}, {{fraba.bus, QStringLiteral("Seat 2")}});
    const auto placeIn = [this](int row) {
        return messages.index(row, MessageModel::placeColumn).data().toString();
    };
    EXPECT_EQ(placeIn(1), QStringLiteral("Ring/1.0"));
    ring.bus.advance(1000);
    add("cable on", fraba);
    setBusNames({});
    EXPECT_EQ(placeIn(1), QStringLiteral("Ring/1.0"));
    EXPECT_EQ(placeIn(2), QStringLiteral("Seat 2/1.0"));
}

TEST_F(MessagesViewTest, SaysWhatBelongsThereAsLongAsThereIsNothing)
{
    EXPECT_TRUE(view.findChild<EmptyState *>()->isVisible());
    EXPECT_FALSE(table().isVisible());
    messages.addNow({.severity = Severity::information, .id = MessageId::watchOn});
    messages.catchUp();
    EXPECT_FALSE(view.findChild<EmptyState *>()->isVisible());
    EXPECT_TRUE(table().isVisible());
}

TEST_F(MessagesViewTest, FiltersByKeysAndShowsAllAgain)
{
    add("power off", fraba);
    add("speed", fraba);
    QTest::keyClick(&view, Qt::Key_F, Qt::ControlModifier);
    QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("power"));
    EXPECT_EQ(shownRows(), 1);
    QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("less"));
    EXPECT_EQ(shownRows(), 0);
    auto *empty = view.findChild<EmptyState *>();
    ASSERT_TRUE(empty->isVisible());
    QTest::mouseClick(empty->findChild<QPushButton *>(), Qt::LeftButton);
    EXPECT_EQ(shownRows(), 2);
}

TEST_F(MessagesViewTest, OffersThePlacesWhereSomethingHappened)
{
    add("b", "10.0"_ring);
    add("a", "2.0"_ring);
    add("again", "2.0"_ring);
    add("bus");
    auto &places = find<QComboBox>("Place of messages");
    ASSERT_EQ(places.count(), 4);
    EXPECT_EQ(places.itemText(2), QStringLiteral("2.0"));
    EXPECT_EQ(places.itemText(3), QStringLiteral("10.0"));
    places.setFocus();
    QTest::keyClicks(&places, QStringLiteral("2"));
    EXPECT_EQ(shownRows(), 2);
    QTest::keyClick(&places, Qt::Key_Up);
    EXPECT_EQ(shownRows(), 1);
}

TEST_F(MessagesViewTest, ShowsFaultsOnlyWhenAsked)
{
    add("fine");
    add("look", fraba, Severity::attention);
    add("broken", fraba, Severity::fault);
    auto &severities = find<QComboBox>("Severity");
    severities.setFocus();
    QTest::keyClick(&severities, Qt::Key_Down);
    EXPECT_EQ(shownRows(), 2);
    QTest::keyClick(&severities, Qt::Key_Down);
    EXPECT_EQ(shownRows(), 1);
}

TEST_F(MessagesViewTest, CopiesTheRowsChosenSeparatedByTabs)
{
    add("one", fraba);
    add("two");
    table().setFocus();
    choose(1);
    QTest::keyClick(&table(), Qt::Key_C, Qt::ControlModifier);
    QString text = QApplication::clipboard()->text();
    EXPECT_TRUE(text.endsWith(QStringLiteral("\tInformation\t1.0\tone\n"))) << text.toStdString();
    EXPECT_EQ(text.count(QLatin1Char('\n')), 1);
}

TEST_F(MessagesViewTest, CopiesAllThatAreShownWhenNoneIsChosen)
{
    add("one", fraba);
    add("two");
    click("Copy the messages");
    const QString text = QApplication::clipboard()->text();
    EXPECT_EQ(text.count(QLatin1Char('\n')), 2);
    EXPECT_TRUE(text.endsWith(QStringLiteral("\tInformation\t\ttwo\n"))) << text.toStdString();
}

TEST_F(MessagesViewTest, FollowsTheNewestUntilOneScrollsUp)
{
    for (int i = 0; i < 50; ++i)
        add(i % 2 == 0 ? "something" : "other");
    QScrollBar &bar = *table().verticalScrollBar();
    EXPECT_GT(bar.maximum(), 0);
    EXPECT_EQ(bar.value(), bar.maximum());

    auto &follow = find<QAbstractButton>("Keep the newest");
    bar.triggerAction(QAbstractSlider::SliderToMinimum);
    EXPECT_FALSE(follow.isChecked());
    add("more");
    EXPECT_EQ(bar.value(), 0);

    QTest::mouseClick(&follow, Qt::LeftButton);
    EXPECT_EQ(bar.value(), bar.maximum());
    bar.triggerAction(QAbstractSlider::SliderToMinimum);
    table().setFocus();
    QTest::keyClick(&table(), Qt::Key_End, Qt::ControlModifier);
    EXPECT_TRUE(follow.isChecked());
}

TEST_F(MessagesViewTest, BringsBackWhatWasCleared)
{
    add("before");
    click("Hide all messages");
    EXPECT_EQ(messages.rowCount(), 0);
    EXPECT_EQ(note(), QStringLiteral("The messages up to now are hidden. They are kept on disk."));
    add("after");
    QTest::mouseClick(view.findChild<InlineMessage *>()->findChild<QPushButton *>(), Qt::LeftButton);
    ASSERT_EQ(shownNow(), 2);
    EXPECT_EQ(messages.text(messages.message(1), MessageModel::textColumn), QStringLiteral("before"));
    EXPECT_EQ(note(), QString());
}

TEST_F(MessagesViewTest, ExportsTheRowsShown)
{
    add("power off", fraba);
    add("speed", fraba);
    QTest::keyClicks(&find<QLineEdit>("Search"), QStringLiteral("speed"));
    messages.catchUp();
    const QString name = folder.filePath(QStringLiteral("all.csv"));
    exportTo(name);
    QFile file(name);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray csv = file.readAll();
    EXPECT_EQ(csv.count("\r\n"), 2);
    EXPECT_TRUE(csv.contains(",information,1.0,training,\"speed\"")) << csv.constData();
    EXPECT_TRUE(note().contains(name));
}

TEST_F(MessagesViewTest, ExportsAPageByTheNameOfTheFile)
{
    add("<power> off", fraba);
    const QString name = folder.filePath(QStringLiteral("all.html"));
    exportTo(name);
    QFile file(name);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().contains("<td>1.0</td><td>&lt;power&gt; off</td>"));
}

TEST_F(MessagesViewTest, AnExportThatTakesLongCanBeCancelled)
{
    for (int i = 0; i < 30'000; ++i)
        store.add({.id = MessageId::training, .arguments = {QStringLiteral("something")}},
                  QDateTime::currentDateTime());
    messages.catchUp();
    const QString name = folder.filePath(QStringLiteral("all.csv"));
    exportTo(name);
    EXPECT_TRUE(note().startsWith(QStringLiteral("Writing "))) << note().toStdString();
    QTest::mouseClick(view.findChild<InlineMessage *>()->findChild<QPushButton *>(), Qt::LeftButton);
    EXPECT_EQ(note(), QString());
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST_F(MessagesViewTest, ChoosesATime)
{
    store.add({.id = MessageId::busStarted}, QDateTime::currentDateTime().addDays(-2));
    store.add({.id = MessageId::busStopped}, QDateTime::currentDateTime().addSecs(-5));
    auto &times = find<QComboBox>("Time of messages");
    times.setCurrentText(QStringLiteral("Last hour"));
    EXPECT_EQ(shownRows(), 1);
    times.setCurrentText(QStringLiteral("Last 7 days"));
    EXPECT_EQ(shownRows(), 2);
    times.setCurrentText(QStringLiteral("From … to …"));
    auto &from = find<QDateTimeEdit>("Show messages from");
    ASSERT_TRUE(from.isVisible());
    from.setDateTime(QDateTime::currentDateTime().addDays(-3));
    find<QDateTimeEdit>("Show messages before").setDateTime(QDateTime::currentDateTime().addDays(-1));
    EXPECT_EQ(shownRows(), 1);
    times.setCurrentIndex(0);
    EXPECT_FALSE(from.isVisible());
    EXPECT_EQ(shownRows(), 2);
}

TEST_F(MessagesViewTest, WhatOneReadsStaysWhereItIsWhenOlderMessagesAreFound)
{
    for (int i = 0; i < 9'000; ++i)
        store.add({.id = MessageId::training, .arguments = {QStringLiteral("speed %1").arg(i)}},
                  QDateTime::currentDateTime());
    messages.catchUp();
    messages.setFilter({.text = QStringLiteral("speed")});
    EXPECT_TRUE(QTest::qWaitFor([&] { return messages.rowCount() > 0; }, 60'000));
    QScrollBar &bar = *table().verticalScrollBar();
    bar.triggerAction(QAbstractSlider::SliderSingleStepSub);
    bar.triggerAction(QAbstractSlider::SliderPageStepSub);
    const auto topText = [&] {
        return messages.index(table().rowAt(0), MessageModel::textColumn).data().toString();
    };
    const QString before = topText();
    messages.catchUp();
    EXPECT_EQ(shownNow(), 9'000);
    EXPECT_EQ(topText(), before);
}

TEST_F(MessagesViewTest, AnExportWithoutRoomLeavesTheOldOne)
{
    for (int i = 0; i < 1'000; ++i)
        add("power off", fraba);
    test::OldFile old;
    old.saveWithoutRoom([&](const QString &name) {
        exportTo(name);
        return false;
    });
    EXPECT_TRUE(old.isThere());
    EXPECT_TRUE(note().contains(QStringLiteral("could not be written: File too large")))
        << note().toStdString();
}

TEST_F(MessagesViewTest, CopiesAndExportsEachMessageOfARowThatRepeats)
{
    add("again", fraba);
    add("again", fraba);
    add("again", fraba);
    ASSERT_EQ(messages.rowCount(), 2);
    choose(1);
    QTest::keyClick(&table(), Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QApplication::clipboard()->text().count(QStringLiteral("\tagain\n")), 3);
    const QString name = folder.filePath(QStringLiteral("all.csv"));
    exportTo(name);
    QFile file(name);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll().count("\"again\""), 3);
}

TEST_F(MessagesViewTest, ALongTextWrapsInANarrowPanel)
{
    view.resize(500, 160);
    add("short");
    add("A sentence that is much too long for one line of a panel as narrow as this one is, and that goes "
        "on");
    const QTableView &rows = table();
    EXPECT_GE(rows.columnWidth(MessageModel::textColumn), 300);
    EXPECT_GT(rows.rowHeight(2), rows.rowHeight(1));
    EXPECT_EQ(rows.columnSpan(0, 0), rows.model()->columnCount()) << "the date stands across";
    const int end = rows.rowViewportPosition(2) + rows.rowHeight(2);
    EXPECT_LE(end, rows.viewport()->height()) << "the newest is in sight to its last line";
}

TEST_F(MessagesViewTest, GoesToTheDeviceAMessageIsAbout)
{
    add("device", fraba);
    add("program");
    std::vector<Place> places;
    QObject::connect(&view, &MessagesView::goToWanted, [&](Place place) { places.push_back(place); });
    choose(1);
    QTest::keyClick(&table(), Qt::Key_G, Qt::ControlModifier);
    EXPECT_EQ(places, std::vector<Place>{fraba});
    const QAction &goTo = *table().actions().front();
    EXPECT_EQ(goTo.text(), QStringLiteral("Go to 1.0"));
    choose(2);
    EXPECT_FALSE(goTo.isEnabled());
    QTest::keyClick(&table(), Qt::Key_G, Qt::ControlModifier);
    EXPECT_EQ(places.size(), 1U);
}

TEST_F(MessagesViewTest, TheMenuComesByKeyToo)
{
    add("device", fraba);
    choose(1);
    bool isShown = false;
    QTimer::singleShot(0, &view, [&] { // the menu runs its own event loop
        QWidget *menu = QApplication::activePopupWidget();
        isShown = menu != nullptr && menu->actions().contains(table().actions().front());
        if (menu != nullptr)
            menu->close();
    });
    QTest::keyClick(&table(), Qt::Key_F10, Qt::ShiftModifier);
    EXPECT_TRUE(isShown);
}

TEST_F(MessagesViewTest, DetailsAreShownWhereThereIsRoomOrOnDemand)
{
    add("first", fraba, Severity::fault);
    auto &details = find<QFrame>("Details of the message");
    EXPECT_FALSE(details.isVisible());
    choose(1);
    EXPECT_FALSE(details.isVisible()) << "no room";
    QTest::keyClick(&table(), Qt::Key_Return);
    EXPECT_TRUE(details.isVisible());
    QString all;
    for (const auto *label : details.findChildren<QLabel *>())
        all += label->text();
    EXPECT_TRUE(all.contains(QStringLiteral("Fault"))) << all.toStdString();
    EXPECT_TRUE(all.contains(QStringLiteral("first"))) << all.toStdString();
    QTest::keyClick(&table(), Qt::Key_Return);
    EXPECT_FALSE(details.isVisible());
}

TEST_F(MessagesViewTest, WithRoomTheChosenMessageHasItsDetails)
{
    view.resize(900, 400);
    add("first", fraba);
    EXPECT_FALSE(find<QFrame>("Details of the message").isVisible()) << "none is chosen";
    choose(1);
    EXPECT_TRUE(find<QFrame>("Details of the message").isVisible());
}

TEST_F(MessagesViewTest, WhatIsInSightIsSeen)
{
    add("fault", fraba, Severity::fault);
    EXPECT_EQ(messages.unseen(), 0);
    view.hide();
    add("fault", fraba, Severity::fault);
    EXPECT_EQ(messages.unseen(), 1);
    view.show();
    EXPECT_TRUE(QTest::qWaitFor([this] { return messages.unseen() == 0; }));
}

TEST_F(MessagesViewTest, SaysWhyAFileCouldNotBeWritten)
{
    add("power off", fraba);
    const QString name = folder.filePath(QStringLiteral("no such folder/all.csv"));
    exportTo(name);
    EXPECT_FALSE(QFile::exists(name));
    EXPECT_TRUE(note().contains(QStringLiteral("could not be written"))) << note().toStdString();
}

} // namespace
} // namespace codewheel
