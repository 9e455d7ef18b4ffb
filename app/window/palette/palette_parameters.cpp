// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/palette/palette_entries.h"
#include "catalog/value_text.h"
#include "widgets/models/shown_encoder.h"

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

std::vector<PaletteEntry> parameterEntries(const ShownEncoder &encoder,
                                           const std::function<void(Parameter)> &show)
{
    std::vector<PaletteEntry> entries;
    if (!encoder.isThere())
        return entries;
    for (const ParameterDescription &each : encoder.device().parameters)
        entries.push_back({.kind = PaletteEntry::Kind::parameter,
                           .id = QStringLiteral("parameter:") + parameterKey(each.parameter),
                           .title = parameterName(each),
                           .context = whoseAndValue(encoder, each),
                           .words = parameterKey(each.parameter),
                           .run = [show, parameter = each.parameter] { show(parameter); }});
    return entries;
}

} // namespace codewheel
