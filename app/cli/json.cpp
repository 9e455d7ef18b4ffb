// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/json.h"

#include "encoder/hex.h"
#include "encoder/meaning_text.h"

namespace codewheel {
namespace {

struct ArgumentJson
{
    QJsonValue operator()(std::int64_t number) const { return static_cast<qint64>(number); }
    QJsonValue operator()(double number) const { return number; }
    QJsonValue operator()(Word word) const { return hexWord(word); }
    QJsonValue operator()(Parameter parameter) const { return parameterKey(parameter); }
    QJsonValue operator()(const QString &text) const { return text; }
};

} // namespace

QJsonValue wordJson(Word word)
{
    return hexWord(word);
}

QJsonValue numberJson(std::optional<std::int64_t> number)
{
    return number ? QJsonValue(static_cast<qint64>(*number)) : QJsonValue();
}

QJsonValue knownJson(std::int64_t number)
{
    return numberJson(number == 0 ? std::nullopt : std::optional(number));
}

QJsonValue millimetresJson(std::optional<std::int64_t> position, const std::optional<RodScale> &scale)
{
    return position && scale ? QJsonValue(scale->millimetres(*position)) : QJsonValue();
}

QJsonArray meaningsJson(const Explanation &explanation)
{
    QJsonArray meanings;
    for (const Meaning &meaning : explanation) {
        QJsonArray numbers;
        for (const std::int64_t number : meaning.number)
            numbers.append(static_cast<qint64>(number));
        meanings.append(QJsonObject{{QStringLiteral("id"), meaningKey(meaning.id)},
                                    {QStringLiteral("numbers"), numbers}});
    }
    return meanings;
}

QJsonValue participantJson(const Participant *participant)
{
    if (participant == nullptr)
        return {};
    const QString &key = participant->deviceKey;
    return QJsonObject{{QStringLiteral("place"), participant->number.toString()},
                       {QStringLiteral("idCode"), static_cast<int>(participant->idCode)},
                       {QStringLiteral("deviceCode"), static_cast<int>(participant->deviceCode)},
                       {QStringLiteral("inWords"), participant->inWords},
                       {QStringLiteral("outWords"), participant->outWords},
                       {QStringLiteral("level"), participant->level},
                       {QStringLiteral("device"), key.isEmpty() ? QJsonValue() : QJsonValue(key)}};
}

QJsonObject errorJson(const Complaint &complaint)
{
    return {{QStringLiteral("key"), complaint.key},
            {QStringLiteral("arguments"), argumentsJson(complaint.arguments)}};
}

QJsonArray argumentsJson(const std::vector<RefusalArgument> &arguments)
{
    QJsonArray json;
    for (const RefusalArgument &argument : arguments)
        json.append(std::visit(ArgumentJson(), argument));
    return json;
}

QJsonObject valueJson(const ParameterDescription &parameter, std::int64_t value)
{
    QJsonObject json{{QStringLiteral("parameter"), parameterKey(parameter.parameter)},
                     {QStringLiteral("value"), static_cast<qint64>(value)},
                     {QStringLiteral("unit"), unitKey(parameter.unit)}};
    if (const Choice *choice = parameter.findChoice(value))
        json.insert(QStringLiteral("choice"), choice->key);
    return json;
}

void merge(QJsonObject &into, const QJsonObject &more)
{
    for (auto one = more.begin(); one != more.end(); ++one)
        into.insert(one.key(), one.value());
}

QString unitKey(Unit unit)
{
    switch (unit) {
    case Unit::none:
        break;
    case Unit::steps:
        return QStringLiteral("steps");
    case Unit::revolutions:
        return QStringLiteral("revolutions");
    case Unit::tenMinutes:
        return QStringLiteral("ten-minutes");
    case Unit::tenthDegreeCelsius:
        return QStringLiteral("tenth-degree-celsius");
    case Unit::micrometres:
        return QStringLiteral("micrometres");
    case Unit::tenthHours:
        return QStringLiteral("tenth-hours");
    }
    return QStringLiteral("none");
}

QString evidenceKey(Evidence evidence)
{
    switch (evidence) {
    case Evidence::read:
        return QStringLiteral("read");
    case Evidence::echoed:
        return QStringLiteral("echoed");
    case Evidence::told:
        break;
    }
    return QStringLiteral("told");
}

QJsonValue modeJson(std::optional<Mode> mode)
{
    if (!mode)
        return {};
    switch (*mode) {
    case Mode::velocity:
        return QStringLiteral("velocity");
    case Mode::cam:
        return QStringLiteral("cam");
    case Mode::position:
        break;
    }
    return QStringLiteral("position");
}

QString stateKey(EncoderState state)
{
    switch (state) {
    case EncoderState::notSeen:
        return QStringLiteral("notSeen");
    case EncoderState::operation:
        return QStringLiteral("operation");
    case EncoderState::parameterization:
        return QStringLiteral("parameterization");
    case EncoderState::readOut:
        return QStringLiteral("readOut");
    case EncoderState::service:
        return QStringLiteral("service");
    case EncoderState::error:
        return QStringLiteral("error");
    case EncoderState::silent:
        return QStringLiteral("silent");
    case EncoderState::unknown:
        break;
    }
    return QStringLiteral("unknown");
}

} // namespace codewheel
