// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/explain_word.h"
#include "tests/support/fraba_appendix.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

TEST(FrabaAppendix, EveryRowHasItsSentenceOutAndIn)
{
    const Catalog catalog = Catalog::builtIn();
    const DeviceDescription &fraba = *catalog.find(u"fraba-ocd-ib");
    const auto text = [&fraba](Word word, WordDirection direction, Mode mode, Word counterpart) {
        const Explanation explanation = explainWord(fraba, word, {direction, mode, {}, counterpart});
        return explanationText(fraba, explanation).toStdString();
    };
    for (const AppendixRow &row : frabaAppendix()) {
        EXPECT_EQ(text(row.out, WordDirection::out, row.mode, row.in), row.outText)
            << row.section << ' ' << row.name;
        EXPECT_EQ(text(row.in, WordDirection::in, row.mode, row.out), row.inText)
            << row.section << ' ' << row.name;
    }
}

} // namespace
} // namespace codewheel
