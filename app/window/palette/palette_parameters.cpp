// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/palette/palette_parameters.h"

#include "app/window/buses/device_choice.h"
#include "catalog/value_text.h"

#include <utility>

namespace codewheel {
namespace {

// "1.0  FRABA OCD-IB K3 · 8 192 steps"; without the value, if none is known.
QString whoseAndValue(const ShownEncoder &encoder, const ParameterDescription &parameter)
{
    QString text = QStringLiteral("%1  %2").arg(encoder.place().shown(), encoder.device().fullName());
    const auto known = encoder.known(parameter.parameter);
    if (!known)
        return text;
    text += QStringLiteral(" \u00B7 ") + valueText(parameter, known->value);
    const QString unit = unitText(parameter, known->value);
    return unit.isEmpty() ? text : QStringLiteral("%1 %2").arg(text, unit);
}

} // namespace

PaletteParameters::PaletteParameters(const DeviceChoice &choice, std::function<void(Parameter)> show)
    : m_choice(choice)
    , m_show(std::move(show))
{}

void PaletteParameters::begin()
{
    m_isGiven = false;
}

std::vector<PaletteEntry> PaletteParameters::next()
{
    std::vector<PaletteEntry> entries;
    const ShownEncoder &encoder = m_choice.encoder();
    if (std::exchange(m_isGiven, true) || !encoder.isThere())
        return entries;
    for (const ParameterDescription &each : encoder.device().parameters)
        entries.push_back({.kind = PaletteEntry::Kind::parameter,
                           .id = QStringLiteral("parameter:") + parameterKey(each.parameter),
                           .title = parameterName(each),
                           .context = whoseAndValue(encoder, each),
                           .words = parameterKey(each.parameter),
                           .run = [show = m_show, parameter = each.parameter] { show(parameter); }});
    return entries;
}

} // namespace codewheel
