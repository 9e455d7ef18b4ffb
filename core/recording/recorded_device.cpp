// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/recorded_device.h"

#include "catalog/device_description.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/value_json.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace codewheel {
namespace {

const QString deviceMember = QStringLiteral("device");
const QString nameMember = QStringLiteral("name");
const QString turnsMember = QStringLiteral("turns");
const QString stepsPerTurnMember = QStringLiteral("stepsPerTurn");
const QString parametersMember = QStringLiteral("parameters");

} // namespace

RecordedDevice recordedDevice(const EncoderSession &encoder)
{
    const DeviceDescription &device = encoder.device();
    RecordedDevice recorded{.key = device.key,
                            .name = device.fullName(),
                            .turns = device.physicalTurns,
                            .stepsPerTurn = device.physicalStepsPerTurn};
    for (const Parameter parameter : allParameters())
        if (const auto known = encoder.known(parameter))
            recorded.known.push_back({parameter, known->value});
    return recorded;
}

QByteArray toJson(const RecordedDevice &device)
{
    QJsonObject parameters;
    for (const ParameterValue &value : device.known)
        parameters.insert(parameterKey(value.parameter), valueToJson(value.value));
    return QJsonDocument(QJsonObject{{deviceMember, device.key},
                                     {nameMember, device.name},
                                     {turnsMember, device.turns},
                                     {stepsPerTurnMember, device.stepsPerTurn},
                                     {parametersMember, parameters}})
        .toJson(QJsonDocument::Compact);
}

RecordedDevice recordedDeviceFromJson(const QByteArray &json)
{
    const QJsonObject object = QJsonDocument::fromJson(json).object();
    RecordedDevice device{.key = object.value(deviceMember).toString(),
                          .name = object.value(nameMember).toString(),
                          .turns = std::max(object.value(turnsMember).toInt(), 0),
                          .stepsPerTurn = std::max(object.value(stepsPerTurnMember).toInt(), 0)};
    const QJsonObject parameters = object.value(parametersMember).toObject();
    for (const Parameter parameter : allParameters())
        if (const auto value = valueFromJson(parameters.value(parameterKey(parameter))))
            device.known.push_back({parameter, *value});
    return device;
}

} // namespace codewheel
