// SPDX-License-Identifier: GPL-3.0-or-later
// The example of FRABA manual 5.3 word by word, with mouse and keys, in the smallest window, from the first
// start: everything to click is visible without scrolling, and no click is superfluous.
#include "language.h"
#include "tests/app/window_test.h"
#include "widgets/monitor/word_card.h"
#include "widgets/monitor/word_field.h"
#include "widgets/monitor/word_view.h"
#include "widgets/structure/structure_view.h"

#include <QLocale>
#include <QPushButton>
#include <QTest>
#include <QTreeView>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::fraba;

class WordsByHand : public test::WindowTest, public testing::WithParamInterface<const char *>
{
protected:
    WordsByHand()
    {
        language.use(QString::fromLatin1(GetParam()));
        open();
        window().resize(1024, 640);
        actions().defaultLayout->trigger(); // the one for a low window
        window().resize(1024, 640);
        advance(50);
    }
    ~WordsByHand() override { QLocale::setDefault(QLocale::c()); }

    const WordCard &card() { return *monitors().cards().front(); }
    void click(QWidget &widget, QRect part)
    {
        ASSERT_TRUE(widget.isVisible());
        ASSERT_EQ(widget.visibleRegion().intersected(part), QRegion(part)) << "it is not in sight";
        QTest::mouseClick(&widget, Qt::LeftButton, {}, part.center());
        ++clicks;
        advance(5);
    }
    void clickDevice(Place place)
    {
        auto &tree = *window().findChild<StructureView *>()->findChild<QTreeView *>();
        const QAbstractItemModel &model = *tree.model();
        const QModelIndex ring = model.index(0, 0);
        for (int row = 0; row < model.rowCount(ring); ++row) {
            const QModelIndex device = model.index(row, 0, ring);
            if (device.data().toString().startsWith(place.toString())) {
                click(*tree.viewport(), tree.visualRect(device));
                return;
            }
        }
        FAIL() << "no row";
    }
    void clickBit(int bit)
    {
        auto &bits = *card().findChild<WordView *>();
        click(bits, bits.bitRect({0, bit}));
    }
    void clickWrite()
    {
        for (auto *button : card().findChildren<QPushButton *>())
            if (button->accessibleName().startsWith(QStringLiteral("Write")) ||
                button->accessibleName().startsWith(QStringLiteral("Schreiben"))) {
                click(*button, button->rect());
                return;
            }
        FAIL() << "no Write";
    }
    void typeWord(const char *word)
    {
        auto &hex = *card().line(WordDirection::out)->findChild<WordField *>();
        if (!hex.hasFocus())
            click(hex, hex.rect());
        QTest::keyClicks(&hex, QString::fromLatin1(word));
        QTest::keyClick(&hex, Qt::Key_Return, Qt::ControlModifier);
        advance(20);
    }

    Language language;
    int clicks = 0;
};

TEST_P(WordsByHand, TheExampleOfTheManualTakesTwelveClicks)
{
    clickDevice("2.0"_ring);
    EXPECT_EQ(card().place(), "2.0"_ring);
    clicks = 0;
    clickDevice(fraba);
    ASSERT_EQ(card().place(), fraba);
    for (const int bit : {25, 7, 6, 5, 4, 3, 2, 1, 0})
        clickBit(bit);
    EXPECT_EQ(out(fraba), 0U) << "nothing is sent before Write";
    clickWrite();
    advance(20);
    EXPECT_EQ(out(fraba), 0x0200'00FFU);
    EXPECT_EQ(in(fraba), 0xC200'00FFU);
    const std::pair<const char *, Word> answers[] = {
        {"04000001", 0xC400'0001}, {"06000003", 0xC600'0003}, {"08000000", 0xC800'0000}};
    for (const auto &[word, answer] : answers) {
        typeWord(word);
        EXPECT_EQ(in(fraba), answer) << word;
    }
    typeWord("80000000");
    EXPECT_EQ(bus().encoder(fraba)->latest().state, EncoderState::operation);
    typeWord("00000000");
    EXPECT_EQ(out(fraba), 0U);
    EXPECT_EQ(in(fraba), 12345U * 255 / 8192) << "the position in the new scale";
    EXPECT_EQ(clicks, 1 + 9 + 1 + 1) << "device, bits, Write, and the field for the other words";
}

INSTANTIATE_TEST_SUITE_P(Language, WordsByHand, testing::Values("en", "de"),
                         [](const auto &tested) { return std::string(tested.param); });

} // namespace
} // namespace codewheel
