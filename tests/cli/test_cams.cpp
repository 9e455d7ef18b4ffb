// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/cli_run.h"
#include "tests/support/no_room.h"
#include "tests/support/places.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

class CliCams : public testing::Test
{
protected:
    // The path contains no space.
    QString file(const QByteArray &json)
    {
        QString name = m_directory.filePath(QStringLiteral("cams.json"));
        QFile file(name);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(json);
        return name;
    }
    static QByteArray program(const QByteArray &number, const QByteArray &shift, const QByteArray &start)
    {
        return R"({"format": "codewheel-cams", "version": 1, "device": "fraba-ocd-ib", "programs": [{"program": )" +
               number + R"(, "shift": )" + shift + R"(, "cams": [{"cam": 3, "start": )" + start +
               R"(, "stop": 531, "active": true}]}]})";
    }

    QTemporaryDir m_directory;
};

TEST_F(CliCams, WritesTheWordsOfTheManualAndReadsThemBack)
{
    SharedBus shared;
    const QString cams = file(program("1", "0", "21"));
    const CliRun run = shared.runLine(QStringLiteral("cams 1.0 write %1 --yes --trace --json").arg(cams));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(rowsOf(run.json()),
                IsSupersetOf({"46000015 C6000015", "66000213 E6000213", "20400008 E0400008",
                              "20200013 A0000015", "20200023 A0000213", "20200000 A0000008"}));
    EXPECT_EQ(run.json()[u"eepromWrites"], 1);
    EXPECT_EQ(shared.eepromWrites(), 1);
    EXPECT_EQ(shared.bus().encoder("1.0"_ring)->latest().mode, Mode::position) << "as before";

    EXPECT_EQ(shared.runLine(QStringLiteral("cams 1.0 compare %1").arg(cams)).exit, 0);
    const CliRun again = shared.runLine(QStringLiteral("cams 1.0 write %1 --yes").arg(cams));
    EXPECT_EQ(again.out, "The encoder has all of it.\n"
                         "The encoder is in position mode again, as before.\n");
    EXPECT_EQ(shared.eepromWrites(), 1);
}

TEST_F(CliCams, WhatIsReadAndSavedIsWhatIsThere)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("cams 1.0 write %1 --yes").arg(file(program("8", "25", "21"))));
    const QString saved = m_directory.filePath(QStringLiteral("saved.json"));
    EXPECT_EQ(shared.runLine(QStringLiteral("cams 1.0 read %1").arg(saved)).exit, 0);
    EXPECT_EQ(shared.runLine(QStringLiteral("cams 1.0 compare %1").arg(saved)).exit, 0);
    QFile json(saved);
    ASSERT_TRUE(json.open(QIODevice::ReadOnly));
    const QByteArray text = json.readAll();
    EXPECT_THAT(text.toStdString(), HasSubstr("\"totalRange\": 33554432"));
    EXPECT_THAT(text.toStdString(),
                HasSubstr("{\"cam\": 3, \"start\": 21, \"stop\": 531, \"active\": true}"));
    EXPECT_EQ(text.count("\"program\""), 8);
}

TEST_F(CliCams, AFileThatIsThereIsReplacedOnlyWithYes)
{
    SharedBus shared;
    const QByteArray before = program("1", "0", "21");
    const QString name = file(before);
    const auto content = [&] {
        QFile kept(name);
        EXPECT_TRUE(kept.open(QIODevice::ReadOnly));
        return kept.readAll();
    };
    const CliRun run = shared.runLine(QStringLiteral("cams 1.0 read %1 --json").arg(name));
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(errorKey(run), "fileExists");
    EXPECT_THAT(run.err, HasSubstr("cams.json is there already. Nothing was read."));
    EXPECT_EQ(shared.bus().latest().cycle, 0u) << "nothing went over the bus";
    EXPECT_EQ(content(), before);
    EXPECT_EQ(shared.runLine(QStringLiteral("cams 1.0 read %1 --yes").arg(name)).exit, 0);
    EXPECT_EQ(content().count("\"program\""), 8);
}

TEST_F(CliCams, WhereThereIsNoRoomTheOldFileStaysAndItIsTold)
{
    const QString cams = file("what was there");
    for (const char *json : {"", " --json"}) {
        const CliRun run = [&] {
            const test::NoRoom disk(10);
            return SharedBus().runLine(
                QStringLiteral("cams 1.0 read %1 --yes").arg(cams + QString::fromLatin1(json)));
        }();
        EXPECT_EQ(run.exit, 1);
        EXPECT_THAT(run.err, HasSubstr("cams.json cannot be written: File too large."));
        EXPECT_THAT(run.out, Not(HasSubstr("Saved")));
    }
    QFile kept(cams);
    ASSERT_TRUE(kept.open(QIODevice::ReadOnly));
    EXPECT_EQ(kept.readAll(), "what was there");
}

TEST_F(CliCams, WhatIsNoFileIsNotReplacedAndNothingIsRead)
{
    const QString pipe = m_directory.filePath(QStringLiteral("pipe"));
    ASSERT_EQ(::mkfifo(QFile::encodeName(pipe).constData(), 0600), 0);
    SharedBus shared;
    const CliRun run = shared.runLine(QStringLiteral("cams 1.0 read %1 --yes").arg(pipe));
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, HasSubstr("pipe cannot be written: It is not a file."));
    struct stat there = {};
    ASSERT_EQ(::stat(QFile::encodeName(pipe).constData(), &there), 0);
    EXPECT_TRUE(S_ISFIFO(there.st_mode));
}

TEST_F(CliCams, AFileOfAnotherDeviceIsRefused)
{
    const QByteArray json = program("1", "0", "21");
    for (const char *device : {"fraba-ocd-ib-k2", "tr-la66", "baumer-gxp6w", "nobodys-encoder"})
        for (const char *action : {"write", "compare"}) {
            SharedBus shared;
            const QString name = file(QByteArray(json).replace("fraba-ocd-ib", device));
            const CliRun run = shared.runLine(
                QStringLiteral("cams 1.0 %1 %2 --yes --json").arg(QLatin1String(action), name));
            EXPECT_EQ(run.exit, 2) << device;
            EXPECT_EQ(errorKey(run), "camFileOfOtherDevice") << device;
            EXPECT_THAT(run.err, HasSubstr(std::string("cams.json contains cam programs for the device ") +
                                           device + "; this encoder is fraba-ocd-ib. Nothing was taken"));
            EXPECT_EQ(shared.bus().encoder("1.0"_ring)->latest().mode, Mode::position)
                << "no cam word went out";
            EXPECT_EQ(shared.eepromWrites(), 0);
        }
}

TEST_F(CliCams, TheSameEncoderOnLoop2TakesTheFile)
{
    SharedBus shared;
    EXPECT_EQ(
        shared.runLine(QStringLiteral("cams 6.1 write %1 --yes").arg(file(program("1", "0", "21")))).exit, 0);
    const QString saved = m_directory.filePath(QStringLiteral("loop2.json"));
    EXPECT_EQ(shared.runLine(QStringLiteral("cams 6.1 read %1 --program 1").arg(saved)).exit, 0);
    EXPECT_EQ(shared.runLine(QStringLiteral("cams 1.0 write %1 --yes").arg(saved)).exit, 0);
}

TEST_F(CliCams, ACompareTellsLineByLineWhatDiffers)
{
    const CliRun run = runLine(QStringLiteral("cams 1.0 compare %1").arg(file(program("2", "3", "21"))));
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(run.out, "  program  cam  value    encoder      file  OUT\n"
                       "        2    3  start          0        21  46000015\n"
                       "        2    3  stop           0       531  66000213\n"
                       "        2    -  active  00000000  00001000  20400008\n"
                       "        2    -  shift          0         3  20100003\n"
                       "The encoder is in position mode again, as before.\n");
    EXPECT_EQ(run.err, "codewheel-cli: The encoder and the file differ in values: 4.\n");
}

TEST_F(CliCams, NothingIsWrittenWithoutConsent)
{
    SharedBus shared;
    const QString line = QStringLiteral("cams 1.0 write %1").arg(file(program("1", "0", "21")));
    const CliRun nobody = shared.runLine(line);
    EXPECT_EQ(nobody.exit, 2);
    EXPECT_THAT(nobody.out,
                HasSubstr("Words to be sent, beside read-outs: 20800001 46000015 66000213 20400008 "
                          "80000000 00000000 20800000 00000000\n"
                          "EEPROM writes: 1, one for each program that is changed and left.\n"));
    EXPECT_THAT(nobody.err, HasSubstr("Nothing was written"));
    EXPECT_EQ(shared.runLine(line, {true, "no\n"}).exit, 2);
    EXPECT_EQ(shared.eepromWrites(), 0);
    EXPECT_EQ(shared.runLine(line, {true, "yes\n"}).exit, 0);
    EXPECT_EQ(shared.eepromWrites(), 1);
}

TEST_F(CliCams, StaysInTheProgramThatIsSavedWhereThatIsWanted)
{
    SharedBus shared;
    const QString line = QStringLiteral("cams 1.0 write %1 --yes --stay").arg(file(program("4", "0", "21")));
    EXPECT_EQ(shared.runLine(line).exit, 0);
    EXPECT_EQ(shared.bus().encoder("1.0"_ring)->latest().camProgram, 4u);
    EXPECT_EQ(shared.eepromWrites(), 1);
}

TEST_F(CliCams, InWhichModeTheEncoderIsAfterwardsIsTold)
{
    struct
    {
        const char *options;
        const char *says;
        std::optional<Mode> mode;
    } const rows[] = {
        {"", "The encoder is in position mode again, as before.\n", Mode::position},
        {"--stay", "The encoder is now in cam mode, program 4; before, it was in position mode.\n",
         Mode::cam},
        {"", "The encoder is in cam mode, program 4 again, as before.\n", Mode::cam},
        {"--to-position", "The encoder is now in position mode; before, it was in cam mode, program 4.\n",
         Mode::position},
    };
    SharedBus shared;
    for (const auto &row : rows) {
        const CliRun run = shared.runLine(QStringLiteral("cams 1.0 read --program 4 --yes ") +
                                          QString::fromLatin1(row.options));
        EXPECT_EQ(run.exit, 0) << run.err;
        EXPECT_THAT(run.out, testing::EndsWith(row.says));
        EXPECT_EQ(shared.bus().encoder("1.0"_ring)->latest().mode, row.mode) << row.says;
    }
    EXPECT_EQ(shared.runLine(QStringLiteral("cams 1.0 read --stay --to-position")).exit, 2);
}

TEST_F(CliCams, BadInputIsNamedAndNothingIsSent)
{
    struct Row
    {
        QByteArray json;
        const char *options;
        const char *key;
    };
    const Row rows[] = {
        {program("0", "0", "21"), "", "camFileBroken"},
        {program("9", "0", "21"), "", "camFileBroken"},
        {program("1", "26", "21"), "", "camFileBroken"},
        {program("1", "0", "33554432"), "", "camFileBroken"},
        {"{}", "", "camFileBroken"},
        {program("1", "0", "21"), "--program 2", "camFileOfOtherProgram"},
        {program("1", "0", "21"), "--program 0", "camProgramOutOfRange"},
        {program("1", "0", "21"), "--program 9", "camProgramOutOfRange"},
        {program("1", "0", "21"), "--program x", "notANumber"},
    };
    for (const Row &row : rows) {
        SharedBus shared;
        const CliRun run = shared.runLine(QStringLiteral("cams 1.0 write %1 --yes --json %2")
                                              .arg(file(row.json), QLatin1String(row.options)));
        EXPECT_EQ(run.exit, 2) << row.json.toStdString();
        EXPECT_EQ(errorKey(run), row.key) << row.json.toStdString();
        EXPECT_EQ(shared.bus().latest().cycle, 0u) << "nothing went over the bus";
    }
    EXPECT_EQ(errorKey(runLine(QStringLiteral("cams 1.0 write /no/such.json --json"))), "fileNotReadable");
    const QString pipe = m_directory.filePath(QStringLiteral("pipe"));
    ASSERT_EQ(::mkfifo(pipe.toLocal8Bit().constData(), 0600), 0);
    EXPECT_EQ(errorKey(runLine(QStringLiteral("cams 1.0 compare %1 --json").arg(pipe))), "fileNotReadable");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("cams 1.0 write --json"))), "missingFile");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("cams 1.0 erase --json"))), "unknownAction");
    EXPECT_EQ(errorKey(runLine(QStringLiteral("cams 2.0 read --json"))), "camsNotSupported");
}

TEST_F(CliCams, APositionTheEncoderDoesNotHaveIsRefusedBeforeAnyCamWord)
{
    SharedBus shared;
    shared.runLine(QStringLiteral("write 1.0 steps=2 --yes")); // x 4096 turns: positions 0..8191
    const CliRun run =
        shared.runLine(QStringLiteral("cams 1.0 write %1 --yes --json").arg(file(program("1", "0", "8192"))));
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(errorKey(run), "camPositionTooLarge");
}

// FRABA manual 5.4.4
TEST(CliWords, OfTheCamVectorAreAcknowledgedOneByOne)
{
    const CliRun run = runLine(QStringLiteral(
        "words 1.0 20800001 46000015 66000213 20400008 80000000 20200013 20200023 20200000 00000000 --json"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(
        rowsOf(run.json()),
        IsSupersetOf({"46000015 C6000015", "66000213 E6000213", "20400008 E0400008", "80000000 00303900",
                      "20200013 A0000015", "20200023 A0000213", "20200000 A0000008"}));
}

} // namespace
} // namespace codewheel
