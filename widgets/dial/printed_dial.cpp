// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/dial/printed_dial.h"

#include "catalog/value_text.h"
#include "vocabulary/encoder_session.h"
#include "widgets/dial/dial_panel.h"

namespace codewheel {
namespace {

QString withUnit(const QString &value, const QString &unit)
{
    return unit.isEmpty() ? value : value + QLatin1Char(' ') + unit;
}

} // namespace

PrintedView printedDial(const EncoderSession &encoder, PrintedPicture picture,
                        std::vector<std::pair<QString, QString>> values,
                        std::span<const Parameter> parameters)
{
    for (const Parameter parameter : parameters) {
        const ParameterDescription *description = encoder.device().find(parameter);
        const auto known = encoder.known(parameter);
        if (description != nullptr && known)
            values.emplace_back(parameterName(parameter),
                                withUnit(valueText(*description, known->value, encoder.valueOptions()),
                                         unitText(description->unit, known->value)));
    }
    return {.title = DialPanel::tr("Encoder"),
            .place = encoder.place(),
            .device = encoder.device().fullName(),
            .pictures = {std::move(picture)},
            .values = std::move(values)};
}

} // namespace codewheel
