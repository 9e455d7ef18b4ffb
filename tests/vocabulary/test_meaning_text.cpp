// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/meaning_text.h"

#include <QRegularExpression>
#include <QSet>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(MeaningText, EveryMeaningHasAKeyOfItsOwn)
{
    static const QRegularExpression camelCase(QStringLiteral("^[a-z][A-Za-z0-9]*$"));
    QSet<QString> keys;
    for (int i = 0; i < meaningCount; ++i) {
        keys << meaningKey(static_cast<MeaningId>(i));
        EXPECT_TRUE(camelCase.match(meaningKey(static_cast<MeaningId>(i))).hasMatch()) << i;
    }
    EXPECT_EQ(keys.size(), meaningCount);
    EXPECT_EQ(meaningKey(MeaningId::parameterRequest), QStringLiteral("parameterRequest"));
    EXPECT_EQ(meaningKey(MeaningId::undefinedIn), QStringLiteral("undefinedIn"));
}

TEST(MeaningText, EveryMeaningHasASentenceEvenWithoutItsParts)
{
    static const QRegularExpression place(QStringLiteral("%[1-9]"));
    for (int i = 0; i < meaningCount; ++i) {
        const QString sentence = meaningSentence(static_cast<MeaningId>(i), {});
        EXPECT_FALSE(sentence.isEmpty()) << i;
        EXPECT_FALSE(sentence.contains(place)) << sentence.toStdString();
    }
}

} // namespace
} // namespace codewheel
