// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/words/device_number.h"
#include "tests/trend/trend_csv_test.h"

#include <QFile>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using test::at;
using test::linePosition;
using test::ringIn;
using test::ringPosition;
using test::SampledTracks;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

TrendExtract extractOf(const std::vector<Track> &tracks, Instant from, Instant to)
{
    TrendExtract extract{.columns = {}, .span = {from, to}};
    for (const Track &track : tracks)
        extract.columns.push_back({.track = track});
    return extract;
}

TEST(TrendColumn, IsNamedByPlaceAndWhatIsInItWithItsUnit)
{
    const TrackScale degrees{TrackUnit::degrees, 360. / 4'096};
    const TrackScale turns{TrackUnit::turns, 1. / 4'096};
    const Place otherRing{{3}, NodeId("1.0")};
    const std::vector<std::pair<TrendColumn, const char *>> titles{
        {{ringPosition, {}, {}}, "1.0 position [steps]"},
        {{ringPosition, {}, degrees}, "1.0 position [deg]"},
        {{{"1.0"_ring, Channel::speed, {}}, {}, turns}, "1.0 speed [rpm]"},
        {{ringIn, {}, degrees}, "1.0 IN"},
        {{{"1.0"_ring, Channel::out, 25}, {}, {}}, "1.0 OUT.25"},
        {{{"3.0"_ring, Channel::cams, {}}, {}, {}}, "3.0 cams"},
        {{{"3.0"_ring, Channel::cams, 1}, {}, {}}, "3.0 cam 1"},
        {{{otherRing, Channel::position, {}}, {}, {}}, "3/1.0 position [steps]"},
        {{linePosition, QStringLiteral("Hoist"), {}}, "esc:05 Hoist: position [steps]"},
        {{ringIn, QStringLiteral(" two\nlines\t"), {}}, "1.0 two lines: IN"}};
    for (const auto &[column, title] : titles)
        EXPECT_EQ(column.title().toStdString(), title);
}

TEST(TrendCsv, BeginsWithTheNamesOfItsColumns)
{
    const SampledTracks tracks;
    TrendExtract extract = extractOf({ringPosition, ringIn}, at(0), at(10));
    EXPECT_EQ(tracks.written(extract), "time [s],1.0 position [steps],1.0 IN\r\n");
    extract.columns[0].name = QStringLiteral("Crane 1, \"hoist\"");
    EXPECT_EQ(tracks.written(extract),
              "time [s],\"1.0 Crane 1, \"\"hoist\"\": position [steps]\",1.0 IN\r\n");
    extract.columns[0].name = QStringLiteral("=HYPERLINK(A1)");
    EXPECT_EQ(tracks.written(extract), "time [s],1.0 =HYPERLINK(A1): position [steps],1.0 IN\r\n");
}

TEST(TrendCsv, HasTimesInSecondsToTheMicrosecond)
{
    SampledTracks tracks;
    tracks[ringPosition].append({at(0) + Instant(7), -12});
    EXPECT_EQ(tracks.written(extractOf({ringPosition}, at(0), at(10))),
              "time [s],1.0 position [steps]\r\n1772370120.000007,-12\r\n");
}

TEST(TrendCsv, HasARowForEveryMomentOfAnyColumn)
{
    SampledTracks tracks;
    for (const auto &[time, value] : {std::pair(0, 10), {2, 20}, {4, 30}})
        tracks[ringPosition].append({at(time), value});
    for (const auto &[time, value] : {std::pair(0, 500), {3, 600}, {9, 700}})
        tracks[linePosition].append({at(time), value});
    EXPECT_THAT(tracks.rows(extractOf({ringPosition, linePosition}, at(0), at(100))),
                ElementsAre(u"0,10,500", u"2,20,500", u"3,20,600", u"4,30,600", u"9,,700"))
        << "nobody knows 1.0 after its last sample";
}

TEST(TrendCsv, LeavesUnknownWhatIsBeforeTheFirstSampleAndWhatNobodyWatched)
{
    SampledTracks tracks;
    tracks[ringPosition].append({at(0), 10});
    tracks[ringPosition].append({at(5), 11});
    tracks[linePosition].append({at(5), 500});
    EXPECT_THAT(tracks.rows(extractOf({ringPosition, linePosition, ringIn}, at(0), at(100))),
                ElementsAre(u"0,10,,", u"5,11,500,"));
}

TEST(TrendCsv, HasAnEmptyCellFromWhereAGapBegins)
{
    SampledTracks tracks;
    MemoryHistory &position = tracks[ringPosition];
    position.append({at(0), 10});
    position.interrupt(at(3));
    position.append({at(8), 11});
    for (const int time : {0, 5, 9})
        tracks[linePosition].append({at(time), time});
    EXPECT_THAT(tracks.rows(extractOf({ringPosition, linePosition}, at(0), at(9))),
                ElementsAre(u"0,10,0", u"3,,0", u"5,,5", u"8,11,5", u"9,,9"));
}

TEST(TrendCsv, TellsAGapThatBeginsWithASampleFromTheSample)
{
    SampledTracks tracks;
    tracks[ringPosition].append({at(1), 10});
    tracks[ringPosition].interrupt(at(1));
    tracks[ringPosition].append({at(4), 11});
    EXPECT_THAT(tracks.rows(extractOf({ringPosition}, at(0), at(9))), ElementsAre(u"1,10", u"1,", u"4,11"));
}

TEST(TrendCsv, BeginsAndEndsWithWhatStandsAtTheEndsOfItsSpan)
{
    SampledTracks tracks;
    for (int time = 0; time <= 100; ++time)
        tracks[ringPosition].append({at(time), 7}); // of which two samples are kept
    for (const auto &[time, value] : {std::pair(0, 1), {50, 2}, {100, 3}})
        tracks[linePosition].append({at(time), value});
    EXPECT_THAT(tracks.rows(extractOf({ringPosition}, at(20), at(40))), ElementsAre(u"20,7", u"40,7"));
    EXPECT_THAT(tracks.rows(extractOf({ringPosition, linePosition}, at(20), at(60))),
                ElementsAre(u"20,7,1", u"50,7,2", u"60,7,2"));
    EXPECT_THAT(tracks.rows(extractOf({linePosition}, at(50), at(100))), ElementsAre(u"50,2", u"100,3"))
        << "both ends included";
}

TEST(TrendCsv, IsEmptyWhereNothingWas)
{
    SampledTracks tracks;
    tracks[ringPosition].append({at(5), 1});
    EXPECT_THAT(tracks.rows(extractOf({ringPosition}, at(-10), at(4))), IsEmpty());
    EXPECT_THAT(tracks.rows(extractOf({ringPosition}, at(6), at(20))), IsEmpty());
    EXPECT_THAT(tracks.rows(extractOf({ringPosition}, at(20), at(0))), IsEmpty());
    EXPECT_THAT(tracks.rows(extractOf({}, at(0), at(20))), IsEmpty());
}

TEST(TrendCsv, HasASpikeOfOneCycle)
{
    SampledTracks tracks;
    for (int time = 0; time < 100'000; ++time)
        tracks[ringPosition].append({at(time), time == 76'543 ? 4'096 : 12});
    const QStringList rows = tracks.rows(extractOf({ringPosition}, at(0), at(100'000)));
    EXPECT_THAT(rows, ElementsAre(u"0,12", u"76542,12", u"76543,4096", u"76544,12", u"99999,12"));
}

TEST(TrendCsv, HasEachOfSeveralSamplesOfOneMoment)
{
    SampledTracks tracks;
    for (const int value : {1, 2, 3})
        tracks[ringPosition].append({at(5), value});
    EXPECT_THAT(tracks.rows(extractOf({ringPosition}, at(0), at(9))), ElementsAre(u"5,1", u"5,2", u"5,3"));
}

TEST(TrendCsv, HasWordsAsNumbersAndBitsAsZeroOrOne)
{
    SampledTracks tracks;
    for (const auto &[time, word] : {std::pair(0, 0xFFFF'FFFFLL), {1, 0x0200'0000LL}, {2, 0LL}}) {
        tracks[ringIn].append({at(time), word});
        tracks[{"1.0"_ring, Channel::in, 25}].append({at(time), word});
    }
    EXPECT_THAT(tracks.rows(extractOf({ringIn, {"1.0"_ring, Channel::in, 25}}, at(0), at(9))),
                ElementsAre(u"0,4294967295,1", u"1,33554432,1", u"2,0,0"));
}

TEST(TrendCsv, HasValuesInTheUnitOfTheirScale)
{
    SampledTracks tracks;
    const Track speed{"1.0"_ring, Channel::speed, {}};
    tracks[ringPosition].append({at(0), 1'024});
    tracks[speed].append({at(0), 4'096'000});
    TrendExtract extract = extractOf({ringPosition, speed}, at(0), at(9));
    EXPECT_THAT(tracks.rows(extract), ElementsAre(u"0,1024,4096.000"));
    for (TrendColumn &column : extract.columns)
        column.scale = {TrackUnit::turns, 1. / 4'096};
    EXPECT_THAT(tracks.rows(extract), ElementsAre(u"0,0.250000,60.0000000"));
    for (TrendColumn &column : extract.columns)
        column.scale = {TrackUnit::millimetres, 0.005};
    EXPECT_THAT(tracks.rows(extract), ElementsAre(u"0,5.120,20.480000"));
}

TEST(TrendCsv, WritesAMillionRowsPieceByPiece)
{
    constexpr int count = 1'000'000;
    SampledTracks tracks;
    for (int time = 0; time < count; ++time)
        tracks[ringPosition].append({at(time), time});
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    TrendCsv csv(buffer, extractOf({ringPosition}, at(0), at(count)), tracks.historyOf());
    qint64 before = 0;
    qint64 largest = 0;
    for (bool isMore = true; isMore; before = buffer.size()) {
        const double part = csv.part();
        isMore = csv.writeSome();
        EXPECT_GT(csv.part(), part);
        largest = std::max(largest, buffer.size() - before);
    }
    EXPECT_EQ(csv.rows(), count);
    EXPECT_EQ(csv.part(), 1);
    EXPECT_EQ(buffer.data().count('\n'), count + 1);
    EXPECT_TRUE(buffer.data().endsWith("\r\n1772371119.999000,999999\r\n"));
    EXPECT_LT(largest, 500'000);
}

// Each look into a history may be a question to a database.
TEST(TrendCsv, LooksIntoEachOfManyColumnsAFewTimes)
{
    constexpr int columns = 2'000;
    SampledTracks tracks;
    std::vector<Track> all;
    for (int i = 0; i < columns; ++i) {
        all.push_back({{{i / 100 + 1}, DeviceNumber{i % 100 + 1, 0}.node()}, Channel::position, {}});
        for (int sample = 0; sample < 50; ++sample)
            tracks[all.back()].append({at(sample), i + sample});
    }
    int looks = 0;
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    TrendCsv csv(buffer, extractOf(all, at(0), at(50)),
                 [&, of = tracks.historyOf()](const Track &track) {
                     ++looks;
                     return of(track);
                 },
                 {});
    while (csv.writeSome()) {
    }
    EXPECT_EQ(buffer.data().count('\n'), 1 + 50);
    EXPECT_LE(looks, 8 * columns);
}

TEST(TrendCsv, GoesOnWhileSamplesComeAndGo)
{
    SampledTracks tracks;
    for (int time = 0; time < 50'000; ++time)
        tracks[ringPosition].append({at(time), time});
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    TrendCsv csv(buffer, extractOf({ringPosition}, at(0), at(49'999)), tracks.historyOf());
    ASSERT_TRUE(csv.writeSome());
    for (int time = 50'000; time < 60'000; ++time)
        tracks[ringPosition].append({at(time), time});
    for (int blocks = 0; blocks < 4; ++blocks)
        tracks[ringPosition].forgetOldest();
    while (csv.writeSome()) {
    }
    EXPECT_GT(csv.rows(), 30'000);
    EXPECT_TRUE(buffer.data().endsWith(",49999\r\n")) << "no more than was asked for";
}

TEST(TrendCsv, EndsWhereATrackIsGoneMeanwhile)
{
    SampledTracks tracks;
    for (int time = 0; time < 50'000; ++time)
        tracks[ringPosition].append({at(time), time});
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    TrendCsv csv(buffer, extractOf({ringPosition}, at(0), at(49'999)), tracks.historyOf());
    ASSERT_TRUE(csv.writeSome());
    const qint64 rows = csv.rows();
    tracks.forget();
    while (csv.writeSome()) {
    }
    EXPECT_EQ(csv.rows(), rows);
}

TEST(TrendCsv, StopsWhereNothingCanBeWritten)
{
    SampledTracks tracks;
    for (int time = 0; time < 50'000; ++time)
        tracks[ringPosition].append({at(time), time});
    QFile full(QStringLiteral("/dev/full"));
    ASSERT_TRUE(full.open(QIODevice::WriteOnly | QIODevice::Unbuffered));
    TrendCsv csv(full, extractOf({ringPosition}, at(0), at(49'999)), tracks.historyOf());
    EXPECT_FALSE(csv.writeSome());
    EXPECT_LT(csv.part(), 1);
    EXPECT_FALSE(full.errorString().isEmpty());
}

TEST(TrendCsv, EachValueIsScaledAsItsStepWasThen)
{
    SampledTracks tracks;
    for (const auto time : {0, 1, 2})
        tracks[ringPosition].append({at(time), 100});
    TrendExtract extract = extractOf({ringPosition}, at(0), at(2));
    extract.columns[0].scale = {TrackUnit::degrees, 0.5, {{at(1), 2}}};
    EXPECT_EQ(tracks.rows(extract), (QStringList{QStringLiteral("0,200"), QStringLiteral("2,50.0")}));
}

} // namespace
} // namespace codewheel
