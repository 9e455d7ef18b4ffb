// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/kinds/canopen/object_argument.h"

#include "catalog/device_description.h"
#include "cli/bus/places.h"
#include "cli/call/keys.h"
#include "cli/call/texts.h"
#include "cli/kinds/canopen/canopen_trace.h"
#include "kinds/canopen/protocol/canopen_reach.h"
#include "vocabulary/hex.h"

#include <algorithm>

namespace codewheel {
namespace {

using canopen::ObjectType;

constexpr NamedValue<ObjectType> objectTypeKeys[] = {
    {"u8", ObjectType::u8},   {"u16", ObjectType::u16}, {"u32", ObjectType::u32},   {"i8", ObjectType::i8},
    {"i16", ObjectType::i16}, {"i32", ObjectType::i32}, {"text", ObjectType::text},
};

constexpr std::size_t mostOctetsOfNumber = 8;
constexpr std::size_t mostOctetsOfUsualNumber = 4;

std::optional<canopen::SdoObject> objectFrom(const QString &typed)
{
    const auto digits = [](const QString &text, bool isHex) -> std::optional<std::int64_t> {
        if (text.startsWith(QStringLiteral("0x"), Qt::CaseInsensitive))
            return parseHexDigits(text.sliced(2), 4);
        if (text.endsWith(u'h', Qt::CaseInsensitive))
            return parseHexDigits(text.chopped(1), 4);
        return isHex ? parseHexDigits(text, 4) : parseNumber(text);
    };
    const qsizetype colon = typed.indexOf(u':');
    const auto index = digits(typed.left(colon), true);
    const auto sub = colon < 0 ? std::optional<std::int64_t>(0) : digits(typed.sliced(colon + 1), false);
    if (!index || !sub || *index == 0 || *sub > 0xFF)
        return std::nullopt;
    return canopen::SdoObject{static_cast<std::uint16_t>(*index), static_cast<std::uint8_t>(*sub)};
}

Checked<std::optional<ObjectType>> typeOf(const Call &call)
{
    const auto typed = call.arguments.value("--type");
    if (!typed)
        return std::optional<ObjectType>();
    QStringList keys;
    for (const auto &one : objectTypeKeys) {
        if (*typed == QLatin1String(one.name))
            return std::optional(one.value);
        keys << QString::fromLatin1(one.name);
    }
    return badInput("optionNotAllowed", CommandLine::tr("%1 cannot be \"%2\". Allowed are: %3."),
                    {QStringLiteral("--type"), *typed, keys.join(QStringLiteral(", "))});
}

// Of which it is the whole, no bit.
const ParameterDescription *describedAs(const DeviceDescription *device, canopen::SdoObject object)
{
    if (device != nullptr)
        for (const ParameterDescription &parameter : device->parameters)
            if (const CanopenReach *reach = canopenReach(parameter);
                reach != nullptr && reach->object == object && !reach->bit)
                return &parameter;
    return nullptr;
}

// That are shown or typed where no type is given: as many as a text has, none of them a control.
bool isReadable(std::span<const std::uint8_t> octets)
{
    return octets.size() > mostOctetsOfUsualNumber && std::ranges::all_of(octets, [](std::uint8_t octet) {
               return octet == 0 || (octet >= 0x20 && octet != 0x7F);
           });
}

// Empty: its octets are all that can be told.
std::optional<Value> valueIn(const ObjectArgument &argument, std::span<const std::uint8_t> octets,
                             bool isSizeTold)
{
    if (argument.type)
        return canopen::objectValue(*argument.type, octets, isSizeTold);
    if (isReadable(octets))
        return canopen::objectValue(ObjectType::text, octets);
    if (!isSizeTold || octets.empty() || octets.size() > mostOctetsOfNumber)
        return std::nullopt;
    return canopen::objectValue(ObjectType::u32, octets);
}

bool fits(std::int64_t number, std::size_t width, bool isSigned)
{
    const unsigned bits = static_cast<unsigned>(8 * width);
    const std::int64_t most = isSigned ? (std::int64_t{1} << (bits - 1)) - 1 : (std::int64_t{1} << bits) - 1;
    return number <= most && number >= (isSigned ? -most - 1 : 0);
}

std::optional<std::int64_t> signedNumber(const QString &typed)
{
    if (!typed.startsWith(u'-'))
        return parseNumber(typed);
    const auto size = parseNumber(typed.sliced(1));
    return size ? std::optional(-*size) : std::nullopt;
}

} // namespace

Checked<CanopenAccess *> canBusMeant(const Call &call)
{
    return busMeant(call, QString::fromLatin1(canopenKind)).map([](BusAccess *bus) {
        return static_cast<CanopenAccess *>(bus); // of its kind
    });
}

Checked<NodeMeant> nodeMeant(const Call &call, const QString &typed)
{
    const auto place = placeMeant(call, call.project, typed);
    if (!place)
        return tl::unexpected(place.error());
    BusAccess &bus = call.busOf(*place);
    if (bus.kind() != QLatin1String(canopenKind))
        return badInput("notANode", CommandLine::tr("%1 is no node on CANopen. Those are written as can:5."),
                        {typed});
    return NodeMeant{static_cast<CanopenAccess *>(&bus), *place};
}

Checked<ObjectArgument> objectArgument(const Call &call, const QString &typed,
                                       const DeviceDescription *device)
{
    const qsizetype equals = typed.indexOf(u'=');
    const auto object = objectFrom(typed.left(equals));
    if (!object)
        return badInput("objectWrong",
                        CommandLine::tr("\"%1\" is no object. Write index, in hexadecimal, and subindex, as "
                                        "6004 or 1018:4."),
                        {typed.left(equals)});
    const auto type = typeOf(call);
    if (!type)
        return tl::unexpected(type.error());
    ObjectArgument argument{.object = *object, .type = *type, .parameter = describedAs(device, *object)};
    if (equals >= 0)
        argument.value = typed.sliced(equals + 1);
    if (!argument.type && argument.parameter != nullptr)
        argument.type = canopenReach(*argument.parameter)->type;
    return argument;
}

Checked<std::vector<std::uint8_t>> octetsFor(const ObjectArgument &argument, std::size_t width)
{
    const QString text = argument.value.value_or(QString());
    const bool isSignature = argument.object.index == 0x1010 || argument.object.index == 0x1011;
    const auto number = signedNumber(text);
    if (argument.type == ObjectType::text || (isSignature && !number && text.size() == 4))
        return canopen::octetsOf(Value(text), 0);
    if (width == 0 && argument.type)
        width = canopen::widthOf(*argument.type);
    if (width == 0 || width > mostOctetsOfUsualNumber)
        return badInput("objectTypeMissing",
                        CommandLine::tr("How wide %1 is, it does not tell. Give its type, as --type u32."),
                        {argument.object.text()});
    const bool isSigned = argument.type && canopen::isSigned(*argument.type);
    if (!number || !fits(*number, width, isSigned || *number < 0))
        return badInput("objectValueWrong",
                        CommandLine::tr("%1 cannot become \"%2\": it takes a number of %3 bits, in decimal, "
                                        "or in hexadecimal as 1388h."),
                        {argument.object.text(), text, static_cast<std::int64_t>(8 * width)});
    return canopen::octetsOf(*number, width);
}

QString objectValueText(const ObjectArgument &argument, std::span<const std::uint8_t> octets, bool isSizeTold)
{
    const auto value = valueIn(argument, octets, isSizeTold);
    if (!value)
        return octetsText(octets);
    if (value->isText())
        return u'"' + value->toString() + u'"';
    const std::size_t size = isSizeTold || !argument.type ? octets.size() : canopen::widthOf(*argument.type);
    const auto bits = static_cast<quint64>(value->number());
    const quint64 shown = size < mostOctetsOfNumber ? bits & ((quint64{1} << (8 * size)) - 1) : bits;
    return QStringLiteral("%1h, %2").arg(
        QStringLiteral("%1").arg(shown, static_cast<int>(2 * size), 16, QLatin1Char('0')).toUpper(),
        value->toString());
}

QJsonObject objectJson(const ObjectArgument &argument)
{
    return {{QStringLiteral("index"),
             QStringLiteral("%1").arg(argument.object.index, 4, 16, QLatin1Char('0')).toUpper()},
            {QStringLiteral("sub"), argument.object.sub},
            {QStringLiteral("parameter"), argument.parameter != nullptr
                                              ? QJsonValue(parameterKey(argument.parameter->parameter))
                                              : QJsonValue()},
            {QStringLiteral("type"),
             argument.type ? QJsonValue(keyOf(objectTypeKeys, *argument.type)) : QJsonValue()}};
}

QJsonObject objectValueJson(const ObjectArgument &argument, std::span<const std::uint8_t> octets,
                            bool isSizeTold)
{
    const auto value = valueIn(argument, octets, isSizeTold);
    const QJsonValue told = !value            ? QJsonValue()
                            : value->isText() ? QJsonValue(value->toString())
                                              : QJsonValue(static_cast<qint64>(value->number()));
    return {{QStringLiteral("value"), told}, {QStringLiteral("octets"), octetsText(octets)}};
}

} // namespace codewheel
