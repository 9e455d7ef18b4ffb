// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/gateway/gateway_presets.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

struct GatewayPresetTexts
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::GatewayPreset)
};

} // namespace

std::vector<GatewayPreset> gatewayPresets()
{
    return {
        {GatewayPresetTexts::tr("High word first"),
         GatewayPresetTexts::tr("IN in input registers, OUT in holding registers, both from 0"),
         {}},
        {GatewayPresetTexts::tr("Low word first"),
         GatewayPresetTexts::tr(
             "The same, but the first register of each encoder is the low half of its word"),
         {{QStringLiteral("order"), QStringLiteral("low")}}},
        {GatewayPresetTexts::tr("Holding registers only"),
         GatewayPresetTexts::tr("IN from 0 and OUT from 512, read by function 3 and written by function 16"),
         {{QStringLiteral("in-area"), QStringLiteral("holding")},
          {QStringLiteral("out"), QStringLiteral("512")}}},
        {GatewayPresetTexts::tr("Holding registers, function 23"),
         GatewayPresetTexts::tr("The same, but OUT is written and IN is read in one transaction"),
         {{QStringLiteral("in-area"), QStringLiteral("holding")},
          {QStringLiteral("out"), QStringLiteral("512")},
          {QStringLiteral("write"), QStringLiteral("23")}}},
        {GatewayPresetTexts::tr("A training bus of Codewheel"),
         GatewayPresetTexts::tr(
             "As another Codewheel offers its training bus; the state of the ring is in register 8192"),
         {{QStringLiteral("status"), QStringLiteral("8192")},
          {QStringLiteral("run-bit"), QStringLiteral("5")},
          {QStringLiteral("fault-bits"), QStringLiteral("2+3+9")},
          {QStringLiteral("place"), QStringLiteral("8193")}}},
    };
}

} // namespace codewheel
