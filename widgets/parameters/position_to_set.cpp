// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/position_to_set.h"

#include "catalog/protocol_rules.h"
#include "jobs/protocol.h"
#include "jobs/value_notes.h"
#include "jobs/values_to_write.h"
#include "vocabulary/sentence.h"

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
    const DeviceDescription &device = encoder.device();
    if (device.find(Parameter::preset))
        return protocolOf(device).narrowed(device, Parameter::preset, valuesOf(allKnown(encoder)),
                                           encoder.valueOptions());
    ParameterDescription position;
    position.parameter = Parameter::preset;
    position.maximum = protocolRules(device.profile).largestData();
    position.unit = Unit::steps;
    return position;
}

QString positionToSetText(const EncoderSession &encoder)
{
    return sentence(
        PositionToSet::tr("Sends %1 with this position; it holds at once, and costs an EEPROM write."),
        {protocolOf(encoder.device()).presetCommand()});
}

} // namespace codewheel
