// SPDX-License-Identifier: GPL-3.0-or-later
// Before a real ring goes to Operate: what can move, once per connection.
#include "kinds/interbus/ring/id_code.h"
#include "tests/app/kinds/interbus/gateway_test.h"
#include "tests/app/question.h"

#include <QAbstractButton>
#include <QMessageBox>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using test::fraba;

class OperateQuestionTest : public test::GatewayTest
{
protected:
    QMessageBox *question() { return window().findChild<QMessageBox *>(QStringLiteral("operateQuestion")); }
    bool isAsked() { return question() != nullptr && question()->isVisible(); }
    QString text()
    {
        return isAsked() ? question()->text() + u'\n' + question()->informativeText() : QString();
    }
    void operate()
    {
        actions().operate->trigger();
        advance(50);
    }
    void answer(const QString &beginning)
    {
        ASSERT_TRUE(isAsked());
        for (QAbstractButton *button : question()->buttons())
            if (button->text().remove(u'&') == beginning)
                QTest::mouseClick(button, Qt::LeftButton);
        EXPECT_FALSE(isAsked());
        advance(50);
    }
    void plan(const std::vector<ProjectDevice> &more)
    {
        Project project = shown->project().project();
        project.devices.insert(project.devices.end(), more.begin(), more.end());
        shown->project().setProject(project, {});
    }
    static ProjectDevice planned(const char *number, unsigned deviceCode, const QString &station = {})
    {
        ProjectDevice device;
        device.participant = deviceOf(deviceCode);
        device.participant.number = NodeId(number);
        device.station = station;
        return device;
    }
    QString modeInSwitch()
    {
        const auto *on = window().findChild<QAbstractButton *>(QStringLiteral("operate"));
        return on->isChecked() ? QStringLiteral("Operate") : QStringLiteral("Watch");
    }
};

TEST_F(OperateQuestionTest, StaysInWatchUnlessAgreedTo)
{
    connectGateway();
    operate();
    ASSERT_TRUE(isAsked());
    EXPECT_FALSE(bus().isOperating());
    EXPECT_TRUE(actions().watch->isChecked()) << "the switch says what is so while the question is open";
    EXPECT_EQ(modeInSwitch(), QStringLiteral("Watch"));
    QTest::keyClick(question(), Qt::Key_Return);
    EXPECT_FALSE(isAsked());
    advance(50);
    EXPECT_FALSE(bus().isOperating());
    operate();
    ASSERT_TRUE(isAsked());
    QTest::keyClick(question(), Qt::Key_Escape);
    EXPECT_FALSE(isAsked());
    advance(50);
    EXPECT_FALSE(bus().isOperating());
    EXPECT_EQ(bank->writes, 0);
    operate();
    answer(QStringLiteral("Operate"));
    EXPECT_TRUE(bus().isOperating());
    EXPECT_EQ(modeInSwitch(), QStringLiteral("Operate"));
}

TEST_F(OperateQuestionTest, IsAskedOnceInAConnection)
{
    connectGateway();
    operate();
    answer(QStringLiteral("Operate"));
    actions().watch->trigger();
    advance(50);
    ASSERT_FALSE(bus().isOperating());
    operate();
    EXPECT_FALSE(isAsked());
    EXPECT_TRUE(bus().isOperating());
    actions().watch->trigger();
    advance(50);
    ringActions().disconnectBus->trigger();
    advance(50);
    ringActions().connectBus->trigger();
    advance(50);
    ASSERT_TRUE(bus().isOpen());
    operate();
    EXPECT_TRUE(isAsked());
    EXPECT_FALSE(bus().isOperating());
}

TEST_F(OperateQuestionTest, IsNeverAskedOfTheTrainingBus)
{
    ringActions().connectBus->trigger();
    advance(50);
    ASSERT_TRUE(bus().isSimulated() && bus().isOperating());
    actions().watch->trigger();
    advance(50);
    operate();
    EXPECT_FALSE(isAsked());
    EXPECT_TRUE(bus().isOperating());
    ringActions().disconnectBus->trigger();
    advance(50);
    connectGateway();
    operate();
    EXPECT_TRUE(isAsked()) << "what was done with simulated encoders agrees to nothing";
}

TEST_F(OperateQuestionTest, NamesWhatIsNoEncoderByPlaceAndStation)
{
    plan({planned("7.0", 0x0101, QStringLiteral("brake of the hoist")), planned("8.0", 0x0102),
          planned("9.0", 0x02E3)});
    connectGateway();
    operate();
    ASSERT_TRUE(isAsked());
    EXPECT_TRUE(text().contains(QStringLiteral("What they drive can move:\n7.0  brake of the hoist: digital "
                                               "output\n9.0  drive with PCP")))
        << text().toStdString();
    EXPECT_FALSE(text().contains(QStringLiteral("8.0"))) << "it has no OUT";
    EXPECT_FALSE(text().contains(QStringLiteral("1.0"))) << "an encoder";
    EXPECT_FALSE(text().contains(QStringLiteral("read back")));
}

TEST_F(OperateQuestionTest, SaysWhereNothingButEncodersHasOut)
{
    connectGateway();
    operate();
    EXPECT_TRUE(text().contains(QStringLiteral("All devices with OUT words are encoders.")));
}

TEST_F(OperateQuestionTest, ManyDevicesAreCounted)
{
    std::vector<ProjectDevice> outputs;
    for (int i = 0; i < 20; ++i)
        outputs.push_back(planned(QStringLiteral("%1.0").arg(10 + i).toLatin1().constData(), 0x0101));
    plan(outputs);
    connectGateway();
    operate();
    EXPECT_TRUE(text().contains(QStringLiteral("17.0  digital output\nand 12 more"))) << text().toStdString();
}

TEST_F(OperateQuestionTest, JoinsWhatCannotBeReadBack)
{
    choose(QStringLiteral("gateway.hall"));
    for (auto *readBack : connection().findChildren<QComboBox *>(QStringLiteral("read-back")))
        readBack->setCurrentIndex(readBack->findData(QStringLiteral("off")));
    click(button(connection(), QStringLiteral("Connect")));
    advance(20);
    operate();
    EXPECT_TRUE(text().contains(QStringLiteral("OUT cannot be read back of these. It stays as it is until "
                                               "something is sent there:\n1.0  ")))
        << text().toStdString();
}

TEST_F(OperateQuestionTest, GoesWithTheConnectionItIsAbout)
{
    connectGateway();
    operate();
    ASSERT_TRUE(isAsked());
    bus().close();
    advance(50);
    EXPECT_FALSE(isAsked());
    EXPECT_FALSE(bus().isOperating());
}

} // namespace
} // namespace codewheel
