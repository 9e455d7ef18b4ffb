// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/device_number.h"
#include "tests/widgets/rod_bus.h"
#include "widgets/look/inline_message.h"
#include "widgets/monitor/bar_view.h"
#include "widgets/monitor/number_field.h"
#include "widgets/monitor/word_card.h"
#include "widgets/monitor/word_field.h"
#include "widgets/monitor/word_view.h"

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QEvent>
#include <QLocale>
#include <QPoint>
#include <QPushButton>
#include <QTest>
#include <QVBoxLayout>
#include <QWidget>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::fraba;

// The monitor of the FRABA encoder in a window.
class WordCardTest : public testing::Test
{
protected:
    WordCardTest()
    {
        window.resize(1024, 640);
        auto *column = new QVBoxLayout(&window);
        column->addWidget(&card);
        QObject::connect(&ring.bus, &RingSession::updated, &window,
                         [this] { card.showFrame(ring.bus.latest().at); });
        QObject::connect(&ring.bus, &RingSession::stateChanged, &card, &WordCard::busStateChanged);
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
        ring.bus.advance(10);
    }

    WordCard cardOf(Place place)
    {
        EncoderSession &encoder = ring.encoder(place);
        return {ring.channel(place), &encoder, &encoder.device()};
    }
    template <typename Widget>
    static Widget &find(const QWidget &monitor, const char *name)
    {
        for (Widget *widget : monitor.findChildren<Widget *>())
            if (widget->accessibleName() == QLatin1String(name))
                return *widget;
        ADD_FAILURE() << "no " << name;
        std::abort();
    }
    QString number(const QWidget &monitor, const char *name)
    {
        return find<NumberField>(monitor, name).text();
    }
    QString hexadecimal(const QWidget &monitor)
    {
        return find<WordField>(monitor, "IN 1.0 hexadecimal").text();
    }
    WordField &hex() { return find<WordField>(out, "OUT 1.0 hexadecimal"); }
    QAbstractButton &write() { return find<QAbstractButton>(out, "Write OUT 1.0"); }
    QAbstractButton &atOnce() { return find<QAbstractButton>(out, "Send OUT 1.0 at once"); }
    static QString message(const WordCard &monitor)
    {
        const auto *shown = monitor.findChild<InlineMessage *>();
        return shown->isVisible() ? shown->sentence() : QString();
    }
    static QPushButton &messageAction(const WordCard &monitor)
    {
        return *monitor.findChild<InlineMessage *>()->findChild<QPushButton *>();
    }
    void click(int bit)
    {
        auto &bits = *card.findChild<WordView *>();
        QTest::mouseClick(&bits, Qt::LeftButton, {}, bits.bitRect({0, bit}).center());
    }
    void type(const char *typed)
    {
        hex().setFocus();
        hex().selectAll();
        QTest::keyClicks(&hex(), QString::fromLatin1(typed));
    }
    void tick(QAbstractButton &box)
    {
        QTest::mouseClick(&box, Qt::LeftButton, {}, QPoint(8, box.height() / 2));
    }
    Word sentWord()
    {
        ring.bus.advance(5);
        return ring.bus.latest().devices.front().out;
    }

    test::TrainingBusSession ring;
    QWidget window;
    WordCard card = cardOf(fraba);
    const WordLine &in = *card.line(WordDirection::in);
    const WordLine &out = *card.line(WordDirection::out);
};

// As banner and F12 say.
TEST_F(WordCardTest, Position0MayBeAnEncoderWithoutSupply)
{
    ring.encoder(fraba).tell(Parameter::startUpMode, 1); // in position mode
    ring.bus.advance(40);
    EXPECT_FALSE(in.meaning().contains(QStringLiteral("supply")));
    ring.controls->turnTo(fraba.node, 0);
    ring.bus.advance(40);
    EXPECT_TRUE(in.meaning().endsWith(QStringLiteral("position 0, or no supply")))
        << in.meaning().toStdString();
}

TEST_F(WordCardTest, AWordIsShownInEveryWriting)
{
    ring.controls->turnTo(fraba.node, 0x1234);
    ring.bus.advance(10);
    card.setDisplay({.signedDecimal = true, .gray = true, .binary = true});
    EXPECT_EQ(hexadecimal(in), QStringLiteral("00001234"));
    EXPECT_EQ(number(in, "IN 1.0 decimal"), QStringLiteral("4660"));
    EXPECT_EQ(number(in, "IN 1.0 signed"), QStringLiteral("4660"));
    EXPECT_EQ(number(in, "IN 1.0 Gray"), QStringLiteral("7207"));
    EXPECT_EQ(number(in, "IN 1.0 binary"), QStringLiteral("0000 0000 0000 0000 0001 0010 0011 0100"));
    EXPECT_TRUE(find<WordField>(in, "IN 1.0 hexadecimal").isReadOnly());
    EXPECT_TRUE(in.meaning().contains(QLatin1String("position 4660"))) << in.meaning().toStdString();
}

TEST_F(WordCardTest, BothMeaningsAreGivenWhereTheModeIsNotKnown)
{
    type("40000000");
    EXPECT_TRUE(out.meaning().contains(QLatin1String("Initialise the preset")))
        << out.meaning().toStdString();
    EXPECT_TRUE(out.meaning().contains(QLatin1String("Start of cam 0"))) << out.meaning().toStdString();
}

TEST_F(WordCardTest, AWordFromBeforeIsToldAsSuchWithItsReason)
{
    const QString upToDate = in.meaning();
    const QString ofOut = out.meaning();
    ring.bus.setRunning(false);
    ring.bus.advance(40);
    const QDateTime seen = ring.bus.dateTime(ring.channel(fraba).freshness().seen());
    const QString lastSeen = QLocale().toString(seen.toLocalTime(), QLocale::ShortFormat);
    EXPECT_EQ(in.meaning(), QStringLiteral("Bus stopped, %1: %2").arg(lastSeen, upToDate));
    EXPECT_EQ(out.meaning(), ofOut) << "it is what will be sent";
    ring.bus.setRunning(true);
    ring.bus.advance(40);
    EXPECT_EQ(in.meaning(), upToDate);
    ring.bus.switchSegment(DeviceNumber::of(fraba.node).segment, false);
    ring.bus.advance(40);
    EXPECT_TRUE(in.meaning().startsWith(QStringLiteral("Not on the bus, "))) << "the ring runs without it";
}

TEST_F(WordCardTest, AClickedBitIsStagedAndSentByWrite)
{
    click(25);
    EXPECT_EQ(ring.channel(fraba).staged(), 0x02000000U);
    EXPECT_TRUE(out.meaning().startsWith(QLatin1String("Not sent yet: ")));
    EXPECT_EQ(sentWord(), 0U);
    for (const int bit : {0, 1, 2, 3, 4, 5, 6, 7})
        click(bit);
    EXPECT_EQ(hex().text(), QStringLiteral("020000FF"));
    QTest::mouseClick(&write(), Qt::LeftButton);
    EXPECT_EQ(sentWord(), 0x020000FFU);
    EXPECT_FALSE(ring.channel(fraba).staged());
    ring.bus.advance(10);
    EXPECT_EQ(hexadecimal(in), QStringLiteral("C20000FF"));
}

TEST_F(WordCardTest, TypedWordsAreTakenAsTheFieldWritesThem)
{
    for (const char *typed : {"020000FF", "0x20000ff", "20000FFh", "0200 00FF"}) {
        type(typed);
        EXPECT_EQ(ring.channel(fraba).staged(), 0x020000FFU) << typed;
        EXPECT_EQ(hex().text().toStdString(), typed);
        write().setFocus();
        EXPECT_EQ(hex().text(), QStringLiteral("020000FF")) << typed;
        QTest::keyClick(&card, Qt::Key_Escape);
        EXPECT_FALSE(ring.channel(fraba).staged());
        EXPECT_EQ(hex().text(), QStringLiteral("00000000"));
    }
}

TEST_F(WordCardTest, BadInputIsSaidAtOnceStagesNothingAndIsNotLost)
{
    click(4);
    type("02XY");
    EXPECT_TRUE(message(card).startsWith(QLatin1String("\"02XY\" is not a hexadecimal word")))
        << message(card).toStdString();
    EXPECT_TRUE(hex().hasProblem());
    EXPECT_EQ(ring.channel(fraba).staged(), 0x10U);
    QTest::keyClick(&hex(), Qt::Key_Return);
    QTest::keyClick(&hex(), Qt::Key_Return, Qt::ControlModifier);
    EXPECT_EQ(sentWord(), 0U);
    EXPECT_EQ(hex().text(), QStringLiteral("02XY"));
    QTest::keyClick(&hex(), Qt::Key_Backspace);
    EXPECT_FALSE(write().isEnabled());
    QTest::keyClick(&hex(), Qt::Key_Backspace);
    EXPECT_TRUE(message(card).isEmpty());
    EXPECT_FALSE(hex().hasProblem());
    EXPECT_TRUE(write().isEnabled());
    EXPECT_EQ(ring.channel(fraba).staged(), 0x02U);
}

TEST_F(WordCardTest, ABitClickedAfterBadInputReplacesIt)
{
    type("zz");
    click(0);
    EXPECT_EQ(hex().text(), QStringLiteral("00000001"));
    EXPECT_TRUE(message(card).isEmpty());
    EXPECT_TRUE(write().isEnabled());
}

TEST_F(WordCardTest, NineDigitsAreCounted)
{
    type("0200000FF");
    EXPECT_TRUE(message(card).contains(QLatin1String("has 9 digits"))) << message(card).toStdString();
}

TEST_F(WordCardTest, CtrlReturnWritesFromEveryFieldOfTheMonitor)
{
    type("20400001");
    QTest::keyClick(&hex(), Qt::Key_Return, Qt::ControlModifier);
    EXPECT_EQ(sentWord(), 0x20400001U);
}

TEST_F(WordCardTest, InWatchTheRefusalStandsAtTheWordUntilOperate)
{
    ring.bus.setOperate(false);
    ring.bus.advance(5);
    click(0);
    QTest::mouseClick(&write(), Qt::LeftButton);
    EXPECT_EQ(message(card),
              QStringLiteral("Nothing was sent to 1.0: the program only watches. Switch to Operate first."));
    EXPECT_EQ(ring.channel(fraba).staged(), 1U);
    EXPECT_EQ(sentWord(), 0U);
    ring.bus.setOperate(true);
    ring.bus.advance(5);
    EXPECT_TRUE(message(card).isEmpty());
    QTest::mouseClick(&write(), Qt::LeftButton);
    EXPECT_EQ(sentWord(), 1U);
}

TEST_F(WordCardTest, WhileAJobHoldsTheWordNothingIsSent)
{
    ASSERT_TRUE(ring.encoder(fraba).start(SendWords{{0x020000FF, 0x80000000}}, Pace::byHand));
    ring.bus.advance(5);
    click(0);
    QTest::mouseClick(&write(), Qt::LeftButton);
    EXPECT_TRUE(message(card).contains(QLatin1String("a job holds its OUT word")))
        << message(card).toStdString();
    EXPECT_EQ(ring.channel(fraba).staged(), 1U);
}

TEST_F(WordCardTest, AtOnceIsOffAndSendsHarmlessWordsOnly)
{
    EXPECT_FALSE(atOnce().isChecked());
    tick(atOnce());
    ASSERT_TRUE(atOnce().isChecked());
    click(3);
    EXPECT_EQ(sentWord(), 8U);
    EXPECT_TRUE(message(card).isEmpty());

    click(25);
    EXPECT_EQ(sentWord(), 8U);
    EXPECT_TRUE(message(card).startsWith(QLatin1String("02000008 has a command bit")))
        << message(card).toStdString();
    QTest::mouseClick(&messageAction(card), Qt::LeftButton);
    EXPECT_EQ(sentWord(), 0x02000008U);
    EXPECT_TRUE(message(card).isEmpty());
}

// TR manual 2.2: OUT has no effect without the service bit.
TEST_F(WordCardTest, OfALinearEncoderOnlyTheServiceBitIsAsked)
{
    test::TrainingBusSession bus{RingSession::Start::operating, test::makeRodBus};
    EncoderSession &encoder = bus.encoder(test::rodPlace);
    WordCard monitor(bus.channel(test::rodPlace), &encoder, &encoder.device());
    monitor.show();
    monitor.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&monitor));
    tick(find<QAbstractButton>(monitor, "Send OUT 5.0 at once"));
    auto &field = find<WordField>(monitor, "OUT 5.0 hexadecimal");
    const auto enter = [&](const char *word) {
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, QString::fromLatin1(word));
        QTest::keyClick(&field, Qt::Key_Return);
        bus.bus.advance(10);
    };
    enter("4200C350");
    EXPECT_EQ(bus.channel(test::rodPlace).out(), 0x4200C350U);
    enter("C200C350");
    EXPECT_EQ(bus.channel(test::rodPlace).out(), 0x4200C350U);
    EXPECT_TRUE(message(monitor).startsWith(QLatin1String("C200C350 has a command bit")))
        << message(monitor).toStdString();
    QTest::mouseClick(&messageAction(monitor), Qt::LeftButton);
    bus.bus.advance(10);
    EXPECT_EQ(bus.channel(test::rodPlace).in(), 0xC200C350U);
}

TEST_F(WordCardTest, AtOnceATypedWordIsSentByReturnNotWhileItIsTyped)
{
    tick(atOnce());
    type("1F");
    EXPECT_EQ(sentWord(), 0U);
    QTest::keyClick(&hex(), Qt::Key_Return);
    EXPECT_EQ(sentWord(), 0x1FU);
}

TEST_F(WordCardTest, TheQuestionGoesWhenTheWordIsDiscarded)
{
    tick(atOnce());
    click(31);
    EXPECT_FALSE(message(card).isEmpty());
    QTest::keyClick(&card, Qt::Key_Escape);
    EXPECT_TRUE(message(card).isEmpty());
    EXPECT_EQ(sentWord(), 0U);
}

TEST_F(WordCardTest, CopiesAsHexadecimalAndAsTheWordsOfAPlc)
{
    type("020000FF");
    auto &bits = *card.findChild<WordView *>();
    bits.setFocus();
    bits.setFocusedBit({0, 7});
    QTest::keyClick(&bits, Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QApplication::clipboard()->text(), QStringLiteral("020000FF"));
    QTest::keyClick(&bits, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(QApplication::clipboard()->text(), QStringLiteral("16#0200 16#00FF"));
}

TEST_F(WordCardTest, ANumberIsCopiedByItself)
{
    type("020000FF");
    auto &decimal = find<NumberField>(out, "OUT 1.0 decimal");
    decimal.setFocus();
    QTest::keyClick(&decimal, Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QApplication::clipboard()->text(), QStringLiteral("255"));
}

TEST_F(WordCardTest, TheBarShowsThePositionOnceTheRangeIsKnown)
{
    card.setDisplay({.bar = true});
    const auto &bar = *card.findChild<BarView *>();
    EXPECT_EQ(bar.valueText(), QStringLiteral("Not known"));
    ring.encoder(fraba).tell(Parameter::startUpMode, 1);
    ring.encoder(fraba).tell(Parameter::steps, 8192);
    ring.encoder(fraba).tell(Parameter::revolutions, 1);
    ring.bus.advance(10);
    EXPECT_EQ(bar.valueText(), QStringLiteral("12345 of 0 to 33554431"));
}

TEST_F(WordCardTest, ChosenBitsStandInRowsOfEight)
{
    const auto &bits = *card.findChild<WordView *>();
    card.setDisplay({.matrix = true});
    EXPECT_EQ(bits.bitRect({0, 24}).left(), bits.bitRect({0, 0}).left());
    EXPECT_LT(bits.bitRect({1, 24}).top(), bits.bitRect({0, 23}).top());
    EXPECT_LT(bits.bitRect({1, 8}).top(), bits.bitRect({0, 7}).top());
}

TEST_F(WordCardTest, NumbersAreShownWhenTheyAreAskedFor)
{
    EXPECT_TRUE(find<NumberField>(out, "OUT 1.0 decimal").isVisible());
    EXPECT_FALSE(find<NumberField>(out, "OUT 1.0 signed").isVisible());
    card.setDisplay({.signedDecimal = true});
    EXPECT_FALSE(find<NumberField>(out, "OUT 1.0 Gray").isVisible());
    EXPECT_TRUE(find<NumberField>(out, "OUT 1.0 signed").isVisible());
    EXPECT_TRUE(find<NumberField>(in, "IN 1.0 signed").isVisible());
}

// So that two cards fit into a window of 1280 x 800, one into 1024 x 640, and Write is always in sight.
TEST_F(WordCardTest, IsAsLowAsItCanBe)
{
    const auto &bits = *card.findChild<WordView *>();
    EXPECT_LE(card.heightForWidth(660), 210);
    EXPECT_LE(card.heightForWidth(659), 280);
    EXPECT_LE(card.minimumSizeHint().width(), 470) << "the middle of a window of 1024 pixels";
    EXPECT_LE(bits.sizeHint().width(), 644);
}

TEST_F(WordCardTest, ReturnSelectsTheWordAndSendsNothing)
{
    type("020000FF");
    QTest::keyClick(&hex(), Qt::Key_Return);
    EXPECT_EQ(hex().selectedText(), QStringLiteral("020000FF"));
    EXPECT_EQ(sentWord(), 0U);
    QTest::keyClicks(&hex(), QStringLiteral("04000001"));
    QTest::keyClick(&hex(), Qt::Key_Return, Qt::ControlModifier);
    EXPECT_EQ(sentWord(), 0x0400'0001U);
}

TEST_F(WordCardTest, TheWordOfTheBitChosenLastIsCopied)
{
    ring.controls->turnTo(fraba.node, 0x54321);
    ring.bus.advance(10);
    auto &bits = *card.findChild<WordView *>();
    bits.setFocus();
    bits.setFocusedBit({1, 7});
    QTest::keyClick(&bits, Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(QApplication::clipboard()->text(), QStringLiteral("00054321"));
}

TEST_F(WordCardTest, OnlyWhatChangedIsLaidOutAndPainted)
{
    QTest::qWait(20); // paints requested by showing it
    class Counter : public QObject
    {
    public:
        int layouts = 0;
        QString last;
        int paints = 0;
        bool eventFilter(QObject *o, QEvent *event) override
        {
            layouts += event->type() == QEvent::LayoutRequest;
            if (event->type() == QEvent::LayoutRequest)
                last = QString::fromLatin1(o->metaObject()->className());
            paints += event->type() == QEvent::Paint;
            return false;
        }
    } counter;
    for (QWidget *widget : window.findChildren<QWidget *>())
        widget->installEventFilter(&counter);
    window.installEventFilter(&counter);
    ring.bus.advance(5);
    QCoreApplication::processEvents();
    EXPECT_EQ(counter.paints, 0);
    ring.controls->turnBy(fraba.node, 1);
    ring.bus.advance(5);
    QCoreApplication::processEvents();
    EXPECT_GT(counter.paints, 0);
    EXPECT_EQ(counter.layouts, 0) << counter.last.toStdString();
}

} // namespace
} // namespace codewheel
