// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/canopen/traffic/can_services.h"

#include "kinds/canopen/protocol/cob_id.h"

namespace codewheel {
namespace {

struct CanServices
{
    Q_DECLARE_TR_FUNCTIONS(CanServices)
};

} // namespace

CanService canServiceOf(const CanFrame &frame)
{
    using Service = canopen::CobId::Service;
    const auto cob = frame.isExtended || frame.isError ? std::nullopt : canopen::CobId::of(frame.id);
    if (!cob)
        return CanService::other;
    switch (cob->service) {
    case Service::nmt:
        return CanService::nmt;
    case Service::sync:
    case Service::time:
        return CanService::sync;
    case Service::emcy:
        return CanService::emcy;
    case Service::tpdo:
    case Service::rpdo:
        return CanService::pdo;
    case Service::sdoAnswer:
    case Service::sdoRequest:
        return CanService::sdo;
    case Service::errorControl:
        return CanService::heartbeat;
    case Service::lssAnswer:
    case Service::lssRequest:
        break;
    }
    return CanService::lss;
}

QString canServiceText(CanService service)
{
    switch (service) {
    case CanService::nmt:
        return CanServices::tr("States of nodes (NMT)");
    case CanService::sync:
        return CanServices::tr("SYNC and TIME");
    case CanService::emcy:
        return CanServices::tr("Emergencies (EMCY)");
    case CanService::pdo:
        return CanServices::tr("Process data (PDO)");
    case CanService::sdo:
        return CanServices::tr("Transfers of objects (SDO)");
    case CanService::heartbeat:
        return CanServices::tr("Boot-up, heartbeat, guarding");
    case CanService::lss:
        return CanServices::tr("Numbers and rates (LSS)");
    case CanService::other:
        break;
    }
    return CanServices::tr("Other identifiers, errors");
}

} // namespace codewheel
