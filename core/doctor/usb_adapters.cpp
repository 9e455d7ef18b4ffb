// SPDX-License-Identifier: GPL-3.0-or-later
#include "doctor/usb_adapters.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace codewheel {
namespace {

const QString usbDevices = QStringLiteral("/sys/bus/usb/devices/");

// Makers of the converters in RS-232, RS-422 and RS-485 adapters, and the module of the kernel for them. A
// maker of other things too is named with its products.
struct AdapterMake
{
    std::string_view ids; // how vendor:product begins
    const char *driver;
};
constexpr std::array makes{
    AdapterMake{"0403:60", "ftdi_sio"}, // FTDI
    AdapterMake{"10c4:ea6", "cp210x"},  // Silicon Labs; its ea80 and ea90 are no serial ports
    AdapterMake{"10c4:ea7", "cp210x"},          AdapterMake{"067b:23", "pl2303"}, // Prolific
    AdapterMake{"0557:2008", "pl2303"},                                           // ATEN
    AdapterMake{"1a86:752", "ch341"},                                             // WCH
    AdapterMake{"1a86:5523", "ch341"},          AdapterMake{"1a86:55d", "cdc_acm"},
    AdapterMake{"04e2:14", "xr_serial"},                                            // Exar
    AdapterMake{"110a:11", "ti_usb_3410_5052"},                                     // Moxa UPort 1110 to 1151
    AdapterMake{"110a:1", "mxuport"},                                               // and its larger ones
    AdapterMake{"04d8:00dd", "cdc_acm"},                                            // Microchip
    AdapterMake{"04d8:00df", "cdc_acm"},        AdapterMake{"0856:ac", "ftdi_sio"}, // B&B Electronics
};

const AdapterMake *makeOf(const QString &ids)
{
    const auto found = std::ranges::find_if(makes, [&](const AdapterMake &make) {
        return ids.startsWith(QLatin1String(make.ids.data(), static_cast<qsizetype>(make.ids.size())));
    });
    return found == makes.end() ? nullptr : &*found;
}

// A port is a folder of its own below an interface, or in its folder "tty".
bool hasPortIn(const QString &interface, const Computer &computer)
{
    const QStringList inside = computer.folders(interface);
    return std::ranges::any_of(inside,
                               [](const QString &name) { return name.startsWith(QStringLiteral("tty")); });
}

UsbAdapter adapterAt(const QString &place, const QString &ids, const AdapterMake &make,
                     const Computer &computer)
{
    const QString folder = usbDevices + place;
    const QString product = QString::fromUtf8(computer.contents(folder + QStringLiteral("/product")));
    UsbAdapter adapter{.name = product.isEmpty() ? QStringLiteral("USB %1").arg(ids) : product,
                       .ids = ids,
                       .driver = QString::fromLatin1(make.driver)};
    for (const QString &interface : computer.folders(folder).filter(place + u':')) {
        const QString path = folder + u'/' + interface;
        adapter.hasPort |= hasPortIn(path, computer);
        adapter.isClaimed |=
            computer.target(path + QStringLiteral("/driver")).endsWith(QStringLiteral("/usbfs"));
    }
    return adapter;
}

} // namespace

std::vector<UsbAdapter> usbAdapters(const Computer &computer)
{
    std::vector<UsbAdapter> adapters;
    for (const QString &place : computer.folders(usbDevices)) {
        const QString folder = usbDevices + place;
        const QString ids = QStringLiteral("%1:%2").arg(
            QString::fromLatin1(computer.contents(folder + QStringLiteral("/idVendor"))),
            QString::fromLatin1(computer.contents(folder + QStringLiteral("/idProduct"))));
        if (const AdapterMake *make = makeOf(ids))
            adapters.push_back(adapterAt(place, ids, *make, computer));
    }
    return adapters;
}

} // namespace codewheel
