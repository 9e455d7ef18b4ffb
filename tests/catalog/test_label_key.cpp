// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/label_key.h"
#include "vocabulary/refusal_text.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace codewheel {
namespace {

using testing::Contains;
using testing::HasSubstr;

class LabelKey : public testing::Test
{
protected:
    struct Found
    {
        std::vector<std::string> keys;
        int turns = 0;
        int stepsPerTurn = 0;
    };

    Found find(const char *typed) const
    {
        const auto matches = findByLabel(m_catalog, QString::fromUtf8(typed));
        if (!matches) {
            ADD_FAILURE() << refusalText(matches.error()).toStdString();
            return {};
        }
        Found found{{}, matches->front().turns, matches->front().stepsPerTurn};
        for (const LabelMatch &match : *matches)
            found.keys.push_back(match.device->key.toStdString());
        return found;
    }

    std::string refusal(const char *typed) const
    {
        const auto matches = findByLabel(m_catalog, QString::fromUtf8(typed));
        if (matches) {
            ADD_FAILURE() << typed << " is taken for " << matches->front().device->key.toStdString();
            return {};
        }
        EXPECT_EQ(matches.error().kind, RefusalKind::badInput);
        EXPECT_EQ(matches.error().id, RefusalId::labelKeyNotUnderstood);
        return refusalText(matches.error()).toStdString();
    }

    const Catalog m_catalog = Catalog::builtIn();
};

// FRABA manual 8
TEST_F(LabelKey, OfFrabaTellsTurnsAndSteps)
{
    struct Row
    {
        const char *typed;
        int turns;
        int stepsPerTurn;
    };
    const Row rows[] = {
        {"OCD-IBA1B-1213-C100-PRI", 4096, 8192},     {"OCD-IBA1B-1212-S06S-PRI", 4096, 4096},
        {"OCD-IBA1B-0012-C100-PRI", 1, 4096},        {"OCD-IBA1B-0013-B150-PRI", 1, 8192},
        {"OCD-IBA1B-1213-C10C-PRI-123", 4096, 8192},
    };
    for (const Row &row : rows) {
        const Found found = find(row.typed);
        EXPECT_THAT(found.keys, Contains("fraba-ocd-ib")) << row.typed;
        EXPECT_EQ(found.turns, row.turns) << row.typed;
        EXPECT_EQ(found.stepsPerTurn, row.stepsPerTurn) << row.typed;
    }
}

TEST_F(LabelKey, MayBeTypedWithAnySeparatorsInEitherCase)
{
    for (const char *typed : {"ocd-iba1b-1213-c100-pri", "OCDIBA1B1213C100PRI",
                              " OCD -IB A1 B - 12 13 - C 10 0 - PRI ", "ocd.ib.a1.b.12.13.c.10.0.pri"})
        EXPECT_THAT(find(typed).keys, Contains("fraba-ocd-ib")) << typed;
}

TEST_F(LabelKey, TellsEachPart)
{
    const auto matches = findByLabel(m_catalog, QStringLiteral("GXP6W.0 10 A3 01"));
    ASSERT_TRUE(matches);
    const LabelReading &reading = matches->front().reading;
    ASSERT_EQ(reading.parts.size(), 5u);
    EXPECT_EQ(reading.parts[3].written, QStringLiteral("A3"));
    EXPECT_EQ(reading.parts[3].meaning.toString(), QStringLiteral("C-plug 2 x 9 pins, radial, 4 LEDs"));
    EXPECT_FALSE(reading.turns); // not part of this key
}

// Baumer manual 9.1
TEST_F(LabelKey, OfBaumerHasTurnsAndStepsOfTheDescription)
{
    for (const char *typed : {"GXP6W.0 10 A0 01", "GXP6W.B 20 20 01", "gxp6w0102001"}) {
        const Found found = find(typed);
        EXPECT_EQ(found.keys, std::vector<std::string>{"baumer-gxp6w"}) << typed;
        EXPECT_EQ(found.turns, 4096);
        EXPECT_EQ(found.stepsPerTurn, 8192);
    }
}

TEST_F(LabelKey, OfKueblerTellsTheInterface)
{
    for (const char *typed : {"8.5882.xx3x.3001", "8.5862.XX3X.3001", "8.9081.2A31.3001"})
        EXPECT_EQ(find(typed).keys, std::vector<std::string>{"kuebler-esc-rs485"}) << typed;
    EXPECT_EQ(find("8.5882.xx1x.1001").keys, std::vector<std::string>{"kuebler-esc-rs422"});
}

TEST_F(LabelKey, SaysWhichPartIsNotUnderstoodAndWhatMayStandThere)
{
    EXPECT_EQ(refusal("OCD-IBA1B-1413-C100-PRI"),
              "\"14\" in \"OCD-IBA1B-1413-C100-PRI\" is not understood. Allowed there: Bits for revolutions: "
              "00 (single-turn), 12 (multi-turn, 4096 turns).");
    EXPECT_THAT(refusal("OCD-IBA1B-12 14-C100-PRI"), HasSubstr("\"14\""));
    EXPECT_THAT(refusal("OCD-IBA1B-1213-C150-PRI"), HasSubstr("\"C15\"")) << "only for a hollow shaft";
    EXPECT_THAT(refusal("OCD-IBA1B-1213-B100-PRI"), HasSubstr("B15 (blind hollow shaft, 15 mm)"));
    EXPECT_THAT(refusal("GXP6W.0 30 A0 01"), HasSubstr("\"30\" in \"GXP6W.0 30 A0 01\""));
    EXPECT_THAT(refusal("GXP6W.0 10 A0 02"), HasSubstr("Software: 01 (profile K3)"));
    EXPECT_THAT(refusal("8.5883.xx3x.3001"), HasSubstr("\"5883\""));
    // The interface of one with the protocol of the other.
    EXPECT_THAT(refusal("8.5882.xx3x.1001"), HasSubstr("\"1001\""));
}

TEST_F(LabelKey, SaysWhereItEndsTooEarlyOrTooLate)
{
    EXPECT_EQ(refusal("GXP6W.0 10"),
              "\"GXP6W.0 10\" ends too early. What may follow: Connection: A0 (C-plug 2 x 9 pins, axial), A1 "
              "(C-plug 2 x 9 pins, radial), A2 (C-plug 2 x 9 pins, axial, 4 LEDs), A3 (C-plug 2 x 9 pins, "
              "radial, 4 LEDs), 20 (bus cover, 2 LEDs).");
    EXPECT_EQ(refusal("GXP6W.0 10 A0 01 77"),
              "\"77\" in \"GXP6W.0 10 A0 01 77\" is too much: the key ends before it. Leave it out.");
    EXPECT_THAT(refusal(""), HasSubstr("ends too early"));
    EXPECT_THAT(refusal("---"), HasSubstr("OCD"));
    EXPECT_THAT(refusal("8.5882.x"), HasSubstr("any letters or digits, 2 in all"));
}

TEST_F(LabelKey, OfNobodyNamesAllThatMayStandFirst)
{
    const std::string text = refusal("XYZ-17");
    EXPECT_THAT(text, HasSubstr("OCD"));
    EXPECT_THAT(text, HasSubstr("GXP6W"));
    EXPECT_THAT(text, HasSubstr("Series: 8"));
}

// Whatever is typed: either a match or a sentence.
TEST_F(LabelKey, SurvivesEveryBeginningAndEveryOtherLetter)
{
    for (const DeviceDescription &device : m_catalog.devices()) {
        if (!device.orderingKey)
            continue;
        const QString whole = device.orderingKey->example;
        EXPECT_TRUE(findByLabel(m_catalog, whole)) << qPrintable(whole);
        for (qsizetype size = 0; size < whole.size(); ++size) {
            const auto matches = findByLabel(m_catalog, whole.first(size));
            EXPECT_TRUE(matches || !refusalText(matches.error()).contains(u'%'));
        }
        for (qsizetype i = 0; i < whole.size(); ++i) {
            QString other = whole;
            other[i] = u'\u00DF';
            const auto matches = findByLabel(m_catalog, other);
            if (!matches) {
                EXPECT_EQ(std::get<QString>(matches.error().arguments.front()), other);
            }
        }
    }
}

} // namespace
} // namespace codewheel
