// SPDX-License-Identifier: GPL-3.0-or-later
// Help > Collect for support: the file contains what was listed, and nothing identifies the computer's owner.
#include "app/window/files/private_names.h"
#include "app/window/files/support_dialog.h"
#include "project/project_json.h"
#include "tests/app/window_test.h"
#include "widgets/look/inline_message.h"
#include "widgets/project/project_document.h"
#include "widgets/trace/trace_view.h"

#include <QAction>
#include <QFile>
#include <QPlainTextEdit>
#include <QProcess>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class SupportTest : public test::WindowTest
{
protected:
    SupportDialog &dialog()
    {
        auto *its = window().findChild<SupportDialog *>();
        if (its == nullptr) {
            actions().collectSupport->trigger();
            its = window().findChild<SupportDialog *>();
        }
        return *its;
    }
    QTreeWidget &list() { return *dialog().findChild<QTreeWidget *>(QStringLiteral("supportFiles")); }
    std::vector<std::string> listed()
    {
        std::vector<std::string> names;
        for (int i = 0; i < list().topLevelItemCount(); ++i)
            names.push_back(list().topLevelItem(i)->text(0).toStdString());
        return names;
    }
    std::string notice()
    {
        return window().findChild<InlineMessage *>(QStringLiteral("notice"))->sentence().toStdString();
    }
    QString zip() const { return folder.filePath(QStringLiteral("support.zip")); }
    // With a program that shares no code with this one.
    static QByteArray python(const QString &script, const QStringList &arguments)
    {
        QProcess process;
        process.start(QStringLiteral(CODEWHEEL_PYTHON),
                      QStringList{QStringLiteral("-c"), script} + arguments);
        EXPECT_TRUE(process.waitForFinished());
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
        return process.readAllStandardOutput();
    }
    std::vector<std::string> saved() const
    {
        std::vector<std::string> names;
        const auto lines =
            python(QStringLiteral("import sys, zipfile; z = zipfile.ZipFile(sys.argv[1]); "
                                  "assert z.testzip() is None; print(*z.namelist(), sep='\\n')"),
                   {zip()});
        for (const QByteArray &line : lines.trimmed().split('\n'))
            names.push_back(line.toStdString());
        return names;
    }
    QByteArray content(const char *name) const
    {
        return python(
            QStringLiteral("import sys, zipfile; "
                           "sys.stdout.buffer.write(zipfile.ZipFile(sys.argv[1]).read(sys.argv[2]))"),
            {zip(), QLatin1String(name)});
    }
};

TEST_F(SupportTest, SavesWhatWasListedAndNothingElse)
{
    send(test::fraba, 0x0200'00FF);
    const auto names = listed();
    for (const char *expected :
         {"project.codewheel", "messages.csv", "trace-1.0.csv", "versions.txt", "adapters.txt", "buses.txt"})
        EXPECT_THAT(names, Contains(std::string(expected)));
    ASSERT_TRUE(dialog().saveTo(zip()));
    EXPECT_EQ(saved(), names);
    EXPECT_THAT(content("trace-1.0.csv").toStdString(), HasSubstr("020000FF"));
    EXPECT_THAT(content("versions.txt").toStdString(), HasSubstr("Qt 6"));
    EXPECT_THAT(content("buses.txt").toStdString(), HasSubstr("FRABA OCD-IB K3"));
    EXPECT_THAT(notice(), HasSubstr("support.zip"));
}

TEST_F(SupportTest, HasTheProjectWithWhatIsNotSaved)
{
    shown->project().editDevice(test::fraba, QStringLiteral("Steps"), [](ProjectDevice &device) {
        device.wanted = {{Parameter::steps, 4096}};
    });
    ASSERT_TRUE(dialog().saveTo(zip()));
    const auto project = projectFromJson(content("project.codewheel"), QStringLiteral("project"));
    ASSERT_TRUE(project);
    EXPECT_EQ(*project, shown->project().project());
}

TEST_F(SupportTest, LeavesOutWhatIsNotTickedAndTakesANote)
{
    list().setFocus();
    list().setCurrentItem(list().topLevelItem(0));
    QTest::keyClick(&list(), Qt::Key_Space);
    QTest::keyClicks(dialog().findChild<QPlainTextEdit *>(QStringLiteral("supportNote")),
                     QStringLiteral("It stops at night"));
    ASSERT_TRUE(dialog().saveTo(zip()));
    EXPECT_THAT(saved(), Not(Contains(std::string("project.codewheel"))));
    EXPECT_EQ(content("message.txt"), QByteArray("It stops at night\n"));
}

TEST_F(SupportTest, ShowsWhatAFileHolds)
{
    for (int i = 0; i < list().topLevelItemCount(); ++i)
        if (list().topLevelItem(i)->text(0) == QStringLiteral("versions.txt"))
            list().setCurrentItem(list().topLevelItem(i));
    EXPECT_TRUE(dialog()
                    .findChild<QPlainTextEdit *>(QStringLiteral("supportContent"))
                    ->toPlainText()
                    .contains(QStringLiteral("Codewheel")));
}

TEST_F(SupportTest, SaysWhyItWasNotSavedAndKeepsWhatWasThere)
{
    QFile old(zip());
    ASSERT_TRUE(old.open(QIODevice::WriteOnly));
    old.write("old");
    old.close();
    EXPECT_FALSE(dialog().saveTo(folder.filePath(QStringLiteral("nowhere/support.zip"))));
    EXPECT_THAT(dialog().findChild<InlineMessage *>()->sentence().toStdString(), HasSubstr("nowhere"));
    EXPECT_TRUE(dialog().isVisible());
    EXPECT_FALSE(dialog().saveTo(QStringLiteral("/dev/full"))) << "it is not a file";
    ASSERT_TRUE(old.open(QIODevice::ReadOnly));
    EXPECT_EQ(old.readAll(), QByteArray("old"));
    EXPECT_TRUE(dialog().saveTo(zip())) << "in place of one that is there";
    EXPECT_FALSE(saved().empty());
}

TEST_F(SupportTest, NothingTellsWhoseComputerItIs)
{
    const PrivateNames names = PrivateNames::ofThisComputer();
    for (const SupportFile &file : supportFiles(
             {shown->project(), shown->plant(), shown->messages(), *window().findChild<TraceView *>()})) {
        const QString text = QString::fromUtf8(file.file.bytes);
        EXPECT_EQ(withoutPrivateNames(text, names), text) << file.file.name.toStdString();
    }
}

TEST(PrivateNames, AreTakenOutOfPathsAndNotOutOfWords)
{
    const PrivateNames names{QStringLiteral("/home/crane"), QStringLiteral("crane"), QStringLiteral("pc-17")};
    const auto without = [&](const char *text) {
        return withoutPrivateNames(QString::fromUtf8(text), names).toStdString();
    };
    EXPECT_EQ(without("/home/crane/a.codewheel was saved."), "~/a.codewheel was saved.");
    EXPECT_EQ(without("/home/crane2/a.codewheel"), "/home/crane2/a.codewheel");
    EXPECT_EQ(without("/media/crane/STICK/crane.pdf"), "/media/user/STICK/crane.pdf");
    EXPECT_EQ(without("The crane on pc-17 stands."), "The crane on computer stands.");
    EXPECT_EQ(withoutPrivateNames(QStringLiteral("unchanged"), {}), QStringLiteral("unchanged"));
}

} // namespace
} // namespace codewheel
