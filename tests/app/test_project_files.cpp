// SPDX-License-Identifier: GPL-3.0-or-later
// Projects as files of the window: open, save, recent files, dropped files, the question before changes are
// lost, what remains after a crash.
#include "app/window/files/project_files.h"
#include "app/window/files/project_recovery.h"
#include "cams/cam_file.h"
#include "kinds/interbus/plan/project_take_over.h"
#include "project/file_access.h"
#include "project/project_file.h"
#include "project/word_list.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "tests/support/places.h"
#include "widgets/cams/cam_editor.h"
#include "widgets/kinds/interbus/training/fault_plan_bar.h"
#include "widgets/look/inline_message.h"
#include "widgets/parameters/parameter_model.h"
#include "widgets/parameters/parameter_table.h"
#include "widgets/sequence/sequence_view.h"
#include "widgets/structure/structure_view.h"

#include <QAction>
#include <QApplication>
#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QIODevice>
#include <QKeySequence>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPoint>
#include <QPointF>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QUrl>
#include <QWidget>

#include <algorithm>
#include <gtest/gtest.h>
#include <optional>

namespace codewheel {
namespace {

using test::fraba;
using test::Question;

// What Qt's item views complain about meanwhile.
class ViewWarnings
{
public:
    ViewWarnings()
    {
        s_heard.clear();
        s_before =
            qInstallMessageHandler([](QtMsgType type, const QMessageLogContext &at, const QString &text) {
                if (text.startsWith(QStringLiteral("QAbstractItemView::")))
                    s_heard << text;
                else
                    s_before(type, at, text);
            });
    }
    ~ViewWarnings() { qInstallMessageHandler(s_before); }
    ViewWarnings(const ViewWarnings &) = delete;
    ViewWarnings &operator=(const ViewWarnings &) = delete;

    static QStringList heard() { return s_heard; }

private:
    static inline QStringList s_heard;
    static inline QtMessageHandler s_before = nullptr;
};

class ProjectFilesTest : public test::WindowTest
{
protected:
    QString path(const char *name) const { return folder.filePath(QString::fromLatin1(name)); }
    ProjectDocument &document() { return shown->project(); }
    void nameStation(const QString &station)
    {
        document().editDevice(fraba, QStringLiteral("Station of 1.0"),
                              [&](ProjectDevice &device) { device.station = station; });
    }
    QString saved(const char *name, const QString &station)
    {
        Project project = document().project();
        project.devices.front().station = station;
        EXPECT_TRUE(saveProject(project, path(name)));
        return path(name);
    }
    QString station() { return document().device(fraba).station; }
    QString notice(const char *name = "notice")
    {
        const auto *shownNotice = window().findChild<InlineMessage *>(QLatin1String(name));
        return shownNotice && shownNotice->isVisible() ? shownNotice->sentence() : QString();
    }
    QString faultPlan(const char *name, const char *place)
    {
        const QString file = path(name);
        const QByteArray json =
            R"({"format": "codewheel-faults", "version": 1, "title": "Lesson 1", "steps": [
            {"at": 10, "fault": "wireBreak", "place": ")" +
            QByteArray(place) + R"("}]})";
        EXPECT_TRUE(replaceFile(file, json, OldFile::goes));
        return file;
    }
    static bool saysPlan(const FaultPlanBar &bar, const QString &text)
    {
        const auto labels = bar.findChildren<QLabel *>();
        return std::ranges::any_of(labels, [&](const QLabel *label) {
            return label->isVisible() && label->text().startsWith(text);
        });
    }
    void drop(const QString &file)
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(file)});
        QDragEnterEvent enter(QPoint(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&window(), &enter);
        if (!enter.isAccepted())
            return;
        QDropEvent event(QPointF(5, 5), Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&window(), &event);
        advance(5);
    }
};

TEST_F(ProjectFilesTest, TheFirstProjectIsThePlantAndIsSaved)
{
    EXPECT_EQ(document().project().devices.size(), bus().structure().size());
    EXPECT_EQ(window().windowTitle(), QStringLiteral("Untitled[*]"));
    EXPECT_FALSE(window().isWindowModified());
}

TEST_F(ProjectFilesTest, AChangeIsMarkedAndUndoneByAKey)
{
    nameStation(QStringLiteral("hoist"));
    EXPECT_TRUE(window().isWindowModified());
    QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(station(), QString());
    EXPECT_FALSE(window().isWindowModified());
    QTest::keySequence(&window(), QKeySequence::Redo);
    EXPECT_EQ(station(), QStringLiteral("hoist"));
}

TEST_F(ProjectFilesTest, AProjectIsOpenedSavedAndNamedInTheTitle)
{
    ASSERT_TRUE(window().files().open(saved("crane.codewheel", QStringLiteral("hoist"))));
    EXPECT_EQ(station(), QStringLiteral("hoist"));
    EXPECT_EQ(window().windowTitle(), QStringLiteral("crane.codewheel[*]"));
    nameStation(QStringLiteral("trolley"));
    actions().saveProject->trigger();
    EXPECT_FALSE(window().isWindowModified());
    EXPECT_EQ(loadProject(path("crane.codewheel"))->devices.front().station, QStringLiteral("trolley"));
}

TEST_F(ProjectFilesTest, TheTitleIsTypedIntoAPageAndSaved)
{
    ASSERT_TRUE(window().files().open(saved("crane.codewheel", QStringLiteral("hoist"))));
    QTest::keyClick(&window(), Qt::Key_F4, Qt::ShiftModifier);
    auto *title = window().findChild<QLineEdit *>(QStringLiteral("projectTitle"));
    ASSERT_TRUE(title->hasFocus());
    QTest::keyClicks(title, QStringLiteral("Crane 1"));
    EXPECT_FALSE(window().isWindowModified()) << "half typed";
    actions().saveProject->trigger();
    EXPECT_EQ(loadProject(path("crane.codewheel"))->title, QStringLiteral("Crane 1"));
}

TEST_F(ProjectFilesTest, WhatIsBeingTypedIsAskedForBeforeAnotherProjectIsOpened)
{
    const QString other = saved("press.codewheel", QStringLiteral("press"));
    ASSERT_TRUE(window().files().open(saved("crane.codewheel", QStringLiteral("hoist"))));
    QTest::keyClick(&window(), Qt::Key_F4, Qt::ShiftModifier);
    QTest::keyClicks(window().findChild<QLineEdit *>(QStringLiteral("projectTitle")),
                     QStringLiteral("Crane 1"));
    bool isAsked = false;
    Question question([&](QWidget &dialog) {
        isAsked = true;
        dialog.close();
    });
    EXPECT_FALSE(window().files().open(other));
    EXPECT_TRUE(isAsked);
    EXPECT_EQ(document().project().title, QStringLiteral("Crane 1"));
}

TEST_F(ProjectFilesTest, WhatCannotBeOpenedIsSaidAndChangesNothing)
{
    QFile file(path("broken.codewheel"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{");
    file.close();
    const Project before = document().project();
    EXPECT_FALSE(window().files().open(file.fileName()));
    EXPECT_TRUE(notice().contains(QStringLiteral("broken.codewheel"))) << notice().toStdString();
    EXPECT_EQ(document().project(), before);
    EXPECT_FALSE(window().files().open(path("nowhere.codewheel")));
    EXPECT_TRUE(notice().contains(QStringLiteral("nowhere.codewheel")));
    ASSERT_TRUE(window().files().open(saved("good.codewheel", {})));
    EXPECT_EQ(notice(), QString()) << "the cause is gone";
}

TEST_F(ProjectFilesTest, ChangesAreNotLostWithoutAQuestion)
{
    const QString other = saved("other.codewheel", QStringLiteral("other"));
    ASSERT_TRUE(window().files().open(saved("crane.codewheel", QStringLiteral("hoist"))));
    nameStation(QStringLiteral("trolley"));
    {
        const Question question = Question::answeredBy(QStringLiteral("Cancel"));
        EXPECT_FALSE(window().files().open(other));
        EXPECT_TRUE(question.text().contains(QStringLiteral("Station of 1.0")))
            << question.text().toStdString();
    }
    EXPECT_EQ(station(), QStringLiteral("trolley"));
    {
        const Question question = Question::answeredBy(QStringLiteral("Save"));
        EXPECT_TRUE(window().files().open(other));
    }
    EXPECT_EQ(loadProject(path("crane.codewheel"))->devices.front().station, QStringLiteral("trolley"));
    nameStation(QStringLiteral("lost"));
    const Question question = Question::answeredBy(QStringLiteral("Discard"));
    actions().newProject->trigger();
    EXPECT_TRUE(document().project().devices.empty());
    EXPECT_EQ(loadProject(other)->devices.front().station, QStringLiteral("other"));
}

TEST_F(ProjectFilesTest, WhatAnotherProgramHasSavedIsNotOverwrittenWithoutAQuestion)
{
    ASSERT_TRUE(window().files().open(saved("crane.codewheel", QStringLiteral("hoist"))));
    nameStation(QStringLiteral("trolley"));
    EXPECT_TRUE(window().files().save()) << "nobody has changed it";
    saved("crane.codewheel", QStringLiteral("of another program"));
    nameStation(QStringLiteral("ours"));
    const auto inFile = [&](const QString &name) { return loadProject(name)->devices.front().station; };
    {
        const Question question = Question::answeredBy(QStringLiteral("Cancel"));
        EXPECT_FALSE(window().files().save());
        EXPECT_TRUE(question.text().contains(QStringLiteral("crane.codewheel~")))
            << question.text().toStdString();
    }
    EXPECT_EQ(inFile(path("crane.codewheel")), QStringLiteral("of another program"));
    EXPECT_FALSE(document().isSaved());
    {
        const Question question = Question::answeredBy(QStringLiteral("Replace"));
        EXPECT_TRUE(window().files().save());
    }
    EXPECT_EQ(inFile(path("crane.codewheel")), QStringLiteral("ours"));
    EXPECT_EQ(inFile(path("crane.codewheel~")), QStringLiteral("of another program"));
    nameStation(QStringLiteral("ours again"));
    EXPECT_TRUE(window().files().save()) << "it is ours now";
}

TEST_F(ProjectFilesTest, AFileIsNotReplacedWithoutAQuestionWhereItsSuffixIsLeftToTheProgram)
{
    const QString other = saved("moved.codewheel", QStringLiteral("other"));
    nameStation(QStringLiteral("hoist"));
    std::optional<Question> replace;
    const Question question([&](QWidget &dialog) {
        replace.emplace([&](QWidget &box) {
            QTest::keyClick(&box, Qt::Key_Escape);
            QTimer::singleShot(0, &dialog, &QWidget::close);
        });
        dialog.findChild<QLineEdit *>()->setText(path("moved"));
        QTest::keyClick(dialog.findChild<QLineEdit *>(), Qt::Key_Return);
    });
    EXPECT_FALSE(window().files().saveAs());
    ASSERT_TRUE(replace && replace->wasAsked());
    EXPECT_TRUE(replace->text().contains(QStringLiteral("moved.codewheel"))) << replace->text().toStdString();
    EXPECT_EQ(loadProject(other)->devices.front().station, QStringLiteral("other"));
}

TEST_F(ProjectFilesTest, ValuesOfDevicesThatTheProjectHasNotAreToldWhenItIsSaved)
{
    actions().newProject->trigger();
    document().editDevice(fraba, QStringLiteral("Steps"), [](ProjectDevice &device) {
        device.wanted = {{Parameter::steps, 100}};
    });
    document().setFile(path("new.codewheel"));
    actions().saveProject->trigger();
    EXPECT_TRUE(notice().startsWith(QStringLiteral("What is planned for 1.0 is in no file")))
        << notice().toStdString();
    EXPECT_TRUE(window().isWindowModified());
    {
        const Question question = Question::answeredBy(QStringLiteral("Cancel"));
        EXPECT_FALSE(window().files().mayClose());
        EXPECT_TRUE(question.text().contains(QStringLiteral("1.0 is in no file")))
            << question.text().toStdString();
    }
    Project project = document().project();
    project.devices = projectOf(bus().structure()).devices;
    document().edit(project, QStringLiteral("Take over"));
    actions().saveProject->trigger();
    EXPECT_EQ(notice(), QString());
    EXPECT_FALSE(window().isWindowModified());
    EXPECT_EQ(loadProject(path("new.codewheel"))->devices.front().wanted,
              (ParameterValues{{Parameter::steps, 100}}));
}

TEST_F(ProjectFilesTest, WhatIsBeingTypedIntoACellIsTakenOnceWhenTheWindowIsClosed)
{
    window().findChild<StructureView *>()->choose(fraba);
    auto &table = *window().findChild<ParameterTable *>();
    const QModelIndex name =
        table.model()->match(table.model()->index(0, 0), Qt::DisplayRole, QStringLiteral("Steps")).value(0);
    ASSERT_TRUE(name.isValid());
    const ViewWarnings warnings;
    QTest::mouseClick(table.viewport(), Qt::LeftButton, {},
                      table.visualRect(name.siblingAtColumn(ParameterModel::wantedColumn)).center());
    auto *field = qobject_cast<QLineEdit *>(QApplication::focusWidget());
    ASSERT_NE(field, nullptr);
    QTest::keyClicks(field, QStringLiteral("77"));
    const Question question = Question::answeredBy(QStringLiteral("Cancel"));
    window().close();
    EXPECT_TRUE(question.wasAsked());
    EXPECT_EQ(document().device(fraba).wanted, (ParameterValues{{Parameter::steps, 77}}));
    EXPECT_TRUE(ViewWarnings::heard().isEmpty()) << ViewWarnings::heard().join(u'\n').toStdString();
}

TEST_F(ProjectFilesTest, ClosingAsksWithAlarmStopWithinReach)
{
    nameStation(QStringLiteral("hoist"));
    {
        bool hasAlarmStop = false;
        const Question question([&](QWidget &dialog) {
            hasAlarmStop = dialog.findChild<QWidget *>(QStringLiteral("alarmStop")) != nullptr;
            QTest::keyClick(&dialog, Qt::Key_Escape);
        });
        window().close();
        EXPECT_TRUE(hasAlarmStop);
    }
    advance(5);
    EXPECT_TRUE(window().isVisible());
    {
        const Question question = Question::answeredBy(QStringLiteral("Discard"));
        window().close();
    }
    advance(5);
    EXPECT_FALSE(window().isVisible());
}

TEST_F(ProjectFilesTest, RecentFilesAreKeptForTheNextStart)
{
    window().files().open(saved("a.codewheel", QStringLiteral("a")));
    window().files().open(saved("b.codewheel", QStringLiteral("b")));
    open(); // a new window
    const QList<QAction *> recent = actions().recentFiles->actions();
    ASSERT_EQ(recent.size(), 2);
    EXPECT_TRUE(recent.first()->text().contains(QStringLiteral("b.codewheel")));
    recent.last()->trigger();
    advance(5);
    EXPECT_EQ(station(), QStringLiteral("a"));
    EXPECT_TRUE(actions().recentFiles->actions().first()->text().contains(QStringLiteral("a.codewheel")));
    QFile::remove(path("b.codewheel"));
    EXPECT_FALSE(window().files().open(path("b.codewheel")));
    Q_EMIT actions().recentFiles->aboutToShow();
    EXPECT_EQ(actions().recentFiles->actions().size(), 1) << "it is gone";
}

TEST_F(ProjectFilesTest, AFileDroppedOntoTheWindowIsOpened)
{
    drop(saved("crane.codewheel", QStringLiteral("hoist")));
    EXPECT_EQ(station(), QStringLiteral("hoist"));
    drop(path("picture.png"));
    EXPECT_EQ(document().file(), path("crane.codewheel"));
    EXPECT_TRUE(notice().contains(QStringLiteral("picture.png cannot be read")));
}

TEST_F(ProjectFilesTest, ADroppedFileIsKnownByWhatItHolds)
{
    const auto write = [this](const char *name, const QByteArray &text) {
        QFile file(path(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
        return path(name);
    };
    drop(write("words.txt", sequenceToJson({.words = {0x020000FF, 0x80000000}})));
    EXPECT_EQ(window().findChild<SequenceView *>()->list().words.size(), 2u);
    drop(write("steps.json", R"({"format": "codewheel-words", "version": 1})"));
    EXPECT_TRUE(notice().contains(QStringLiteral("not one that can be opened by dropping")));
    drop(write("readme.txt", "encoders"));
    EXPECT_TRUE(notice().contains(QStringLiteral("cannot be dropped here")));
    drop(write("own.json", R"({"vendor": "Own", "profile": "unheard of"})"));
    EXPECT_TRUE(
        notice("droppedDevice").contains(QStringLiteral("not a device description that can be used")));
    QFile::rename(saved("crane.codewheel", QStringLiteral("hoist")), path("crane.json"));
    nameStation(QStringLiteral("unsaved"));
    {
        const Question question = Question::answeredBy(QStringLiteral("Cancel"));
        drop(path("crane.json"));
    }
    EXPECT_EQ(station(), QStringLiteral("unsaved")) << "asked, as Open does";
    EXPECT_TRUE(document().file().isEmpty());
}

TEST_F(ProjectFilesTest, ADroppedFaultPlanIsLoadedAndBeginsOnlyWithRun)
{
    drop(faultPlan("lesson.cwfaults", "4.0"));
    EXPECT_EQ(notice("waitingFaultPlan"), QString());
    auto &bar = *window().findChild<FaultPlanBar *>();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !bar.visibleRegion().isEmpty(); }));
    EXPECT_TRUE(saysPlan(bar, QStringLiteral("Lesson 1: 1 step")));
    advance(50);
    EXPECT_FALSE(shown->controls().planProgress().isRunning);
}

TEST_F(ProjectFilesTest, ADroppedFaultPlanWaitsForATrainingRing)
{
    ringActions().disconnectBus->trigger();
    advance(5);
    drop(faultPlan("lesson.cwfaults", "4.0"));
    EXPECT_TRUE(notice("waitingFaultPlan").startsWith(QStringLiteral("lesson.cwfaults is a fault plan")));
    ringActions().connectBus->trigger();
    advance(50);
    EXPECT_EQ(notice("waitingFaultPlan"), QString());
    EXPECT_TRUE(saysPlan(*window().findChild<FaultPlanBar *>(), QStringLiteral("Lesson 1: 1 step")));
}

TEST_F(ProjectFilesTest, AFaultPlanForAnotherRingSaysSoInThePanel)
{
    drop(faultPlan("lesson.cwfaults", "9.0"));
    auto &bar = *window().findChild<FaultPlanBar *>();
    const auto *message = bar.findChild<InlineMessage *>();
    EXPECT_TRUE(message->isVisible());
    EXPECT_TRUE(message->sentence().contains(QStringLiteral("There is no device at \"9.0\"")))
        << message->sentence().toStdString();
}

TEST_F(ProjectFilesTest, DroppedCamsWaitForAnEncoderThatHasSome)
{
    auto &structure = *window().findChild<StructureView *>();
    structure.choose("3.0"_ring); // a K1
    advance(5);
    const QString cams = path("hoist.cwcams");
    ASSERT_TRUE(replaceFile(cams,
                            camFileToJson({.device = QStringLiteral("fraba-ocd-ib"),
                                           .totalRange = {},
                                           .programs = {{.cam = {{{.start = 10, .stop = 20}}}}}}),
                            OldFile::goes));
    drop(cams);
    EXPECT_TRUE(notice("waitingCams").startsWith(QStringLiteral("hoist.cwcams has cam programs")));
    structure.choose(test::fraba);
    advance(5);
    EXPECT_EQ(notice("waitingCams"), QString());
    auto &editor = *window().findChild<CamEditor *>();
    EXPECT_EQ(page(), &editor);
    EXPECT_EQ(editor.findChild<InlineMessage *>()->sentence(),
              QStringLiteral("Loaded from hoist.cwcams: program 1."));
    structure.choose(test::baumer);
    structure.choose(test::fraba);
    advance(5);
    EXPECT_EQ(notice("waitingCams"), QString()) << "once";
}

TEST_F(ProjectFilesTest, TheProjectNamesTheDevicesOfTheRing)
{
    ASSERT_FALSE(bus().structure().front().deviceKey.isEmpty());
    Project project = document().project();
    project.devices.front().participant.deviceKey.clear();
    ASSERT_TRUE(saveProject(project, path("unnamed.codewheel")));
    window().files().open(path("unnamed.codewheel"));
    EXPECT_EQ(bus().structure().front().deviceKey, QString());
    ASSERT_TRUE(bus().name(fraba, QStringLiteral("baumer-gxp6w"), 4096, 0));
    EXPECT_EQ(document().device(fraba).participant.deviceKey, QStringLiteral("baumer-gxp6w"));
    EXPECT_TRUE(window().isWindowModified());
    document().undoStack().undo();
    EXPECT_EQ(bus().structure().front().deviceKey, QString());
}

TEST_F(ProjectFilesTest, WhatIsUndoneOnAnotherBusIsChosen)
{
    auto &structure = *window().findChild<StructureView *>();
    document().editDevice(fraba, QStringLiteral("station"),
                          [](ProjectDevice &device) { device.station = QStringLiteral("Lift"); });
    const Place onLine = shown->plant().buses().places().back();
    ASSERT_NE(onLine.bus, fraba.bus);
    structure.choose(onLine);
    document().undoStack().undo();
    EXPECT_EQ(structure.current(), fraba);
}

TEST_F(ProjectFilesTest, APlanThatIsEditedDoesNotShiftTheNamesOfTheRing)
{
    const RingStructure before = bus().structure();
    Project project = document().project();
    project.devices.insert(project.devices.begin(), project.devices.front());
    for (std::size_t i = 0; i < project.devices.size(); ++i)
        if (i > 0)
            project.devices[i].participant.number = nextSegment(project.devices[i].participant.number);
    ASSERT_TRUE(saveProject(project, path("shifted.codewheel")));
    window().files().open(path("shifted.codewheel"));
    EXPECT_EQ(bus().structure(), before) << "2.0 is a FRABA in the plan, and has the code of the Baumer";
}

class RecoveryTest : public ProjectFilesTest
{
protected:
    QString recoveryFolder() const { return path("recovery"); }
    // As a killed program leaves it: kept, and no longer locked.
    void leaveBehind(const QString &station)
    {
        Project project = document().project();
        const QByteArray mark = projectMark(project);
        project.devices.front().station = station;
        QFile file;
        {
            Recovery crashed(recoveryFolder());
            ASSERT_TRUE(
                crashed.keep(project, path("crane.codewheel"), QDateTime::currentDateTimeUtc(), mark));
        }
    }
    void click(int button)
    {
        const auto buttons = window()
                                 .findChild<InlineMessage *>(QStringLiteral("recoveryQuestion"))
                                 ->findChildren<QPushButton *>();
        QTest::mouseClick(buttons.at(button), Qt::LeftButton);
    }
};

TEST_F(RecoveryTest, WhatACrashLeftIsOfferedAndTaken)
{
    leaveBehind(QStringLiteral("hoist"));
    {
        ProjectRecovery recovery(document(), recoveryFolder());
        window().askForRecovery(recovery);
        EXPECT_TRUE(notice("recoveryQuestion").contains(QStringLiteral("crane.codewheel")));
        click(0);
        EXPECT_EQ(station(), QStringLiteral("hoist"));
        EXPECT_EQ(document().file(), path("crane.codewheel"));
        EXPECT_FALSE(document().isSaved());
        EXPECT_EQ(notice("recoveryQuestion"), QString());
    }
    EXPECT_TRUE(leftProjects(recoveryFolder()).empty());
}

TEST_F(RecoveryTest, WhatIsDiscardedIsNotOfferedAgain)
{
    leaveBehind(QStringLiteral("hoist"));
    ProjectRecovery recovery(document(), recoveryFolder());
    window().askForRecovery(recovery);
    click(1);
    EXPECT_EQ(notice("recoveryQuestion"), QString());
    EXPECT_TRUE(document().isSaved());
    EXPECT_TRUE(leftProjects(recoveryFolder()).empty());
}

TEST_F(RecoveryTest, WhatIsRecoveredDoesNotOverwriteWhatWasSavedSince)
{
    saved("crane.codewheel", {});
    leaveBehind(QStringLiteral("hoist"));
    ProjectRecovery recovery(document(), recoveryFolder());
    window().askForRecovery(recovery);
    click(0);
    saved("crane.codewheel", QStringLiteral("of another program"));
    {
        const Question question = Question::answeredBy(QStringLiteral("Cancel"));
        EXPECT_FALSE(window().files().save());
    }
    saved("crane.codewheel", {});
    EXPECT_TRUE(window().files().save()) << "the file has what it had";
    EXPECT_EQ(loadProject(path("crane.codewheel"))->devices.front().station, QStringLiteral("hoist"));
}

TEST_F(RecoveryTest, ChangesAreKeptUntilTheyAreSaved)
{
    ProjectRecovery recovery(document(), recoveryFolder());
    nameStation(QStringLiteral("hoist"));
    recovery.keep();
    EXPECT_FALSE(QDir(recoveryFolder()).isEmpty());
    document().setFile(path("crane.codewheel"));
    EXPECT_TRUE(leftProjects(recoveryFolder()).empty());
}

} // namespace
} // namespace codewheel
