// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/interbus/gateway/gateway_refusals.h"
#include "kinds/interbus/gateway/gateway_settings.h"

#include <QStringList>

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Texts = std::map<QString, QString>;

TEST(GatewaySettings, TheDefaultsAreThoseOfTheSpecification)
{
    const GatewaySettings usual;
    EXPECT_EQ(usual.tcpPort, 502);
    EXPECT_EQ(usual.serial.baudRate, 19'200);
    EXPECT_EQ(usual.serial.parity, SerialSettings::Parity::even);
    EXPECT_EQ(usual.unit, 1);
    EXPECT_EQ(usual.inArea, RegisterArea::input);
    EXPECT_TRUE(usual.highWordFirst);
    EXPECT_TRUE(settingTexts(usual).empty());
}

TEST(GatewaySettings, WhatIsKeptComesBack)
{
    GatewaySettings settings{.transport = GatewaySettings::Transport::rtu,
                             .serialPort = QStringLiteral("/dev/ttyUSB1"),
                             .unit = 17,
                             .inArea = RegisterArea::holding,
                             .inFirst = 512,
                             .outFirst = 1'024,
                             .writesWithRead = true,
                             .highWordFirst = false,
                             .statusRegister = 2'000,
                             .controlRegister = 2'001,
                             .readsBack = false,
                             .pollInterval = std::chrono::milliseconds(20),
                             .reactionDelay = std::chrono::milliseconds(3),
                             .timeOut = std::chrono::milliseconds(750),
                             .retries = 5};
    settings.serial.baudRate = 38'400;
    settings.serial.parity = SerialSettings::Parity::none;
    settings.serial.stopBits = 2;
    EXPECT_EQ(gatewaySettings(QStringLiteral("modbus-rtu"), linkTexts(settings)), settings);

    const GatewaySettings tcp{.host = QStringLiteral("gateway.hall"), .tcpPort = 1502, .unit = 0};
    EXPECT_EQ(gatewaySettings(QStringLiteral("modbus-tcp"), linkTexts(tcp)), tcp);
}

TEST(GatewaySettings, ASettingThatIsWrongIsRefusedAndNothingIsTaken)
{
    const Texts wrong[] = {
        {{QStringLiteral("unit"), QStringLiteral("256")}},
        {{QStringLiteral("unit"), QStringLiteral("-1")}},
        {{QStringLiteral("unit"), QStringLiteral("1 ")}, {QStringLiteral("in"), QStringLiteral("x")}},
        {{QStringLiteral("in"), QStringLiteral("65536")}},
        {{QStringLiteral("order"), QStringLiteral("up")}},
        {{QStringLiteral("write"), QStringLiteral("15")}},
        {{QStringLiteral("status"), QString()}},
    };
    for (const Texts &texts : wrong) {
        GatewaySettings settings;
        const auto applied = applySettings(settings, texts);
        ASSERT_FALSE(applied) << texts.begin()->first.toStdString();
        EXPECT_EQ(applied.error().id, GatewayRefusalId::linkSettingWrong);
        EXPECT_EQ(settings, GatewaySettings());
    }
}

TEST(GatewaySettings, ASettingThatThereIsNotIsRefusedWithThoseThereAre)
{
    GatewaySettings tcp;
    for (const char *name : {"baud", "speed", ""}) { // one of RTU, none, nothing
        const auto applied = applySettings(tcp, {{QLatin1String(name), QStringLiteral("1")}});
        ASSERT_FALSE(applied) << name;
        EXPECT_EQ(applied.error().id, GatewayRefusalId::linkSettingUnknown);
        EXPECT_EQ(applied.error().arguments,
                  (std::vector<RefusalArgument>{
                      QLatin1String(name),
                      settingNames(GatewaySettings::Transport::tcp).join(QStringLiteral(", "))}));
    }
}

TEST(GatewaySettings, RtuHasUnitsUpTo247AndTheFormatsOfModbus)
{
    GatewaySettings rtu{.transport = GatewaySettings::Transport::rtu};
    const auto takes = [&rtu](const char *name, const char *text) {
        return applySettings(rtu, {{QLatin1String(name), QLatin1String(text)}}).has_value();
    };
    EXPECT_TRUE(takes("unit", "247"));
    EXPECT_FALSE(takes("unit", "248"));
    EXPECT_FALSE(takes("unit", "0"));
    EXPECT_TRUE(takes("format", "8n2"));
    EXPECT_FALSE(takes("format", "7E1"));
    EXPECT_FALSE(takes("format", "8E3"));
    EXPECT_TRUE(takes("baud", "115200"));
}

} // namespace
} // namespace codewheel
