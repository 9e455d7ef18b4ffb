// SPDX-License-Identifier: GPL-3.0-or-later
// A recording begun, watched and ended in the window, and what becomes of it when the window goes.
#include "app/window/buses/plant.h"
#include "app/window/program.h"
#include "history/histories.h"
#include "language.h"
#include "recording/recording_reader.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "tests/support/cut_off.h"
#include "widgets/help/help_topic.h"
#include "widgets/help/manual.h"
#include "widgets/look/appearance.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/recording/recording_details.h"
#include "widgets/recording/recording_dialog.h"
#include "widgets/recording/recording_indicator.h"
#include "widgets/structure/structure_view.h"
#include "widgets/trend/trend_page.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <QSqlDatabase>
#include <QSqlQuery>
#include <QStatusBar>
#include <QToolButton>
#include <QTreeWidget>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;
using test::baumer;
using test::fraba;
using testing::HasSubstr;

class RecordingInWindowTest : public test::WindowTest
{
protected:
    QString path(const char *name = "night.cwrec") const { return folder.filePath(QLatin1String(name)); }
    RecordingAtWork &recording() { return shown->plant().recording(); }
    bool isRunning() { return recording().recorder() != nullptr; }
    RecordingDialog *dialog() { return window().findChild<RecordingDialog *>(); }
    RecordingDetails *details() { return window().findChild<RecordingDetails *>(); }
    RecordingIndicator &indicator() { return *window().findChild<RecordingIndicator *>(); }
    template <class Field>
    Field &field(const char *name)
    {
        auto *found = window().findChild<Field *>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    std::string textOf(const char *label) { return field<QLabel>(label).text().toStdString(); }

    RecordingDialog &open()
    {
        QTest::keyClick(&window(), Qt::Key_F11, Qt::ShiftModifier);
        EXPECT_NE(dialog(), nullptr);
        dialog()->activateWindow();
        EXPECT_TRUE(QTest::qWaitFor([this] { return QApplication::activeWindow() == dialog(); }));
        type("recordingFile", path());
        return *dialog();
    }
    void type(const char *name, const QString &text)
    {
        auto *line = window().findChild<QLineEdit *>(QLatin1String(name));
        if (line == nullptr)
            line = field<QAbstractSpinBox>(name).findChild<QLineEdit *>();
        line->setFocus();
        line->selectAll();
        QTest::keyClicks(line, text);
    }
    void choose(const char *name, const QString &text)
    {
        auto &box = field<QComboBox>(name);
        EXPECT_TRUE(box.isVisible()) << name;
        const int index = box.findText(text, Qt::MatchStartsWith);
        ASSERT_GE(index, 0) << text.toStdString();
        box.setCurrentIndex(index);
    }
    void press(const char *button)
    {
        auto &its = field<QAbstractButton>(button);
        QTest::mouseClick(&its, Qt::LeftButton, {}, {its.height() / 2, its.height() / 2});
    }
    void begin()
    {
        press("beginRecording");
        EXPECT_TRUE(isRunning());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        EXPECT_EQ(dialog(), nullptr);
        window().activateWindow();
        EXPECT_TRUE(QTest::qWaitFor([this] { return QApplication::activeWindow() == &window(); }));
    }
    // Its thread writes once a second, of the computer's clock.
    bool waitFor(const std::function<bool()> &isSo) { return QTest::qWaitFor(isSo, 60'000); }

    std::vector<std::string> messages()
    {
        std::vector<std::string> texts;
        const MessageModel &all = shown->messages();
        for (int row = 0; row < all.rowCount(); ++row)
            for (int column = 0; column < all.columnCount(); ++column)
                texts.push_back(all.index(row, column).data().toString().toStdString());
        return texts;
    }
    static RecordingReader read(const QString &file)
    {
        auto reader = RecordingReader::open(file);
        EXPECT_TRUE(reader) << file.toStdString();
        return std::move(*reader);
    }
    static std::size_t samplesOf(const RecordingReader &reader, Place place)
    {
        const auto devices = reader.devices().value();
        for (const auto &device : devices)
            if (device.place == place) {
                auto channel = reader.channel(device, Channel::position).value();
                std::size_t count = 0;
                EXPECT_TRUE(channel.forEach({Instant(0), Instant::max()},
                                            [&](const Sample &, const std::optional<Instant> &) {
                                                ++count;
                                                return true;
                                            }));
                return count;
            }
        return 0;
    }
};

TEST_F(RecordingInWindowTest, IsMadeByItsKeyAndHasWhatTheEncodersShow)
{
    shown->controls().setSpeed(baumer.node, 60);
    open();
    begin();
    EXPECT_TRUE(indicator().isVisible());
    advance(3'000);
    EXPECT_TRUE(waitFor([&] { return recording().recorder()->status().bytes > 0; }));
    EXPECT_TRUE(waitFor([&] { return indicator().text().startsWith(QStringLiteral("Records 0:00:")); }));
    QTest::mouseClick(&indicator(), Qt::LeftButton);
    ASSERT_NE(details(), nullptr);
    EXPECT_THAT(field<QLineEdit>("recordingFileNow").text().toStdString(), HasSubstr("night.cwrec"));
    EXPECT_THAT(textOf("recordingLost"), "none");
    press("endRecording");
    EXPECT_FALSE(isRunning());
    EXPECT_FALSE(indicator().isVisible());
    const RecordingReader reader = read(path());
    EXPECT_TRUE(reader.head()->hasEnded);
    EXPECT_GT(samplesOf(reader, baumer), 2'500U);
    EXPECT_EQ(reader.buses()->size(), 2U);
    advance(100);
    EXPECT_THAT(messages(), testing::Contains(HasSubstr("Recording to " + path().toStdString())));
    EXPECT_THAT(messages(), testing::Contains(HasSubstr("The recording has ended: " + path().toStdString())));
}

TEST_F(RecordingInWindowTest, SaysAtOnceWhereNoFileCanBeMade)
{
    QFile other(path("other.cwrec"));
    ASSERT_TRUE(other.open(QIODevice::WriteOnly));
    other.write("mine");
    other.close();
    open();
    EXPECT_EQ(textOf("recordingFileWrong"), "");
    type("recordingFile", path("other"));
    EXPECT_THAT(textOf("recordingFileWrong"), HasSubstr("never written over")) << "its suffix is added";
    press("beginRecording");
    EXPECT_FALSE(isRunning());
    EXPECT_TRUE(field<QLineEdit>("recordingFile").hasFocus());
    type("recordingFile", path("nowhere/night"));
    EXPECT_THAT(textOf("recordingFileWrong"), HasSubstr("There is no folder"));
    type("recordingFile", QStringLiteral("/proc/night"));
    press("beginRecording");
    EXPECT_FALSE(isRunning()) << "nothing can be saved there";
    ASSERT_NE(dialog(), nullptr);
    EXPECT_TRUE(!textOf("recordingFileWrong").empty() ||
                !dialog()->findChild<InlineMessage *>()->sentence().isEmpty());
    type("recordingFile", QStringLiteral(" "));
    EXPECT_THAT(textOf("recordingFileWrong"), HasSubstr("Name a file"));
    dialog()->reject();
    ASSERT_TRUE(other.open(QIODevice::ReadOnly));
    EXPECT_EQ(other.readAll(), QByteArray("mine"));
}

TEST_F(RecordingInWindowTest, OnlyTheTickedEncodersAreRecordedAndWhatWasChosenIsRemembered)
{
    shown->project().editDevice(fraba, {},
                                [](ProjectDevice &device) { device.station = QStringLiteral("Crane 1"); });
    open();
    press("recordSome");
    press("beginRecording");
    EXPECT_FALSE(isRunning()) << "none is ticked";
    EXPECT_THAT(dialog()->findChild<InlineMessage *>()->sentence().toStdString(), HasSubstr("Tick"));
    auto &list = field<QTreeWidget>("recordedEncoders");
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_Space);
    EXPECT_EQ(list.topLevelItem(0)->text(0), QStringLiteral("1.0  Crane 1"));
    press("recordTraffic");
    type("recordBefore", QStringLiteral("2,5")); // either sign; the field is not left
    type("recordFree", QStringLiteral("150"));
    begin();
    EXPECT_EQ(recording().recorder()->plan().places, std::set<Place>{fraba});
    EXPECT_FALSE(recording().recorder()->plan().withTraffic);
    EXPECT_EQ(recording().recorder()->plan().extent.before, 2500ms);
    EXPECT_EQ(recording().recorder()->plan().settings.leastFree, 150'000'000);
    advance(500);
    recording().end();
    EXPECT_EQ(read(path()).devices()->size(), 1U);
    test::WindowTest::open(); // the next start
    QTest::keyClick(&window(), Qt::Key_F11, Qt::ShiftModifier);
    const RecordingChoices choices = dialog()->choices();
    EXPECT_EQ(choices.places, std::set<Place>{fraba});
    EXPECT_FALSE(choices.withTraffic);
    EXPECT_EQ(choices.before, 2500ms);
    EXPECT_EQ(choices.leastFree, 150);
    EXPECT_EQ(choices.folder, folder.path());
    EXPECT_TRUE(
        field<QLineEdit>("recordingFile").text().startsWith(folder.filePath(QStringLiteral("2026-"))));
}

TEST_F(RecordingInWindowTest, TheWheelChangesNothingWithoutTheFocusAndHalfANumberIsNotTaken)
{
    open();
    auto &free = field<QSpinBox>("recordFree");
    const int before = free.value();
    QWheelEvent wheel(QPointF(5, 5), free.mapToGlobal(QPointF(5, 5)), {}, {0, 120}, {}, {}, {}, false);
    QApplication::sendEvent(&free, &wheel);
    EXPECT_EQ(free.value(), before);
    type("recordFree", QStringLiteral("7")); // too little
    press("beginRecording");
    EXPECT_FALSE(isRunning());
    EXPECT_TRUE(free.hasFocus());
    type("recordFree", QStringLiteral("1.5"));
    press("beginRecording");
    EXPECT_FALSE(isRunning());
    dialog()->reject();
}

TEST_F(RecordingInWindowTest, ABitMakesItBeginWithTheSecondsBefore)
{
    advance(2'000);
    open();
    choose("recordingTrigger", QStringLiteral("when a bit"));
    choose("triggerPlace", QStringLiteral("1.0"));
    choose("triggerWord", QStringLiteral("OUT"));
    type("triggerBit", QStringLiteral("25"));
    type("recordBefore", QStringLiteral("1"));
    choose("recordingEnd", QStringLiteral("after"));
    type("recordAfter", QStringLiteral("1"));
    choose("recordAfterUnit", QStringLiteral("s"));
    begin();
    EXPECT_EQ(indicator().text(), QStringLiteral("Waits for its trigger"));
    advance(1'000);
    indicator().click();
    EXPECT_THAT(textOf("recordingStateNow"), HasSubstr("1.0: OUT bit 25 becomes 1"));
    send(fraba, 0x0200'00FF);
    const Instant now = bus().sinceEpoch(bus().now());
    advance(100);
    EXPECT_FALSE(field<QPushButton>("fireRecording").isVisible());
    advance(2'000);
    EXPECT_FALSE(isRunning()) << "its time is over";
    const RecordingReader reader = read(path());
    EXPECT_TRUE(reader.head()->hasEnded);
    std::optional<Instant> from; // of OUT
    const auto devices = reader.devices().value();
    for (const auto &device : devices)
        if (device.place == fraba)
            from = reader.channel(device, Channel::out)->span().value().from;
    ASSERT_TRUE(from);
    EXPECT_LT(*from, now - 900ms) << (now - *from).count();
    EXPECT_GT(*from, now - 1'200ms) << (now - *from).count();
    const auto head = reader.head().value();
    EXPECT_LT(head.until, now + 1'500ms);
    EXPECT_THAT(messages(), testing::Contains(HasSubstr("waits for its trigger")));
    EXPECT_THAT(messages(), testing::Contains(HasSubstr("The trigger fired")));
}

TEST_F(RecordingInWindowTest, AThresholdIsInTheUnitOfTheTrend)
{
    bus().encoder(baumer)->tell(Parameter::steps, 4'096);
    advance(100);
    window().findChild<StructureView *>()->choose(baumer);
    actions().showInTrend->trigger();
    auto &tracks = window().findChild<TrendPage *>()->tracks();
    tracks.setUnit(0, TrackUnit::degrees);
    open();
    choose("recordingTrigger", QStringLiteral("when a value"));
    choose("triggerPlace", QStringLiteral("2.0"));
    EXPECT_EQ(field<QComboBox>("triggerUnit").currentText(), QStringLiteral("°"));
    type("triggerThreshold", QStringLiteral("90"));
    begin();
    const auto threshold = std::get<ThresholdTrigger>(*recording().recorder()->plan().trigger);
    EXPECT_EQ(threshold.place, baumer);
    EXPECT_EQ(threshold.threshold, 1'024);
    EXPECT_TRUE(threshold.rising);
    indicator().click();
    press("fireRecording");
    EXPECT_EQ(recording().recorder()->state(), BusRecorder::State::recording);
}

TEST_F(RecordingInWindowTest, AFullDiskIsSaidAndItGoesOnOnceThereIsRoom)
{
    open();
    type("recordFree", QStringLiteral("900000000")); // more than any disk has
    begin();
    advance(500);
    EXPECT_TRUE(waitFor([&] { return recording().recorder()->status().problem.has_value(); }));
    EXPECT_TRUE(waitFor([&] { return indicator().text() == QStringLiteral("Recording held up"); }));
    indicator().click();
    EXPECT_THAT(details()->findChild<InlineMessage *>()->sentence().toStdString(), HasSubstr("almost full"));
    advance(100);
    EXPECT_THAT(messages(), testing::Contains(HasSubstr("almost full")));
    EXPECT_TRUE(isRunning());
}

TEST_F(RecordingInWindowTest, AProblemThatIsOverIsSaidToo)
{
    open();
    begin();
    {
        auto other = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("other"));
        other.setDatabaseName(path());
        ASSERT_TRUE(other.open());
        QSqlQuery query(other);
        ASSERT_TRUE(query.exec(QStringLiteral("BEGIN EXCLUSIVE")));
        advance(500);
        EXPECT_TRUE(waitFor([&] { return indicator().text() == QStringLiteral("Recording held up"); }));
        ASSERT_TRUE(query.exec(QStringLiteral("COMMIT")));
    }
    QSqlDatabase::removeDatabase(QStringLiteral("other"));
    advance(500);
    EXPECT_TRUE(waitFor([&] { return indicator().text().startsWith(QStringLiteral("Records")); }));
    advance(100);
    EXPECT_THAT(messages(), testing::Contains(HasSubstr("goes on (values lost so far: 0)")));
}

TEST_F(RecordingInWindowTest, AFileThatIsMovedAwayEndsItWithASentence)
{
    open();
    begin();
    advance(500);
    EXPECT_TRUE(waitFor([&] { return recording().recorder()->status().written > Instant(0); }));
    ASSERT_TRUE(QFile::rename(path(), path("elsewhere.cwrec")));
    advance(200);
    EXPECT_TRUE(waitFor([&] { return !isRunning(); }));
    EXPECT_FALSE(indicator().isVisible());
    advance(100);
    EXPECT_THAT(messages(), testing::Contains(HasSubstr("was moved, replaced or removed")));
}

TEST_F(RecordingInWindowTest, AnotherOneIsNotBegunBesideIt)
{
    open();
    begin();
    QTest::keyClick(&window(), Qt::Key_F11, Qt::ShiftModifier);
    EXPECT_EQ(dialog(), nullptr);
    ASSERT_NE(details(), nullptr);
    EXPECT_THAT(details()->findChild<InlineMessage *>()->sentence().toStdString(), HasSubstr("runs already"));
    EXPECT_THAT(field<QLineEdit>("recordingFileNow").text().toStdString(), HasSubstr("night.cwrec"));
}

TEST_F(RecordingInWindowTest, NotesComeIntoTheRecording)
{
    open();
    begin();
    advance(500);
    indicator().click();
    type("recordingNote", QStringLiteral("17 t"));
    QTest::keyClick(&field<QLineEdit>("recordingNote"), Qt::Key_Return);
    advance(100);
    const Instant later = shown->plant().histories().span()->to;
    shown->plant().histories().note(later, QStringLiteral("of the trend"));
    advance(100);
    recording().end();
    const auto notes = read(path()).notes({Instant(0), Instant::max()}, 10).value();
    ASSERT_EQ(notes.size(), 2U);
    EXPECT_EQ(notes[0].text, QStringLiteral("17 t"));
    EXPECT_EQ(notes[1].text, QStringLiteral("of the trend"));
    EXPECT_EQ(std::ranges::count_if(shown->plant().histories().marks(), &Mark::isNote), 2) << "in the trend";
}

TEST_F(RecordingInWindowTest, DisconnectingAnAlarmStopAndAnotherProjectLoseNothing)
{
    open();
    begin();
    advance(500);
    actions().alarmStop->trigger();
    advance(500);
    bus().close();
    advance(200);
    EXPECT_TRUE(isRunning());
    shown->project().setProject({}, {});
    advance(200);
    EXPECT_TRUE(isRunning());
    recording().end();
    EXPECT_GT(samplesOf(read(path()), baumer), 0U);
    EXPECT_FALSE(read(path()).messages({Instant(0), Instant::max()}, 100)->empty());
}

TEST_F(RecordingInWindowTest, QuittingAsksAndEndsIt)
{
    open();
    begin();
    advance(500);
    {
        test::Question stay = test::Question::answeredBy(QStringLiteral("Go on recording"));
        window().close();
        EXPECT_THAT(stay.text().toStdString(), HasSubstr("night.cwrec"));
    }
    EXPECT_TRUE(window().isVisible());
    EXPECT_TRUE(isRunning());
    const test::Question end = test::Question::answeredBy(QStringLiteral("End it and quit"));
    window().close();
    advance(100);
    EXPECT_FALSE(window().isVisible());
    EXPECT_FALSE(isRunning());
    EXPECT_TRUE(read(path()).head()->hasEnded);
}

TEST_F(RecordingInWindowTest, ThatIsDestroyedEndsIt)
{
    open();
    begin();
    advance(500);
    shown.reset();
    EXPECT_TRUE(read(path()).head()->hasEnded);
}

TEST_F(RecordingInWindowTest, TheTrendHasAButtonForIt)
{
    actions().trend->trigger();
    for (auto *button : window().findChild<TrendPage *>()->findChildren<QToolButton *>())
        if (button->defaultAction() == actions().record)
            QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_NE(dialog(), nullptr);
}

TEST_F(RecordingInWindowTest, SaysHowLongThereIsRoom)
{
    shown->controls().setSpeed(baumer.node, 60);
    advance(3'000);
    open();
    EXPECT_THAT(textOf("recordingRoom"), HasSubstr("Free on this disk"));
    EXPECT_THAT(textOf("recordingRoom"), HasSubstr("an hour"));
    press("recordOnlyLast");
    EXPECT_THAT(textOf("recordingRoom"), HasSubstr("24 h"));
    press("recordOnlyLast");
    press("recordHasSize");
    EXPECT_THAT(textOf("recordingRoom"), HasSubstr("the oldest gives way"));
    type("recordFree", QStringLiteral("900000000"));
    field<QCheckBox>("recordTraffic").setFocus();
    EXPECT_THAT(textOf("recordingRoom"), HasSubstr("nothing would be written"));
}

// The texts of both languages have room, in all the dialog shows.
struct Sight
{
    const char *name;
    const char *language;
    bool largeControls;
};
void PrintTo(const Sight &tested, std::ostream *out)
{
    *out << tested.name;
}

class RecordingLook : public RecordingInWindowTest, public testing::WithParamInterface<Sight>
{
protected:
    RecordingLook()
    {
        applyAppearance(*qApp, {.scheme = Scheme::light, .largeControls = GetParam().largeControls});
        language.use(QString::fromLatin1(GetParam().language));
        test::WindowTest::open(); // in this language
        resizeTo({1024, 640});
        actions().defaultLayout->trigger();
        resizeTo({1024, 640});
    }
    ~RecordingLook() override
    {
        applyAppearance(*qApp, {.scheme = Scheme::light});
        QLocale::setDefault(QLocale::c());
    }
    void look(QWidget &part, const QString &where)
    {
        advance(50);
        for (const QString &cut : test::cutOff(part))
            ADD_FAILURE() << where.toStdString() << ": " << cut.toStdString();
        EXPECT_LE(part.width(), 1024) << where.toStdString();
        EXPECT_LE(part.height(), 640) << where.toStdString();
        std::map<QKeySequence, QString> owners;
        const auto take = [&](const QString &text) {
            const QKeySequence key = QKeySequence::mnemonic(text);
            if (key.isEmpty())
                return;
            EXPECT_TRUE(owners.emplace(key, text).second)
                << where.toStdString() << ": " << text.toStdString() << " and " << owners[key].toStdString();
        };
        for (const auto *button : part.findChildren<QAbstractButton *>())
            if (button->isVisible() && button->objectName() != QStringLiteral("alarmStop"))
                take(button->text());
        for (const auto *label : part.findChildren<QLabel *>())
            if (label->isVisible() && label->buddy() != nullptr)
                take(label->text());
    }

    Language language;
};

TEST_P(RecordingLook, HasRoomForAllTexts)
{
    RecordingDialog &its = open();
    const Manual manual;
    EXPECT_TRUE(manual.has(Manual::url(helpTopicOf(&its))));
    auto &trigger = field<QComboBox>("recordingTrigger");
    for (int i = 0; i < trigger.count(); ++i) {
        trigger.setCurrentIndex(i);
        look(its, trigger.currentText());
    }
    press("recordSome");
    field<QComboBox>("recordingEnd").setCurrentIndex(1);
    type("recordingFile", folder.path());
    look(its, QStringLiteral("all"));
    for (const auto *control : its.findChildren<QWidget *>())
        if (control->isVisible() && control->focusPolicy() != Qt::NoFocus &&
            (qobject_cast<const QAbstractButton *>(control) != nullptr ||
             qobject_cast<const QComboBox *>(control) != nullptr ||
             qobject_cast<const QAbstractSpinBox *>(control) != nullptr)) {
            EXPECT_FALSE(control->toolTip().isEmpty()) << control->objectName().toStdString();
            const auto *button = qobject_cast<const QAbstractButton *>(control);
            EXPECT_FALSE(control->accessibleName().isEmpty() &&
                         (button == nullptr || button->text().isEmpty()))
                << control->objectName().toStdString();
        }
}

TEST_P(RecordingLook, HasRoomForWhatRuns)
{
    open();
    field<QComboBox>("recordingTrigger").setCurrentIndex(3);
    begin();
    indicator().click();
    look(*details(), QStringLiteral("waiting"));
    look(*window().statusBar(), QStringLiteral("status line"));
    const Manual manual;
    EXPECT_TRUE(manual.has(Manual::url(helpTopicOf(details()))));
    recording().fire();
    advance(500);
    EXPECT_TRUE(waitFor([&] { return recording().recorder()->status().bytes > 0; }));
    recording().note({}); // tells how it gets on
    look(*details(), QStringLiteral("recording"));
    look(*window().statusBar(), QStringLiteral("status line, recording"));
    EXPECT_LE(window().minimumSizeHint().width(), 1024);
}

INSTANTIATE_TEST_SUITE_P(Sights, RecordingLook,
                         testing::Values(Sight{"English", "en", false}, Sight{"German", "de", false},
                                         Sight{"GermanLarge", "de", true}),
                         [](const auto &tested) { return tested.param.name; });

// The whole program, whose window is rebuilt in another language.
TEST(RecordingInProgram, GoesOnInAnotherLanguage)
{
    const QTemporaryDir folder;
    Program program(*qApp, folder.filePath(QStringLiteral("program.ini")));
    program.openWindow();
    program.window()->show();
    ASSERT_TRUE(QTest::qWaitFor([&] { return program.plant() != nullptr; }, 60'000));
    RecordingPlan plan;
    plan.settings.file = folder.filePath(QStringLiteral("night.cwrec"));
    ASSERT_TRUE(program.plant()->recording().begin(plan));
    const auto isSeen = [&] { return program.window()->findChild<RecordingIndicator *>()->isVisible(); };
    EXPECT_TRUE(isSeen());
    program.window()->findChild<RecordingIndicator *>()->click();
    const QPointer<MainWindow> before(program.window());
    for (QAction *language : program.window()->actions().language->actions())
        if (language->data().toString() == QStringLiteral("de"))
            language->trigger();
    ASSERT_TRUE(QTest::qWaitFor([&] { return before.isNull() && program.window() != nullptr; }, 60'000));
    EXPECT_NE(program.plant()->recording().recorder(), nullptr);
    EXPECT_TRUE(isSeen());
    EXPECT_TRUE(program.window()->findChild<RecordingIndicator *>()->text().startsWith(
        QStringLiteral("Zeichnet auf")))
        << program.window()->findChild<RecordingIndicator *>()->text().toStdString();
    const auto *details = program.window()->findChild<RecordingDetails *>();
    ASSERT_NE(details, nullptr) << "they were open";
    EXPECT_TRUE(details->isVisible());
    program.plant()->recording().end();
    const auto reader = RecordingReader::open(plan.settings.file);
    ASSERT_TRUE(reader);
    EXPECT_TRUE(reader->head()->hasEnded);
    QLocale::setDefault(QLocale::c());
}

} // namespace
} // namespace codewheel
