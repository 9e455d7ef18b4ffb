// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/plan/ring_plan.h"
#include "widgets/connect/connect_page.h"
#include "widgets/connect/plain_link_form.h"
#include "widgets/connect/port_row.h"
#include "widgets/kinds/interbus/gateway/gateway_form.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"

#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Transport = GatewaySettings::Transport;

KindData planOf(const GatewaySettings &settings)
{
    return KindData(ProjectLink{linkKindOf(settings), linkTexts(settings)});
}

GatewaySettings unusualGateway(Transport transport)
{
    GatewaySettings settings{.transport = transport};
    if (transport == Transport::tcp) {
        settings.host = QStringLiteral("gateway.hall");
        settings.tcpPort = 1502;
    } else {
        settings.serialPort = QStringLiteral("/dev/ttyHALL");
        settings.serial.baudRate = 38'400;
    }
    settings.unit = 7;
    settings.inArea = RegisterArea::holding;
    settings.inFirst = 100;
    settings.outFirst = 200;
    settings.highWordFirst = false;
    settings.statusRegister = 40;
    settings.runBit = 3;
    settings.faultBits = 0x0030;
    settings.pollInterval = std::chrono::milliseconds(50);
    return settings;
}

class GatewayFormTest : public testing::Test
{
protected:
    GatewayFormTest()
    {
        page.addForm(new PlainLinkForm(QStringLiteral("Training bus"), {}, KindData(ProjectLink()), &page));
        page.addForm(&tcp);
        page.addForm(&rtu);
        page.resize(700, 600);
    }
    void open()
    {
        page.show();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
    }
    void choose(const char *link)
    {
        page.findChild<QComboBox *>(QStringLiteral("link"))->setCurrentText(QLatin1String(link));
    }
    QPushButton &button(const char *text)
    {
        for (auto *button : page.findChildren<QPushButton *>())
            if (plainLabel(button->text()) == QLatin1String(text))
                return *button;
        ADD_FAILURE() << text;
        return *page.findChild<QPushButton *>();
    }
    QString said() const
    {
        for (const auto *message : page.findChildren<InlineMessage *>())
            if (message->isVisible())
                return message->sentence();
        return {};
    }
    static bool isEmpty(const LinkForm &form)
    {
        return !form.hasFields() && form.findChildren<QWidget *>().isEmpty();
    }

    ConnectPage page;
    GatewayForm &tcp = *new GatewayForm(Transport::tcp, &page);
    GatewayForm &rtu = *new GatewayForm(Transport::rtu, &page);
    const std::vector<PortRow> ports{{QStringLiteral("/dev/ttyUSB0"), QStringLiteral("USB Serial"), {}}};
};

TEST_F(GatewayFormTest, FieldsAreMadeForTheFormThatIsChosenOnAnOpenPage)
{
    page.setPorts(ports, {});
    page.showPlan(planOf(unusualGateway(Transport::rtu)));
    page.showPlan(KindData(ProjectLink()));
    choose("Modbus/TCP gateway");
    EXPECT_TRUE(isEmpty(tcp)) << "nobody sees it";
    choose("Training bus");
    open();
    EXPECT_TRUE(isEmpty(tcp));
    EXPECT_TRUE(isEmpty(rtu));
    choose("Modbus/TCP gateway");
    EXPECT_TRUE(tcp.findChild<QLineEdit *>(QStringLiteral("host"))->isVisible());
    EXPECT_TRUE(isEmpty(rtu));
}

TEST_F(GatewayFormTest, TheFieldsOfTheChosenFormAreThereWhenThePageOpens)
{
    choose("Modbus/TCP gateway");
    open();
    EXPECT_TRUE(tcp.findChild<QLineEdit *>(QStringLiteral("host"))->isVisible());
    EXPECT_TRUE(isEmpty(rtu));
}

TEST_F(GatewayFormTest, APlanIsTheSameBeforeAndAfterItsFieldsAreMade)
{
    for (GatewayForm *form : {&tcp, &rtu}) {
        const KindData untouched = form->plan();
        const bool isTcp = form == &tcp;
        const KindData plan = planOf(unusualGateway(isTcp ? Transport::tcp : Transport::rtu));
        EXPECT_TRUE(form->showPlan(plan));
        EXPECT_FALSE(form->showPlan(planOf(unusualGateway(isTcp ? Transport::rtu : Transport::tcp))));
        EXPECT_EQ(form->plan(), plan);
        EXPECT_TRUE(isEmpty(*form));
        form->makeFields();
        EXPECT_EQ(form->plan(), plan);
        GatewayForm other(isTcp ? Transport::tcp : Transport::rtu);
        other.makeFields();
        EXPECT_EQ(other.plan(), untouched);
    }
}

TEST_F(GatewayFormTest, WhatIsMissingIsToldBeforeAndAfterItsFieldsAreMade)
{
    for (GatewayForm *form : {&tcp, &rtu}) {
        const QString missing = form->complaint();
        EXPECT_FALSE(missing.isEmpty());
        EXPECT_EQ(form->wrong(), QString());
        form->makeFields();
        EXPECT_EQ(form->complaint(), missing);
        EXPECT_EQ(form->wrong(), QString());
        form->showPlan(planOf(unusualGateway(form == &tcp ? Transport::tcp : Transport::rtu)));
        EXPECT_EQ(form->complaint(), QString());
    }
}

TEST_F(GatewayFormTest, WhatATestHasFoundIsKeptForTheFields)
{
    tcp.showPlan(planOf(unusualGateway(Transport::tcp)));
    tcp.propose({{QStringLiteral("unit"), QStringLiteral("9")}});
    GatewaySettings wanted = unusualGateway(Transport::tcp);
    wanted.unit = 9;
    EXPECT_EQ(tcp.plan(), planOf(wanted));
    EXPECT_TRUE(isEmpty(tcp));
    tcp.makeFields();
    EXPECT_EQ(tcp.plan(), planOf(wanted));
    EXPECT_EQ(tcp.findChild<QSpinBox *>(QStringLiteral("unit"))->value(), 9);
}

TEST_F(GatewayFormTest, WhatWasUsedLastIsOfferedByFieldsThatAreMadeLater)
{
    tcp.setLast(linkTexts(unusualGateway(Transport::tcp)));
    EXPECT_TRUE(isEmpty(tcp));
    tcp.makeFields();
    const auto &presets = *tcp.findChild<QComboBox *>(QStringLiteral("preset"));
    EXPECT_EQ(presets.itemText(presets.count() - 1), QStringLiteral("As used last: gateway.hall"));
    const int count = presets.count();
    tcp.setLast({});
    EXPECT_EQ(presets.count(), count - 1);
}

TEST_F(GatewayFormTest, ThePortsThatWereListedAreInFieldsThatAreMadeLater)
{
    page.setPorts(ports, QStringLiteral("You lack the group dialout."));
    open();
    EXPECT_TRUE(isEmpty(rtu));
    choose("Modbus RTU gateway");
    EXPECT_EQ(rtu.complaint(), QString()) << "the first one is chosen";
    EXPECT_EQ(said(), QStringLiteral("You lack the group dialout."));
    page.setPorts(ports, {});
    EXPECT_EQ(said(), QString());
}

// Nobody has edited anything.
TEST_F(GatewayFormTest, WhatWasToldOfAPlanIsStillToldWhenItsFieldsAreMade)
{
    page.showPlan(planOf(unusualGateway(Transport::tcp)));
    page.setProblem(QStringLiteral("The gateway does not answer."));
    open();
    EXPECT_TRUE(tcp.hasFields());
    EXPECT_EQ(said(), QStringLiteral("The gateway does not answer."));
}

TEST_F(GatewayFormTest, APlanThatIsConnectedUnseenIsTheWholePlan)
{
    std::vector<KindData> wanted;
    QObject::connect(&page, &ConnectPage::connectWanted, &page,
                     [&](const KindData &plan) { wanted.push_back(plan); });
    page.connectBy(planOf(unusualGateway(Transport::rtu)));
    EXPECT_EQ(wanted, std::vector{planOf(unusualGateway(Transport::rtu))});
}

TEST_F(GatewayFormTest, TabGoesThroughFieldsThatAreMadeLateAndThenToTheButtons)
{
    open();
    choose("Modbus/TCP gateway");
    page.setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    EXPECT_EQ(QApplication::focusWidget(), tcp.findChild<QLineEdit *>(QStringLiteral("host")));
    QStringList passed;
    while (tcp.isAncestorOf(QApplication::focusWidget()) && passed.size() < 50) {
        passed << QApplication::focusWidget()->objectName();
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    EXPECT_EQ(QApplication::focusWidget(), &button("Test")) << passed.join(u' ').toStdString();
    EXPECT_EQ(passed.mid(0, 3),
              QStringList({QStringLiteral("host"), QStringLiteral("tcpPort"), QStringLiteral("preset")}));
}

} // namespace
} // namespace codewheel
