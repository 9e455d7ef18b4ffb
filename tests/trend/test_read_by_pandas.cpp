// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/trend/trend_csv_test.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryFile>

#include <gmock/gmock.h>

namespace codewheel {
namespace {

using test::at;
using test::linePosition;
using test::ringIn;
using test::ringPosition;

constexpr int cycles = 1'000'000;
constexpr int spikeAt = 654'321;

QByteArray outputOf(const QStringList &arguments)
{
    QProcess python;
    python.start(QStringLiteral(PYTHON3), arguments);
    const bool hasEnded = python.waitForFinished(300'000);
    return hasEnded && python.exitCode() == 0 ? python.readAllStandardOutput() : QByteArray();
}

class ReadByPandas : public testing::Test
{
protected:
    // A shaft that turns for 1000 s with a spike, a word, and a line that was interrupted.
    static void SetUpTestSuite()
    {
        s_isThere = !outputOf({QStringLiteral("-c"), QStringLiteral("import pandas; print(1)")}).isEmpty();
        for (int time = 0; s_isThere && time < cycles; ++time) {
            s_tracks[ringPosition].append({at(time), time == spikeAt ? 33'554'431 : time % 8'192});
            s_tracks[ringIn].append({at(time), 0xFFFF'FFFF});
            if (time % 10 == 0)
                s_tracks[linePosition].append({at(time), -time});
            if (time == 500'000)
                s_tracks[linePosition].interrupt(at(time + 1));
            if (time == 500'000)
                time += 99; // nothing came for 100 ms
        }
    }
    static void TearDownTestSuite() { s_tracks.forget(); }
    void SetUp() override
    {
        if (!s_isThere)
            GTEST_SKIP() << "the package python3-pandas is not installed";
    }

    static TrendExtract extract()
    {
        return {.columns = {{ringPosition,
                             QStringLiteral("Crane 1, \"hoist\""),
                             {TrackUnit::degrees, 360. / 8'192}},
                            {linePosition, {}, {}},
                            {ringIn, {}, {}}},
                .span = {at(0), at(cycles)}};
    }
    QJsonObject read(const CsvStyle &style)
    {
        QTemporaryFile file;
        EXPECT_TRUE(file.open());
        file.write(s_tracks.written(extract(), style));
        file.close();
        const QString name =
            style.isForSpreadsheets() ? QStringLiteral("spreadsheet") : QStringLiteral("plain");
        return QJsonDocument::fromJson(outputOf({QStringLiteral(READ_TREND), file.fileName(), name}))
            .object();
    }
    static std::vector<double> numbers(const QJsonValue &list)
    {
        std::vector<double> values;
        for (const QJsonValue &value : list.toArray())
            values.push_back(value.toDouble());
        return values;
    }

    static inline test::SampledTracks s_tracks;
    static inline bool s_isThere = false;
};

TEST_F(ReadByPandas, IsATableOfNumbersOverTime)
{
    const QJsonObject table = read({});
    EXPECT_EQ(
        table[u"columns"],
        QJsonArray({QStringLiteral("time [s]"), QStringLiteral("1.0 Crane 1, \"hoist\": position [deg]"),
                    QStringLiteral("esc:05 position [steps]"), QStringLiteral("1.0 IN")}));
    EXPECT_EQ(table[u"types"], QJsonArray({QStringLiteral("float64"), QStringLiteral("float64"),
                                           QStringLiteral("float64"), QStringLiteral("int64")}));
    EXPECT_EQ(table[u"rows"].toInt(), cycles - 99 + 1) << "all cycles, and the beginning of the gap";
    EXPECT_TRUE(table[u"isMonotonic"].toBool());
    EXPECT_EQ(table[u"first"].toString(), QStringLiteral("2026-03-01 13:02:00+00:00"));
    EXPECT_EQ(table[u"last"].toString(), QStringLiteral("2026-03-01 13:18:39.999000+00:00"));
    EXPECT_THAT(numbers(table[u"greatest"]), testing::ElementsAre(1'474'559.9561, 0, 4'294'967'295.));
}

TEST_F(ReadByPandas, HasNoNumberWhereNothingWasKnown)
{
    // From 500001 to 500099 there was no cycle; 1000 - 991 = 9 cycles follow the last sample of the line.
    EXPECT_THAT(numbers(read({})[u"missing"]), testing::ElementsAre(0, 0, 1 + 9, 0));
}

TEST_F(ReadByPandas, HasTheSameNumbersAsASpreadsheetOfGermany)
{
    const QJsonObject plain = read({});
    const QJsonObject german = read({QLocale(QStringLiteral("de_DE")), QTimeZone(3'600)});
    for (const auto *key : {u"rows", u"missing", u"greatest", u"sums"})
        EXPECT_EQ(german[QStringView(key)], plain[QStringView(key)]) << QString::fromUtf16(key).toStdString();
    EXPECT_EQ(german[u"types"], QJsonArray({QStringLiteral("object"), QStringLiteral("float64"),
                                            QStringLiteral("float64"), QStringLiteral("int64")}));
    EXPECT_TRUE(german[u"isMonotonic"].toBool());
    EXPECT_EQ(german[u"first"].toString(), QStringLiteral("2026-03-01 14:02:00"));
    EXPECT_EQ(german[u"last"].toString(), QStringLiteral("2026-03-01 14:18:39.999000"));
}

} // namespace
} // namespace codewheel
