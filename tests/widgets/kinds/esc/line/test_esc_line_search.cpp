// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/model_tester.h"
#include "tests/widgets/kinds/esc/line/esc_line_bench.h"
#include "widgets/kinds/esc/line/esc_line_search.h"
#include "widgets/kinds/esc/line/found_encoder_model.h"
#include "widgets/look/inline_message.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QModelIndex>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>

#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

class EscLineSearchTest : public testing::Test
{
protected:
    EscLineSearchTest()
    {
        search.setLine(bench.line.get());
        search.resize(600, 500);
        search.show();
        QObject::connect(&search, &EscLineSearch::takeOverWanted, &search,
                         [this](const auto &encoders) { taken = encoders; });
    }
    QPushButton &button(const char *text) const { return *test::button(search, QLatin1String(text)); }
    QString cell(int row, int column) const { return model.index(row, column).data().toString(); }
    bool isSaid(const char *part) const
    {
        for (const auto *label : search.findChildren<QLabel *>())
            if (label->isVisible() && label->text().contains(QLatin1String(part)))
                return true;
        return false;
    }

    test::EscLineBench bench;
    EscLineSearch search;
    FoundEncoderModel &model = *search.findChild<FoundEncoderModel *>();
    const test::ModelTester tester{model};
    std::vector<FoundEncoder> taken;
};

TEST_F(EscLineSearchTest, NeedsALine)
{
    EXPECT_FALSE(button("Search").isEnabled());
    bench.open();
    EXPECT_TRUE(button("Search").isEnabled());
    EXPECT_FALSE(button("Cancel").isEnabled());
    EXPECT_FALSE(button("Take over").isEnabled());
}

TEST_F(EscLineSearchTest, WhatIsNoAddressIsSaidAndNothingIsSearched)
{
    bench.open();
    auto *first = search.findChild<QSpinBox *>();
    const int before = search.wish().first.value;
    first->selectAll();
    QTest::keyClicks(first, QStringLiteral("zz"));
    button("Search").click();
    EXPECT_FALSE(search.findChild<QProgressBar *>()->isVisible());
    EXPECT_TRUE(isSaid("\"zz\" is not an address")) << "not the first one";
    EXPECT_EQ(search.wish().first.value, before);
    first->selectAll();
    QTest::keyClicks(first, QStringLiteral("05"));
    button("Search").click();
    EXPECT_EQ(search.wish().first.value, 5);
    EXPECT_TRUE(search.findChild<QProgressBar *>()->isVisible());
}

TEST_F(EscLineSearchTest, ShowsWhatAnEncoderTellsOfItself)
{
    bench.open();
    button("Search").click();
    EXPECT_TRUE(search.findChild<QProgressBar *>()->isVisible());
    bench.pass(20'000);
    ASSERT_EQ(model.rowCount(), 1);
    EXPECT_EQ(cell(0, FoundEncoderModel::address), QStringLiteral("05h (5)"));
    EXPECT_EQ(cell(0, FoundEncoderModel::baudRate).remove(u','), QStringLiteral("19200"));
    EXPECT_EQ(cell(0, FoundEncoderModel::serialNumber), QStringLiteral("195939070 (BADCAFEh)"));
    EXPECT_EQ(cell(0, FoundEncoderModel::deviceCode), QStringLiteral("9000h"));
    EXPECT_EQ(cell(0, FoundEncoderModel::version), QStringLiteral("ENCODER V1.23"));
    EXPECT_FALSE(search.findChild<QProgressBar *>()->isVisible());
    button("Take over").click();
    ASSERT_EQ(taken.size(), 1U);
    EXPECT_EQ(taken.front().address, EscLineAddress{5});
    for (const QByteArray &sent : bench.link->sentTexts())
        EXPECT_FALSE(sent.mid(2).startsWith('G') || sent.mid(2).startsWith('X')) << sent.toStdString();
}

TEST_F(EscLineSearchTest, ProposesTheKindWhoseInterfaceAnEncoderTells)
{
    search.setDevices({{QStringLiteral("other"), QStringLiteral("Kübler RS-422")},
                       {QStringLiteral("told"), QStringLiteral("Kübler V1.23")}});
    QString kind;
    QObject::connect(&search, &EscLineSearch::takeOverWanted, &search,
                     [&kind](const auto &, const QString &key) { kind = key; });
    bench.open();
    button("Search").click();
    bench.pass(20'000); // it tells "ENCODER V1.23"
    button("Take over").click();
    EXPECT_EQ(kind, QStringLiteral("told"));
}

TEST_F(EscLineSearchTest, OnlyTickedEncodersAreTakenOver)
{
    bench.open();
    button("Search").click();
    bench.pass(20'000);
    const QModelIndex found = model.index(0, FoundEncoderModel::address);
    EXPECT_EQ(found.data(Qt::CheckStateRole), Qt::Checked);
    EXPECT_TRUE(model.setData(found, Qt::Unchecked, Qt::CheckStateRole));
    EXPECT_FALSE(button("Take over").isEnabled());
}

// Manual, "Masteraddress: 00"
TEST(FoundEncoderModel, WhatAnswersAtTheMasterAddressIsTakenOverWhereItIsAlone)
{
    FoundEncoderModel found;
    const test::ModelTester tester(found);
    FoundEncoder alone;
    alone.baudRate = 19'200;
    found.show({alone});
    const QModelIndex first = found.index(0, FoundEncoderModel::address);
    EXPECT_TRUE(found.flags(first) & Qt::ItemIsUserCheckable);
    EXPECT_EQ(first.data(Qt::CheckStateRole), Qt::Checked);
    ASSERT_EQ(found.chosen().size(), 1U);
    FoundEncoder other = alone;
    other.address = {5};
    found.show({alone, other});
    EXPECT_FALSE(found.flags(first) & Qt::ItemIsUserCheckable);
    ASSERT_EQ(found.chosen().size(), 1U);
    EXPECT_EQ(found.chosen().front().address, EscLineAddress{5});
}

TEST_F(EscLineSearchTest, SaysWhatToCheckWhenNobodyAnswers)
{
    bench.open();
    bench.link->answers.clear();
    button("Search").click();
    bench.pass(60'000);
    EXPECT_TRUE(isSaid("baud rate"));
    EXPECT_TRUE(isSaid("ST (pin 7)"));
}

TEST_F(EscLineSearchTest, CanBeCancelled)
{
    bench.open();
    bench.link->answers.clear();
    button("Search").click();
    bench.pass(500);
    const auto sent = bench.link->sent.size();
    button("Cancel").click();
    bench.pass(2'000);
    EXPECT_LE(bench.link->sent.size(), sent + 1);
    EXPECT_TRUE(isSaid("cancelled"));
    EXPECT_TRUE(button("Search").isEnabled());
}

TEST_F(EscLineSearchTest, AsksAsWished)
{
    const auto fields = search.findChildren<QSpinBox *>();
    ASSERT_EQ(fields.size(), 2);
    fields.at(0)->setValue(0x12);
    fields.at(1)->setValue(3);
    EXPECT_EQ(fields.at(0)->text(), QStringLiteral("12h (18)"));
    auto &rates = *search.findChild<QComboBox *>();
    rates.setCurrentIndex(rates.count() - 1);
    const ScanWish wish = search.wish();
    EXPECT_EQ(wish.first, EscLineAddress{3});
    EXPECT_EQ(wish.last, EscLineAddress{0x12});
    EXPECT_EQ(wish.baudRates, (std::vector{19'200, 9'600, 4'800}));
    EscLineSearch other;
    other.setSettings(wish);
    EXPECT_EQ(other.wish(), wish);
    other.setSettings({.baudRates = {38'400}});
    EXPECT_EQ(other.wish().baudRates, std::vector{38'400});
}

TEST_F(EscLineSearchTest, AnAddressIsTypedAsItStandsOnTheWire)
{
    auto &first = *search.findChildren<QSpinBox *>().at(0);
    search.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&search));
    first.setFocus();
    first.selectAll();
    QTest::keyClicks(&first, QStringLiteral("1f"));
    QTest::keyClick(&first, Qt::Key_Tab);
    EXPECT_EQ(first.value(), 31);
}

TEST_F(EscLineSearchTest, TheConditionOfTheMasterAddressIsSaid)
{
    EXPECT_FALSE(isSaid("single one"));
    search.findChild<QCheckBox *>()->click();
    EXPECT_TRUE(isSaid("single one"));
    EXPECT_TRUE(search.wish().throughMaster);
}

TEST_F(EscLineSearchTest, EveryButtonHasATooltip)
{
    test::expectAccessible(search);
}

} // namespace
} // namespace codewheel
