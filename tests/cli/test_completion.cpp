// SPDX-License-Identifier: GPL-3.0-or-later
// What the completion of a shell is told. It must open nothing and never complain.
#include "cli/commands.h"
#include "cli/completion/complete.h"
#include "cli/completion/usage_words.h"
#include "cli/kinds/link_kind.h"
#include "links/serial_ports.h"
#include "tests/cli/cli_run.h"
#include "tests/support/pty_pair.h"

#include <QRegularExpression>

#include <gmock/gmock.h>
#include <poll.h>
#include <termios.h>

namespace codewheel {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::Not;
using testing::StartsWith;

const QString crane = QStringLiteral(CODEWHEEL_ROOT "/docs/examples/crane.codewheel");

// `line`: everything behind codewheel-cli, split at spaces; a last space begins a new word.
std::vector<std::string> completed(const QString &line)
{
    std::vector<std::string> texts;
    for (const Candidate &candidate : candidates(line.split(u' ')))
        texts.push_back(candidate.text.toStdString());
    return texts;
}

TEST(Completion, CommandsComeFromTheTableOfTheProgram)
{
    const auto all = completed(QString());
    EXPECT_EQ(all.size(), allCommands().size());
    EXPECT_THAT(completed(QStringLiteral("re")),
                ElementsAre("read", "reset", "replace", "restore", "report", "record"));
    EXPECT_THAT(completed(QStringLiteral("--link esc:training sca")), ElementsAre("scan"));
    EXPECT_THAT(all, Not(Contains("complete"))) << "no help mentions it";
}

TEST(Completion, OptionsAreThoseOfTheCommandWhichAreNotYetGiven)
{
    EXPECT_THAT(completed(QStringLiteral("write 1.0 --dr")), ElementsAre("--dry-run"));
    EXPECT_THAT(completed(QStringLiteral("write 1.0 --dry-run --dr")), IsEmpty());
    EXPECT_THAT(completed(QStringLiteral("scan --a")), ElementsAre("--all-rates", "--ask"));
    EXPECT_THAT(completed(QStringLiteral("serve esc --corr")), ElementsAre("--corrupted"));
    EXPECT_THAT(completed(QStringLiteral("--v")), ElementsAre("--version"));
}

TEST(Completion, PlacesOfTheTrainingBusAreItsPlan)
{
    EXPECT_THAT(completed(QStringLiteral("read ")),
                ElementsAre("1.0", "2.0", "3.0", "4.0", "5.0", "6.1", "esc:03", "esc:05", "esc:12", "can:5",
                            "can:6", "can:7"));
    EXPECT_THAT(completed(QStringLiteral("read --link interbus:training 1")), ElementsAre("1.0"));
    EXPECT_THAT(completed(QStringLiteral("clone 1.0 6")), ElementsAre("6.1"));
    EXPECT_THAT(completed(QStringLiteral("monitor --link esc:ttyUSB0 ")), IsEmpty()) << "nobody knows";
    EXPECT_THAT(completed(QStringLiteral("monitor 1.0 ")), IsEmpty()) << "it takes one";
}

TEST(Completion, APlaceMayBeOneOfTheProjectOrAStation)
{
    const auto places = completed(QStringLiteral("read --link project --project %1 ").arg(crane));
    EXPECT_THAT(places, Contains("1.0"));
    EXPECT_THAT(completed(QStringLiteral("store %1 ").arg(crane)), Contains("1.0"));
    EXPECT_THAT(completed(QStringLiteral("devices --project %1 --bus ").arg(crane)), Contains("Ring"));
    EXPECT_THAT(completed(QStringLiteral("read --link project --project /no/such/file ")), IsEmpty());
}

TEST(Completion, ParametersAreThoseOfTheDeviceAtThePlace)
{
    EXPECT_THAT(completed(QStringLiteral("read 1.0 st")), Contains("steps"));
    EXPECT_THAT(completed(QStringLiteral("write 1.0 ste")), ElementsAre("steps="));
    EXPECT_THAT(completed(QStringLiteral("write 1.0 steps=255 direction=c")),
                ElementsAre("direction=cw", "direction=ccw"));
    const auto ofLine = completed(QStringLiteral("read esc:05 "));
    EXPECT_THAT(ofLine, Not(IsEmpty()));
    EXPECT_NE(ofLine, completed(QStringLiteral("read 1.0 ")));
    EXPECT_THAT(completed(QStringLiteral("read Line/05 ")), ofLine);
    EXPECT_THAT(completed(QStringLiteral("read somewhere ")), IsSupersetOf(ofLine)) << "of any device";
}

TEST(Completion, DevicesLinksAndFixedWords)
{
    EXPECT_THAT(completed(QStringLiteral("devices kuebler")),
                ElementsAre("kuebler-esc-rs422", "kuebler-esc-rs485"));
    EXPECT_THAT(completed(QStringLiteral("scan --link ")),
                ElementsAre("training", "project", "interbus:", "modbus-tcp:", "modbus-rtu:", "esc:", "can:",
                            "slcan:", "canopen:", "log:"));
    EXPECT_THAT(
        completed(QStringLiteral("scan --link=esc:")),
        AllOf(IsSupersetOf({"--link=esc:training", "--link=esc:project"}), Each(StartsWith("--link=esc:"))));
    EXPECT_THAT(completed(QStringLiteral("scan --link esc:ttyUSB0,baud=9600,form")),
                ElementsAre("esc:ttyUSB0,baud=9600,format="));
    EXPECT_THAT(completed(QStringLiteral("scan --link esc:ttyUSB0,baud=9600,ba")), IsEmpty()) << "given";
    EXPECT_THAT(completed(QStringLiteral("gateway --link modbus-tcp:host,un")),
                ElementsAre("modbus-tcp:host,unit="));
    EXPECT_THAT(completed(QStringLiteral("cams 1.0 ")), ElementsAre("read", "write", "compare"));
    EXPECT_THAT(completed(QStringLiteral("master segment 2 ")), ElementsAre("on", "off"));
    EXPECT_THAT(completed(QStringLiteral("explain 0 --direction ")), ElementsAre("in", "out"));
    EXPECT_THAT(completed(QStringLiteral("messages --severity f")), ElementsAre("fault"));
    std::vector<std::string> ports;
    for (const PortInfo &port : serialPorts())
        ports.push_back(port.path.section(u'/', -1).toStdString());
    EXPECT_THAT(completed(QStringLiteral("find ")), testing::ElementsAreArray(ports));
    EXPECT_THAT(completed(QStringLiteral("serve ")),
                ElementsAre("modbus-tcp", "modbus-rtu", "esc", "canopen"));
}

TEST(Completion, FilesAreLeftToTheShell)
{
    EXPECT_THAT(completed(QStringLiteral("compare cr")), ElementsAre(":files codewheel"));
    EXPECT_THAT(completed(QStringLiteral("scan --project ")), ElementsAre(":files codewheel"));
    EXPECT_THAT(completed(QStringLiteral("export ni")), ElementsAre(":files cwrec"));
    EXPECT_THAT(completed(QStringLiteral("cams 1.0 read ca")), ElementsAre(":files"));
    EXPECT_THAT(completed(QStringLiteral("monitor can:5 --link log:ni")), ElementsAre(":files log:"));
    EXPECT_THAT(completed(QStringLiteral("monitor can:5 --link=log:ni")), ElementsAre(":files log:"));
    EXPECT_THAT(completed(QStringLiteral("monitor can:5 --link log:night.log,us")),
                ElementsAre("log:night.log,usual-mapping="));
}

TEST(Completion, IsSilentAboutACallThatMakesNoSense)
{
    for (const char *line : {"complete -- nonsense x", "complete -- read 1.0 --link nowhere: ", "complete --",
                             "complete -- scan --link", "complete -- -x=y", "complete -- read -- "}) {
        const CliRun run = runLine(QString::fromLatin1(line));
        EXPECT_EQ(run.exit, 0) << line;
        EXPECT_EQ(run.err, "") << line;
    }
}

TEST(Completion, IsPrintedWithItsHelpBehindATab)
{
    const CliRun run = runLine(QStringLiteral("complete -- dev"));
    EXPECT_EQ(run.out, "devices\tlist the encoders this program knows\n");
    const CliRun named = runLine(QStringLiteral("complete -- devices fraba-ocd-ib-k2"));
    EXPECT_THAT(named.out, HasSubstr("fraba-ocd-ib-k2\tFRABA"));
}

TEST(Completion, OpensNoPort)
{
    PtyPair port;
    termios before{};
    tcgetattr(port.descriptor(), &before);
    for (const char *line : {"read 05 --link esc:%1 ", "read --link esc:%1 ", "scan --link esc:%1,"})
        (void)completed(QString::fromLatin1(line).arg(port.path()));
    pollfd sent{port.descriptor(), POLLIN, 0};
    EXPECT_EQ(poll(&sent, 1, 0), 0);
    termios after{};
    tcgetattr(port.descriptor(), &after);
    EXPECT_EQ(cfgetospeed(&after), cfgetospeed(&before)) << "a port that is opened gets its baud rate";
    EXPECT_EQ(after.c_lflag, before.c_lflag);
}

// Whatever a usage says: a position has either fixed words, or something that completion knows about.
TEST(Completion, UnderstandsTheUsageOfEveryCommand)
{
    for (const Subcommand *command : allCommands()) {
        const UsageWords words(*command);
        for (int i = 0; i < command->arguments.least; ++i)
            EXPECT_FALSE(words.at(i).isEmpty()) << command->name << ", argument " << i;
        for (const QString &word : words.at(0))
            EXPECT_FALSE(word.contains(QRegularExpression(QStringLiteral("[\\[\\]. ]"))))
                << command->name << ": " << word.toStdString();
    }
}

} // namespace
} // namespace codewheel
