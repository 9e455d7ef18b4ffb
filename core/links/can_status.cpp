// SPDX-License-Identifier: GPL-3.0-or-later
#include "links/can_status.h"

#include "links/descriptor.h"

#include <array>
#include <cstring>
#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <sys/socket.h>
#include <sys/time.h>

namespace codewheel {
namespace {

// A value that lies anywhere in bytes; empty: they are too few.
template <typename T>
std::optional<T> valueIn(QByteArrayView bytes)
{
    T value{};
    if (bytes.size() < static_cast<qsizetype>(sizeof value))
        return std::nullopt;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
}

// What is in the attribute of this type; empty: there is none.
QByteArrayView attribute(QByteArrayView all, int type)
{
    while (const auto head = valueIn<rtattr>(all)) {
        if (head->rta_len < sizeof(rtattr) || head->rta_len > all.size())
            break;
        if ((head->rta_type & NLA_TYPE_MASK) == type)
            return all.first(head->rta_len).sliced(sizeof(rtattr));
        all = all.sliced(std::min<qsizetype>(RTA_ALIGN(head->rta_len), all.size()));
    }
    return {};
}

CanState stateOfKernel(std::uint32_t state)
{
    constexpr std::array states{CanState::active, CanState::warning, CanState::passive, CanState::busOff};
    return state < states.size() ? states[state] : CanState::notKnown;
}

struct LinkRequest
{
    nlmsghdr head{.nlmsg_len = sizeof(LinkRequest),
                  .nlmsg_type = RTM_GETLINK,
                  .nlmsg_flags = NLM_F_REQUEST,
                  .nlmsg_seq = 1,
                  .nlmsg_pid = 0};
    ifinfomsg interface {};
};

} // namespace

std::optional<CanStatus> canStatusOf(const QByteArray &answer)
{
    const auto head = valueIn<nlmsghdr>(answer);
    constexpr qsizetype before = NLMSG_SPACE(sizeof(ifinfomsg));
    if (!head || head->nlmsg_type != RTM_NEWLINK || head->nlmsg_len > answer.size() || answer.size() < before)
        return std::nullopt;
    const QByteArrayView info =
        attribute(QByteArrayView(answer).first(head->nlmsg_len).sliced(before), IFLA_LINKINFO);
    const QByteArrayView data = attribute(info, IFLA_INFO_DATA);
    const auto state = valueIn<std::uint32_t>(attribute(data, IFLA_CAN_STATE));
    if (attribute(info, IFLA_INFO_KIND) != QByteArrayView("can", 4) || !state) // with its NUL
        return std::nullopt;
    CanStatus status{.state = stateOfKernel(*state)};
    if (const auto timing = valueIn<can_bittiming>(attribute(data, IFLA_CAN_BITTIMING));
        timing && timing->bitrate != 0)
        status.rate = static_cast<int>(timing->bitrate);
    if (const auto mode = valueIn<can_ctrlmode>(attribute(data, IFLA_CAN_CTRLMODE)))
        status.listensOnly = (mode->flags & CAN_CTRLMODE_LISTENONLY) != 0;
    if (const auto errors = valueIn<can_berr_counter>(attribute(data, IFLA_CAN_BERR_COUNTER))) {
        status.transmitErrors = errors->txerr;
        status.receiveErrors = errors->rxerr;
    }
    return status;
}

std::optional<CanStatus> canStatus(const QString &interface)
{
    constexpr qsizetype room = 32'768; // libmnl and iproute2 have as much
    constexpr timeval longest{0, 100'000};
    LinkRequest request;
    request.interface.ifi_index = static_cast<int>(::if_nametoindex(interface.toLocal8Bit().constData()));
    const Descriptor socket(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE));
    if (request.interface.ifi_index == 0 || !socket)
        return std::nullopt;
    ::setsockopt(socket.get(), SOL_SOCKET, SO_RCVTIMEO, &longest, sizeof longest);
    if (::send(socket.get(), &request, sizeof request, 0) < 0)
        return std::nullopt;
    QByteArray answer(room, '\0');
    const ssize_t size = ::recv(socket.get(), answer.data(), static_cast<std::size_t>(answer.size()), 0);
    return size > 0 ? canStatusOf(answer.first(size)) : std::nullopt;
}

} // namespace codewheel
