// SPDX-License-Identifier: GPL-3.0-or-later
// The monitors that one works with at a time are seen whole, without scrolling.
#include "app/window/look/bottom_fold.h"
#include "language.h"
#include "tests/app/window_test.h"
#include "tests/support/painted_texts.h"
#include "widgets/monitor/meaning_line.h"
#include "widgets/monitor/word_line.h"

#include <QAction>
#include <QLocale>
#include <QScrollArea>
#include <QScrollBar>

namespace codewheel {
namespace {

constexpr int rowHigh = 210; // of a card with its bits in a row
constexpr int twoRowsHigh = 280;
constexpr int rowWide = 660;

class CardRoom : public test::WindowTest, public testing::WithParamInterface<const char *>
{
protected:
    CardRoom()
    {
        language.use(QString::fromLatin1(GetParam()));
        open(); // in this language
    }
    ~CardRoom() override { QLocale::setDefault(QLocale::c()); }

    void expectWhole(std::size_t cards)
    {
        advance(100);
        ASSERT_EQ(monitors().cards().size(), cards);
        for (const WordCard *card : monitors().cards()) {
            EXPECT_LE(card->height(), card->width() >= rowWide ? rowHigh : twoRowsHigh) << card->width();
            EXPECT_EQ(card->visibleRegion().boundingRect(), card->rect())
                << card->place().shown().toStdString();
        }
        EXPECT_EQ(monitors().findChild<QScrollArea *>()->verticalScrollBar()->maximum(), 0);
    }
    const MeaningLine &meaning(Place place)
    {
        return *monitors().card(place)->line(WordDirection::in)->findChild<MeaningLine *>();
    }

private:
    Language language;
};

TEST_P(CardRoom, HoldsTwoInTheUsualWindowWithTheBottomFolded)
{
    resizeTo({1280, 800});
    monitors().pin(test::baumer);
    window().findChild<BottomFold *>()->fold();
    expectWhole(2);
}

TEST_P(CardRoom, HoldsOneInTheSmallestWindowWithTheBottomOpen)
{
    resizeTo({960, 600});
    monitors().pin(test::fraba);
    expectWhole(1);
    resizeTo({1024, 640});
    expectWhole(1);
    EXPECT_GE(monitors().cards().front()->width(), rowWide);
}

TEST_P(CardRoom, WhyAWordIsOldIsReadOnTheCardWhichStaysAsItIs)
{
    resizeTo({960, 600});
    const int before = monitors().card(test::fraba)->height();
    actions().stop->trigger();
    advance(100);
    const MeaningLine &line = meaning(test::fraba);
    const QString why = line.text().section(QLatin1String(": "), 0, 0);
    EXPECT_TRUE(why.startsWith(QLatin1String(GetParam()) == QLatin1String("de")
                                   ? QStringLiteral("Bus angehalten, ")
                                   : QStringLiteral("Bus stopped, ")))
        << why.toStdString();
    EXPECT_LT(line.fontMetrics().horizontalAdvance(why), line.width()) << why.toStdString();
    EXPECT_EQ(monitors().card(test::fraba)->height(), before);
}

TEST(MeaningLineTest, IsNeverCutOffWithinANumber)
{
    const QString text = QStringLiteral("Not on the bus: Running, position 7,967,178");
    MeaningLine line(nullptr, Qt::AlignLeft);
    line.setText(text);
    const int needed = line.fontMetrics().horizontalAdvance(text);
    line.resize(needed, 20);
    EXPECT_EQ(test::paintedTexts(line).front().text, text);
    for (const int missing : {1, 20, 40}) {
        line.resize(needed - missing, 20);
        EXPECT_EQ(test::paintedTexts(line).front().text.toStdString(), "Not on the bus: Running, position…")
            << missing;
    }
}

INSTANTIATE_TEST_SUITE_P(Languages, CardRoom, testing::Values("en", "de"),
                         [](const auto &tested) { return std::string(tested.param); });

} // namespace
} // namespace codewheel
