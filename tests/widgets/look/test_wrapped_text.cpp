// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/look/wrapped_text.h"

#include <QFontMetrics>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

const QString word = QStringLiteral("operatingparameters");

int widthOf(const QString &text)
{
    return QFontMetrics(QGuiApplication::font()).horizontalAdvance(text);
}

int heightOf(const QString &text, int width)
{
    return WrappedText(text, QGuiApplication::font(), width, Qt::AlignLeft).height();
}

// The columns of the picture with ink.
QRect inkOf(const QImage &picture)
{
    QRect ink;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (picture.pixelColor(x, y) != Qt::white)
                ink |= QRect(x, y, 1, 1);
    return ink;
}

TEST(WrappedText, StandsOnOneLineWhereThereIsRoom)
{
    EXPECT_EQ(heightOf(word, 2 * widthOf(word)), heightOf(QStringLiteral("o"), 2 * widthOf(word)));
}

TEST(WrappedText, BreaksBetweenWordsFirst)
{
    const QString two = word + u' ' + word;
    const int width = widthOf(word) + 4;
    const int twoLines = 2 * heightOf(word, width);
    EXPECT_EQ(heightOf(two, width), twoLines);
}

TEST(WrappedText, AShortParenthesisGoesToTheNextLineWhole)
{
    EXPECT_EQ(withWholeParentheses(QStringLiteral("8 192 (by hand)")),
              QStringLiteral("8 192 (by%1hand)").arg(QChar(QChar::Nbsp)));
    const QString longer = QStringLiteral("3 (unsigned, clockwise)");
    EXPECT_EQ(withWholeParentheses(longer), longer);
    const QString open = QStringLiteral("3 (by hand");
    EXPECT_EQ(withWholeParentheses(open), open);
}

TEST(WrappedText, AWordThatIsTooLongIsBrokenAndNothingIsCutOff)
{
    const int width = widthOf(word) / 3;
    const WrappedText text(word, QGuiApplication::font(), width, Qt::AlignRight);
    EXPECT_GE(text.height(), 3 * heightOf(QStringLiteral("o"), width));
    QImage picture(width + 80, text.height() + 80, QImage::Format_RGB32);
    picture.fill(Qt::white);
    const QRect where(40, 40, width, text.height());
    QPainter painter(&picture);
    text.draw(painter, where);
    painter.end();
    const QRect ink = inkOf(picture);
    EXPECT_FALSE(ink.isEmpty());
    EXPECT_TRUE(where.adjusted(-1, 0, 1, 0).contains(ink));
}

TEST(WrappedText, WithoutRoomIsDrawnAllTheSame)
{
    EXPECT_GT(heightOf(word, 0), 0);
    EXPECT_EQ(heightOf(QString(), -5), heightOf(QStringLiteral("o"), 100)) << "one line";
}

} // namespace
} // namespace codewheel
