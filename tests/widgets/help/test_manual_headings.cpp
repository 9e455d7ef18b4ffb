// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/help/manual.h"
#include "widgets/help/manual_headings.h"

#include <gtest/gtest.h>
#include <map>

namespace codewheel {
namespace {

TEST(ManualHeadingsTest, AreThoseOfThePagesAsTheyAreRead)
{
    const Manual manual;
    std::map<QUrl, QString> expected;
    for (const ManualPage &page : manual.pages())
        for (const ManualSection &section : page.sections) {
            QUrl url = page.url;
            if (&section != &page.sections.front())
                url.setFragment(section.anchor);
            expected[url] = section.title;
        }
    std::map<QUrl, QString> found;
    for (const ManualHeading &heading : manualHeadings())
        found[Manual::url(heading.topic)] = heading.title;
    EXPECT_GT(found.size(), 150U);
    for (const auto &[url, title] : expected)
        EXPECT_EQ(found[url], title) << url.toString().toStdString();
    EXPECT_EQ(found.size(), expected.size());
}

} // namespace
} // namespace codewheel
