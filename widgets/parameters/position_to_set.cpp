// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/position_to_set.h"

#include "drivers/esc_values.h"
#include "drivers/values_to_write.h"
#include "widgets/models/device_traits.h"
#include "words/la66_word.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

struct PositionToSet
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::PositionToSet)
};

} // namespace

ParameterDescription positionToSet(const EncoderSession &encoder)
{
    if (isOnLine(encoder.device())) {
        ParameterValues known;
        for (const Known &one : allKnown(encoder))
            known.push_back({one.parameter, one.value});
        return escNarrowed(encoder.device(), Parameter::preset, known);
    }
    ParameterDescription position;
    position.parameter = Parameter::preset;
    position.maximum = la66::dataMask;
    position.unit = Unit::steps;
    return position;
}

QString positionToSetText(const EncoderSession &encoder)
{
    return isOnLine(encoder.device())
               ? PositionToSet::tr(
                     "Sends GP with this position; it holds at once, and costs an EEPROM write.")
               : PositionToSet::tr(
                     "Sends service 6 with this position; it holds at once, and costs an EEPROM write.");
}

} // namespace codewheel
