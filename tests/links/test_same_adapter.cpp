// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/serial_ports.h"

#include <gtest/gtest.h>

namespace codewheel {
namespace {

using Kind = AdapterMatch::Kind;

PortInfo plugged(const char *path, const char *serialNumber, const char *usbPath, int product = 0x6001)
{
    return {.path = QString::fromLatin1(path),
            .serialNumber = QString::fromLatin1(serialNumber),
            .usbPath = QString::fromLatin1(usbPath),
            .vendor = 0x0403,
            .product = product};
}

const PortInfo numbered = plugged("/dev/ttyUSB0", "A50285BI", "1-2:1.0");
const PortInfo pluggedNameless = plugged("/dev/ttyUSB0", "", "1-2:1.0");

TEST(SameAdapter, IsFoundByItsSerialNumberWhereverItIsPluggedIn)
{
    const PortInfo elsewhere = plugged("/dev/ttyUSB3", "A50285BI", "3-1.4:1.0");
    const PortInfo other = plugged("/dev/ttyUSB0", "FT9QZZZZ", "1-2:1.0");
    EXPECT_EQ(sameAdapter(numbered, {other, elsewhere}), (AdapterMatch{Kind::found, {elsewhere}}));
}

TEST(SameAdapter, WithASerialNumberNoOtherIsTakenNorAskedFor)
{
    EXPECT_EQ(sameAdapter(numbered, {}), AdapterMatch{});
    EXPECT_EQ(sameAdapter(numbered, {plugged("/dev/ttyUSB0", "FT9QZZZZ", "1-2:1.0")}), AdapterMatch{});
    EXPECT_EQ(sameAdapter(numbered, {pluggedNameless}), AdapterMatch{});
    // The same number at another model is another adapter.
    EXPECT_EQ(sameAdapter(numbered, {plugged("/dev/ttyUSB0", "A50285BI", "1-2:1.0", 0x6015)}),
              AdapterMatch{});
}

TEST(SameAdapter, OfSeveralPortsWithOneSerialNumberTheInterfaceDecides)
{
    const PortInfo second = plugged("/dev/ttyUSB1", "A50285BI", "1-2:1.1");
    const PortInfo firstElsewhere = plugged("/dev/ttyUSB4", "A50285BI", "2-1:1.0");
    const PortInfo secondElsewhere = plugged("/dev/ttyUSB5", "A50285BI", "2-1:1.1");
    EXPECT_EQ(sameAdapter(second, {firstElsewhere, secondElsewhere}),
              (AdapterMatch{Kind::found, {secondElsewhere}}));
    const PortInfo twin = plugged("/dev/ttyUSB6", "A50285BI", "4-1:1.1");
    EXPECT_EQ(sameAdapter(second, {secondElsewhere, twin}),
              (AdapterMatch{Kind::ask, {secondElsewhere, twin}}));
}

TEST(SameAdapter, WithoutASerialNumberThePlaceOnUsbDecides)
{
    const PortInfo here = plugged("/dev/ttyUSB7", "", "1-2:1.0");
    const PortInfo there = plugged("/dev/ttyUSB0", "", "1-3:1.0");
    EXPECT_EQ(sameAdapter(pluggedNameless, {there, here}), (AdapterMatch{Kind::found, {here}}));
    EXPECT_EQ(sameAdapter(pluggedNameless, {there}), (AdapterMatch{Kind::ask, {there}}));
    EXPECT_EQ(sameAdapter(pluggedNameless, {numbered}), AdapterMatch{});
    EXPECT_EQ(sameAdapter(pluggedNameless, {plugged("/dev/ttyUSB0", "", "1-2:1.0", 0x6015)}), AdapterMatch{});
    const PortInfo placeless = plugged("/dev/ttyUSB0", "", "");
    EXPECT_EQ(sameAdapter(placeless, {placeless}), (AdapterMatch{Kind::ask, {placeless}}));
}

TEST(SameAdapter, APortOfTheComputerIsItsPath)
{
    const PortInfo first{.path = QStringLiteral("/dev/ttyS0")};
    const PortInfo second{.path = QStringLiteral("/dev/ttyS1")};
    EXPECT_EQ(sameAdapter(second, {first, second}), (AdapterMatch{Kind::found, {second}}));
    EXPECT_EQ(sameAdapter(second, {first, numbered}), AdapterMatch{});
}

TEST(SerialPorts, ThePlaceOnUsbIsReadFromThePathOfTheDevice)
{
    const std::pair<const char *, const char *> rows[] = {
        {"/sys/devices/pci0000:00/0000:00:14.0/usb1/1-2/1-2:1.0/ttyUSB0", "1-2:1.0"},
        {"/sys/devices/pci0000:00/0000:00:14.0/usb1/1-2/1-2.4/1-2.4.1/1-2.4.1:1.1/ttyUSB1", "1-2.4.1:1.1"},
        {"/sys/devices/pci0000:00/0000:00:14.0/usb3/3-1/3-1:2.0", "3-1:2.0"},
        {"/sys/devices/pnp0/00:04", ""},
        {"/sys/devices/platform/serial8250", ""},
        {"", ""},
    };
    for (const auto &[path, place] : rows)
        EXPECT_EQ(usbPathOf(QString::fromLatin1(path)), QString::fromLatin1(place)) << path;
}

TEST(SerialPorts, APortIsLabelledByWhatItsAdapterTells)
{
    EXPECT_EQ((PortInfo{.path = QStringLiteral("/dev/ttyUSB0"),
                        .description = QStringLiteral("FT232R USB UART"),
                        .manufacturer = QStringLiteral("FTDI"),
                        .serialNumber = QStringLiteral("A50285BI")})
                  .label(),
              QStringLiteral("ttyUSB0, FT232R USB UART, FTDI, A50285BI"));
    EXPECT_EQ((PortInfo{.path = QStringLiteral("/dev/ttyS0")}).label(), QStringLiteral("ttyS0"));
}

TEST(SerialPorts, AreListedByPath)
{
    const std::vector<PortInfo> ports = serialPorts();
    EXPECT_TRUE(std::ranges::is_sorted(ports, {}, &PortInfo::path));
    EXPECT_TRUE(noSerialPortsText().contains(QStringLiteral("no serial port")));
}

} // namespace
} // namespace codewheel
