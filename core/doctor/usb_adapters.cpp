// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/usb_adapters.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace codewheel {
namespace {

const QString usbDevices = QStringLiteral("/sys/bus/usb/devices/");

// Converters in RS-232, RS-422 and RS-485 adapters, and the module that makes ports of them, as the tables of
// Linux 6.1 have it. Other products of these makers are something else: a CP2110 (10c4:ea80) is an input
// device, a PL2305 (067b:2305) a printer. packaging/udev.rules has the same.
struct AdapterMake
{
    std::string_view vendor;
    std::string_view products;
    const char *driver;
};
constexpr std::array makes{
    // FTDI
    AdapterMake{"0403", "6001 6006 6010 6011 6014 6015 6040 6041 6042 6043 6044 6045 6048", "ftdi_sio"},
    // Silicon Labs
    AdapterMake{"10c4", "ea60 ea61 ea63 ea70 ea71 ea7a ea7b", "cp210x"},
    // Prolific
    AdapterMake{"067b", "2303 2304 23a3 23b3 23c3 23d3 23e3 23f3", "pl2303"},
    // ATEN
    AdapterMake{"0557", "2008 2021 2022 2118", "pl2303"},
    AdapterMake{"0557", "2011 7820", "mos7840"},
    // WCH; the newer ones are of the class of modems
    AdapterMake{"1a86", "5523 7522 7523", "ch341"},
    AdapterMake{"4348", "5523", "ch341"},
    AdapterMake{"1a86", "55d2 55d3 55d4 55d5", "cdc_acm"},
    // Microchip MCP2221 and MCP2200, likewise
    AdapterMake{"04d8", "00dd 00df", "cdc_acm"},
    // Exar
    AdapterMake{"04e2", "1400 1401 1402 1403 1410 1411 1412 1414 1420 1422 1424", "xr_serial"},
    // Moxa
    AdapterMake{"110a", "1110 1130 1131 1150 1151", "ti_usb_3410_5052"},
    AdapterMake{"110a", "1250 1251 1410 1450 1451 1613 1618 1653 1658", "mxuport"},
    AdapterMake{"110a", "2210", "mos7840"},
    // B&B Electronics
    AdapterMake{"0856",
                "ac01 ac02 ac03 ac11 ac12 ac16 ac17 ac18 ac19 ac25 ac26 ac27 ac33 ac34 ac49 ac50 ba02",
                "ftdi_sio"},
    AdapterMake{"0856", "ac22 ac24 ac29 ac30 ac31 ac32 ac42 ac44 bc00 bc01 bc02 bc03", "mos7840"},
};

bool isAmong(std::string_view products, const QByteArray &product)
{
    constexpr qsizetype digits = 4;
    return product.size() == digits && QByteArrayView(products).contains(product);
}

// A port is a folder of its own below an interface, or in its folder "tty".
bool hasPortIn(const QString &interface, const Computer &computer)
{
    const QStringList inside = computer.folders(interface);
    return std::ranges::any_of(inside,
                               [](const QString &name) { return name.startsWith(QStringLiteral("tty")); });
}

UsbAdapter adapterAt(const QString &place, const QString &ids, const QString &driver,
                     const Computer &computer)
{
    const QString folder = usbDevices + place;
    const QString product = QString::fromUtf8(computer.contents(folder + QStringLiteral("/product")));
    UsbAdapter adapter{.name = product.isEmpty() ? QStringLiteral("USB %1").arg(ids) : product,
                       .ids = ids,
                       .driver = driver};
    for (const QString &interface : computer.folders(folder).filter(place + u':')) {
        const QString path = folder + u'/' + interface;
        adapter.hasPort |= hasPortIn(path, computer);
        adapter.isClaimed |=
            computer.target(path + QStringLiteral("/driver")).endsWith(QStringLiteral("/usbfs"));
    }
    return adapter;
}

} // namespace

QString serialDriverOf(const QByteArray &vendor, const QByteArray &product)
{
    const auto found = std::ranges::find_if(makes, [&](const AdapterMake &make) {
        return vendor == QByteArrayView(make.vendor) && isAmong(make.products, product);
    });
    return found == makes.end() ? QString() : QString::fromLatin1(found->driver);
}

std::vector<UsbAdapter> usbAdapters(const Computer &computer)
{
    std::vector<UsbAdapter> adapters;
    for (const QString &place : computer.folders(usbDevices)) {
        const QString folder = usbDevices + place;
        const QByteArray vendor = computer.contents(folder + QStringLiteral("/idVendor"));
        const QByteArray product = computer.contents(folder + QStringLiteral("/idProduct"));
        const QString driver = serialDriverOf(vendor, product);
        if (!driver.isEmpty())
            adapters.push_back(
                adapterAt(place, QString::fromLatin1(vendor + ':' + product), driver, computer));
    }
    return adapters;
}

} // namespace codewheel
