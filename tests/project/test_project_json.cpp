// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/plan/esc_line_plan.h"
#include "kinds/interbus/plan/ring_plan.h"
#include "kinds/interbus/ring/ring_device.h"
#include "kinds/interbus/ring/ring_rules.h"
#include "project/project_json.h"
#include "tests/project/made_up_project.h"
#include "tests/support/breakage.h"
#include "tests/support/places.h"
#include "tests/support/plans.h"
#include "vocabulary/refusal_text.h"

#include <QDir>
#include <QFile>

#include <algorithm>
#include <gtest/gtest.h>
#include <json/reader.h>
#include <json/writer.h>

namespace codewheel {
namespace {

const QString fileName = QStringLiteral("crane.codewheel");

// The example of docs/project-files.md.
QByteArray example()
{
    QFile page(QStringLiteral(CODEWHEEL_ROOT "/docs/project-files.md"));
    EXPECT_TRUE(page.open(QIODevice::ReadOnly));
    const QByteArray text = page.readAll();
    const QByteArray begin = "```json\n";
    const qsizetype from = text.indexOf(begin) + begin.size();
    return text.mid(from, text.indexOf("```", from) - from);
}

TEST(ProjectJson, ReadsWhatThePageShows)
{
    const auto project = projectFromJson(example(), fileName);
    ASSERT_TRUE(project) << refusalText(project.error()).toStdString();
    EXPECT_EQ(project->title, QStringLiteral("Crane 1"));
    EXPECT_EQ(ringPlan(*project, firstBus).cableKilometres, 0.4);
    ASSERT_EQ(project->devices.size(), 4u);

    ProjectDevice first;
    first.participant = RingDevice{NodeId("1.0"), 0x0237, 2, 2, QStringLiteral("fraba-ocd-ib")};
    first.station = QStringLiteral("Hoist");
    first.group = QStringLiteral("Crane 1");
    first.label = {4096, 8192, QStringLiteral("20417")};
    first.set(GivenAddresses{.in = 128});
    first.wanted = {{Parameter::steps, 8192}, {Parameter::revolutions, 16}};
    first.stored = {{Parameter::steps, 8192, Evidence::read, QDateTime({2026, 3, 1}, QTime(14, 2), Qt::UTC)}};
    first.lastPosition = {12345,
                          QDateTime({2026, 3, 1}, QTime(14, 2), Qt::UTC),
                          {{Parameter::steps, 8192}, {Parameter::revolutions, 16}}};
    CamProgram cams;
    cams.cam[0] = {21, 531, true};
    cams.cam[7] = {8000, 100, false};
    first.wantedCams = {cams};
    EXPECT_EQ(project->devices[0], first);
    EXPECT_EQ(project->devices[2].place(), ("2.1"_ring));
    EXPECT_EQ(project->sequences,
              (std::vector{ProjectSequence{QStringLiteral("Example of the manual"),
                                           {.words = {0x020000FF, 0x80000000, 0}, .holdCycles = 3}}}));
}

TEST(ProjectJson, ReadsTheSerialLineThatThePageShows)
{
    const auto project = projectFromJson(example(), fileName);
    ASSERT_TRUE(project && linePlan(*project, firstLine));
    EscLinePlan line;
    line.settings.port = QStringLiteral("/dev/ttyUSB0");
    line.adapter = {0x0403, 0x6001, QStringLiteral("A50285BI"), QStringLiteral("1-2.4:1.0")};
    ProjectDevice encoder;
    encoder.standAt(placeOnLine({0x12}));
    encoder.participant.deviceKey = QStringLiteral("kuebler-esc-rs422");
    encoder.station = QStringLiteral("Slide");
    encoder.wanted = {{Parameter::direction, 1}};
    encoder.set(EscEncoderSettings{.swapsWarningBytes = true});
    EXPECT_EQ(*linePlan(*project, firstLine), line);
    EXPECT_EQ(encodersOnLine(*project), std::vector{encoder});
    EXPECT_EQ(findDevice(*project, encoder.place()), &project->devices[3]);
    EXPECT_EQ(findDevice(*project, placeOnLine({0x13})), nullptr);
    EXPECT_EQ(findDevice(*project, "2.1"_ring), &project->devices[2]);
}

TEST(ProjectJson, WhatIsLeftOutOfASerialLineIsAsDelivered)
{
    const auto project = projectFromJson(
        R"({"format": "codewheel-project", "version": 1, "devices": [], "serialLine": {"baudRate": 4800}})",
        fileName);
    ASSERT_TRUE(project && linePlan(*project, firstLine));
    EscLinePlan line;
    line.settings.serial.baudRate = 4'800;
    line.settings.timing.character = line.settings.serial.timeOf(1);
    EXPECT_EQ(*linePlan(*project, firstLine), line);
}

// The same limits as at the command line and in the form.
TEST(ProjectJson, ASerialLineMayHaveAllThatTheCommandLineGives)
{
    const auto project = projectFromJson(
        R"({"format": "codewheel-project", "version": 1, "devices": [], "serialLine": {"baudRate": 10000000,
            "timeOut": 60000, "retries": 20, "quietAfterWrite": 60000, "pollInterval": 60000}})",
        fileName);
    ASSERT_TRUE(project && linePlan(*project, firstLine));
    EXPECT_EQ(linePlan(*project, firstLine)->settings.serial.baudRate, 10'000'000);
    EXPECT_EQ(linePlan(*project, firstLine)->settings.timing.answerTimeOut, std::chrono::seconds(60));
    EXPECT_EQ(linePlan(*project, firstLine)->settings.timing.retries, 20);
}

// Kübler manual, "Masteraddress: 00"
TEST(ProjectJson, AnEncoderThatIsAloneMayStandAtTheMasterAddress)
{
    const QByteArray text =
        R"({"format": "codewheel-project", "version": 1, "devices": [], "serialLine": {"encoders": [
            {"place": "esc:00", "device": "kuebler-esc-rs485"}]}})";
    const auto project = projectFromJson(text, fileName);
    ASSERT_TRUE(project) << refusalText(project.error()).toStdString();
    EXPECT_NE(findDevice(*project, placeOnLine(EscLineAddress::master())), nullptr);
    EXPECT_EQ(projectFromJson(projectToJson(*project), fileName), project);
}

TEST(ProjectJson, WritesWhatThePageShows)
{
    const auto project = projectFromJson(example(), fileName);
    ASSERT_TRUE(project);
    EXPECT_EQ(projectToJson(*project).toStdString(), example().toStdString());
}

TEST(ProjectJson, AnyProjectIsTheSameOnceSavedAndLoaded)
{
    std::mt19937 random(1);
    for (int round = 0; round < 100; ++round) {
        const Project project = madeUpProject(random, static_cast<std::size_t>(round) % 12);
        const auto loaded = projectFromJson(projectToJson(project), fileName);
        ASSERT_TRUE(loaded) << refusalText(loaded.error()).toStdString();
        EXPECT_EQ(*loaded, project);
    }
}

TEST(ProjectJson, TheOrderInWhichValuesCameToBeIsNotSeen)
{
    std::mt19937 random(2);
    Project project = madeUpProject(random, 20);
    const QByteArray json = projectToJson(project);
    for (ProjectDevice &device : project.devices) {
        std::ranges::shuffle(device.wanted, random);
        std::ranges::shuffle(device.stored, random);
        std::ranges::shuffle(device.wantedCams, random);
        std::ranges::shuffle(device.storedCams, random);
    }
    EXPECT_EQ(projectToJson(project), json);
}

// As it may be written by hand.
TEST(ProjectJson, TheOrderInTheFileIsNotSeen)
{
    std::mt19937 random(3);
    const Project project = madeUpProject(random, 20);
    Json::Value json;
    ASSERT_TRUE(Json::Reader().parse(projectToJson(project).toStdString(), json));
    int turned = 0;
    for (Json::Value &device : json["buses"][0]["devices"])
        for (const char *key : {"wanted", "stored", "wantedCams", "storedCams"}) {
            Json::Value &rows = device[key];
            if (rows.isNull()) {
                device.removeMember(key);
                continue;
            }
            const Json::Value before = rows;
            for (Json::ArrayIndex i = 0; i < before.size(); ++i)
                rows[i] = before[before.size() - 1 - i];
            turned += before.size() > 1 && std::string_view(key) == "storedCams" ? 1 : 0;
        }
    ASSERT_GT(turned, 0);
    const auto loaded = projectFromJson(QByteArray::fromStdString(Json::FastWriter().write(json)), fileName);
    ASSERT_TRUE(loaded) << refusalText(loaded.error()).toStdString();
    EXPECT_EQ(*loaded, project);
}

TEST(ProjectJson, AnEmptyProjectIsOne)
{
    const auto project =
        projectFromJson(R"({"format": "codewheel-project", "version": 1, "devices": []})", fileName);
    ASSERT_TRUE(project);
    EXPECT_EQ(*project, Project());
    EXPECT_EQ(projectFromJson(projectToJson(Project()), fileName), Project());
}

class BrokenProject : public testing::TestWithParam<Breakage>
{};

TEST_P(BrokenProject, IsRefusedWithLineKeyAndReason)
{
    const auto project = projectFromJson(brokenBy(GetParam(), example(), Occurs::firstOfSeveral), fileName);
    ASSERT_FALSE(project);
    expectNamed(GetParam(), project.error(), RefusalId::projectFileBroken, fileName);
}

INSTANTIATE_TEST_SUITE_P(
    Rules, BrokenProject,
    testing::Values(
        Breakage{"\"version\": 2,", "\"version\": 2", 4, "", "not valid JSON"},
        Breakage{"codewheel-project", "codewheel-cams", 2, "format", "This is not a project"},
        Breakage{"\"version\": 2,", "", 1, "version", "whole number from 1"},
        Breakage{"\"version\": 2,", "\"version\": 0,", 3, "version", "whole number from 1"},
        Breakage{"\"version\": 2,", "\"version\": 2.0,", 3, "version", "whole number from 1"},
        Breakage{"\"version\": 2,", "\"version\": \"1\",", 3, "version", "whole number from 1"},
        Breakage{"\"name\": \"Ring\"", "\"name\": \"Ring/1\"", 9, "buses[0].name", "has no \"/\""},
        Breakage{"\"name\": \"Ring\"", "\"name\": \" \"", 9, "buses[0].name", "needs a name"},
        Breakage{"\"title\": \"Crane 1\"", "\"title\": 1", 4, "title", "text in quotation marks"},
        Breakage{"\"title\"", "\"titel\"", 4, "titel", "not known"},
        Breakage{"\"title\"", "\"buses\"", 5, "buses", "is here twice"},
        Breakage{"\"kind\": \"training\"", "", 10, "buses[0].link.kind", "missing"},
        Breakage{"\"kind\": \"training\"", "\"kind\": \"training\", \"settings\": {\"port\": 1}", 11,
                 "buses[0].link.settings", "object of texts"},
        Breakage{"\"kind\": \"training\"", "\"kind\": \"training\", \"settings\": []", 11,
                 "buses[0].link.settings", "object of texts"},
        Breakage{"\"unit\": \"byte\"", "\"unit\": \"bit\"", 14, "buses[0].addresses.unit", "byte, word"},
        Breakage{"\"first\": 0", "\"first\": 65536", 15, "buses[0].addresses.first",
                 "not between 0 and 65535"},
        Breakage{"\"step5\": false", "\"step5\": 0", 16, "buses[0].addresses.step5", "true or false"},
        Breakage{"0.4", "-0.4", 18, "buses[0].cableKilometres", "not between 0 and 12.8"},
        Breakage{"0.4", "12.9", 18, "buses[0].cableKilometres", "not between 0 and 12.8"},
        Breakage{"0.4", "\"0.4\"", 18, "buses[0].cableKilometres", "number"},
        Breakage{"\"place\": \"1.0\"", "\"place\": \"2.0\"", 21, "buses[0].devices[0].place",
                 "1.0 on the remote"},
        Breakage{"\"place\": \"2.1\"", "\"place\": \"2.2\"", 75, "buses[0].devices[2].place",
                 "3.0 on the remote bus, or 2.1 on a local bus"},
        Breakage{"\"place\": \"2.1\"", "\"place\": \"2.x\"", 75, "buses[0].devices[2].place",
                 "cannot be here"},
        Breakage{"\"place\": \"2.1\"", "\"place\": \"\"", 75, "buses[0].devices[2].place", "text"},
        Breakage{"\"place\": \"2.1\",", "", 74, "buses[0].devices[2].place", "missing"},
        Breakage{"\"level\": 0", "\"level\": 16", 22, "buses[0].devices[0].level", "not between 0 and 15"},
        Breakage{"\"level\": 0", "\"level\": 0.5", 22, "buses[0].devices[0].level", "whole number"},
        Breakage{"0237h", "0237", 23, "buses[0].devices[0].deviceCode", "hexadecimal"},
        Breakage{"0237h", "10237h", 23, "buses[0].devices[0].deviceCode", "four digits"},
        Breakage{"\"inWords\": 2", "\"inWords\": 257", 24, "buses[0].devices[0].inWords",
                 "not between 0 and 256"},
        Breakage{"\"outWords\": 2,", "", 20, "buses[0].devices[0].outWords", "missing"},
        Breakage{"\"device\": \"fraba-ocd-ib\"", "\"device\": null", 26, "buses[0].devices[0].device",
                 "text"},
        Breakage{"\"station\": \"Hoist\"", "\"station\": []", 27, "buses[0].devices[0].station", "text"},
        Breakage{"\"turns\": 4096", "\"turns\": -1", 30, "buses[0].devices[0].label.turns", "not between"},
        Breakage{"\"stepsPerTurn\": 8192", "\"stepsPerTurn\": 9999999999", 31,
                 "buses[0].devices[0].label.stepsPerTurn", "not between"},
        Breakage{"\"20417\"", "20417", 32, "buses[0].devices[0].label.serialNumber", "text"},
        Breakage{"\"inAddress\": 128", "\"inAddress\": -1", 34, "buses[0].devices[0].inAddress",
                 "not between"},
        Breakage{"\"revolutions\"", "\"turns\"", 37, "buses[0].devices[0].wanted[1].parameter",
                 "no parameter"},
        Breakage{"\"revolutions\"", "\"steps\"", 37, "buses[0].devices[0].wanted[1].parameter",
                 "already given above"},
        Breakage{"\"value\": 16", "\"value\": 16.5", 37, "buses[0].devices[0].wanted[1].value",
                 "whole number"},
        Breakage{"\"value\": 16", "\"value\": 9223372036854775808", 37, "buses[0].devices[0].wanted[1].value",
                 "whole number"},
        Breakage{"\"read\"", "\"guessed\"", 40, "buses[0].devices[0].stored[0].evidence",
                 "read, echoed, told"},
        Breakage{"14:02:00.000Z", "14:02:00Z", 40, "buses[0].devices[0].stored[0].at", "A time such as"},
        Breakage{"2026-03-01T", "2026-02-30T", 40, "buses[0].devices[0].stored[0].at", "A time such as"},
        Breakage{"\"2026-03-01T14:02:00.000Z\"", "\"\"", 40, "buses[0].devices[0].stored[0].at",
                 "A time such as"},
        Breakage{"\"program\": 1", "\"program\": 9", 44, "buses[0].devices[0].wantedCams[0].program",
                 "not between 1 and 8"},
        Breakage{"\"cam\": 7", "\"cam\": 0", 54, "buses[0].devices[0].wantedCams[0].cams[7].cam",
                 "already given above"},
        Breakage{"8000", "33554432", 54, "buses[0].devices[0].wantedCams[0].cams[7].start", "not between"},
        Breakage{"\"position\": 12345", "\"position\": 1.5", 59, "buses[0].devices[0].lastPosition.position",
                 "whole number"},
        Breakage{"\"scale\"", "\"scales\"", 61, "buses[0].devices[0].lastPosition.scales", "not known"},
        Breakage{"\"holdCycles\": 3", "\"holdCycles\": 0", 122, "sequences[0].holdCycles", "not between"},
        Breakage{"\"020000FF\"", "\"020000FG\"", 124, "sequences[0].words[0]", "8 hexadecimal digits"},
        Breakage{"\"words\"", "\"word\"", 123, "sequences[0].word", "not known"},
        Breakage{"\"port\": \"/dev/ttyUSB0\"", "\"port\": 1", 88, "buses[1].port", "text"},
        Breakage{"0403h", "10403h", 90, "buses[1].adapter.vendor", "four digits"},
        Breakage{"\"baudRate\": 19200", "\"baudRate\": 49", 95, "buses[1].baudRate",
                 "not between 50 and 10000000"},
        Breakage{"\"baudRate\": 19200", "\"baudRate\": 10000001", 95, "buses[1].baudRate", "not between"},
        Breakage{"\"timeOut\": 100", "\"timeOut\": 60001", 101, "buses[1].timeOut",
                 "not between 1 and 60000"},
        Breakage{"\"retries\": 2", "\"retries\": 21", 102, "buses[1].retries", "not between 0 and 20"},
        Breakage{"\"quietAfterWrite\": 100", "\"quietAfterWrite\": 60001", 103, "buses[1].quietAfterWrite",
                 "not between 0 and 60000"},
        Breakage{"\"place\": \"esc:12\"", "\"place\": \"esc:00\", \"device\": \"x\"}, {\"place\": \"esc:12\"",
                 108, "buses[1].devices[1].place", "must be alone"},
        Breakage{"\"dataBits\": 8", "\"dataBits\": 9", 96, "buses[1].dataBits", "not between 7 and 8"},
        Breakage{"\"none\"", "\"mark\"", 97, "buses[1].parity", "none, even, odd"},
        Breakage{"\"pollInterval\": 10", "\"pollInterval\": 9", 100, "buses[1].pollInterval",
                 "not between 10 and 60000"},
        Breakage{"\"fractionBits\": 29", "\"fractionBits\": 31", 104, "buses[1].fractionBits",
                 "not between 17 and 30"},
        Breakage{"esc:12", "esc:20", 108, "buses[1].devices[0].place", "esc:1F"},
        Breakage{"esc:12", "12", 108, "buses[1].devices[0].place", "esc:1F"},
        Breakage{"esc:12", "1.0", 108, "buses[1].devices[0].place", "esc:1F"},
        Breakage{"\"place\": \"esc:12\"", "\"place\": \"esc:12\", \"device\": \"x\"}, {\"place\": \"esc:12\"",
                 108, "buses[1].devices[1].place", "already given above"},
        Breakage{"\"device\": \"kuebler-esc-rs422\",", "", 107, "buses[1].devices[0].device", "missing"}));

// A value of another type is accepted or refused with a sentence. A list or an object is always refused.
void breakEverywhere(Json::Value &part, const Json::Value &root, const std::vector<Json::Value> &others)
{
    if (!part.isObject() && !part.isArray()) {
        const Json::Value before = part;
        for (const Json::Value &other : others) {
            part = other;
            const auto project = projectFromJson(
                QByteArray::fromStdString(Json::writeString(Json::StreamWriterBuilder(), root)), fileName);
            EXPECT_TRUE(project || !refusalText(project.error()).isEmpty());
            EXPECT_FALSE(project && (other.isArray() || other.isObject())) << before.toStyledString();
        }
        part = before;
        return;
    }
    for (Json::Value &member : part)
        breakEverywhere(member, root, others);
}

TEST(ProjectJson, EveryValueMayBeWrong)
{
    Json::Value root;
    const std::string text = example().toStdString();
    const std::unique_ptr<Json::CharReader> reader(Json::CharReaderBuilder().newCharReader());
    ASSERT_TRUE(reader->parse(text.data(), text.data() + text.size(), &root, nullptr));
    breakEverywhere(root, root,
                    {Json::Value(), Json::Value(-1), Json::Value(1e300), Json::Value(true), Json::Value(""),
                     Json::Value("x"), Json::Value(Json::arrayValue), Json::Value(Json::objectValue)});
}

TEST(ProjectJson, WhatIsNoProjectGetsASentence)
{
    const QByteArray json = example();
    for (const QByteArray &nonsense :
         {QByteArray(), QByteArray("\0\0\0\0", 4), QByteArray("PK\x03\x04"), QByteArray(100'000, '['),
          QByteArray("[]"), QByteArray("null"),
          QByteArray(R"({"format": "codewheel-project", "version": 1})"),
          QByteArray(R"({"format": "codewheel-project", "version": 1, "devices": {}})"), json + "x",
          json.chopped(3), QByteArray(json).replace(',', '\0')}) {
        const auto project = projectFromJson(nonsense, fileName);
        ASSERT_FALSE(project);
        const QString text = refusalText(project.error());
        EXPECT_TRUE(text.startsWith(QStringLiteral("crane.codewheel, line "))) << text.toStdString();
        EXPECT_TRUE(text.endsWith(QStringLiteral("The project was not opened."))) << text.toStdString();
        EXPECT_FALSE(text.contains(QStringLiteral(", :"))) << text.toStdString();
    }
}

TEST(ProjectJson, CutShortAnywhereIsRefused)
{
    const QByteArray json = example().trimmed();
    for (qsizetype length = 0; length < json.size(); ++length)
        EXPECT_FALSE(projectFromJson(json.first(length), fileName)) << length;
}

TEST(ProjectJson, ANewerVersionIsRefusedWhateverItHolds)
{
    const auto project = projectFromJson(
        R"({"format": "codewheel-project", "version": 3, "hyperspace": {"devices": 7}})", fileName);
    ASSERT_FALSE(project);
    EXPECT_EQ(refusalText(project.error()).toStdString(),
              "crane.codewheel was saved by a newer Codewheel (version 3 of the file; this one reads up to "
              "2). Open it with that one. Nothing was changed.");
}

// As if titles had once been called names, and cables been given in metres.
const MigrationStep nameBecomesTitle = [](Json::Value &root) { root.removeMember("name", &root["title"]); };
const MigrationStep metresBecomeKilometres = [](Json::Value &root) {
    Json::Value &ring = root["buses"][0];
    if (ring.isMember("metres"))
        ring["cableKilometres"] = ring["metres"].asDouble() / 1000;
    ring.removeMember("metres");
};

QByteArray ofVersion(int version, const char *title, const char *cable)
{
    return QStringLiteral(R"({"format": "codewheel-project", "version": %1, %2, "buses": [
               {"kind": "interbus", "number": 1, "name": "Ring", %3, "devices": []}]})")
        .arg(version)
        .arg(QLatin1String(title), QLatin1String(cable))
        .toUtf8();
}

TEST(ProjectJson, AnOlderVersionIsMigratedStepByStep)
{
    const MigrationStep steps[] = {nameBecomesTitle, metresBecomeKilometres};
    Project expected;
    expected.title = QStringLiteral("Crane 1");
    changeRing(expected, [](RingPlan &ring) { ring.cableKilometres = 1.5; });
    for (const QByteArray &json : {ofVersion(1, R"("name": "Crane 1")", R"("metres": 1500)"),
                                   ofVersion(2, R"("title": "Crane 1")", R"("metres": 1500)"),
                                   ofVersion(3, R"("title": "Crane 1")", R"("cableKilometres": 1.5)")}) {
        const auto project = projectFromJson(json, fileName, steps);
        ASSERT_TRUE(project) << refusalText(project.error()).toStdString();
        EXPECT_EQ(*project, expected);
    }
    EXPECT_FALSE(
        projectFromJson(ofVersion(4, R"("title": "Crane 1")", R"("cableKilometres": 1.5)"), fileName, steps));
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll();
}

// Files as saved by earlier versions, whatever becomes of the examples.
TEST(ProjectJson, FilesOfVersion1AreReadAsTheyWouldBeSavedToday)
{
    const QString folder = QStringLiteral(CODEWHEEL_ROOT "/tests/project/versions/");
    const QStringList files = QDir(folder).entryList({QStringLiteral("1-*.codewheel")});
    ASSERT_EQ(files.size(), 4);
    for (const QString &name : files) {
        const auto project = projectFromJson(contentOf(folder + name), name);
        ASSERT_TRUE(project) << refusalText(project.error()).toStdString();
        const QByteArray today = contentOf(folder + QStringLiteral("today-") + name.mid(2));
        EXPECT_EQ(projectToJson(*project).toStdString(), today.toStdString()) << name.toStdString();
    }
    Project now = *projectFromJson(example(), fileName);
    now.devices.front().lastPosition->scale.clear(); // not kept then
    EXPECT_EQ(*projectFromJson(contentOf(folder + QStringLiteral("1-ring-and-line.codewheel")), fileName),
              now);
}

TEST(ProjectJson, AMigratedFileIsComplainedAboutAtItsOwnLines)
{
    const auto project =
        projectFromJson("{\"format\": \"codewheel-project\", \"version\": 1, \"name\": \"Crane 1\",\n"
                        "\"devices\": [],\n\"cableKilometres\": -1}",
                        fileName, std::vector{nameBecomesTitle});
    ASSERT_FALSE(project);
    EXPECT_EQ(std::get<std::int64_t>(project.error().arguments[1]), 3);
}

TEST(ProjectJson, ForeignBytesAreRefusedWithTheirLine)
{
    const QByteArray good = R"({"format": "codewheel-project", "version": 1, "devices": []})";
    const std::pair<QByteArray, int> rows[] = {
        {good + '\n' + '\0', 2},
        {good + "\n\n" + '\0' + "more", 3},
        {"{\n" + QByteArray(1, '\0') + good.mid(1), 2},
    };
    ASSERT_TRUE(projectFromJson(good, fileName));
    for (const auto &[json, line] : rows) {
        const auto project = projectFromJson(json, fileName);
        ASSERT_FALSE(project) << line;
        EXPECT_EQ(std::get<std::int64_t>(project.error().arguments[1]), line);
    }
}

// As editors of Windows save it.
TEST(ProjectJson, AByteOrderMarkIsSkipped)
{
    const QByteArray mark = "\xEF\xBB\xBF";
    EXPECT_EQ(projectFromJson(mark + projectToJson(madeUpProject(3, 4)), fileName), madeUpProject(3, 4));
    const auto broken = projectFromJson(mark + "{\n\"format\": 1,,\n}", fileName);
    ASSERT_FALSE(broken);
    EXPECT_EQ(std::get<std::int64_t>(broken.error().arguments[1]), 2);
    EXPECT_FALSE(projectFromJson(mark, fileName));
    EXPECT_FALSE(projectFromJson(mark + mark + projectToJson({}), fileName)) << "only one";
}

TEST(ProjectJson, HoldsAsManyDevicesAsARingMayHave)
{
    Project project = madeUpProject(3, ring_limit::devices);
    EXPECT_EQ(projectFromJson(projectToJson(project), fileName), project);
    project = madeUpProject(3, ring_limit::devices + 1);
    const auto loaded = projectFromJson(projectToJson(project), fileName);
    ASSERT_FALSE(loaded);
    EXPECT_TRUE(refusalText(loaded.error()).contains(QStringLiteral("513 entries; at most 512")));
}

} // namespace
} // namespace codewheel
