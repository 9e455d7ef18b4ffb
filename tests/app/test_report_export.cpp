// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/paper/report_export.h"
#include "app/window/paper/report_preview.h"
#include "tests/app/question.h"
#include "tests/app/window_test.h"
#include "widgets/look/inline_message.h"
#include "widgets/project/project_document.h"

#include <QAction>
#include <QDesktopServices>
#include <QFile>
#include <QIODevice>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTextBrowser>
#include <QUrl>
#include <QWidget>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

using test::fraba;
using test::Question;
using testing::HasSubstr;

class ReportExportTest : public test::WindowTest
{
protected:
    QString path(const char *name) const { return folder.filePath(QString::fromLatin1(name)); }
    ReportExport &report() { return *window().findChild<ReportExport *>(); }
    std::string notice()
    {
        const auto *shownNotice = window().findChild<InlineMessage *>(QStringLiteral("notice"));
        return shownNotice->isVisible() ? shownNotice->sentence().toStdString() : std::string();
    }
    std::string content(const char *name) const
    {
        QFile file(path(name));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll().toStdString();
    }
};

TEST_F(ReportExportTest, SaysWhereTheReportWasSaved)
{
    const Word before = out(fraba);
    std::vector<MessageCode> told;
    QObject::connect(&report(), &ReportExport::told, &window(),
                     [&](const Message &message) { told.push_back(message.id); });
    EXPECT_TRUE(report().saveTo(path("crane.html")));
    EXPECT_THAT(notice(), HasSubstr("crane.html"));
    EXPECT_THAT(told, testing::ElementsAre(MessageId::reportSaved));
    EXPECT_THAT(content("crane.html"), HasSubstr("FRABA OCD-IB K3"));
    EXPECT_EQ(out(fraba), before);
}

TEST_F(ReportExportTest, HasWhatTheConnectedEncoderIsKnownToHave)
{
    ASSERT_TRUE(bus().encoder(fraba)->start(ReadParameters{{Parameter::steps}}));
    advance(500);
    shown->project().editDevice(fraba, QStringLiteral("Steps"), [](ProjectDevice &device) {
        device.wanted = {{Parameter::steps, 4096}};
    });
    ASSERT_TRUE(report().saveTo(path("crane.html")));
    EXPECT_THAT(content("crane.html"),
                HasSubstr("<td>Steps</td><td class=\"number\">4096</td><td class=\"number\">8192</td>"));
}

TEST_F(ReportExportTest, SavesAPdfWhereTheUserChoosesTo)
{
    int sheets = 0;
    std::optional<Question> question; // the next one
    const Question preview([&](QWidget &dialog) {
        question.emplace([&](QWidget &files) {
            files.findChild<QLineEdit *>()->setText(path("crane"));
            QTest::keyClick(files.findChild<QLineEdit *>(), Qt::Key_Return);
        });
        sheets = qobject_cast<ReportPreview *>(&dialog)->sheets();
        QTest::mouseClick(dialog.findChild<QPushButton *>(QStringLiteral("saveReport")), Qt::LeftButton);
    });
    actions().exportReport->trigger();
    EXPECT_GT(sheets, 2);
    EXPECT_THAT(content("crane.pdf"), testing::StartsWith("%PDF-"));
}

TEST_F(ReportExportTest, OpensWhatWasSaved)
{
    QTextBrowser opener; // instead of the desktop
    QDesktopServices::setUrlHandler(QStringLiteral("file"), &opener, "setSource");
    ASSERT_TRUE(report().saveTo(path("crane.html")));
    auto *shownNotice = window().findChild<InlineMessage *>(QStringLiteral("notice"));
    Q_EMIT shownNotice->actionTriggered();
    EXPECT_EQ(opener.source(), QUrl::fromLocalFile(path("crane.html")));
    EXPECT_EQ(notice(), "");
    QDesktopServices::unsetUrlHandler(QStringLiteral("file"));
    shownNotice->showMessage(Role::attention, QStringLiteral("Another question"), QStringLiteral("Yes"));
    Q_EMIT shownNotice->actionTriggered();
    EXPECT_EQ(notice(), "Another question") << "the notice is not the report's any more";
}

TEST_F(ReportExportTest, SaysThatNoProgramOpensTheReport)
{
    ASSERT_TRUE(report().saveTo(path("crane.html")));
    Q_EMIT window().findChild<InlineMessage *>(QStringLiteral("notice"))->actionTriggered();
    EXPECT_THAT(notice(), HasSubstr("The report is saved.")); // there is no desktop in a test
}

TEST_F(ReportExportTest, SaysWhyItWasNotSaved)
{
    EXPECT_FALSE(report().saveTo(path("crane.doc")));
    EXPECT_THAT(notice(), HasSubstr("ends neither in .pdf nor in .html"));
    EXPECT_FALSE(report().saveTo(path("nowhere/crane.pdf")));
    EXPECT_THAT(notice(), HasSubstr("nowhere/crane.pdf"));
}

} // namespace
} // namespace codewheel
