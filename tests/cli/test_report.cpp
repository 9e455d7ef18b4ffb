// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/command_line.h"
#include "tests/cli/cli_run.h"
#include "tests/support/no_room.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;

// The project of docs/examples: among other things, steps 4096 wanted of both encoders of the training bus.
class CliReport : public testing::Test
{
protected:
    CliRun runIt(const QString &options)
    {
        return shared.runLine(QStringLiteral("report %1/docs/examples/two-encoders.codewheel %2")
                                  .arg(QStringLiteral(CODEWHEEL_ROOT), options));
    }
    std::string content() const
    {
        QFile file(html);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll().toStdString();
    }

    SharedBus shared;
    QTemporaryDir folder;
    QString html = folder.filePath(QStringLiteral("report.html"));
};

TEST_F(CliReport, TellsWhatTheProjectHasStoredAndSendsNothing)
{
    const CliRun run = runIt(QStringLiteral("-o ") + html);
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("Saved in " + html.toStdString() +
                                   ".\n"
                                   "Deviations of encoders from what is wanted: 0; not compared: 4.\n"));
    EXPECT_THAT(content(),
                HasSubstr("<td>Steps</td><td class=\"number\">4096</td><td class=\"number\">unknown"));
    EXPECT_THAT(content(), HasSubstr("The configured bus was not compared with a connected one."));
    EXPECT_EQ(shared.bus().latest().cycle, 0U);
}

TEST_F(CliReport, ReadsWhenAskedTo)
{
    const CliRun run = runIt(QStringLiteral("--read -o ") + html);
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(content(), HasSubstr("<tr class=\"stressed\"><td>Steps</td><td class=\"number\">4096</td><td "
                                     "class=\"number\">8192</td><td>steps</td><td>read</td>"));
    EXPECT_THAT(content(), HasSubstr("20417 (4FC1h) (read)"));
    EXPECT_THAT(content(), HasSubstr("additional"));
    EXPECT_EQ(shared.eepromWrites(), 0);
}

TEST_F(CliReport, TellsProgramsWhatItFound)
{
    const QJsonObject json = runIt(QStringLiteral("--read --json -o ") + html).json();
    EXPECT_EQ(json[u"command"], QStringLiteral("report"));
    EXPECT_EQ(json[u"saved"], html);
    EXPECT_EQ(json[u"deviations"], 1);  // steps of the FRABA
    EXPECT_EQ(json[u"notCompared"], 2); // a Baumer cannot be read
}

TEST_F(CliReport, DoesNotReplaceAFileUnlessToldTo)
{
    ASSERT_EQ(runIt(QStringLiteral("-o ") + html).exit, 0);
    const CliRun again = runIt(QStringLiteral("-o ") + html);
    EXPECT_EQ(again.exit, 2);
    EXPECT_THAT(again.err, HasSubstr("is there already. Nothing was saved."));
    EXPECT_EQ(runIt(QStringLiteral("--yes -o ") + html).exit, 0);
}

TEST_F(CliReport, RefusesAFormatItDoesNotKnow)
{
    const CliRun run = runIt(QStringLiteral("-o report.doc"));
    EXPECT_EQ(run.exit, 2);
    EXPECT_THAT(run.err, HasSubstr("\"report.doc\" ends neither in .html nor in .pdf."));
    EXPECT_EQ(errorKey(runIt(QStringLiteral("-o report.doc --json"))), "reportFormatUnknown");
    EXPECT_EQ(errorKey(runIt(QStringLiteral("--json"))), "missingFile");
}

TEST_F(CliReport, SaysWhatCannotBeReadOrWritten)
{
    const CliRun nowhere = runIt(QStringLiteral("-o /nonexistent/x.pdf"));
    EXPECT_THAT(nowhere.err, HasSubstr("/nonexistent/x.pdf cannot be written: No such file or directory. "
                                       "Nothing was changed there.\n"));
    const CliRun nothing = runLine(QStringLiteral("report nowhere.codewheel --json -o ") + html);
    EXPECT_EQ(nothing.exit, 2);
    EXPECT_EQ(errorKey(nothing), "fileNotReadable");
    EXPECT_FALSE(QFile::exists(html));
    EXPECT_EQ(
        errorKey(runIt(QStringLiteral("--json -o ") + folder.filePath(QStringLiteral("no/where.html")))),
        "fileNotWritten");
}

TEST_F(CliReport, WhereThereIsNoRoomTheOldReportStaysAndItIsTold)
{
    QFile file(html);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("old");
    file.close();
    const CliRun run = [&] {
        const test::NoRoom disk(100);
        return runIt(QStringLiteral("--yes -o %1").arg(html));
    }();
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("cannot be written: File too large."));
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(content(), "old");
}

TEST_F(CliReport, AnEncoderThatDoesNotAnswerIsToldAndTheReportSaved)
{
    shared.controls().setFault(TrainingFault::powerOff, NodeId("1.0"), 1);
    const CliRun run = runIt(QStringLiteral("--read -o ") + html);
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("1.0 could not be read: "));
    EXPECT_THAT(content(),
                HasSubstr("<td>Steps</td><td class=\"number\">4096</td><td class=\"number\">unknown"));
}

TEST(CliReportFonts, AreNeededForAPdfOnly)
{
    EXPECT_TRUE(
        makesPdf({QStringLiteral("report"), QStringLiteral("a.codewheel"), QStringLiteral("-o=b.PDF")}));
    EXPECT_FALSE(
        makesPdf({QStringLiteral("report"), QStringLiteral("a.codewheel"), QStringLiteral("b.html")}));
    EXPECT_FALSE(makesPdf({QStringLiteral("scan")}));
}

} // namespace
} // namespace codewheel
