// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/explain_word.h"
#include "kinds/interbus/words/k3_word.h"
#include "tests/support/word_source.h"

#include <QRegularExpression>

#include <gtest/gtest.h>

// Whatever the device, the direction and the context: a word has a meaning, and there is a sentence for it.
namespace codewheel {
namespace {

// Iterates over the contexts: each mode and each coding, known and unknown, with many words of the other
// direction.
class Contexts
{
public:
    explicit Contexts(WordDirection direction)
        : m_direction(direction)
    {}

    WordContext next()
    {
        WordContext context{m_direction, {}, {}, {}};
        if (const int mode = m_source.below(4); mode < 3)
            context.mode = static_cast<Mode>(mode);
        if (const int coding = m_source.below(4); coding < 3)
            context.coding = static_cast<PositionCoding>(coding);
        if (m_source.below(3) > 0)
            context.counterpart = m_source.next();
        return context;
    }
    Word word() { return m_source.next(); }

private:
    WordDirection m_direction;
    WordSource m_source;
};

class ExplainTotal : public testing::Test
{
protected:
    template <typename Check>
    void forEachDeviceAndDirection(int randomWords, int timesEachCorner, Check check)
    {
        const std::vector<Word> corners = cornerWords();
        for (const DeviceDescription &device : m_catalog.devices())
            for (const WordDirection direction : {WordDirection::in, WordDirection::out}) {
                SCOPED_TRACE(device.key.toStdString());
                Contexts contexts(direction);
                for (const Word word : corners)
                    for (int i = 0; i < timesEachCorner; ++i)
                        check(device, word, contexts.next());
                for (int i = 0; i < randomWords; ++i)
                    check(device, contexts.word(), contexts.next());
            }
    }

private:
    const Catalog m_catalog = Catalog::builtIn();
};

TEST_F(ExplainTotal, EveryWordMeansSomethingAndAlwaysTheSame)
{
    forEachDeviceAndDirection(
        100'000, 16, [](const DeviceDescription &device, Word word, const WordContext &context) {
            const Explanation explanation = explainWord(device, word, context);
            ASSERT_GE(explanation.size(), 1u) << std::hex << word;
            ASSERT_EQ(explanation, explainWord(device, word, context)) << std::hex << word;
        });
}

TEST_F(ExplainTotal, EveryWordHasASentence)
{
    static const QRegularExpression unfinished(QStringLiteral("%[1-9]|\\?|  |^ | $"));
    forEachDeviceAndDirection(
        10'000, 1, [](const DeviceDescription &device, Word word, const WordContext &context) {
            const QString sentence = explanationText(device, explainWord(device, word, context));
            ASSERT_FALSE(sentence.isEmpty()) << std::hex << word;
            ASSERT_TRUE(sentence.front().isUpper()) << sentence.toStdString();
            ASSERT_FALSE(sentence.contains(unfinished)) << sentence.toStdString();
        });
}

} // namespace
} // namespace codewheel
