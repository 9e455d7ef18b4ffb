// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/kinds/canopen/bus/canopen_plant.h"
#include "widgets/kinds/canopen/can_search_page.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"

#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using namespace std::chrono_literals;

class CanSearchPageTest : public test::CanopenPlant
{
protected:
    CanSearchPageTest()
    {
        page.setBus(bus.get());
        page.show();
        QObject::connect(&page, &CanSearchPage::takeOverWanted, &page,
                         [this](const std::vector<CanFoundRow> &found) { taken = found; });
    }
    ~CanSearchPageTest() override { page.setBus(nullptr); }

    QPushButton &button(const char *key) { return *page.findChild<QPushButton *>(QString::fromLatin1(key)); }
    InlineMessage &message() { return *page.findChild<InlineMessage *>(); }
    QTableView &table() { return *page.findChild<QTableView *>(); }
    void press(QPushButton &pressed)
    {
        ASSERT_TRUE(pressed.isEnabled());
        QTest::mouseClick(&pressed, Qt::LeftButton);
    }
    void agree()
    {
        for (auto *each : message().findChildren<QPushButton *>())
            if (plainLabel(each->text()) == QStringLiteral("Ask now")) {
                QTest::qWait(400); // a question takes no click at once
                press(*each);
                return;
            }
        ADD_FAILURE();
    }
    void search()
    {
        press(button("canSearch"));
        agree();
        bus->advance(20s);
    }

    std::vector<CanFoundRow> taken;
    CanSearchPage page;
};

TEST_F(CanSearchPageTest, InWatchItSaysThatItWouldSend)
{
    open(EncoderBus::Start::watching);
    bus->advance(100ms);
    press(button("canSearch"));
    EXPECT_TRUE(message().sentence().contains(QStringLiteral("Switch to Operate first")));
    bus->advance(1s);
    EXPECT_TRUE(link->sent.empty());
}

TEST_F(CanSearchPageTest, NothingIsAskedBeforeTheQuestionIsAnswered)
{
    open(EncoderBus::Start::operating);
    bus->advance(100ms);
    press(button("canSearch"));
    EXPECT_TRUE(message().sentence().contains(QStringLiteral("1 to 127")));
    bus->advance(500ms);
    EXPECT_FALSE(bus->latest().scanning);
    EXPECT_EQ(sentTo(0x600 + 99), 0);
    agree();
    bus->advance(100ms);
    EXPECT_TRUE(bus->latest().scanning);
    bus->advance(20s);
    EXPECT_GT(sentTo(0x600 + 99), 0);
}

TEST_F(CanSearchPageTest, ListsWhoAnswersAndHandsOverTheTickedThatAreNew)
{
    operate();
    search();
    ASSERT_EQ(table().model()->rowCount(), 3);
    const auto cell = [this](int row, int column) {
        return table().model()->index(row, column).data().toString();
    };
    EXPECT_EQ(cell(2, CanFoundModel::node), QStringLiteral("7 (07h)"));
    EXPECT_EQ(cell(2, CanFoundModel::vendor), QStringLiteral("10Dh"));
    EXPECT_TRUE(cell(0, CanFoundModel::device).contains(QStringLiteral("on this bus already")));
    EXPECT_FALSE(table().model()->index(0, 0).data(Qt::CheckStateRole).isValid());
    press(button("canTake"));
    ASSERT_EQ(taken.size(), 1U);
    EXPECT_EQ(taken.front().found.node, 7);
    EXPECT_EQ(taken.front().deviceKey, QStringLiteral("canopen-406-linear"));
    table().model()->setData(table().model()->index(2, 0), Qt::Unchecked, Qt::CheckStateRole);
    EXPECT_FALSE(button("canTake").isEnabled());
    page.setBus(bus.get()); // connected anew
    const auto texts = page.findChildren<QLabel *>();
    EXPECT_TRUE(std::ranges::any_of(
        texts, [](const QLabel *each) { return each->text() == QStringLiteral("No search yet"); }));
}

TEST_F(CanSearchPageTest, ASearchThatIsCancelledSaysSo)
{
    operate();
    press(button("canSearch"));
    agree();
    bus->advance(100ms);
    press(button("canCancel"));
    bus->advance(100ms);
    EXPECT_FALSE(bus->latest().scanning);
    EXPECT_TRUE(button("canSearch").isEnabled());
    EXPECT_TRUE(message().sentence().contains(QStringLiteral("cancelled")) ||
                table().model()->rowCount() == 0);
}

} // namespace
} // namespace codewheel
