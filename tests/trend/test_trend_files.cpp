// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/no_room.h"
#include "tests/trend/trend_csv_test.h"
#include "trend/trend_files.h"
#include "vocabulary/refusal_text.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using test::at;
using test::linePosition;
using test::ringPosition;

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString &path, const QByteArray &content)
{
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(content);
}

class TrendFilesTest : public testing::Test
{
protected:
    TrendFilesTest()
    {
        for (int time = 0; time < 20'000; ++time)
            tracks[ringPosition].append({at(time), time});
        tracks[ringPosition].interrupt(at(20'000));
        tracks[ringPosition].append({at(20'500), 1});
        tracks[ringPosition].append({at(21'000), 2});
    }
    Result<void> save()
    {
        TrendFiles files(path, extract, tracks.historyOf(), {});
        if (auto begun = files.begin(); !begun)
            return begun;
        while (files.writeSome()) {
        }
        return files.finish(origin);
    }
    QJsonObject description() const { return QJsonDocument::fromJson(contentOf(json)).object(); }
    QStringList filesThere() const { return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden); }

    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("hoist.csv"));
    const QString json = folder.filePath(QStringLiteral("hoist.json"));
    test::SampledTracks tracks;
    TrendExtract extract{
        .columns = {{ringPosition, QStringLiteral("Hoist"), {TrackUnit::degrees, 360. / 4'096}},
                    {{"1.0"_ring, Channel::speed, {}}, {}, {TrackUnit::turns, 1. / 4'096}},
                    {{"1.0"_ring, Channel::in, 25}, {}, {}}},
        .span = {at(10'000), at(30'000)}};
    TrendOrigin origin{.version = QStringLiteral("1.2"),
                       .now = QDateTime(QDate(2026, 3, 1), QTime(14, 5), QTimeZone("Europe/Berlin"))};
};

TEST_F(TrendFilesTest, AShiftedRecordingIsWrittenAtItsOwnTimes)
{
    constexpr std::chrono::seconds shift{34};
    for (TrendColumn &column : extract.columns) {
        column.shift = shift;
        column.busName = QStringLiteral("b Master");
    }
    origin.marks = {{.at = at(12'000), .place = ringPosition.place, .what = QStringLiteral("slips")},
                    {.at = at(12'000), .place = linePosition.place, .what = QStringLiteral("elsewhere")}};
    ASSERT_TRUE(save());
    const QList<QByteArray> lines = contentOf(path).split('\n');
    EXPECT_TRUE(lines[0].startsWith("time [s],b Master/1.0 Hoist: position [deg],b Master/1.0 speed [rpm]"))
        << lines[0].toStdString();
    EXPECT_TRUE(lines[1].startsWith("1772370096.000000,")) << lines[1].toStdString();
    const QJsonObject described = description();
    EXPECT_EQ(described[u"from"], QStringLiteral("2026-03-01T13:01:36.000000Z"));
    EXPECT_EQ(described[u"shownLaterSeconds"], 34);
    const QJsonObject column = described[u"columns"].toArray().at(0).toObject();
    EXPECT_EQ(column[u"shiftSeconds"], 0);
    EXPECT_EQ(column[u"knownFrom"], QStringLiteral("2026-03-01T13:01:36.000000Z"));
    const QJsonArray marks = described[u"marks"].toArray();
    ASSERT_EQ(marks.size(), 1);
    EXPECT_EQ(marks[0].toObject()[u"at"], QStringLiteral("2026-03-01T13:01:38.000000Z"));
}

// One table has one time, so what lies on another one says by how much it was shifted.
TEST_F(TrendFilesTest, OfRecordingsOnTopOfEachOtherTheShiftIsNamed)
{
    extract.columns[0].shift = std::chrono::milliseconds(-34'500);
    ASSERT_TRUE(save());
    const QList<QByteArray> lines = contentOf(path).split('\n');
    EXPECT_TRUE(lines[0].contains("1.0 Hoist: position [deg] shifted -34.500 s,1.0 speed [rpm],"))
        << lines[0].toStdString();
    EXPECT_TRUE(lines[1].startsWith("1772370130.000000,"));
    const QJsonArray columns = description()[u"columns"].toArray();
    EXPECT_EQ(columns[0].toObject()[u"shiftSeconds"], -34.5);
    EXPECT_EQ(columns[0].toObject()[u"name"], QStringLiteral("1.0 Hoist: position [deg] shifted -34.500 s"));
    EXPECT_EQ(columns[1].toObject()[u"shiftSeconds"], 0);
    EXPECT_EQ(description()[u"shownLaterSeconds"], 0);
}

TEST_F(TrendFilesTest, EarlierScalesAreDescribed)
{
    extract.columns[0].scale.earlier = {{at(9'000), 3}, {at(20'000), 360. / 8'192}};
    ASSERT_TRUE(save());
    const QJsonArray columns = description()[u"columns"].toArray();
    EXPECT_DOUBLE_EQ(columns[0][u"perStep"].toDouble(), 360. / 4'096);
    const QJsonArray earlier = columns[0][u"earlierScales"].toArray();
    ASSERT_EQ(earlier.size(), 1) << "the other one ended before the span";
    EXPECT_EQ(earlier[0][u"until"], QStringLiteral("2026-03-01T13:02:20.000000Z"));
    EXPECT_DOUBLE_EQ(earlier[0][u"perStep"].toDouble(), 360. / 8'192);
    EXPECT_TRUE(columns[1][u"earlierScales"].toArray().isEmpty());
}

TEST_F(TrendFilesTest, TheDescriptionStandsBesideTheTable)
{
    EXPECT_EQ(TrendFiles::descriptionPath(QStringLiteral("/a/hoist.csv")), QStringLiteral("/a/hoist.json"));
    EXPECT_EQ(TrendFiles::descriptionPath(QStringLiteral("HOIST.CSV")), QStringLiteral("HOIST.json"));
    EXPECT_EQ(TrendFiles::descriptionPath(QStringLiteral("a.txt")), QStringLiteral("a.txt.json"));
    EXPECT_EQ(TrendFiles::descriptionPath(QStringLiteral("a.json")), QStringLiteral("a.json.json"))
        << "never the table itself";
    ASSERT_TRUE(save());
    EXPECT_EQ(filesThere(), QStringList({QStringLiteral("hoist.csv"), QStringLiteral("hoist.json")}));
    EXPECT_TRUE(
        contentOf(path).startsWith("time [s],1.0 Hoist: position [deg],1.0 speed [rpm],1.0 IN.25\r\n"));
}

TEST_F(TrendFilesTest, TheDescriptionTellsWhatTheTableIs)
{
    ASSERT_TRUE(save());
    const QJsonObject told = description();
    EXPECT_EQ(told[u"format"], QStringLiteral("codewheel-trend"));
    EXPECT_EQ(told[u"version"], 1);
    EXPECT_EQ(told[u"program"], QStringLiteral("Codewheel 1.2"));
    EXPECT_EQ(told[u"written"], QStringLiteral("2026-03-01T13:05:00.000Z"));
    EXPECT_EQ(told[u"file"], QStringLiteral("hoist.csv"));
    EXPECT_EQ(told[u"rows"].toInt(), contentOf(path).count('\n') - 1);
    EXPECT_EQ(told[u"from"], QStringLiteral("2026-03-01T13:02:10.000000Z"));
    EXPECT_EQ(told[u"to"], QStringLiteral("2026-03-01T13:02:30.000000Z"));
    EXPECT_EQ(told[u"timeZone"], (QJsonObject{{QStringLiteral("id"), QStringLiteral("Europe/Berlin")},
                                              {QStringLiteral("offsetSeconds"), 3'600}}));
    EXPECT_EQ(told[u"separator"], QStringLiteral(","));
    EXPECT_EQ(told[u"decimalSign"], QStringLiteral("."));
    EXPECT_EQ(told[u"timeColumn"], QStringLiteral("time [s]"));
}

TEST_F(TrendFilesTest, TheDescriptionTellsOfEachColumnWhatItIsAndHowMuchIsMissing)
{
    ASSERT_TRUE(save());
    const QJsonArray columns = description()[u"columns"].toArray();
    ASSERT_EQ(columns.size(), 3);
    EXPECT_EQ(columns[0].toObject(),
              (QJsonObject{{QStringLiteral("name"), QStringLiteral("1.0 Hoist: position [deg]")},
                           {QStringLiteral("track"), QStringLiteral("1.0/position")},
                           {QStringLiteral("bus"), 1},
                           {QStringLiteral("place"), QStringLiteral("1.0")},
                           {QStringLiteral("channel"), QStringLiteral("position")},
                           {QStringLiteral("bit"), QJsonValue()},
                           {QStringLiteral("unit"), QStringLiteral("deg")},
                           {QStringLiteral("perStep"), 360. / 4'096},
                           {QStringLiteral("earlierScales"), QJsonArray()},
                           {QStringLiteral("knownFrom"), QStringLiteral("2026-03-01T13:02:10.000000Z")},
                           {QStringLiteral("knownTo"), QStringLiteral("2026-03-01T13:02:21.000000Z")},
                           {QStringLiteral("gaps"), 1},
                           {QStringLiteral("gapSeconds"), 0.5},
                           {QStringLiteral("shiftSeconds"), 0.0}}));
    EXPECT_EQ(columns[1][u"unit"], QStringLiteral("rpm"));
    EXPECT_DOUBLE_EQ(columns[1][u"perStep"].toDouble(), 60. / 4'096);
    EXPECT_TRUE(columns[1][u"knownFrom"].isNull());
    EXPECT_EQ(columns[2][u"bit"], 25);
    EXPECT_TRUE(columns[2][u"unit"].isNull());
    EXPECT_TRUE(columns[2][u"perStep"].isNull());
}

TEST_F(TrendFilesTest, TheDescriptionCountsWhatIsMissingWithinTheSpan)
{
    struct Row
    {
        int from;
        int to; // milliseconds
        const char *knownFrom;
        const char *knownTo;
        int gaps;
        double seconds;
    };
    tracks[ringPosition].interrupt(at(22'000)); // for good
    for (const Row &row :
         {Row{20'100, 20'700, "20.500000", "20.700000", 1, 0.4},
          Row{19'900, 20'300, "19.900000", "20.000000", 1, 0.3},
          Row{20'100, 20'300, nullptr, nullptr, 1, 0.2}, Row{100, 23'000, "00.100000", "21.000000", 2, 1.5},
          Row{100, 200, "00.100000", "00.200000", 0, 0}, Row{-200, -100, nullptr, nullptr, 0, 0}}) {
        extract.span = {at(row.from), at(row.to)};
        ASSERT_TRUE(save());
        const QJsonObject column = description()[u"columns"][0].toObject();
        const auto second = [&](QStringView key) {
            return column[key].toString().section(u':', -1).chopped(1);
        };
        if (row.knownFrom != nullptr) {
            EXPECT_EQ(second(u"knownFrom"), QLatin1String(row.knownFrom)) << row.from;
            EXPECT_EQ(second(u"knownTo"), QLatin1String(row.knownTo)) << row.from;
        } else {
            EXPECT_TRUE(column[u"knownFrom"].isNull() && column[u"knownTo"].isNull()) << row.from;
        }
        EXPECT_EQ(column[u"gaps"], row.gaps) << row.from;
        EXPECT_DOUBLE_EQ(column[u"gapSeconds"].toDouble(), row.seconds) << row.from;
    }
}

TEST_F(TrendFilesTest, TheDescriptionTellsWhatIsKnownOfItsEncoders)
{
    const QDateTime known(QDate(2026, 3, 1), QTime(12, 0), Qt::UTC);
    origin.encoders = {{.place = linePosition.place, .device = QStringLiteral("kuebler-esc-rs485")},
                       {.place = ringPosition.place,
                        .station = QStringLiteral("Hoist"),
                        .busName = QStringLiteral("Crane 2"),
                        .device = QStringLiteral("fraba-ocd-ib"),
                        .deviceName = QStringLiteral("FRABA OCD-IB K3"),
                        .stepsPerTurn = 4'096,
                        .values = {{Parameter::steps, 4'096, Evidence::read, known}}}};
    ASSERT_TRUE(save());
    EXPECT_EQ(
        description()[u"encoders"],
        (QJsonArray{QJsonObject{
            {QStringLiteral("bus"), 1},
            {QStringLiteral("place"), QStringLiteral("1.0")},
            {QStringLiteral("busName"), QStringLiteral("Crane 2")},
            {QStringLiteral("station"), QStringLiteral("Hoist")},
            {QStringLiteral("device"), QStringLiteral("fraba-ocd-ib")},
            {QStringLiteral("deviceName"), QStringLiteral("FRABA OCD-IB K3")},
            {QStringLiteral("stepsPerTurn"), 4'096},
            {QStringLiteral("values"),
             QJsonArray{QJsonObject{{QStringLiteral("parameter"), QStringLiteral("steps")},
                                    {QStringLiteral("value"), 4'096},
                                    {QStringLiteral("evidence"), QStringLiteral("read")},
                                    {QStringLiteral("at"), QStringLiteral("2026-03-01T12:00:00.000Z")}}}}}}))
        << "only of those in the table";
}

TEST_F(TrendFilesTest, TheDescriptionTellsWhatHappenedMeanwhile)
{
    const Message started{.place = Place{firstBus, {}}, .id = MessageId::busStarted};
    origin.marks = {{at(9'999), {}, QStringLiteral("too early")},
                    {at(10'000), started.place, started},
                    {at(12'000) + Instant(5), {}, QStringLiteral("belt slips")},
                    {at(30'001), {}, QStringLiteral("too late")}};
    origin.dropped = 12;
    ASSERT_TRUE(save());
    EXPECT_EQ(description()[u"marks"],
              (QJsonArray{QJsonObject{{QStringLiteral("at"), QStringLiteral("2026-03-01T13:02:10.000000Z")},
                                      {QStringLiteral("kind"), QStringLiteral("message")},
                                      {QStringLiteral("bus"), 1},
                                      {QStringLiteral("place"), QJsonValue()},
                                      {QStringLiteral("severity"), QStringLiteral("information")},
                                      {QStringLiteral("code"), QStringLiteral("busStarted")},
                                      {QStringLiteral("text"), messageText(started)}},
                          QJsonObject{{QStringLiteral("at"), QStringLiteral("2026-03-01T13:02:12.000005Z")},
                                      {QStringLiteral("kind"), QStringLiteral("note")},
                                      {QStringLiteral("text"), QStringLiteral("belt slips")}}}));
    EXPECT_EQ(description()[u"dropped"], 12);
}

std::vector<QStringList> keysIn(const QJsonObject &description)
{
    const QJsonArray marks = description[u"marks"].toArray();
    return {description.keys(),
            description[u"timeZone"].toObject().keys(),
            description[u"columns"][0].toObject().keys(),
            description[u"encoders"][0].toObject().keys(),
            marks.first().toObject().keys(),
            marks.last().toObject().keys()};
}

TEST_F(TrendFilesTest, TheDescriptionHasTheKeysOfTheExampleInTheDocumentation)
{
    const QString page = QString::fromUtf8(contentOf(QStringLiteral(CODEWHEEL_ROOT "/docs/trend-files.md")));
    const QString example = page.section(QStringLiteral("```json"), 1).section(QStringLiteral("```"), 0, 0);
    origin.encoders = {{.place = ringPosition.place}};
    origin.marks = {{at(12'000), ringPosition.place, Message{.place = ringPosition.place}},
                    {at(13'500), {}, QStringLiteral("belt slips")}};
    ASSERT_TRUE(save());
    EXPECT_EQ(keysIn(description()), keysIn(QJsonDocument::fromJson(example.toUtf8()).object()));
}

TEST_F(TrendFilesTest, NothingIsThereBeforeBothAreComplete)
{
    {
        TrendFiles files(path, extract, tracks.historyOf(), {});
        ASSERT_TRUE(files.begin());
        EXPECT_TRUE(files.writeSome());
        EXPECT_FALSE(QFile::exists(path));
        EXPECT_FALSE(QFile::exists(json));
    } // cancelled
    EXPECT_TRUE(filesThere().isEmpty());
}

TEST_F(TrendFilesTest, ReplaceThoseOfAnotherTrend)
{
    ASSERT_TRUE(save());
    const QByteArray before = contentOf(path);
    extract.span.from = at(15'000);
    ASSERT_TRUE(save());
    EXPECT_NE(contentOf(path), before);
    EXPECT_EQ(description()[u"from"], QStringLiteral("2026-03-01T13:02:15.000000Z"));
    EXPECT_EQ(filesThere().size(), 2);
}

TEST_F(TrendFilesTest, LeaveAloneWhatBelongsToNoTrend)
{
    for (const char *content : {"{\"format\": \"codewheel-cams\"}", "", "[1]", "{\"format\": 1}"}) {
        put(json, content);
        const auto saved = save();
        ASSERT_FALSE(saved);
        EXPECT_EQ(
            refusalText(saved.error()),
            json + QStringLiteral(" cannot be written: It does not belong to a trend. Give the trend another "
                                  "name. Nothing was changed there."));
        EXPECT_EQ(contentOf(json), content);
        EXPECT_FALSE(QFile::exists(path));
    }
}

TEST_F(TrendFilesTest, StayAsTheyAreWhereThereIsNoRoom)
{
    ASSERT_TRUE(save());
    const QByteArray table = contentOf(path);
    const QByteArray described = contentOf(json);
    extract.span.from = at(0);
    for (const rlim_t room : {rlim_t{100}, rlim_t{200'000}}) {
        const auto saved = [&] {
            const test::NoRoom disk(room);
            return save();
        }();
        ASSERT_FALSE(saved);
        EXPECT_EQ(saved.error().id, RefusalId::fileNotWritten);
        EXPECT_EQ(saved.error().arguments.front(), RefusalArgument(path));
        EXPECT_EQ(contentOf(path), table);
        EXPECT_EQ(contentOf(json), described);
        EXPECT_EQ(filesThere().size(), 2);
    }
}

TEST_F(TrendFilesTest, TheTableIsNotThereWithoutItsDescription)
{
    TrendFiles files(path, extract, tracks.historyOf(), {});
    ASSERT_TRUE(files.begin());
    while (files.writeSome()) {
    }
    ASSERT_TRUE(QDir(folder.path()).mkdir(QStringLiteral("hoist.json")));
    const auto saved = files.finish(origin);
    ASSERT_FALSE(saved);
    EXPECT_EQ(saved.error().id, RefusalId::fileNotWritten);
    EXPECT_EQ(saved.error().arguments.front(), RefusalArgument(json));
    EXPECT_FALSE(QFile::exists(path));
}

TEST_F(TrendFilesTest, AreRefusedWhereNoFileCanBe)
{
    for (const QString &place : {folder.filePath(QStringLiteral("nowhere/hoist.csv")), folder.path(),
                                 QStringLiteral("/dev/full"), QStringLiteral("/proc/hoist.csv")}) {
        TrendFiles files(place, extract, tracks.historyOf(), {});
        const auto begun = files.begin();
        ASSERT_FALSE(begun) << place.toStdString();
        EXPECT_EQ(begun.error().id, RefusalId::fileNotWritten);
    }
    EXPECT_TRUE(filesThere().isEmpty());
}

} // namespace
} // namespace codewheel
