// SPDX-License-Identifier: GPL-3.0-or-later
// Which adapter is opened and kept, with a list of ports given by the test: pseudo terminals that stand in
// for adapters.
#include "tests/app/kinds/esc/esc_line_at_port_test.h"
#include "tests/app/press_connect.h"
#include "tests/support/plans.h"
#include "tests/support/pty_pair.h"
#include "widgets/look/inline_message.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QFile>
#include <QPushButton>
#include <QTest>

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

namespace codewheel {
namespace {

class EscLineAdapterTest : public test::EscLineAtPortTest
{
protected:
    EscLineAdapterTest()
    {
        shown->line().setPortList([this] {
            const std::scoped_lock lock(m_mutex); // the line's thread looks too
            return m_present;
        });
    }
    ~EscLineAdapterTest() override { shown->line().close(); }

    static PortInfo adapter(const PtyPair &at, const QString &serialNumber,
                            const QString &usbPath = QStringLiteral("1-2:1.0"))
    {
        return {.path = at.path(),
                .description = QStringLiteral("FT232R USB UART"),
                .serialNumber = serialNumber,
                .usbPath = usbPath,
                .vendor = 0x0403,
                .product = 0x6001};
    }
    void plugIn(const std::vector<PortInfo> &present)
    {
        const std::scoped_lock lock(m_mutex);
        m_present = present;
    }
    // The project was last connected through adapter A at this port.
    void planAt(const PtyPair &port)
    {
        EscLinePlan kept;
        kept.settings.port = port.path();
        kept.adapter = {0x0403, 0x6001, QStringLiteral("A"), QStringLiteral("1-2:1.0")};
        plan(kept);
    }
    void showForm() { lineActions().settings->trigger(); }
    // As the user chooses it in the open list.
    void pickFirst()
    {
        auto &list = *form().findChild<PortField *>()->findChild<QComboBox *>();
        list.showPopup();
        QTest::keyClick(list.view(), Qt::Key_Home);
        QTest::keyClick(list.view(), Qt::Key_Return);
        advance(5);
    }
    QString keptSerialNumber() { return linePlan(project(), firstLine)->adapter.serialNumber; }

    PtyPair first;
    PtyPair second;

private:
    std::mutex m_mutex;
    std::vector<PortInfo> m_present;
};

TEST_F(EscLineAdapterTest, TheOneThatWasOpenedIsKept)
{
    planAt(first);
    plugIn({adapter(first, QStringLiteral("B")), adapter(second, QStringLiteral("A"))});
    showForm();
    connectNow();
    EXPECT_EQ(line().linkName(), second.path()) << "A is there now";
    EXPECT_EQ(keptSerialNumber(), QStringLiteral("A"));
    EXPECT_EQ(linePlan(project(), firstLine)->settings.port, second.path());
    EXPECT_EQ(form().settings().port, second.path());
}

TEST_F(EscLineAdapterTest, WhatIsPickedInTheListIsMeant)
{
    planAt(first);
    plugIn({adapter(first, QStringLiteral("B")), adapter(second, QStringLiteral("A"))});
    showForm();
    pickFirst();
    connectNow();
    EXPECT_EQ(line().linkName(), first.path());
    EXPECT_EQ(keptSerialNumber(), QStringLiteral("B"));
}

// A port opens as slowly as its adapter: until then the previous line goes on, and the user can leave it.
TEST_F(EscLineAdapterTest, TheWindowDoesNotWaitForThePort)
{
    showForm();
    typePort(first.path());
    const EscLineSession *before = shown->line().session();
    const auto buttons = connection().findChildren<QPushButton *>();
    const auto button = std::ranges::find(buttons, QStringLiteral("&Connect"), &QPushButton::text);
    ASSERT_NE(button, buttons.end());
    test::pressConnect(connection()); // no events are processed meanwhile
    EXPECT_TRUE(shown->line().isOpening());
    EXPECT_EQ(shown->line().session(), before);
    EXPECT_EQ((*button)->text(), QStringLiteral("Connecting…"));
    EXPECT_FALSE((*button)->isEnabled());
    lineActions().disconnectBus->trigger();
    EXPECT_FALSE(shown->line().isOpening());
    EXPECT_EQ(shown->line().session(), nullptr);
    QTest::qWait(50);
    EXPECT_EQ(shown->line().session(), nullptr) << "it comes to nothing any more";

    typePort(first.path());
    connectNow();
    EXPECT_EQ(line().linkName(), first.path());
}

TEST_F(EscLineAdapterTest, ThePortTypedAnewIsMeant)
{
    planAt(first);
    plugIn({adapter(first, QStringLiteral("B"))});
    connectPort(first.path());
    ASSERT_EQ(shown->line().training(), nullptr);
    EXPECT_EQ(keptSerialNumber(), QStringLiteral("B"));
}

TEST_F(EscLineAdapterTest, AnotherAdapterIsUsedWhereTheUserSaysSo)
{
    planAt(first);
    plugIn({adapter(first, QStringLiteral("B"))});
    showForm();
    connectNow();
    EXPECT_EQ(shown->line().session(), nullptr) << "unasked none is used";
    EXPECT_TRUE(said().contains(QStringLiteral("another adapter"))) << said().toStdString();
    click(connection(), QStringLiteral("Use this adapter"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return shown->line().session() != nullptr; }));
    EXPECT_EQ(line().linkName(), first.path());
    EXPECT_EQ(keptSerialNumber(), QStringLiteral("B"));
    EXPECT_EQ(said(), QString());

    connectNow();
    EXPECT_EQ(line().linkName(), first.path()) << "it is the line's now";
}

// Without a serial number, it cannot be told from another adapter of its model in a different place.
TEST_F(EscLineAdapterTest, WhatReplacesAnUnpluggedOneIsKeptToo)
{
    plan(EscLinePlan());
    plugIn({adapter(first, {})});
    connectPort(first.path());
    ASSERT_EQ(line().linkName(), first.path());
    first.unplug();
    plugIn({adapter(second, {}, QStringLiteral("1-4:1.0"))});
    const auto &notice = *window().findChild<InlineMessage *>(QStringLiteral("lineNotice"));
    ASSERT_TRUE(comes([&] { return notice.isVisible(); }));
    click(notice, QStringLiteral("Use this adapter"));
    ASSERT_TRUE(comes([&] { return line().latest().connected; }));
    EXPECT_EQ(line().linkName(), second.path());
    EXPECT_EQ(linePlan(project(), firstLine)->adapter.usbPath, QStringLiteral("1-4:1.0"));
    EXPECT_EQ(linePlan(project(), firstLine)->settings.port, second.path());

    showForm();
    connectNow();
    EXPECT_EQ(line().linkName(), second.path());
    EXPECT_EQ(said(), QString());
}

TEST_F(EscLineAdapterTest, ThePortThatIsOpenIsOpenedAgainByAnotherPathOfIt)
{
    plan(EscLinePlan());
    connectPort(first.path());
    ASSERT_EQ(line().linkName(), first.path());
    const QString link = folder.filePath(QStringLiteral("encoders"));
    ASSERT_TRUE(QFile::link(first.path(), link));
    connectPort(link);
    EXPECT_EQ(said(), QString());
    ASSERT_NE(shown->line().session(), nullptr);
    EXPECT_EQ(line().linkName(), link);
}

TEST_F(EscLineAdapterTest, AnAdapterThatCameBackElsewhereIsOpenedAgainWithOtherSettings)
{
    plan(EscLinePlan());
    plugIn({adapter(first, QStringLiteral("A"))});
    connectPort(first.path());
    first.unplug();
    plugIn({adapter(second, QStringLiteral("A"))});
    ASSERT_TRUE(comes([&] { return line().linkName() == second.path() && line().latest().connected; }));
    EscLineSettings slower = form().settings();
    slower.pollInterval = std::chrono::milliseconds(700);
    form().setSettings(slower);
    connectNow();
    EXPECT_EQ(said(), QString());
    ASSERT_NE(shown->line().session(), nullptr);
    EXPECT_EQ(line().linkName(), second.path());
    EXPECT_EQ(linePlan(project(), firstLine)->settings.pollInterval, slower.pollInterval);
}

} // namespace
} // namespace codewheel
