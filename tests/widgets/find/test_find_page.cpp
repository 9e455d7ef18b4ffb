// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/find/find_page.h"
#include "widgets/find/finder_news_model.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"

#include <QApplication>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

class FindPageTest : public testing::Test
{
protected:
    FindPageTest()
    {
        page.resize(800, 600);
        page.show();
        page.setPorts({{QStringLiteral("/dev/ttyUSB0"), QStringLiteral("FT232R"), {}},
                       {QStringLiteral("/dev/ttyUSB1"), {}, {}}},
                      {});
    }
    QPushButton &button(const QString &text)
    {
        for (auto *its : page.findChildren<QPushButton *>())
            if (plainLabel(its->text()) == text && its->isVisibleTo(&page))
                return *its;
        ADD_FAILURE() << text.toStdString();
        return *page.findChild<QPushButton *>();
    }
    static FinderNews found(bool isMasterAtWork)
    {
        return {FinderNews::Kind::found, QStringLiteral("/dev/ttyUSB0"), QStringLiteral("An encoder"),
                Found{.kind = QStringLiteral("esc"),
                      .place = QStringLiteral("/dev/ttyUSB0"),
                      .settings = QStringLiteral("9600 Bd, 8N2"),
                      .isMasterAtWork = isMasterAtWork}};
    }

    FindPage page;
};

TEST_F(FindPageTest, LooksAtTheTickedPortsAndTheHost)
{
    auto &ports = *page.findChild<QListWidget *>();
    ports.item(1)->setCheckState(Qt::Checked);
    QTest::keyClicks(page.findChild<QLineEdit *>(QStringLiteral("findHost")), QStringLiteral(" gateway "));
    FindWish wanted;
    QObject::connect(&page, &FindPage::searchWanted, &page, [&](const FindWish &wish) { wanted = wish; });
    QTest::mouseClick(&button(QStringLiteral("Search")), Qt::LeftButton);
    EXPECT_EQ(wanted, (FindWish{{QStringLiteral("/dev/ttyUSB1")}, QStringLiteral("gateway"), 502}));
    page.setPorts({{QStringLiteral("/dev/ttyUSB0"), {}, {}}}, {});
    EXPECT_EQ(ports.item(0)->checkState(), Qt::Unchecked) << "a new list leaves it out, too";
    EXPECT_TRUE(page.wish().ports.isEmpty());
}

// Of several nobody knows which one is meant.
TEST_F(FindPageTest, OnlyAPortOnItsOwnIsTickedOrOneThatWasPluggedInSince)
{
    EXPECT_TRUE(page.wish().ports.isEmpty());
    page.setPorts({{QStringLiteral("/dev/ttyUSB0"), QStringLiteral("FT232R"), {}},
                   {QStringLiteral("/dev/ttyUSB1"), {}, {}},
                   {QStringLiteral("/dev/ttyUSB2"), {}, {}}},
                  {});
    EXPECT_EQ(page.wish().ports, QStringList{QStringLiteral("/dev/ttyUSB2")});
    FindPage other;
    other.setPorts({{QStringLiteral("/dev/ttyS0"), {}, {}}}, {});
    EXPECT_EQ(other.wish().ports, QStringList{QStringLiteral("/dev/ttyS0")});
}

TEST_F(FindPageTest, ReturnSearchesAtAPortThatWasTyped)
{
    auto &field = *page.findChild<QLineEdit *>(QStringLiteral("findOtherPort"));
    std::vector<FindWish> wanted;
    QObject::connect(&page, &FindPage::searchWanted, &page,
                     [&](const FindWish &wish) { wanted.push_back(wish); });
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_Return);
    EXPECT_TRUE(wanted.empty()) << "there is no place yet";
    QTest::keyClicks(&field, QStringLiteral("/dev/pts/7"));
    QTest::keyClick(&field, Qt::Key_Return);
    ASSERT_EQ(wanted.size(), 1u);
    EXPECT_EQ(wanted[0].ports, QStringList{QStringLiteral("/dev/pts/7")});
}

TEST_F(FindPageTest, TabGoesFromThePlacesOverTheSearchToWhatWasFound)
{
    QWidget window;
    auto *before = new QPushButton(&window);
    page.setParent(&window);
    page.show();
    before->show();
    window.show();
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    page.begin();
    page.add(found(false));
    page.end();
    page.findChild<QListWidget *>()->item(0)->setCheckState(Qt::Checked);
    page.findChild<QListWidget *>()->setFocus();
    QStringList order;
    for (int i = 0; i < 7; ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        const auto *button = qobject_cast<QPushButton *>(QApplication::focusWidget());
        order << (button != nullptr ? plainLabel(button->text()) : QApplication::focusWidget()->objectName());
    }
    EXPECT_EQ(order, (QStringList{QStringLiteral("Refresh"), QStringLiteral("findOtherPort"),
                                  QStringLiteral("findHost"), QStringLiteral("findTcpPort"),
                                  QStringLiteral("Search"), QString(), QStringLiteral("Connect")}))
        << "the table has no name";
    page.setParent(nullptr);
}

TEST_F(FindPageTest, WithoutAPlaceThereIsNothingToSearch)
{
    page.setPorts({}, QStringLiteral("This computer has no serial port."));
    EXPECT_FALSE(button(QStringLiteral("Search")).isEnabled());
    QTest::keyClicks(page.findChild<QLineEdit *>(QStringLiteral("findHost")), QStringLiteral("gateway"));
    EXPECT_TRUE(button(QStringLiteral("Search")).isEnabled());
}

TEST_F(FindPageTest, AsksOnlyIfThatIsAgreedTo)
{
    const QSignalSpy agreed(&page, &FindPage::askAgreed);
    page.begin();
    page.end();
    page.ask({QStringLiteral("/dev/ttyUSB0")}, {QStringLiteral("ESC: all addresses.")});
    const auto messages = page.findChildren<InlineMessage *>();
    EXPECT_TRUE(std::ranges::any_of(messages, [](const InlineMessage *message) {
        return message->sentence().contains(u"Ask /dev/ttyUSB0? Only reads are sent.\nESC: all");
    }));
    EXPECT_EQ(agreed.count(), 0);
    QTest::mouseClick(&button(QStringLiteral("Ask")), Qt::LeftButton);
    EXPECT_EQ(agreed.count(), 1);
}

// It would send to a port that is no longer ticked.
TEST_F(FindPageTest, AQuestionAboutOtherPlacesIsWithdrawn)
{
    page.begin();
    page.end();
    const auto isAsking = [this] {
        return std::ranges::any_of(page.findChildren<QPushButton *>(), [this](const QPushButton *its) {
            return plainLabel(its->text()) == QStringLiteral("Ask") && its->isVisibleTo(&page);
        });
    };
    page.ask({QStringLiteral("/dev/ttyUSB0")}, {QStringLiteral("ESC: all addresses.")});
    EXPECT_TRUE(isAsking());
    page.findChild<QListWidget *>()->item(1)->setCheckState(Qt::Checked);
    EXPECT_FALSE(isAsking());
    page.ask({QStringLiteral("/dev/ttyUSB0")}, {QStringLiteral("ESC: all addresses.")});
    QTest::keyClicks(page.findChild<QLineEdit *>(QStringLiteral("findHost")), QStringLiteral("a"));
    EXPECT_FALSE(isAsking());
}

TEST_F(FindPageTest, ConnectsWithWhatWasFoundOnceTheSearchHasEnded)
{
    std::vector<Found> wanted;
    QObject::connect(&page, &FindPage::connectWanted, &page,
                     [&](const Found &one) { wanted.push_back(one); });
    page.begin();
    page.add({FinderNews::Kind::looking, QStringLiteral("/dev/ttyUSB0"), QStringLiteral("Asks.")});
    page.add(found(false));
    EXPECT_EQ(page.news().rowCount(), 1) << "what it does is no row";
    EXPECT_FALSE(button(QStringLiteral("Connect")).isEnabled());
    page.end();
    QTest::mouseClick(&button(QStringLiteral("Connect")), Qt::LeftButton);
    ASSERT_EQ(wanted.size(), 1U);
    EXPECT_EQ(wanted[0].settings, QStringLiteral("9600 Bd, 8N2"));
}

TEST_F(FindPageTest, HandsOverAllThatWereFoundByTheSameLink)
{
    const auto foundAt = [](const char *link, int who) {
        FinderNews news = found(false);
        news.found->link = QString::fromLatin1(link);
        news.found->device = KindData(who);
        return news;
    };
    std::vector<KindData> handed;
    QObject::connect(&page, &FindPage::connectWanted, &page,
                     [&](const Found &, const std::vector<KindData> &devices) { handed = devices; });
    page.begin();
    page.add(foundAt("esc:/dev/ttyUSB0,baud=9600", 3));
    page.add(foundAt("esc:/dev/ttyUSB1,baud=9600", 7));
    page.add(foundAt("esc:/dev/ttyUSB0,baud=9600", 5));
    page.end();
    QTest::mouseClick(&button(QStringLiteral("Connect")), Qt::LeftButton);
    EXPECT_EQ(handed, (std::vector{KindData(3), KindData(5)}));
}

TEST_F(FindPageTest, ANameStaysInItsLineWhateverIsInIt)
{
    page.begin();
    page.add({FinderNews::Kind::heard, QStringLiteral("/dev/a\nb"), QStringLiteral("The line is silent.")});
    const auto *table = page.findChild<QTableView *>();
    EXPECT_EQ(table->model()->index(0, 0).data().toString(), QStringLiteral("/dev/a\\u000Ab"));
}

TEST_F(FindPageTest, NobodyConnectsWhereAMasterWorks)
{
    page.begin();
    page.add(found(true));
    page.end();
    EXPECT_FALSE(button(QStringLiteral("Connect")).isEnabled());
}

} // namespace
} // namespace codewheel
