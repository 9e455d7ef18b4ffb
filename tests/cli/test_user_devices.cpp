// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/cli_run.h"
#include "user_devices.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::Not;

// A data folder of its own, so that nobody's real folder is read.
class CliUserDevices : public testing::Test
{
protected:
    CliUserDevices()
        : m_before(qgetenv("XDG_DATA_HOME"))
    {
        qputenv("XDG_DATA_HOME", m_home.path().toLocal8Bit());
        EXPECT_TRUE(QDir().mkpath(userDeviceFolder()));
    }
    ~CliUserDevices() override { qputenv("XDG_DATA_HOME", m_before); }

    // A file in the folder: the generic K3 under another key, with something replaced.
    QString write(const QString &name, const QByteArray &key, const QByteArray &from = {},
                  const QByteArray &to = {})
    {
        QFile generic(QStringLiteral(CODEWHEEL_ROOT "/resources/devices/twk-k4.json"));
        EXPECT_TRUE(generic.open(QIODevice::ReadOnly));
        QByteArray json = generic.readAll().replace("twk-k4", key);
        if (!from.isEmpty()) {
            EXPECT_EQ(json.count(from), 1);
            json.replace(from, to);
        }
        QString path = QDir(userDeviceFolder()).filePath(name);
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(json);
        return path;
    }

    const QTemporaryDir m_home;
    const QByteArray m_before;
};

TEST_F(CliUserDevices, AreListedBesideTheOthers)
{
    write(QStringLiteral("mine.json"), "my-encoder");
    const CliRun run = runLine(QStringLiteral("devices"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_EQ(run.err, "");
    EXPECT_THAT(run.out, HasSubstr("my-encoder"));
    EXPECT_EQ(runLine(QStringLiteral("devices my-encoder")).exit, 0);
}

TEST_F(CliUserDevices, ABrokenFileIsToldWithLineKeyAndReasonAndTheOthersAreTaken)
{
    write(QStringLiteral("a-broken.json"), "a-broken", R"("inWords": 2)", R"("inWords": "two")");
    write(QStringLiteral("b-sound.json"), "b-sound");
    const CliRun run = runLine(QStringLiteral("devices"));
    EXPECT_EQ(run.exit, 0) << "the command itself was done";
    EXPECT_THAT(run.out, HasSubstr("b-sound"));
    EXPECT_THAT(run.out, Not(HasSubstr("a-broken")));
    EXPECT_THAT(run.err, HasSubstr("a-broken.json, line 13, inWords: A whole number is expected here."));
    EXPECT_EQ(runLine(QStringLiteral("scan")).exit, 0);
}

TEST_F(CliUserDevices, DoNotTakeThePlaceOfABuiltInOne)
{
    write(QStringLiteral("mine.json"), "baumer-gxp6w");
    const CliRun run = runLine(QStringLiteral("devices baumer-gxp6w"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("Baumer GXP6W K3"));
    EXPECT_THAT(run.err, HasSubstr("is in the catalog already"));
}

TEST_F(CliUserDevices, CheckTellsASoundFile)
{
    const QString path = write(QStringLiteral("mine.json"), "my-encoder");
    const CliRun run = runLine(QStringLiteral("devices --check %1").arg(path));
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("is valid: TWK K4 (my-encoder)"));
    EXPECT_EQ(runLine(QStringLiteral("devices --json --check %1").arg(path)).json()[u"name"],
              QStringLiteral("my-encoder"));
}

TEST_F(CliUserDevices, CheckTellsWhatIsWrong)
{
    const QString path =
        write(QStringLiteral("mine.json"), "my-encoder", R"("idCode": "F7h")", R"("idCode": "F6h")");
    const CliRun run = runLine(QStringLiteral("devices --json --check %1").arg(path));
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(errorKey(run), "deviceFileBroken");
    EXPECT_EQ(run.json()[u"line"], 12);
    EXPECT_EQ(run.json()[u"faultKey"], QStringLiteral("deviceCode"));
    EXPECT_THAT(run.err, HasSubstr("The last two digits must be those of idCode."));
}

TEST_F(CliUserDevices, CheckOfWhatIsNoFileIsBadInput)
{
    const CliRun missing = runLine(QStringLiteral("devices --check nowhere.json"));
    EXPECT_EQ(missing.exit, 2);
    EXPECT_THAT(missing.err, HasSubstr("There is no such file."));
    EXPECT_EQ(runLine(QStringLiteral("devices --check %1").arg(m_home.path())).exit, 2);
    EXPECT_EQ(runLine(QStringLiteral("devices fraba-ocd-ib --check x.json")).exit, 2);
}

TEST_F(CliUserDevices, AFileThatIsTooLargeIsNotRead)
{
    QFile file(QDir(userDeviceFolder()).filePath(QStringLiteral("huge.json")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    ASSERT_TRUE(file.resize(2 << 20));
    const CliRun run = runLine(QStringLiteral("devices"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.err, HasSubstr("larger than 1 MiB"));
}

TEST(CliLabel, TellsPartsAndDevices)
{
    const CliRun run = runLine(QStringLiteral("devices --label OCD-IBA1B-1213-C100-PRI"));
    EXPECT_EQ(run.exit, 0);
    EXPECT_THAT(run.out, HasSubstr("Turns: 4096, steps per turn: 8192\n"));
    EXPECT_THAT(run.out, HasSubstr("fraba-ocd-ib     K3  0237h  FRABA OCD-IB K3\n"));
    EXPECT_THAT(run.out, HasSubstr("fraba-ocd-ib-k2  K2  0236h  FRABA OCD-IB K2\n"));
    EXPECT_THAT(run.out, Not(HasSubstr("fraba-ocd-ib-k1"))) << "25 bits are more than a K1 has";
    EXPECT_THAT(run.out, HasSubstr("One of these"));
    const QJsonObject json = runLine(QStringLiteral("devices --json --label OCD-IBA1B-0012-C100-PRI")).json();
    EXPECT_EQ(json[u"devices"].toArray().size(), 3);
    EXPECT_EQ(json[u"devices"][0][u"turns"], 1);
    EXPECT_EQ(json[u"devices"][0][u"stepsPerTurn"], 4096);
}

TEST(CliLabel, TellsWhichPartIsNotUnderstood)
{
    const CliRun run = runLine(QStringLiteral("devices --json --label GXP6W.0-30-A0-01"));
    EXPECT_EQ(run.exit, 2);
    EXPECT_EQ(errorKey(run), "labelKeyNotUnderstood");
    EXPECT_THAT(run.err, HasSubstr("\"30\" in \"GXP6W.0-30-A0-01\" is not understood."));
}

TEST(CliDeviceOption, NamesTheEncoderForTheCall)
{
    SharedBus bus;
    EXPECT_EQ(bus.runLine(QStringLiteral("read 1.0 steps --device baumer-gxp6w")).exit, 1)
        << "it has no read-out";
    EXPECT_EQ(bus.runLine(QStringLiteral("read 1.0 steps --device ocd-iba1b-1213-c100-pri")).exit, 0);
    const CliRun wrong = bus.runLine(QStringLiteral("read 1.0 steps --device tr-la66 --json"));
    EXPECT_EQ(wrong.exit, 2);
    EXPECT_EQ(errorKey(wrong), "deviceCodeDiffers");
    const CliRun serial = bus.runLine(QStringLiteral("read 1.0 --device kuebler-esc-rs485 --json"));
    EXPECT_EQ(serial.exit, 2);
    EXPECT_EQ(errorKey(serial), "deviceOfOtherBus");
    EXPECT_THAT(serial.err,
                HasSubstr("RS-485 belongs to another kind of bus: it cannot be the device at 1.0."));
    EXPECT_EQ(errorKey(bus.runLine(QStringLiteral("read 1.0 --device nobody --json"))), "unknownDeviceName");
}

} // namespace
} // namespace codewheel
