// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/explain_word.h"
#include "jobs/job_report.h"
#include "language.h"
#include "tests/translations/ts_file.h"
#include "vocabulary/refusal_text.h"

#include <QCoreApplication>
#include <QFile>
#include <QLibraryInfo>
#include <QLocale>
#include <QProcess>
#include <QProcessEnvironment>

#include <algorithm>
#include <cstdio>
#include <gtest/gtest.h>
#include <iterator>
#include <vector>

namespace codewheel {
namespace {

class LanguageTest : public testing::Test
{
protected:
    ~LanguageTest() override { QLocale::setDefault(QLocale::c()); }

    void use(const char *chosen) { m_language.use(QString::fromLatin1(chosen)); }
    std::string meaning(WordDirection direction, Word word) const
    {
        return explanationText(m_fraba,
                               explainWord(m_fraba, word, {.direction = direction, .mode = Mode::position}))
            .toStdString();
    }
    QString notes() const { return m_fraba.notesText(); }
    std::vector<Message> ofJobs() const
    {
        const ParameterValue steps{Parameter::steps, 7200};
        const ParameterValue direction{Parameter::direction, 3};
        const WriteParameters job{.values = {steps, direction}, .previous = {}};
        Outcome written;
        written.eepromWrites = 2;
        written.written = {steps, direction};
        Outcome restored;
        restored.eepromWrites = 3;
        restored.written = {steps};
        restored.restored = Evidence::read;
        restored.camsWritten = {{.number = 1}};
        std::vector<Message> messages = jobReport(job, written, m_fraba);
        std::ranges::copy(jobReport(job, restored, m_fraba), std::back_inserter(messages));
        std::ranges::copy(
            doubtReport(
                {.values = {steps}, .reset = true, .camPrograms = {2}, .out = {0x0200'1C20, 0x8000'0000}},
                m_fraba),
            std::back_inserter(messages));
        return messages;
    }

private:
    Language m_language;
    const Catalog m_catalog = Catalog::builtIn();
    const DeviceDescription &m_fraba = *m_catalog.find(u"fraba-ocd-ib");
};

std::string tooManyRevolutions()
{
    return refusalText({RefusalKind::badInput,
                        RefusalId::valueOutOfRange,
                        {Parameter::revolutions, std::int64_t{5000}, std::int64_t{1}, std::int64_t{4096}}})
        .toStdString();
}

std::string wordsTo(int count)
{
    return QCoreApplication::translate("codewheel::SequenceView", "%n words to %1", nullptr, count)
        .toStdString();
}

TEST_F(LanguageTest, GermanSaysWhatWordsMean)
{
    use("de");
    EXPECT_EQ(meaning(WordDirection::out, 0x0200'00FF), "Parameter 1 Schritte = 255");
    EXPECT_EQ(meaning(WordDirection::out, 0x0600'0003), "Parameter 3 Zählrichtung = 3 (CW)");
    EXPECT_EQ(meaning(WordDirection::out, 0x8000'0000), "Run (Start)");
    EXPECT_EQ(meaning(WordDirection::out, 0x0000'0000), "Normalbetrieb");
    EXPECT_EQ(meaning(WordDirection::in, 0x0001'2A4F), "In Betrieb, Position 76.367");
}

TEST_F(LanguageTest, GermanSaysWhyAndWhatToDo)
{
    use("de");
    EXPECT_EQ(tooManyRevolutions(),
              "Umdrehungen = 5.000 liegt außerhalb des Bereichs. Einen Wert von 1 bis 4.096 angeben.");
    EXPECT_EQ(refusalText({RefusalKind::busy, RefusalId::watchOnly, {QStringLiteral("1.0")}}).toStdString(),
              "Nichts an 1.0 gesendet: Das Programm beobachtet nur. Erst auf Bedienen umschalten.");
}

TEST_F(LanguageTest, GermanHasTheNotesOnDevices)
{
    use("de");
    EXPECT_TRUE(notes().contains(QStringLiteral("angenommen"))) << qPrintable(notes());
    use("en");
    EXPECT_TRUE(notes().contains(QStringLiteral("assumed"))) << qPrintable(notes());
}

// As stored messages are: made in one language, read in another.
TEST_F(LanguageTest, MessagesOfAnEnglishWindowAreReadInGerman)
{
    use("en");
    const std::vector<Message> messages = ofJobs();
    use("de");
    QStringList told;
    for (const Message &message : messages)
        told << messageText(message);
    EXPECT_EQ(told.join(u'\n').toStdString(),
              "Geschrieben und aktiv: Schritte = 7.200, Zählrichtung = cw (Parameter: 2, "
              "EEPROM-Schreibvorgänge: 2).\n"
              "Die vorigen Werte wurden wieder geschrieben und zurückgelesen: Schritte = 7.200, "
              "Nockenprogramm 1 (EEPROM-Schreibvorgänge: 3).\n"
              "Es ist nicht bekannt, ob der Geber dies hat: Schritte = 7.200, Werkseinstellungen, "
              "Nockenprogramm 2. Auslesen, um es zu wissen.\n"
              "In OUT steht vielleicht noch 02001C20 oder 80000000: Der Geber liefert dann "
              "womöglich keine Position. Zurückholen, sobald der Bus wieder läuft.");
}

TEST_F(LanguageTest, GermanIsBuiltIn)
{
    use("de");
    for (const TsText &text :
         readTs(QStringLiteral(CODEWHEEL_SOURCE_FOLDER "/translations/codewheel_de.ts"))) {
        const int one = text.hasNumber ? 1 : -1;
        const QString translation = QCoreApplication::translate(text.context.toUtf8(), text.source.toUtf8(),
                                                                text.comment.toUtf8(), one);
        QString expected = text.translations.front();
        if (text.hasNumber)
            expected.replace(QStringLiteral("%n"), QStringLiteral("1"))
                .replace(QStringLiteral("%Ln"), QStringLiteral("1"));
        EXPECT_EQ(translation.toStdString(), expected.toStdString()) << qPrintable(text.name());
    }
}

TEST_F(LanguageTest, CountsInBothLanguages)
{
    use("de");
    EXPECT_EQ(wordsTo(1), "1 Wort an %1");
    EXPECT_EQ(wordsTo(2), "2 Worte an %1");
    use("en");
    EXPECT_EQ(wordsTo(1), "1 word to %1");
    EXPECT_EQ(wordsTo(2), "2 words to %1");
}

TEST_F(LanguageTest, ComesBackToEnglish)
{
    use("de");
    use("en");
    EXPECT_EQ(meaning(WordDirection::in, 0x0001'2A4F), "Running, position 76,367");
    EXPECT_EQ(tooManyRevolutions(), "Revolutions = 5,000 is out of range. Give a value from 1 to 4,096.");
}

TEST_F(LanguageTest, LanguagesWithoutTranslationGetEnglishTextsAndTheirOwnNumbers)
{
    use("nl");
    EXPECT_EQ(meaning(WordDirection::in, 0x0001'2A4F), "Running, position 76.367");
    EXPECT_EQ(wordsTo(1), "1 word to %1");
}

struct SystemOf
{
    const char *language;
    const char *numbers;
    const char *shown;
};

class LanguageOfSystem : public testing::TestWithParam<SystemOf>
{};

// Started by the next test in a program of its own, which asks for its system's numbers once.
TEST(LanguageOfThisSystem, DISABLED_SaysItsNumbers)
{
    Language language;
    language.use({});
    std::puts(qPrintable(QStringLiteral("<%1 %2>").arg(QLocale().toString(12345), QLocale().toString(1.5))));
}

TEST_P(LanguageOfSystem, GermanTextsBringGermanNumbers)
{
    QProcessEnvironment system = QProcessEnvironment::systemEnvironment();
    system.remove(QStringLiteral("LC_ALL"));
    system.remove(QStringLiteral("LANGUAGE"));
    system.insert(QStringLiteral("LANG"), QString::fromLatin1(GetParam().language));
    system.insert(QStringLiteral("LC_NUMERIC"), QString::fromLatin1(GetParam().numbers));
    system.insert(QStringLiteral("GTEST_TOTAL_SHARDS"), QStringLiteral("1"));
    system.insert(QStringLiteral("GTEST_SHARD_INDEX"), QStringLiteral("0"));
    QProcess program;
    program.setProcessEnvironment(system);
    program.start(QCoreApplication::applicationFilePath(),
                  {QStringLiteral("--gtest_also_run_disabled_tests"),
                   QStringLiteral("--gtest_filter=LanguageOfThisSystem.*")});
    ASSERT_TRUE(program.waitForFinished());
    const QString said = QString::fromUtf8(program.readAllStandardOutput());
    EXPECT_TRUE(said.contains(QStringLiteral("<%1>").arg(QString::fromUtf8(GetParam().shown))))
        << said.toStdString();
}

INSTANTIATE_TEST_SUITE_P(Systems, LanguageOfSystem,
                         testing::Values(SystemOf{"de_DE.UTF-8", "de_DE.UTF-8", "12.345 1,5"},
                                         SystemOf{"de_DE.UTF-8", "C", "12.345 1,5"},
                                         SystemOf{"de_DE.UTF-8", "en_US.UTF-8", "12.345 1,5"},
                                         SystemOf{"de_CH.UTF-8", "de_CH.UTF-8", "12’345 1.5"},
                                         SystemOf{"en_US.UTF-8", "de_DE.UTF-8", "12.345 1,5"}));

TEST_F(LanguageTest, QtsOwnTextsAreInTheSameLanguage)
{
    const QString translations = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
    if (!QFile::exists(translations + QStringLiteral("/qtbase_de.qm")))
        GTEST_SKIP() << "the package qt6-translations-l10n is not installed";
    const auto cancel = [] { return QCoreApplication::translate("QPlatformTheme", "Cancel").toStdString(); };
    use("de");
    EXPECT_EQ(cancel(), "Abbrechen");
    use("nl"); // Qt would have it, but our texts are English
    EXPECT_EQ(cancel(), "Cancel");
}

} // namespace
} // namespace codewheel
