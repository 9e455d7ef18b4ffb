// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/line_at_port_test.h"
#include "tests/app/press_connect.h"
#include "widgets/find/find_page.h"
#include "widgets/find/finder_news_model.h"
#include "widgets/line/line_search.h"

namespace codewheel {
namespace {

class FinderInWindowTest : public test::LineAtPortTest
{
protected:
    FindPage &page() { return *window().findChild<FindPage *>(); }
    void lookAt(const QString &port)
    {
        actions().findEncoders->trigger();
        advance(50);
        ASSERT_TRUE(page().isVisible());
        page().setPorts({{port, {}, {}}}, {});
        click(page(), QStringLiteral("Search"));
        ASSERT_TRUE(comes([&] { return !page().isSearching(); }));
    }
};

TEST_F(FinderInWindowTest, AnEncoderIsFoundAndConnectedWithItsSettings)
{
    const QString port = startPeer(QStringLiteral("--addresses 05"));
    lookAt(port);
    EXPECT_EQ(page().news().rowCount(), 1) << "the line is silent";
    click(page(), QStringLiteral("Ask"));
    EXPECT_TRUE(page().isSearching());
    ASSERT_TRUE(comes([&] { return !page().isSearching(); }));
    click(page(), QStringLiteral("Connect"));
    EXPECT_NE(shown->line().training(), nullptr) << "only after asking";
    test::agreeToReplace(connection());
    ASSERT_TRUE(
        comes([&] { return shown->line().training() == nullptr && shown->line().session() != nullptr; }));
    EXPECT_EQ(line().linkName(), port);
    EXPECT_FALSE(line().isOperating());
    EXPECT_TRUE(window().findChild<LineSearch *>()->isVisible()) << "its encoders are taken over there";
}

TEST_F(FinderInWindowTest, ASearchCanBeCancelled)
{
    const QString port = startPeer(QStringLiteral("--addresses 05"));
    actions().findEncoders->trigger();
    page().setPorts({{port, {}, {}}}, {});
    click(page(), QStringLiteral("Search"));
    click(page(), QStringLiteral("Cancel"));
    ASSERT_TRUE(comes([&] { return !page().isSearching(); }));
    EXPECT_EQ(said(), QString()) << "nothing is asked after that";
}

} // namespace
} // namespace codewheel
