// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/link_hindrances.h"
#include "doctor/usb_adapters.h"
#include "tests/doctor/made_computer.h"

#include <QFile>
#include <QRegularExpression>
#include <QSet>

namespace codewheel {
namespace {

TEST(UsbHindrances, AnAdapterWithItsPortIsInNobodysWay)
{
    MadeComputer made;
    made.adapter(QStringLiteral("1-2"), "0403", "6001", "FT232R USB UART", "ftdi_sio");
    made.adapter(QStringLiteral("1-3"), "046d", "c077", "USB Optical Mouse");
    ASSERT_EQ(usbAdapters(made.computer()).size(), 1U) << "a mouse is no adapter";
    EXPECT_TRUE(usbHindrances(made.computer()).empty());
}

TEST(UsbHindrances, AnAdapterWithoutAPortWantsItsDriver)
{
    const struct
    {
        const char *vendor;
        const char *product;
        const char *driver;
    } rows[] = {
        {"0403", "6001", "ftdi_sio"},
        {"0403", "6015", "ftdi_sio"},
        {"0856", "ac27", "ftdi_sio"},
        {"10c4", "ea60", "cp210x"},
        {"10c4", "ea71", "cp210x"},
        {"067b", "2303", "pl2303"},
        {"067b", "23c3", "pl2303"},
        {"0557", "2008", "pl2303"},
        {"1a86", "7523", "ch341"},
        {"1a86", "7522", "ch341"},
        {"4348", "5523", "ch341"},
        {"1a86", "55d4", "cdc_acm"},
        {"04d8", "00df", "cdc_acm"},
        {"04d8", "00dd", "cdc_acm"},
        {"04e2", "1410", "xr_serial"},
        {"110a", "1130", "ti_usb_3410_5052"},
        {"110a", "1150", "ti_usb_3410_5052"},
        {"110a", "1250", "mxuport"},
        {"110a", "1653", "mxuport"},
        {"0856", "ac44", "mos7840"},
    };
    for (const auto &row : rows) {
        MadeComputer made;
        made.adapter(QStringLiteral("3-1.4"), row.vendor, row.product, "Adapter");
        const auto found = usbHindrances(made.computer());
        ASSERT_EQ(idsOf(found), std::vector{QStringLiteral("noDriver")}) << row.vendor << ':' << row.product;
        EXPECT_EQ(found[0].command, QStringLiteral("sudo modprobe ") + QLatin1String(row.driver));
    }
}

TEST(UsbHindrances, WhatTheSameMakersSellWithoutASerialPortIsNoAdapter)
{
    const std::pair<const char *, const char *> rows[] = {
        {"10c4", "ea80"}, {"10c4", "ea90"}, {"067b", "2305"}, {"1a86", "5584"}, {"1a86", "55dc"},
        {"110a", "9999"}, {"04d8", "003f"}, {"04e2", ""},     {"04e2", "10"}};
    for (const auto &[vendor, product] : rows) {
        MadeComputer made;
        made.adapter(QStringLiteral("3-1.4"), vendor, product, "Something else");
        EXPECT_TRUE(usbHindrances(made.computer()).empty()) << vendor << ':' << product;
    }
}

// "0403:6001", as the rules for udev name them.
QSet<QByteArray> idsOfTheRules()
{
    QFile file(QStringLiteral(CODEWHEEL_UDEV_RULES));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    static const QRegularExpression rule(
        QStringLiteral("ATTRS\\{idVendor\\}==\"(....)\", ATTRS\\{idProduct\\}==\"([^\"]+)\""));
    QSet<QByteArray> ids;
    for (auto rules = rule.globalMatch(QString::fromUtf8(file.readAll())); rules.hasNext();) {
        const QRegularExpressionMatch match = rules.next();
        for (const QString &product : match.captured(2).split(u'|'))
            ids << (match.captured(1) + u':' + product).toLatin1();
    }
    return ids;
}

TEST(UsbHindrances, OurRulesNameTheAdaptersThatTheDoctorKnows)
{
    QSet<QByteArray> known;
    for (const char *vendor :
         {"0403", "04d8", "04e2", "0557", "067b", "0856", "10c4", "110a", "1a86", "4348"})
        for (int product = 0; product <= 0xFFFF; ++product) {
            const QByteArray digits = QByteArray::number(product, 16).rightJustified(4, '0');
            if (!serialDriverOf(vendor, digits).isEmpty())
                known << vendor + (':' + digits);
        }
    const QSet<QByteArray> named = idsOfTheRules();
    EXPECT_EQ((known - named).values(), QList<QByteArray>()) << "ModemManager may take these";
    EXPECT_EQ((named - known).values(), QList<QByteArray>()) << "the doctor does not know these";
}

TEST(UsbHindrances, BrlttyTakesAnAdapterForABrailleDisplay)
{
    MadeComputer made;
    made.adapter(QStringLiteral("1-2"), "1a86", "7523", "USB Serial", "usbfs");
    made.file(QStringLiteral("/usr/bin/brltty"));
    const auto found = usbHindrances(made.computer());
    ASSERT_EQ(idsOf(found), std::vector{QStringLiteral("brltty")});
    EXPECT_TRUE(found[0].sentence.contains(u"USB Serial"));
    EXPECT_EQ(found[0].command, QStringLiteral("sudo systemctl mask --now brltty.service"));
    made.file(QStringLiteral("/usr/lib/systemd/system/brltty-udev.service"));
    EXPECT_EQ(usbHindrances(made.computer())[0].command,
              QStringLiteral("sudo systemctl mask --now brltty-udev.service"));
}

TEST(UsbHindrances, BrlttyThatRunsMayHaveTakenAnAdapterBefore)
{
    MadeComputer made;
    made.adapter(QStringLiteral("1-2"), "1a86", "7523", "USB Serial");
    EXPECT_EQ(idsOf(usbHindrances(made.computer())), std::vector{QStringLiteral("noDriver")});
    made.process(800, "brltty");
    const auto found = usbHindrances(made.computer());
    ASSERT_EQ(idsOf(found), std::vector{QStringLiteral("brltty")});
    EXPECT_EQ(found[0].command, QStringLiteral("sudo systemctl mask --now brltty.service"));
}

TEST(UsbHindrances, ModemManagerIsToldUnlessOurRulesKeepItAway)
{
    MadeComputer made;
    made.process(700, "ModemManager");
    EXPECT_TRUE(usbHindrances(made.computer()).empty()) << "no adapter";
    made.adapter(QStringLiteral("1-2"), "0403", "6001", "FT232R USB UART", "ftdi_sio");
    const auto found = usbHindrances(made.computer());
    ASSERT_EQ(idsOf(found), std::vector{QStringLiteral("modemManager")});
    EXPECT_EQ(found[0].weight, Hindrance::Weight::slows);
    made.file(QStringLiteral("/usr/lib/udev/rules.d/91-codewheel.rules"));
    EXPECT_TRUE(usbHindrances(made.computer()).empty());
    made.file(QStringLiteral("/etc/udev/rules.d/91-codewheel.rules"));
    EXPECT_EQ(idsOf(usbHindrances(made.computer())), std::vector{QStringLiteral("modemManager")})
        << "masked by an empty file";
}

} // namespace
} // namespace codewheel
