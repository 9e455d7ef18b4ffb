// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/protocol/kept_identifier.h"

#include "kinds/canopen/protocol/canopen_messages.h"
#include "kinds/canopen/protocol/cob_id.h"
#include "vocabulary/find_by.h"

namespace codewheel::canopen {
namespace {

using Service = CobId::Service;

constexpr std::uint32_t identifierIsOff = 0x8000'0000;
constexpr std::uint32_t identifierPart = 0x1FFF'FFFF;

struct ServiceRow
{
    SdoObject object;
    Service service;
    const char *name;
    int number = 0;
};
constexpr std::array serviceRows{
    ServiceRow{{0x1005, 0}, Service::sync, "SYNC"},      ServiceRow{{0x1014, 0}, Service::emcy, "EMCY"},
    ServiceRow{{0x1200, 1}, Service::sdoRequest, "SDO"}, ServiceRow{{0x1200, 2}, Service::sdoAnswer, "SDO"},
    ServiceRow{{0x1800, 1}, Service::tpdo, "TPDO1", 1},  ServiceRow{{0x1801, 1}, Service::tpdo, "TPDO2", 2},
    ServiceRow{{0x1802, 1}, Service::tpdo, "TPDO3", 3},  ServiceRow{{0x1803, 1}, Service::tpdo, "TPDO4", 4},
};

const ServiceRow *serviceRowOf(SdoObject object)
{
    return findBy(serviceRows, object, &ServiceRow::object);
}

bool isOfOtherNode(std::uint32_t identifier, int node)
{
    const auto cob = CobId::of(identifier);
    return cob && cob->service == Service::tpdo && cob->node != node;
}

} // namespace

QString KeptIdentifier::name() const
{
    const ServiceRow *row = serviceRowOf(object);
    return row == nullptr ? object.text()
                          : QStringLiteral("%1 (%2)").arg(object.text(), QString::fromLatin1(row->name));
}

Message KeptIdentifier::message() const
{
    return {.severity = Severity::attention,
            .id = CanopenMessageId::identifierKept,
            .arguments = {name(), Word{identifier}, Word{predefined}}};
}

std::optional<KeptIdentifier> keptIdentifier(SdoObject object, std::uint32_t told, int node)
{
    const ServiceRow *row = serviceRowOf(object);
    if (row == nullptr || (row->service != Service::sync && (told & identifierIsOff) != 0))
        return std::nullopt;
    const std::uint32_t identifier = told & identifierPart;
    const std::uint32_t predefined =
        CobId{.service = row->service, .node = node, .number = row->number}.identifier();
    const bool isPdo = row->service == Service::tpdo;
    if (identifier == predefined || (isPdo && !isOfOtherNode(identifier, node)))
        return std::nullopt;
    return KeptIdentifier{object, identifier, predefined};
}

} // namespace codewheel::canopen
