// SPDX-License-Identifier: GPL-3.0-or-later
// The rules find what they are meant to find.
#include "tests/translations/translation_rules.h"

#include <QBuffer>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TsText read(QByteArray message)
{
    message = "<TS version=\"2.1\"><context><name>Place</name>" + message + "</context></TS>";
    QBuffer buffer(&message);
    buffer.open(QIODevice::ReadOnly);
    const std::vector<TsText> texts = readTs(buffer);
    EXPECT_EQ(texts.size(), 1);
    return texts.empty() ? TsText() : texts.front();
}

struct Row
{
    const char *message;
    const char *fault;
};

constexpr Row rows[] = {
    {"<message><source>Word</source><translation type=\"unfinished\">Wort</translation></message>",
     "is not finished"},
    {"<message><source>Word</source><translation></translation></message>", "is empty"},
    {"<message><source>Word %1</source><translation>Word %1</translation></message>", "is still English"},
    {"<message><source>Word %1</source><translation>Wort</translation></message>",
     "has other placeholders: Wort"},
    {"<message><source>Word</source><translation>Wort %L1</translation></message>",
     "has other placeholders: Wort %L1"},
    {"<message><source>&amp;Word</source><translation>Wort</translation></message>",
     "has a key (&) in one language only: Wort"},
    {"<message><source> or </source><translation>oder</translation></message>",
     "begins or ends with a space in one language only: oder"},
    {"<message numerus=\"yes\"><source>%n words</source><translation><numerusform>%n Worte</numerusform>"
     "</translation></message>",
     "has 1 forms"},
};

TEST(TranslationRules, FindEachFault)
{
    for (const Row &row : rows)
        EXPECT_EQ(faultsOf(read(row.message), {}), QStringList{QString::fromLatin1(row.fault)})
            << row.message;
}

TEST(TranslationRules, LetGoodTranslationsPass)
{
    const QStringList sameInBoth{QStringLiteral("Monitor %1")};
    for (const char *message : {
             "<message><source>%1 of %2 &amp;steps</source><translation>&amp;Schritte %2 von %1</translation>"
             "</message>",
             "<message><source>%1 = %2</source><translation>%1 = %2</translation></message>",
             "<message><source>Monitor %1</source><translation>Monitor %1</translation></message>",
             "<message numerus=\"yes\"><source>%n words</source><translation>"
             "<numerusform>%n Wort</numerusform><numerusform>%n Worte</numerusform></translation></message>",
         })
        EXPECT_EQ(faultsOf(read(message), sameInBoth), QStringList()) << message;
}

} // namespace
} // namespace codewheel
