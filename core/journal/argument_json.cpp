// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/argument_json.h"

#include "vocabulary/hex.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace codewheel {
namespace {

constexpr QLatin1String doubleKey("double");
constexpr QLatin1String wordKey("word");
constexpr QLatin1String parameterKeyName("parameter");

struct ToJson
{
    QJsonValue operator()(std::int64_t number) const { return QJsonValue(qint64{number}); }
    QJsonValue operator()(double number) const { return QJsonObject{{doubleKey, number}}; }
    QJsonValue operator()(Word word) const { return QJsonObject{{wordKey, hexWord(word)}}; }
    QJsonValue operator()(Parameter parameter) const
    {
        return QJsonObject{{parameterKeyName, parameterKey(parameter)}};
    }
    QJsonValue operator()(const QString &text) const { return text; }
};

std::optional<RefusalArgument> typedArgument(const QJsonObject &object)
{
    if (object.size() != 1)
        return std::nullopt;
    const QString key = object.begin().key();
    const QJsonValue value = object.begin().value();
    if (key == doubleKey && value.isDouble())
        return value.toDouble();
    if (key == wordKey)
        if (const auto word = parseHexWord(value.toString()))
            return *word;
    if (key == parameterKeyName)
        if (const auto parameter = parameterFromKey(value.toString()))
            return *parameter;
    return std::nullopt;
}

RefusalArgument argumentFromJson(const QJsonValue &value)
{
    if (value.isString())
        return value.toString();
    if (value.isDouble()) {
        const qint64 whole = value.toInteger();
        if (QJsonValue(whole) == value)
            return std::int64_t{whole};
        return value.toDouble();
    }
    if (value.isObject())
        if (const auto typed = typedArgument(value.toObject()))
            return *typed;
    const QString line = jsonLine(QJsonArray{value});
    return line.sliced(1, line.size() - 2);
}

} // namespace

QJsonArray argumentsToJson(const std::vector<RefusalArgument> &arguments)
{
    QJsonArray json;
    for (const RefusalArgument &argument : arguments)
        json.append(std::visit(ToJson(), argument));
    return json;
}

std::vector<RefusalArgument> argumentsFromJson(const QJsonArray &json)
{
    std::vector<RefusalArgument> arguments;
    for (const QJsonValue value : json)
        arguments.push_back(argumentFromJson(value));
    return arguments;
}

QString jsonLine(const QJsonArray &json)
{
    return QString::fromUtf8(QJsonDocument(json).toJson(QJsonDocument::Compact));
}

QString jsonLine(const QJsonObject &json)
{
    return QString::fromUtf8(QJsonDocument(json).toJson(QJsonDocument::Compact));
}

} // namespace codewheel
