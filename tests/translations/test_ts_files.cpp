// SPDX-License-Identifier: GPL-3.0-or-later
// The .ts files are complete: they match the sources, no more, no less. If a test fails after a text was
// changed, docs/translating.md says what to do.
#include "tests/translations/translation_rules.h"

#include <QProcess>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

const QString sourceFolder = QStringLiteral(CODEWHEEL_SOURCE_FOLDER);
const QString germanFile = sourceFolder + QStringLiteral("/translations/codewheel_de.ts");
const QString englishFile = sourceFolder + QStringLiteral("/translations/codewheel_en.ts");

// Words that engineers also use in German. Add only what a German manual prints like that.
const QStringList sameInGerman{
    QStringLiteral("%1. Position: %2"),
    QStringLiteral("2 MBd"),
    QStringLiteral("%1 (ms)"),
    QStringLiteral("&Port"),
    QStringLiteral("Bytes"),
    QStringLiteral("Identifier"),
    QStringLiteral("pre-operational"),
    QStringLiteral("%1, %2 kBit/s"),
    QStringLiteral("ms"),
    QStringLiteral("Client"),
    QStringLiteral("Clients"),
    QStringLiteral("Exceptions %1"),
    QStringLiteral("Format"),
    QStringLiteral("Gateway"),
    QStringLiteral("Ho&st"),
    QStringLiteral("Host"),
    QStringLiteral("Port"),
    QStringLiteral("Ring"),
    QStringLiteral("Unit"),
    QStringLiteral("Unit %1"),
    QStringLiteral("Alarm"),
    QStringLiteral("Echo"),
    QStringLiteral("&Terminal"),
    QStringLiteral("500 kBd"),
    QStringLiteral("ACTIVE"),
    QStringLiteral("Trend"),
    QStringLiteral("&Trend"),
    QStringLiteral("trend.csv"),
    QStringLiteral("trend.png"),
    QStringLiteral("Pause"),
    QStringLiteral("Rate"),
    QStringLiteral("Min"),
    QStringLiteral("Max"),
    QStringLiteral("Bit %1"),
    QStringLiteral("Bit %1, %2: %3"),
    QStringLiteral("Bus"),
    QStringLiteral("&Bus"),
    QStringLiteral("BUS FAIL"),
    QStringLiteral("°C"),
    QStringLiteral("%1 %2"),
    QStringLiteral("EEPROM"),
    QStringLiteral("CCW"),
    QStringLiteral("Code"),
    QStringLiteral("CW"),
    QStringLiteral("Gray"),
    QStringLiteral("%1 Gray"),
    QStringLiteral("&Gray"),
    QStringLiteral("Gray, CCW"),
    QStringLiteral("Gray, CW"),
    QStringLiteral("h"),
    QStringLiteral("H&ost"),
    QStringLiteral("Handshake"),
    QStringLiteral("IN"),
    QStringLiteral("IN  %1  %2"),
    QStringLiteral("Information"),
    QStringLiteral("In %1 s: %2"),
    QStringLiteral("LED"),
    QStringLiteral("LEDs"),
    QStringLiteral("LEDs: %1"),
    QStringLiteral("Master"),
    QStringLiteral("Master:         %1"),
    QStringLiteral("Master %1"),
    QStringLiteral("mm"),
    QStringLiteral("%1 mm"),
    QStringLiteral("%1 mm/s"),
    QStringLiteral("Monitor %1"),
    QStringLiteral("M&onitor"),
    QStringLiteral("%1 ms"),
    QStringLiteral("Name"),
    QStringLiteral("offline"),
    QStringLiteral("Offset"),
    QStringLiteral("ok"),
    QStringLiteral("OUT"),
    QStringLiteral("OUT %1  %2"),
    QStringLiteral("Parameter %1"),
    QStringLiteral("Parameter"),
    QStringLiteral("Parameter %1 %2"),
    QStringLiteral("PCP"),
    QStringLiteral("PDF (*.pdf)"),
    QStringLiteral("Pin"),
    QStringLiteral("Position"),
    QStringLiteral("Position %1"),
    QStringLiteral("Position: %1."),
    QStringLiteral("Preset"),
    QStringLiteral("READY"),
    QStringLiteral("RUN"),
    QStringLiteral("Segment"),
    QStringLiteral("Signal"),
    QStringLiteral("Software"),
    QStringLiteral("Start"),
    QStringLiteral("Station"),
    QStringLiteral("Status:         %1 (%2)"),
    QStringLiteral("Step &5"),
    QStringLiteral("%1 Bd"),
    QStringLiteral("%1 = %2 h"),
    QStringLiteral("%1: %2"),
    QStringLiteral("%1: %2?"),
    QStringLiteral(" MB"),
    QStringLiteral(" ms"),
    QStringLiteral(" s"),
    QStringLiteral("%1 (%2)."),
    QStringLiteral("%1 Bd, %2"),
    QStringLiteral("%1 (OUT %2)"),
    QStringLiteral("Hex"),
    QStringLiteral("Text"),
    QStringLiteral("Version"),
    QStringLiteral("SYNC"),
    QStringLiteral("SYNC %1"),
    QStringLiteral("SYNC: %1"),
    QStringLiteral("TIME"),
    QStringLiteral("TIME: %1"),
    QStringLiteral("TIME %1 %2"),
    QStringLiteral("EMCY %1"),
    QStringLiteral("TPDO%1?"),
    QStringLiteral("NMT: %1"),
    QStringLiteral("LSS: %1"),
    QStringLiteral(" Bd"),
    QStringLiteral("%1 (%2 ms)"),
    QStringLiteral("%1 kBit/s"),
    QStringLiteral("Adapter"),
    QStringLiteral("Controller"),
    QStringLiteral("Heartbeat"),
    QStringLiteral("PDO"),
    QStringLiteral("Pre-operational"),
    QStringLiteral("Rate: %1 Bd"),
    QStringLiteral("Revision"),
    QStringLiteral("can.txt"),
};

void expectNoFaults(const std::vector<TsText> &texts, const QStringList &sameInBoth)
{
    for (const TsText &text : texts)
        for (const QString &fault : faultsOf(text, sameInBoth))
            ADD_FAILURE() << qPrintable(text.name()) << "\n  " << qPrintable(fault);
}

// The texts that lupdate finds in the sources. It complains about a text without a context.
std::vector<TsText> textsOfSources(const QStringList &options)
{
    const QTemporaryDir folder;
    const QString found = folder.filePath(QStringLiteral("found_de.ts"));
    QProcess lupdate;
    lupdate.setWorkingDirectory(sourceFolder);
    lupdate.start(QStringLiteral(CODEWHEEL_LUPDATE),
                  QStringList{QStringLiteral("-silent"), QStringLiteral("@translations/sources.lst")} +
                      options + QStringList{QStringLiteral("-ts"), found});
    EXPECT_TRUE(lupdate.waitForFinished(120'000)) << qPrintable(lupdate.errorString());
    EXPECT_EQ(lupdate.readAllStandardError().toStdString(), "");
    return readTs(found);
}

void expectAllOf(const std::vector<TsText> &sources, const QString &file)
{
    const QSet<QString> inSources = namesOf(sources);
    const QSet<QString> inFile = namesOf(readTs(file));
    for (const QString &name : inSources - inFile)
        ADD_FAILURE() << "not in " << qPrintable(file) << ":\n  " << qPrintable(name);
    for (const QString &name : inFile - inSources)
        ADD_FAILURE() << "no longer in the sources:\n  " << qPrintable(name);
}

TEST(TsFiles, GermanIsComplete)
{
    const std::vector<TsText> texts = readTs(germanFile);
    EXPECT_FALSE(texts.empty());
    expectNoFaults(texts, sameInGerman);
}

TEST(TsFiles, WhatIsTheSameInGermanIsStillThere)
{
    QSet<QString> same;
    for (const TsText &text : readTs(germanFile))
        if (text.translations.contains(text.source))
            same.insert(text.source);
    for (const QString &text : sameInGerman)
        EXPECT_TRUE(same.contains(text)) << qPrintable(text) << " needs no exception any more";
}

TEST(TsFiles, GermanHasTheTextsOfTheSources)
{
    expectAllOf(textsOfSources({}), germanFile);
}

TEST(TsFiles, EnglishHasASingularForEachNumber)
{
    const std::vector<TsText> texts = readTs(englishFile);
    QStringList same;
    for (const TsText &text : texts)
        same << text.source;
    expectNoFaults(texts, same);
    expectAllOf(textsOfSources({QStringLiteral("-pluralonly")}), englishFile);
}

} // namespace
} // namespace codewheel
