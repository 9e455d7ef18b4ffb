// SPDX-License-Identifier: GPL-3.0-or-later
// Values of several encoders on a serial line: store, transfer, clone, replace, restore, report.
#include "kinds/esc/plan/esc_line_plan.h"
#include "project/project_file.h"
#include "tests/cli/kinds/esc/shared_line.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::HasSubstr;
using testing::Not;

// A project with the encoders 05 and 12 of the training line.
class CliLineTransfer : public testing::Test
{
protected:
    CliLineTransfer()
    {
        setLinePlan(project, firstLine, {});
        for (const EscLineAddress address : {EscLineAddress{0x05}, EscLineAddress{0x12}}) {
            ProjectDevice &encoder = project.devices.emplace_back();
            encoder.standAt(placeOnLine(address));
            encoder.participant.deviceKey = QStringLiteral("kuebler-esc-rs485");
        }
        at(0x12).station = QStringLiteral("Hoist");
        save();
    }
    ProjectDevice &at(std::uint8_t address) { return *findDevice(project, placeOnLine({address})); }
    void save() { EXPECT_TRUE(saveProject(project, file)); }
    Project saved() const { return *loadProject(file); }
    CliRun run(const char *what, const Person &person = {})
    {
        return line.runLine(QString::fromLatin1(what).replace(u'@', file) + QStringLiteral(" --ledger ") +
                                folder.filePath(QStringLiteral("eeprom.sqlite")),
                            person);
    }
    std::optional<std::int64_t> stored(std::uint8_t address, Parameter parameter) const
    {
        const Project now = saved();
        for (const StoredValue &value : findDevice(now, placeOnLine({address}))->stored)
            if (value.parameter == parameter)
                return value.value.asNumber();
        return std::nullopt;
    }

    SharedLine line;
    QTemporaryDir folder;
    QString file = folder.filePath(QStringLiteral("line.codewheel"));
    Project project;
};

std::string became(const QJsonValue &encoder, const char *parameter)
{
    for (const QJsonValue value : encoder[u"values"].toArray())
        if (value[u"parameter"] == QString::fromLatin1(parameter))
            return value[u"became"].toString().toStdString();
    return {};
}

TEST_F(CliLineTransfer, CloneGivesTheValuesOfOneToAnother)
{
    ASSERT_EQ(run("write 03 steps=864 direction=ccw --yes").exit, 0);
    const CliRun run = this->run("clone esc:03 esc:05 --yes --json");
    EXPECT_EQ(run.exit, 0) << run.err;
    const QJsonValue encoder = run.json()[u"encoders"][0];
    EXPECT_EQ(encoder[u"place"], QStringLiteral("esc:05"));
    EXPECT_EQ(became(encoder, "steps"), "written");
    EXPECT_EQ(became(encoder, "revolutions"), "written"); // a consequence of the new steps
    EXPECT_EQ(became(encoder, "scaling"), "alreadyThere");
    const EscRegisters of03 = line.registers(0x03);
    const EscRegisters of05 = line.registers(0x05);
    EXPECT_EQ(of05.stepsPerTurn, 864U);
    EXPECT_EQ(of05.factor, of03.factor);
    EXPECT_TRUE(of05.countsCcw);
}

// They would change where the encoder is reached, or move its position.
TEST_F(CliLineTransfer, CloneLeavesAddressBaudRateAndPresetBehind)
{
    ASSERT_EQ(run("preset 03 1000").exit, 0);
    const auto before = line.registers(0x05).preset;
    const QJsonObject json = run("clone 03 05 --yes --json").json();
    for (const char *parameter : {"address", "baud-rate", "preset", "serial-number", "offset"})
        EXPECT_EQ(became(json[u"encoders"][0], parameter), "") << parameter;
    EXPECT_EQ(line.registers(0x05).preset, before);
}

TEST_F(CliLineTransfer, ThePlanShowsTheCommandsThatAreSent)
{
    at(0x05).wanted = {{Parameter::steps, 864}, {Parameter::direction, 0}};
    save();
    const CliRun dry = run("transfer @ 05 --dry-run");
    EXPECT_EQ(dry.exit, 0) << dry.err;
    EXPECT_EQ(dry.out,
              "esc:05  Kübler 5882 / 5862 / 9081 RS-485\n"
              "  steps           8192 (read)    864        05GR00000360\n"
              "  scaling-factor  unknown        03600000h  05GF03600000\n"
              "  direction       cw (0) (read)  cw (0)     left out: already there\n"
              "  Scaling is off: the encoder keeps the values that scale its position, but counts its own "
              "steps until scaling is on.\n"
              "  Values and cam programs to write: 2. EEPROM writes: at most 2.\n");
    EXPECT_EQ(line.registers(0x05).stepsPerTurn, 8'192U);
    const QJsonObject plan = run("transfer @ 05 --dry-run --json").json();
    const QJsonValue steps = plan[u"plan"][0][u"values"][0];
    EXPECT_EQ(steps[u"command"], QStringLiteral("05GR00000360"));
    EXPECT_TRUE(steps[u"word"].isNull());
}

TEST_F(CliLineTransfer, TransferWritesAndASecondTimeNothing)
{
    at(0x05).wanted = {{Parameter::steps, 864}};
    at(0x12).wanted = {{Parameter::direction, 1}};
    save();
    const CliRun nobody = run("transfer @");
    EXPECT_EQ(nobody.exit, 2);
    EXPECT_EQ(line.registers(0x05).stepsPerTurn, 8'192U);

    const CliRun first = run("transfer @ --yes --trace");
    EXPECT_EQ(first.exit, 0) << first.err;
    EXPECT_THAT(first.out, HasSubstr("esc:05\n"));
    EXPECT_THAT(first.out, HasSubstr("05GR00000360"));
    EXPECT_THAT(first.out, HasSubstr("  steps  = 864  Written, and read back\n"));
    EXPECT_THAT(first.out, HasSubstr("Written: 2. Already there: 0. EEPROM writes: 3.\n"));
    EXPECT_EQ(line.registers(0x05).stepsPerTurn, 864U);
    EXPECT_TRUE(line.registers(0x12).countsCcw);

    const CliRun again = run("transfer @");
    EXPECT_EQ(again.exit, 0) << again.err;
    EXPECT_THAT(again.out, HasSubstr("It has everything already: nothing is sent.\n"));
}

TEST_F(CliLineTransfer, StepsThatDoNotActAreSaidNotToAfterwardsToo)
{
    const QString off =
        QStringLiteral("Scaling is off: the encoder keeps the values that scale its position");
    at(0x05).wanted = {{Parameter::steps, 864}};
    save();
    const QString report = folder.filePath(QStringLiteral("account.txt"));
    const CliRun written = run(("transfer @ 05 --yes --report " + report.toStdString()).c_str());
    EXPECT_EQ(QString::fromStdString(written.out).count(off), 2) << "before and afterwards: " << written.out;
    QFile text(report);
    ASSERT_TRUE(text.open(QIODevice::ReadOnly));
    EXPECT_THAT(text.readAll().toStdString(), testing::ContainsRegex("Not in force: +Scaling is off: "));

    at(0x05).wanted = {{Parameter::steps, 500}};
    save();
    const QJsonValue kept = run("transfer @ 05 --yes --json").json()[u"encoders"][0];
    EXPECT_EQ(kept[u"notInForce"][u"key"], QStringLiteral("scalingOff"));
    EXPECT_TRUE(kept[u"notInForce"][u"text"].toString().startsWith(off));

    at(0x05).wanted = {{Parameter::steps, 600}, {Parameter::scaling, 1}};
    save();
    const QJsonValue acting = run("transfer @ 05 --yes --json").json()[u"encoders"][0];
    EXPECT_EQ(became(acting, "steps"), "written");
    EXPECT_TRUE(acting[u"notInForce"].isNull());
}

TEST_F(CliLineTransfer, OneThatDoesNotAnswerKeepsNoOtherFromItsValues)
{
    at(0x05).wanted = at(0x12).wanted = {{Parameter::direction, 1}};
    save();
    line.mute(0x05);
    const CliRun run = this->run("transfer @ --yes --json");
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "encoderSilent");
    EXPECT_TRUE(line.registers(0x12).countsCcw);
}

TEST_F(CliLineTransfer, AnotherSerialNumberThanThatOnTheLabelIsAnotherEncoder)
{
    at(0x05).wanted = at(0x12).wanted = {{Parameter::direction, 1}};
    at(0x05).label.serialNumber = QStringLiteral("0012D5A4"); // as it reports it
    at(0x12).label.serialNumber = QStringLiteral("4711");
    save();
    const CliRun run = this->run("transfer @ --yes --json");
    EXPECT_EQ(errorKey(run), "serialDiffers");
    EXPECT_THAT(run.err, HasSubstr("esc:12: the label in the project has the serial number 4711, the encoder "
                                   "reports 1245192 (130008h)."));
    EXPECT_TRUE(line.registers(0x05).countsCcw);
    EXPECT_FALSE(line.registers(0x12).countsCcw);
    EXPECT_EQ(errorKey(this->run("store @ 12 --json")), "serialDiffers");
}

TEST_F(CliLineTransfer, CtrlCEndsTheRoundAndWhatWasSentIsAccountedFor)
{
    at(0x05).wanted = at(0x12).wanted = {{Parameter::direction, 1}};
    save();
    line.interruptAfter("05GD");
    const CliRun run = this->run("transfer @ --yes --json");
    EXPECT_EQ(run.exit, 1);
    const QJsonArray encoders = run.json()[u"encoders"].toArray();
    ASSERT_EQ(encoders.size(), 2);
    EXPECT_TRUE(encoders[0][u"begun"].toBool());
    EXPECT_FALSE(encoders[1][u"begun"].toBool());
    EXPECT_TRUE(line.registers(0x05).countsCcw);
    EXPECT_FALSE(line.registers(0x12).countsCcw);
}

// Reading for the plan takes the signal, so the call has to end there.
TEST_F(CliLineTransfer, CtrlCWhileItIsReadForThePlanSendsNothing)
{
    ASSERT_EQ(run("write 05 steps=864 --yes").exit, 0);
    at(0x05).wanted = at(0x12).wanted = {{Parameter::direction, 1}};
    at(0x12).label.serialNumber = QStringLiteral("4711"); // of the previous encoder
    save();
    for (const auto &[call, request] : {std::pair{"transfer @ 05 --yes --json", "05U"},
                                        {"clone 05 03 12 --yes --json", "05U"},
                                        {"clone 05 03 12 --yes --json", "03U"},
                                        {"restore 05 --yes --json", "05U"},
                                        {"replace 12 --project @ --serial 00130008 --yes --json", "12U"},
                                        {"write 05 address=07 --yes --json", "07N"}}) {
        line.interruptAfter(request);
        const CliRun run = this->run(call);
        EXPECT_EQ(run.exit, 1) << call;
        EXPECT_EQ(errorKey(run), "cancelled") << call << request;
    }
    EXPECT_EQ(line.registers(0x05).stepsPerTurn, 864U);
    EXPECT_EQ(line.registers(0x03).stepsPerTurn, 8'192U);
    EXPECT_EQ(line.registers(0x12).stepsPerTurn, 8'192U);
    EXPECT_FALSE(line.registers(0x05).countsCcw);
    EXPECT_FALSE(line.registers(0x12).countsCcw);
    EXPECT_EQ(saved(), project);
}

TEST_F(CliLineTransfer, CtrlCKeepsOfAStoreWhatWasReadToTheEnd)
{
    line.interruptAfter("12U");
    const CliRun run = this->run("store @");
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.err, HasSubstr("The job was cancelled."));
    EXPECT_THAT(run.out, HasSubstr("esc:12: nothing was stored.\n"));
    EXPECT_EQ(stored(0x05, Parameter::steps), 8'192);
    EXPECT_EQ(stored(0x12, Parameter::serialNumber), std::nullopt);
}

TEST_F(CliLineTransfer, AnAdapterUnpluggedBeforeThePlanIsMadeIsTold)
{
    at(0x05).wanted = at(0x12).wanted = {{Parameter::direction, 1}};
    save();
    line.unplugAfter("05U");
    const CliRun run = this->run("transfer @ --yes --json");
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "portLost");
    for (const QJsonValue encoder : run.json()[u"plan"].toArray())
        EXPECT_EQ(encoder[u"hindrance"][u"key"], QStringLiteral("portLost"));
}

TEST_F(CliLineTransfer, APositionThatWasSentAndNotAnsweredIsNotToldAsNotSet)
{
    line.unplugAfter("12GP");
    const CliRun run = this->run("replace 12 --project @ --position 2000 --yes");
    EXPECT_EQ(run.exit, 1);
    EXPECT_THAT(run.out, HasSubstr("Position: it is not known whether it was set to 2000.\n"));
    line.simulated().setUnplugged(false);
    line.interruptAfter("12GP");
    EXPECT_THAT(this->run("replace 12 --project @ --position 3000 --yes").out,
                HasSubstr("Position: set to 3000.\n"));
}

// Its address was never read, so it is taken to be the one at which it is asked.
TEST_F(CliLineTransfer, ThePlanOfASilentEncoderShowsCommandsToItsAddress)
{
    at(0x05).wanted = {{Parameter::direction, 1}};
    save();
    line.mute(0x05);
    const CliRun dry = run("transfer @ 05 --dry-run");
    EXPECT_THAT(dry.out, HasSubstr("05GD1\n"));
    EXPECT_THAT(dry.out, HasSubstr("esc:05 does not answer."));
}

TEST_F(CliLineTransfer, AnAdapterUnpluggedInTheMidstIsTold)
{
    at(0x05).wanted = at(0x12).wanted = {{Parameter::direction, 1}};
    save();
    line.unplugAfter("05GD");
    const CliRun run = this->run("transfer @ --yes --json");
    EXPECT_EQ(run.exit, 1);
    EXPECT_EQ(errorKey(run), "stoppedInWrite");
    EXPECT_THAT(run.err, HasSubstr("first of all to esc:05."));
    EXPECT_THAT(run.err, HasSubstr("is gone"));
    const QJsonValue first = run.json()[u"encoders"][0];
    EXPECT_EQ(became(first, "direction"), "unknown");
    EXPECT_EQ(first[u"leftIn"], QStringLiteral("unknown"));
    EXPECT_FALSE(run.json()[u"encoders"][1][u"begun"].toBool());
    EXPECT_FALSE(line.registers(0x12).countsCcw);
}

TEST_F(CliLineTransfer, StoreKeepsWhatTheEncodersHave)
{
    ASSERT_EQ(run("write 05 steps=864 --yes").exit, 0);
    const CliRun run = this->run("store @ --trace");
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("steps                 = 864"));
    EXPECT_EQ(stored(0x05, Parameter::steps), 864);
    EXPECT_EQ(stored(0x05, Parameter::serialNumber), 0x0012'D5A4);
    EXPECT_EQ(stored(0x12, Parameter::steps), 8'192);
    const Project now = saved();
    EXPECT_TRUE(findDevice(now, placeOnLine({0x05}))->lastPosition);
}

TEST_F(CliLineTransfer, WhatWasStoredIsWrittenSaveThePresetAndThePlace)
{
    ASSERT_EQ(run("write 05 steps=864 --yes").exit, 0);
    ASSERT_EQ(run("store @").exit, 0);
    ASSERT_EQ(run("write 05 steps=500 --yes").exit, 0);
    ASSERT_EQ(run("preset 05 77").exit, 0);
    const CliRun run = this->run("transfer @ 05 --stored --yes");
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, Not(HasSubstr("\n  preset ")));
    EXPECT_EQ(line.registers(0x05).stepsPerTurn, 864U);
    EXPECT_EQ(line.registers(0x05).preset, 77U);
}

TEST_F(CliLineTransfer, ReplaceGivesTheNewEncoderValuesAndPosition)
{
    at(0x12).label.serialNumber = QStringLiteral("4711"); // of the previous encoder
    at(0x12).wanted = {{Parameter::direction, 1}};
    at(0x12).lastPosition = {2000, QDateTime(QDate(2026, 2, 1), QTime(8, 0), Qt::UTC)};
    save();
    const CliRun run = this->run("replace Hoist --project @ --serial 00130008 --position last --yes --json");
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_TRUE(run.json()[u"encoders"][0][u"positionSet"].toBool());
    EXPECT_TRUE(line.registers(0x12).countsCcw);
    EXPECT_EQ(line.registers(0x12).preset, 2'000U);
    const Project now = saved();
    const ProjectDevice &encoder = *findDevice(now, placeOnLine({0x12}));
    EXPECT_EQ(encoder.label.serialNumber, QStringLiteral("00130008"));
    EXPECT_EQ(encoder.wanted, (ParameterValues{{Parameter::direction, 1}}));
    EXPECT_EQ(this->run("transfer @ 12 --yes").exit, 0);
}

TEST_F(CliLineTransfer, ReplaceTakesNoEncoderForAnother)
{
    const CliRun other = run("replace 12 --project @ --serial 4711 --yes --json");
    EXPECT_EQ(errorKey(other), "serialDiffers");
    EXPECT_EQ(saved(), project);
    EXPECT_EQ(errorKey(run("replace 12 --project @ --label OCD-IBA1B-1213-C100-PRI --yes --json")),
              "deviceOfOtherBus");
    EXPECT_EQ(run("replace 12 --project @ --label 8.5882.xx3x.3001 --dry-run").exit, 0);
}

TEST_F(CliLineTransfer, RestoreWritesWhatWasThereBefore)
{
    ASSERT_EQ(run("write 05 steps=864 direction=ccw --yes").exit, 0);
    ASSERT_EQ(run("preset 05 77").exit, 0);
    const CliRun list = run("restore 05 --list");
    EXPECT_EQ(list.exit, 0) << list.err;
    EXPECT_THAT(list.out, HasSubstr("steps=8192"));
    EXPECT_THAT(list.out, Not(HasSubstr("preset")));
    const CliRun run = this->run("restore 05 --yes");
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_EQ(line.registers(0x05).stepsPerTurn, 8'192U);
    EXPECT_FALSE(line.registers(0x05).countsCcw);
    EXPECT_EQ(line.registers(0x05).preset, 77U);
}

TEST_F(CliLineTransfer, TheReportAsksTheEncoders)
{
    ASSERT_EQ(run("write 05 steps=864 --yes").exit, 0);
    at(0x05).wanted = {{Parameter::steps, 500}};
    save();
    const QString report = folder.filePath(QStringLiteral("line.html"));
    const CliRun run = this->run(("report @ --read -o " + report.toStdString()).c_str());
    EXPECT_EQ(run.exit, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("Deviations of encoders from what is wanted: 1; not compared: 0."));
    QFile html(report);
    ASSERT_TRUE(html.open(QIODevice::ReadOnly));
    const std::string text = html.readAll().toStdString();
    EXPECT_THAT(text, HasSubstr("of a simulated encoder"));
    EXPECT_THAT(text, HasSubstr("connected as configured"));
}

TEST_F(CliLineTransfer, OnTheTrainingBusRingAndLineGoTogether)
{
    Project both = *loadProject(QStringLiteral(CODEWHEEL_ROOT "/docs/examples/training.codewheel"));
    findDevice(both, {firstBus, NodeId("2.0")})->wanted = {{Parameter::steps, 4096}};
    setLinePlan(both, firstLine, {});
    ProjectDevice encoder = at(0x05);
    encoder.wanted = {{Parameter::steps, 864}};
    setDevicesOn(both, firstLine, {encoder});
    ASSERT_TRUE(saveProject(both, file));
    const QString account = folder.filePath(QStringLiteral("account.txt"));
    const CliRun run = runLine(QStringLiteral("transfer %1 2.0 esc:05 --yes --report %2").arg(file, account));
    EXPECT_EQ(run.exit, 0) << run.err;
    QFile text(account);
    ASSERT_TRUE(text.open(QIODevice::ReadOnly));
    const std::string told = text.readAll().toStdString();
    EXPECT_THAT(told, HasSubstr("\n2.0"));
    EXPECT_THAT(told, HasSubstr("\nesc:05"));
    EXPECT_THAT(told, HasSubstr("2 of 2 have all of it"));
    const CliRun clone = runLine(QStringLiteral("clone esc:03 esc:05 --yes"));
    EXPECT_EQ(clone.exit, 0) << clone.err;
    EXPECT_EQ(errorKey(runLine(QStringLiteral("clone esc:03 1.0 --yes --json"))), "encodersDiffer");
}

TEST_F(CliLineTransfer, WritesAreCountedBeforeTheyAreSentAndBySerialNumber)
{
    at(0x05).wanted = {{Parameter::direction, 1}};
    save();
    line.unplugAfter("05GD"); // with an unknown outcome
    EXPECT_EQ(run("transfer @ 05 --yes").exit, 1);
    const QJsonArray accounts =
        runLine(QStringLiteral("ledger --json --ledger ") + folder.filePath(QStringLiteral("eeprom.sqlite")))
            .json()[u"accounts"]
            .toArray();
    ASSERT_EQ(accounts.size(), 1);
    EXPECT_EQ(accounts[0][u"countedBy"], QStringLiteral("serialNumber"));
    EXPECT_EQ(accounts[0][u"place"], QStringLiteral("esc:05"));
    EXPECT_EQ(accounts[0][u"writes"].toInt() + accounts[0][u"perhaps"].toInt(), 1);
}

TEST_F(CliLineTransfer, CompareTellsWhatIsMissingAndWhatIsAnother)
{
    at(0x12).label.serialNumber = QStringLiteral("99");
    ProjectDevice silent = at(0x05);
    silent.standAt(placeOnLine({0x1F}));
    project.devices.push_back(silent);
    save();
    const CliRun compared = line.runLine(QStringLiteral("compare ") + file);
    EXPECT_EQ(compared.exit, 1) << compared.err;
    EXPECT_THAT(compared.out, HasSubstr("same     esc:05: Kübler"));
    EXPECT_THAT(compared.out, HasSubstr("differs  esc:12: "));
    EXPECT_THAT(compared.out, HasSubstr("missing  esc:1F: configured Kübler"));
    EXPECT_THAT(compared.err, HasSubstr("Lines that differ: 2."));
}

} // namespace
} // namespace codewheel
