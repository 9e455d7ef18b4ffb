// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/own_addresses.h"

#include <array>
#include <ifaddrs.h>
#include <memory>
#include <net/if.h>
#include <netdb.h>
#include <netinet/in.h>

namespace codewheel {
namespace {

socklen_t sizeOf(const sockaddr &address)
{
    return address.sa_family == AF_INET ? sizeof(sockaddr_in) : sizeof(sockaddr_in6);
}

// Empty: it is none that others can use.
QString addressOf(const ifaddrs &interface)
{
    const sockaddr *address = interface.ifa_addr;
    const bool isUsed = (interface.ifa_flags & IFF_UP) != 0 && (interface.ifa_flags & IFF_LOOPBACK) == 0;
    if (!isUsed || address == nullptr || (address->sa_family != AF_INET && address->sa_family != AF_INET6))
        return {};
    std::array<char, NI_MAXHOST> host{};
    if (::getnameinfo(address, sizeOf(*address), host.data(), host.size(), nullptr, 0, NI_NUMERICHOST) != 0)
        return {};
    const QString text = QString::fromLatin1(host.data());
    return text.contains(u'%') ? QString() : text; // with the name of its interface: of one cable
}

} // namespace

QStringList ownAddresses()
{
    ifaddrs *first = nullptr;
    if (::getifaddrs(&first) != 0)
        return {};
    const std::unique_ptr<ifaddrs, decltype(&::freeifaddrs)> all(first, &::freeifaddrs);
    QStringList addresses;
    for (const ifaddrs *one = all.get(); one != nullptr; one = one->ifa_next)
        if (const QString address = addressOf(*one); !address.isEmpty() && !addresses.contains(address))
            addresses.append(address);
    return addresses;
}

} // namespace codewheel
