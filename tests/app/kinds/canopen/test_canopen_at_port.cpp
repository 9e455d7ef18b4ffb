// SPDX-License-Identifier: GPL-3.0-or-later
// The window at a serial CAN adapter with an encoder behind it, which know nothing of this program. In real
// time.
#include "links/can_link_to.h"
#include "tests/app/kinds/canopen/canopen_window_test.h"
#include "tests/app/press_connect.h"
#include "tests/support/peer_process.h"
#include "widgets/connect/port_field.h"
#include "widgets/parameters/parameter_panel.h"
#include "widgets/parameters/wanted_values.h"

#include <QComboBox>
#include <QLineEdit>
#include <QMessageBox>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace codewheel {
namespace {

using test::nodeFive;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::StartsWith;

class CanopenAtPort : public test::CanopenWindowTest
{
protected:
    CanopenAtPort() { canBus().setMakeLink(canLinkTo); }
    ~CanopenAtPort() override { canBus().close(); }

    ConnectPage &connection() { return *window().findChild<ConnectPage *>(QStringLiteral("canSettings")); }
    void connectAsTyped()
    {
        plan(QStringLiteral("slcan:") + peer.port(), {nodeFive});
        canActions().settings->trigger();
        connection()
            .findChild<QComboBox *>(QStringLiteral("link"))
            ->setCurrentText(QStringLiteral("Serial CAN adapter (SLCAN)"));
        auto *port = connection().findChild<PortField *>()->findChild<QComboBox *>()->lineEdit();
        port->selectAll();
        QTest::keyClicks(port, peer.port());
        auto *rate = connection().findChild<QComboBox *>(QStringLiteral("canRate"));
        rate->setCurrentIndex(rate->findData(250'000));
        test::pressConnect(connection());
        ASSERT_TRUE(hasOpened());
    }
    void click(const QWidget &in, const QString &text)
    {
        QPushButton *found = nullptr;
        for (auto *button : in.findChildren<QPushButton *>())
            if (plainLabel(button->text()) == text && button->isVisibleTo(&in))
                found = button;
        ASSERT_TRUE(found != nullptr && found->isEnabled()) << text.toStdString();
        QTest::mouseClick(found, Qt::LeftButton);
        advance(50);
    }
    void operate()
    {
        tree().choose(nodeFive);
        advance(50);
        actions().operate->trigger();
        auto *question = window().findChild<QMessageBox *>(QStringLiteral("operateQuestion"));
        ASSERT_NE(question, nullptr);
        click(*question, QStringLiteral("Operate"));
        ASSERT_TRUE(comes([this] { return session().isOperating(); }));
    }
    ParameterPanel &parameters() { return *window().findChild<ParameterPanel *>(); }
    // As the panel writes it, after its review.
    void writeSteps(std::int64_t steps)
    {
        window().findChild<WantedValues *>()->set(nodeFive, Parameter::steps, steps);
        advance(50);
        click(parameters(), QStringLiteral("Write…"));
        auto *confirm = parameters().findChild<QPushButton *>(QStringLiteral("confirmWrite"));
        ASSERT_TRUE(confirm->isVisibleTo(&parameters()));
        QTest::mouseClick(confirm, Qt::LeftButton);
    }

    test::PeerProcess peer{QStringLiteral(CODEWHEEL_PYTHON), {QStringLiteral(CODEWHEEL_CANOPEN_PEER)}};
};

TEST_F(CanopenAtPort, WatchesWithoutAFrameAndWritesAndStoresAValueOnceInOperate)
{
    connectAsTyped();
    EXPECT_TRUE(comes([this] { return session().latest().heard(5) != nullptr; }));
    EXPECT_THAT(peer.order(QStringLiteral("heard")), IsEmpty());
    EXPECT_THAT(peer.order(QStringLiteral("state")), ElementsAre(StartsWith("listening")));
    operate();
    ASSERT_TRUE(comes([this] { return session().encoder(nodeFive)->latest().position == 5000; }));
    EXPECT_THAT(peer.order(QStringLiteral("objects")), IsEmpty()) << "reading writes nothing";
    writeSteps(4096);
    ASSERT_TRUE(comes([this] {
        const auto known = session().encoder(nodeFive)->known(Parameter::steps);
        return known && known->value == 4096;
    }));
    EXPECT_THAT(peer.order(QStringLiteral("objects")), ElementsAre("6001:0=00100000", "1010:1=73617665"))
        << "and it is stored, each once";
}

TEST_F(CanopenAtPort, AnAdapterThatIsUnpluggedIsToldAndNoPositionIsOfNow)
{
    connectAsTyped();
    operate();
    ASSERT_TRUE(comes([this] { return session().encoder(nodeFive)->latest().position == 5000; }));
    peer.unplug();
    EXPECT_TRUE(comes([this] { return !session().latest().connected; }));
    EXPECT_FALSE(session().isOperating());
    EXPECT_TRUE(session().encoder(nodeFive)->freshness().isOld());
}

} // namespace
} // namespace codewheel
