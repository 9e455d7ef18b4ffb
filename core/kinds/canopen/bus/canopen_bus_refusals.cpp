// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/bus/canopen_bus_refusals.h"

#include "kinds/canopen/bus/other_master.h"
#include "vocabulary/enumeration_rows.h"
#include "vocabulary/refusal_text.h"

#include <QtGlobal>

#include <array>

namespace codewheel {
namespace {

constexpr auto canopenBusRefusalRows = std::to_array<SentenceRow>({
    {CanopenBusRefusalId::nodeNumberWrong, "canopenNodeNumberWrong",
     QT_TRANSLATE_NOOP("Refusal", "\"%1\" is not a node on CANopen. Nodes are numbered from 1 to 127.")},
    {CanopenBusRefusalId::otherMaster, "canopenOtherMaster",
     QT_TRANSLATE_NOOP("Refusal", "Another master is at work on this bus (heard: %1), and what is sent may "
                                  "disturb it. Nothing was sent: agree to that first.")},
    {CanopenBusRefusalId::searching, "canopenSearching",
     QT_TRANSLATE_NOOP("Refusal",
                       "The bus is being searched for nodes. Wait for the end of it, or cancel it.")},
    {CanopenBusRefusalId::closed, "canopenBusClosed",
     QT_TRANSLATE_NOOP("Refusal", "The CAN bus is not open. Connect it first.")},
    {CanopenBusRefusalId::onlyJ1939, "onlyJ1939",
     QT_TRANSLATE_NOOP(
         "Refusal", "Only frames of 29 bits are heard: what is there speaks J1939, not CANopen, and nothing "
                    "is sent to it. Another variant of the device is needed.")},
});

static_assert(areInOrder(canopenBusRefusalRows, &SentenceRow::id, CanopenBusRefusalId::onlyJ1939));

QString canopenBusRefusalText(const Refusal &refusal)
{
    if (refusal.id == CanopenBusRefusalId::otherMaster && !refusal.arguments.empty())
        return rowText(refusal, {OtherMaster::textOf(refusal.arguments.front())});
    return rowText(refusal);
}

} // namespace

constinit const RefusalFamily canopenBusRefusals{canopenBusRefusalRows, canopenBusRefusalText};

} // namespace codewheel
