// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/call/json.h"

#include "cli/call/keys.h"
#include "vocabulary/hex.h"
#include "vocabulary/meaning_text.h"
#include "vocabulary/value_json.h"

namespace codewheel {
namespace {

constexpr NamedValue<Unit> unitKeys[] = {
    {"none", Unit::none},
    {"steps", Unit::steps},
    {"revolutions", Unit::revolutions},
    {"ten-minutes", Unit::tenMinutes},
    {"tenth-degree-celsius", Unit::tenthDegreeCelsius},
    {"micrometres", Unit::micrometres},
    {"tenth-hours", Unit::tenthHours},
    {"milliseconds", Unit::milliseconds},
};
constexpr NamedValue<Mode> modeKeys[] = {
    {"position", Mode::position},
    {"velocity", Mode::velocity},
    {"cam", Mode::cam},
};
constexpr NamedValue<Kept> keptKeys[] = {
    {"notKnown", Kept::notKnown},
    {"untilPowerOff", Kept::untilPowerOff},
    {"stored", Kept::stored},
};
constexpr NamedValue<EncoderState> stateKeys[] = {
    {"unknown", EncoderState::unknown},     {"notSeen", EncoderState::notSeen},
    {"operation", EncoderState::operation}, {"parameterization", EncoderState::parameterization},
    {"readOut", EncoderState::readOut},     {"service", EncoderState::service},
    {"error", EncoderState::error},         {"silent", EncoderState::silent},
    {"waiting", EncoderState::waiting},
};

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

QJsonObject valueJson(const ParameterDescription &parameter, const Value &value)
{
    QJsonObject json{{QStringLiteral("parameter"), parameterKey(parameter.parameter)},
                     {QStringLiteral("value"), valueToJson(value)},
                     {QStringLiteral("unit"), unitKey(parameter.unit)}};
    if (const Choice *choice = parameter.findChoice(value))
        json.insert(QStringLiteral("choice"), choice->key);
    return json;
}

QJsonValue textJson(const QString &text)
{
    return text.isEmpty() ? QJsonValue() : QJsonValue(text);
}

void addEvidence(QJsonObject &json, const std::optional<Known> &known)
{
    json.insert(QStringLiteral("evidence"), known ? QJsonValue(evidenceKey(known->evidence)) : QJsonValue());
    addKept(json, known);
}

void addKept(QJsonObject &json, const std::optional<Known> &known)
{
    if (known && known->kept != Kept::byItself)
        json.insert(QStringLiteral("kept"), keyOf(keptKeys, known->kept));
}

void addKnown(QJsonObject &json, const std::optional<Known> &known)
{
    json.insert(QStringLiteral("known"), known ? valueToJson(known->value) : QJsonValue());
    addEvidence(json, known);
}

void merge(QJsonObject &into, const QJsonObject &more)
{
    for (auto one = more.begin(); one != more.end(); ++one)
        into.insert(one.key(), one.value());
}

QString unitKey(Unit unit)
{
    return keyOf(unitKeys, unit);
}

QString evidenceKey(Evidence evidence)
{
    return keyOf(project_keys::evidences, evidence);
}

QJsonValue modeJson(std::optional<Mode> mode)
{
    return mode ? QJsonValue(keyOf(modeKeys, *mode)) : QJsonValue();
}

QString stateKey(EncoderState state)
{
    return keyOf(stateKeys, state);
}

} // namespace codewheel
