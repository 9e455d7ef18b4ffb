// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/protocol/esc_command.h"
#include "tests/support/model_tester.h"
#include "tests/widgets/kinds/esc/line/esc_line_bench.h"
#include "widgets/kinds/esc/line/command_list.h"
#include "widgets/kinds/esc/line/request_field.h"

#include <QAbstractItemView>
#include <QCompleter>

namespace codewheel {
namespace {

class RequestFieldTest : public testing::Test
{
protected:
    RequestFieldTest()
    {
        field.show();
        field.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&field));
    }
    void key(Qt::Key which, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QTest::keyClick(&field, which, modifiers);
    }
    QStringList offered() const
    {
        QStringList rows;
        const QAbstractItemModel &model = *field.completer()->completionModel();
        for (int row = 0; row < model.rowCount(); ++row)
            rows << model.index(row, CommandList::request).data().toString();
        return rows;
    }

    RequestField field;
};

TEST_F(RequestFieldTest, UpAndDownBringBackWhatWasTyped)
{
    field.setHistory({QStringLiteral("05P"), QStringLiteral("05N")});
    field.setText(QStringLiteral("03"));
    key(Qt::Key_Up);
    EXPECT_EQ(field.text(), QStringLiteral("05N"));
    key(Qt::Key_Up);
    key(Qt::Key_Up);
    EXPECT_EQ(field.text(), QStringLiteral("05P"));
    key(Qt::Key_Down);
    key(Qt::Key_Down);
    EXPECT_EQ(field.text(), QStringLiteral("03"));
}

TEST_F(RequestFieldTest, KeepsEachOnceTheNewestLast)
{
    for (const char *typed : {"05p", "05N", "05P "}) {
        field.setText(QLatin1String(typed));
        field.keep();
    }
    EXPECT_EQ(field.history(), (QStringList{QStringLiteral("05N"), QStringLiteral("05P")}));
    EXPECT_TRUE(field.text().isEmpty());
    QStringList many;
    for (int i = 0; i < 2 * RequestField::mostKept; ++i)
        many << QString::number(i);
    field.setHistory(many);
    EXPECT_EQ(field.history().size(), RequestField::mostKept);
    EXPECT_EQ(field.history().last(), many.last());
}

TEST_F(RequestFieldTest, OffersEveryCommandBehindTheAddress)
{
    QTest::keyClicks(&field, QStringLiteral("1f"));
    EXPECT_EQ(offered().size(), static_cast<qsizetype>(esc::allCommands().size()));
    EXPECT_TRUE(offered().contains(QLatin1String("1FGP")));
    QTest::keyClicks(&field, QStringLiteral("g"));
    EXPECT_EQ(offered().size(), 9);
    for (const QString &request : offered())
        EXPECT_TRUE(request.startsWith(QLatin1String("1FG"))) << request.toStdString();
    field.completer()->popup()->hide();
}

TEST_F(RequestFieldTest, CtrlSpaceListsAllCommands)
{
    key(Qt::Key_Space, Qt::ControlModifier);
    EXPECT_TRUE(field.completer()->popup()->isVisible());
    EXPECT_EQ(offered().size(), static_cast<qsizetype>(esc::allCommands().size()));
    field.completer()->popup()->hide();
}

// The same as for write and the terminal.
TEST(CommandList, SaysTheLimitsOfTheScalingFactorInTheFormatOfTheLine)
{
    CommandList list;
    const auto ofFactor = [&] {
        for (int row = 0; row < list.rowCount(); ++row)
            if (list.index(row, CommandList::request).data() == QStringLiteral("01GF"))
                return list.index(row, CommandList::meaning).data().toString().toStdString();
        return std::string();
    };
    EXPECT_NE(ofFactor().find("14F9h = 5369 to 20000000h = 536870912"), std::string::npos) << ofFactor();
    list.setFractionBits(30);
    EXPECT_NE(ofFactor().find("to 40000000h = 1073741824"), std::string::npos) << ofFactor();
}

TEST(CommandList, SaysWhatEachCommandDoes)
{
    CommandList list;
    const test::ModelTester tester(list);
    list.setAddress(QStringLiteral("05"));
    ASSERT_EQ(list.rowCount(), static_cast<int>(esc::allCommands().size()));
    QStringList meanings;
    for (int row = 0; row < list.rowCount(); ++row) {
        const QString meaning = list.index(row, CommandList::meaning).data().toString();
        EXPECT_FALSE(meaning.isEmpty());
        if (list.index(row, CommandList::request).data() == QStringLiteral("05X"))
            meanings << meaning;
    }
    ASSERT_EQ(meanings.size(), 1);
    EXPECT_TRUE(meanings.first().startsWith(QLatin1String("writes: "))) << meanings.first().toStdString();
    EXPECT_TRUE(meanings.first().contains(QLatin1String("1h = 1 to 1Fh = 31")));
}

} // namespace
} // namespace codewheel
