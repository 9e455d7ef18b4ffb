// SPDX-License-Identifier: GPL-3.0-or-later
#include "language.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "widgets/help/help_topic.h"
#include "widgets/help/help_window.h"
#include "widgets/look/label_text.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QShortcut>
#include <QStackedWidget>
#include <QTest>
#include <QTextBrowser>
#include <QTimer>
#include <QTreeWidget>

#include <algorithm>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

class HelpTest : public test::WindowTest
{
protected:
    QDialog *keys() { return window().findChild<QDialog *>(QStringLiteral("keys")); }
    QTreeWidget &keyList() { return *keys()->findChild<QTreeWidget *>(); }
    QStringList shownKeys() // "what: keys"
    {
        QStringList rows;
        for (QTreeWidgetItemIterator each(&keyList(), QTreeWidgetItemIterator::NotHidden); *each != nullptr;
             ++each)
            if ((*each)->parent() != nullptr)
                rows << (*each)->text(0) + QStringLiteral(": ") + (*each)->text(1);
        return rows;
    }
    static HelpWindow *help()
    {
        for (QWidget *each : QApplication::topLevelWidgets())
            if (auto *its = qobject_cast<HelpWindow *>(each))
                return its;
        return nullptr;
    }
    static QString shownTopic() { return help()->shown().fileName() + u'#' + help()->shown().fragment(); }
    void checkTopic(const QWidget &part, const QString &name)
    {
        const QString topic = helpTopicOf(&part);
        EXPECT_FALSE(topic.isEmpty()) << name.toStdString();
        EXPECT_TRUE(manual.has(Manual::url(topic))) << name.toStdString() << ": " << topic.toStdString();
    }

    const Manual manual;
};

TEST_F(HelpTest, TheManualTellsOfEveryPanel)
{
    const auto panels = window().findChildren<QDockWidget *>();
    EXPECT_GE(panels.size(), 11);
    for (const auto *panel : panels)
        checkTopic(*panel, panel->windowTitle());
}

TEST_F(HelpTest, TheManualTellsOfEveryPage)
{
    const auto *pages = window().findChild<QStackedWidget *>(QStringLiteral("pages"));
    EXPECT_GE(pages->count(), 10);
    for (int i = 0; i < pages->count(); ++i)
        checkTopic(*pages->widget(i), QLatin1String(pages->widget(i)->metaObject()->className()));
}

TEST_F(HelpTest, F1OpensTheManualWhereItTellsOfWhatHasTheFocus)
{
    QTest::keyClick(&window(), Qt::Key_8, Qt::AltModifier);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F1);
    ASSERT_NE(help(), nullptr);
    EXPECT_EQ(shownTopic(), QStringLiteral("device.md#"));
    EXPECT_FALSE(help()->isModal());
    actions().structureEditor->trigger();
    window().activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window()));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F1);
    EXPECT_EQ(shownTopic(), QStringLiteral("project.md#the-structure-editor"));
    EXPECT_TRUE(QTest::qWaitFor([] { return QApplication::activeWindow() == help(); }));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F1);
    EXPECT_EQ(shownTopic(), QStringLiteral("help.md#")) << "of the help itself";
    actions().manual->trigger();
    EXPECT_EQ(help()->shown(), Manual::firstPage());
}

TEST_F(HelpTest, F1OpensTheManualWhileAQuestionIsAskedAndItCanBeRead)
{
    send(test::fraba, 0x0200'00FF);
    const test::Question question([](QWidget &dialog) {
        QTest::keyClick(&dialog, Qt::Key_F1);
        ASSERT_NE(help(), nullptr);
        EXPECT_EQ(shownTopic(), QStringLiteral("README.md#leaving"));
        EXPECT_TRUE(help()->isVisible());
        EXPECT_TRUE(QTest::qWaitFor([] { return QApplication::activeWindow() == help(); }));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Home, Qt::AltModifier);
        EXPECT_EQ(help()->shown(), Manual::firstPage()) << "it takes keys";
        dialog.close();
    });
    actions().stop->trigger();
    EXPECT_TRUE(question.wasAsked());
    EXPECT_TRUE(help()->isVisible()) << "it outlives the question";
}

TEST_F(HelpTest, F1InAFileDialogOpensTheTopicOfWhoOpenedIt)
{
    const auto topicIn = [](QAction &opens) {
        QString topic;
        const test::Question question([&topic](QWidget &dialog) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_F1);
            topic = shownTopic();
            dialog.close();
        });
        opens.trigger();
        EXPECT_TRUE(QTest::qWaitFor([&] { return question.wasAsked() && !topic.isEmpty(); }));
        return topic.toStdString();
    };
    EXPECT_EQ(topicIn(*actions().exportReport), "report.md#");
    EXPECT_EQ(topicIn(*actions().openProject), "project.md#files");
    EXPECT_EQ(topicIn(*actions().saveProjectAs), "project.md#files");
    EXPECT_EQ(topicIn(*actions().exportMessages), "messages.md#");
}

TEST_F(HelpTest, F1WhereAFileDialogAsksToReplaceAFileIsAboutFilesToo)
{
    QFile old(folder.filePath(QStringLiteral("old.codewheel")));
    ASSERT_TRUE(old.open(QIODevice::WriteOnly));
    old.close();
    QString topic;
    const test::Question saving([&](QWidget &dialog) {
        auto &files = dynamic_cast<QFileDialog &>(dialog);
        files.setDirectory(folder.path());
        files.findChild<QLineEdit *>()->setText(QStringLiteral("old.codewheel"));
        QTimer::singleShot(0, &files, [&] {
            QWidget *replace = QApplication::activeModalWidget();
            ASSERT_NE(qobject_cast<QMessageBox *>(replace), nullptr);
            QTest::keyClick(replace, Qt::Key_F1);
            topic = shownTopic();
            replace->close();
            files.close();
        });
        QTest::keyClick(files.findChild<QLineEdit *>(), Qt::Key_Return);
    });
    actions().saveProjectAs->trigger();
    EXPECT_EQ(topic, QStringLiteral("project.md#files"));
}

TEST_F(HelpTest, AlarmStopWorksWhileTheManualIsRead)
{
    send(test::fraba, 0x0200'00FF);
    actions().manual->trigger();
    EXPECT_TRUE(QTest::qWaitForWindowActive(help()));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F12, Qt::ControlModifier);
    advance(10);
    EXPECT_EQ(out(test::fraba), 0U);
}

TEST_F(HelpTest, TheManualKeepsItsSizeAndGoesWithTheWindow)
{
    actions().manual->trigger();
    help()->resize(650, 420);
    open();
    EXPECT_EQ(help(), nullptr);
    actions().manual->trigger();
    EXPECT_EQ(help()->size(), QSize(650, 420));
}

TEST_F(HelpTest, TheListOfKeysFitsASmallScreenAndLeavesTheWindowAtWork)
{
    actions().keys->trigger();
    ASSERT_NE(keys(), nullptr);
    EXPECT_LE(keys()->height(), 600);
    EXPECT_FALSE(keys()->isModal());
    const QStringList rows = shownKeys();
    for (const char *expected :
         {"ALARM STOP 2 buses: Ctrl+F12", "Help on this: F1", "Keys: Ctrl+F1", "Handshake trace: Alt+6",
          "Toggles a bit of OUT: Space", "The request typed before, or after: Up, Down",
          "Lists the commands: Ctrl+Space", "Shows all devices: Esc",
          "Brings back what stood there before: Esc", "Read: Ctrl+R",
          "Shows fewer positions, or more, or all: +, -, 0"})
        EXPECT_TRUE(rows.contains(QLatin1String(expected))) << expected;
    actions().keys->trigger();
    EXPECT_EQ(window().findChildren<QDialog *>(QStringLiteral("keys")).size(), 1) << "it is one list";
}

TEST_F(HelpTest, TheListOfKeysIsSearched)
{
    actions().keys->trigger();
    auto *search = keys()->findChild<QLineEdit *>();
    const auto all = shownKeys().size();
    QTest::keyClicks(search, QStringLiteral("alarm"));
    EXPECT_EQ(shownKeys(), QStringList{QStringLiteral("ALARM STOP 2 buses: Ctrl+F12")});
    search->clear();
    QTest::keyClicks(search, QStringLiteral("ctrl+f12"));
    EXPECT_EQ(shownKeys().size(), 1);
    search->clear();
    EXPECT_EQ(shownKeys().size(), all);
}

TEST_F(HelpTest, TheListOfKeysHasEachKeyOfEachAction)
{
    advance(50);
    actions().keys->trigger();
    const QStringList rows = shownKeys();
    for (const QAction *action : window().findChildren<QAction *>()) {
        if (action->shortcut().isEmpty() || action->text().isEmpty())
            continue;
        EXPECT_TRUE(std::ranges::any_of(rows, [&](const QString &row) {
            return row.startsWith(plainLabel(action->text())) && row.contains(action->shortcut().toString());
        })) << action->text().toStdString();
    }
    for (const auto *shortcut : window().findChildren<QShortcut *>())
        EXPECT_TRUE(std::ranges::any_of(rows, [&](const QString &row) {
            return row.contains(shortcut->key().toString());
        })) << shortcut->key().toString().toStdString();
}

TEST_F(HelpTest, AlarmStopWorksWhileTheKeysAreRead)
{
    send(test::fraba, 0x0200'00FF);
    actions().keys->trigger();
    keys()->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(keys()));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F12, Qt::ControlModifier);
    advance(10);
    EXPECT_EQ(out(test::fraba), 0U);
}

class HelpInGerman : public HelpTest
{
protected:
    HelpInGerman()
    {
        language.use(QStringLiteral("de"));
        open();
    }
    ~HelpInGerman() override { QLocale::setDefault(QLocale::c()); }

private:
    Language language;
};

TEST_F(HelpInGerman, F1OpensThePageInTheLanguageOfTheWindow)
{
    QTest::keyClick(&window(), Qt::Key_8, Qt::AltModifier);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F1);
    ASSERT_NE(help(), nullptr);
    EXPECT_TRUE(help()->shown().path().endsWith(QStringLiteral("/manual/de/device.md")))
        << help()->shown().path().toStdString();
    actions().structureEditor->trigger();
    window().activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window()));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F1);
    const QUrl editor = help()->shown();
    EXPECT_TRUE(editor.path().endsWith(QStringLiteral("/manual/de/project.md")));
    const Manual german;
    ASSERT_TRUE(german.has(editor)) << editor.toString().toStdString();
    const auto &sections = german.find(editor)->sections;
    const auto its = std::ranges::find(sections, editor.fragment(QUrl::FullyDecoded), &ManualSection::anchor);
    ASSERT_NE(its, sections.end());
    EXPECT_EQ(its->title, QStringLiteral("Busaufbau bearbeiten"));
}

TEST_F(HelpInGerman, EveryPageAndPanelHasItsPlace)
{
    const Manual german;
    const auto check = [&](const QWidget &part) {
        const QUrl url = Manual::url(helpTopicOf(&part));
        EXPECT_TRUE(german.has(url)) << url.toString().toStdString();
    };
    const auto *pages = window().findChild<QStackedWidget *>(QStringLiteral("pages"));
    for (int i = 0; i < pages->count(); ++i)
        check(*pages->widget(i));
    for (const auto *panel : window().findChildren<QDockWidget *>())
        check(*panel);
}

// Those about files and protocols are in English, and lead back.
TEST_F(HelpInGerman, APageInEnglishLeadsToTheGermanOnes)
{
    actions().manual->trigger();
    auto *page = help()->findChild<QTextBrowser *>();
    page->setSource(Manual::url(QStringLiteral("../cam-files.md")));
    page->setSource(QUrl(QStringLiteral("manual/cams.md")));
    EXPECT_TRUE(help()->shown().path().endsWith(QStringLiteral("/manual/de/cams.md")))
        << help()->shown().path().toStdString();
}

} // namespace
} // namespace codewheel
