// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/canopen/eds/device_description_json.h"

#include "kinds/canopen/protocol/canopen_reach.h"
#include "vocabulary/hex.h"

#include <QJsonArray>

#include <algorithm>
#include <set>

namespace codewheel::canopen {
namespace {

constexpr qsizetype mostFurther = 1'000; // parameters

struct TypeRange
{
    std::int64_t minimum;
    std::int64_t maximum;
};

// What a parameter on CANopen can be: a number of up to 32 bits.
std::optional<TypeRange> typeRange(DataType type)
{
    constexpr int mostBits = 32;
    const DataTypeFacts &facts = factsOf(type);
    if (!isNumber(type) || facts.bits > mostBits)
        return std::nullopt;
    if (facts.form == DataTypeFacts::Form::isSigned)
        return TypeRange{-(std::int64_t{1} << (facts.bits - 1)), (std::int64_t{1} << (facts.bits - 1)) - 1};
    return TypeRange{0, (std::int64_t{1} << facts.bits) - 1};
}

// The type of a parameter that has room for it.
QString parameterType(DataType type)
{
    switch (type) {
    case DataType::boolean:
        return QStringLiteral("u8");
    case DataType::u24:
        return QStringLiteral("u32");
    case DataType::i24:
        return QStringLiteral("i32");
    default:
        return dataTypeKey(type);
    }
}

std::optional<SdoObject> objectNamed(const QString &text)
{
    constexpr int hexadecimal = 16;
    bool isIndex = false;
    const ushort index = text.section(u':', 0, 0).toUShort(&isIndex, hexadecimal);
    const ushort sub = text.section(u':', 1, 1).toUShort();
    return isIndex ? std::optional(SdoObject{index, static_cast<std::uint8_t>(sub)}) : std::nullopt;
}

std::optional<std::int64_t> plainNumber(const std::optional<FileValue> &value)
{
    return value && !value->addsNode && value->number() != nullptr ? std::optional(*value->number())
                                                                   : std::nullopt;
}

qint64 jsonNumber(const QJsonObject &row, const char *key)
{
    return row[QLatin1String(key)].toInteger();
}

// The smaller of both ranges, unless nothing is left of them.
void narrow(QJsonObject &row, TypeRange by)
{
    const qint64 minimum = std::max<qint64>(jsonNumber(row, "minimum"), by.minimum);
    const qint64 maximum = std::min<qint64>(jsonNumber(row, "maximum"), by.maximum);
    if (minimum > maximum)
        return;
    row[u"minimum"] = minimum;
    row[u"maximum"] = maximum;
}

void tellFactory(QJsonObject &row, const FileObject &object)
{
    auto factory = plainNumber(object.factory);
    if (factory && row.contains(u"bit"))
        factory = *factory >> jsonNumber(row, "bit") & 1;
    if (factory && *factory >= jsonNumber(row, "minimum") && *factory <= jsonNumber(row, "maximum"))
        row[u"factory"] = static_cast<qint64>(*factory);
}

void tellNumbers(QJsonObject &row, const FileObject &object, TypeRange range)
{
    if (!row.contains(u"bit")) {
        narrow(row, range);
        narrow(row, {plainNumber(object.minimum).value_or(range.minimum),
                     plainNumber(object.maximum).value_or(range.maximum)});
    }
    tellFactory(row, object);
}

// A row of the generic description, as this device has it.
QJsonObject rowFor(QJsonObject row, const FileObject &object)
{
    const auto range = object.type ? typeRange(*object.type) : std::nullopt;
    if (range && row.value(u"type") != QStringLiteral("text")) {
        row[u"type"] = parameterType(*object.type);
        tellNumbers(row, object, *range);
    }
    if (row.value(u"access") == QStringLiteral("rw") && object.access && !object.canBeWritten())
        row[u"access"] = QStringLiteral("ro");
    return row;
}

// An object of which only the file tells.
QJsonObject furtherRow(const FileObject &object, TypeRange range)
{
    const QString key =
        object.object.sub == 0 ? objectName(object.object).section(u':', 0, 0) : objectName(object.object);
    QJsonObject row{{QStringLiteral("parameter"), key.toLower()},
                    {QStringLiteral("name"), object.name},
                    {QStringLiteral("object"), key.toLower()},
                    {QStringLiteral("type"), parameterType(*object.type)},
                    {QStringLiteral("access"), QStringLiteral("ro")},
                    {QStringLiteral("minimum"), static_cast<qint64>(range.minimum)},
                    {QStringLiteral("maximum"), static_cast<qint64>(range.maximum)},
                    {QStringLiteral("detail"), true}};
    tellFactory(row, object);
    return row;
}

// Counts of subindexes; what the driver reads by itself: position and cams.
bool isReadAnyway(const DeviceFile &file, SdoObject object)
{
    const bool isCount = object.sub == 0 && file.find({object.index, 1}) != nullptr;
    const bool isCam = object.index >= 0x6300 && object.index < 0x6340;
    return isCount || isCam || object.index == 0x6004 || object.index == 0x6020;
}

bool isFurther(const DeviceFile &file, const FileObject &object)
{
    constexpr std::uint16_t firstOfMakers = 0x2000;
    return object.object.index >= firstOfMakers && object.access != FileAccess::writeOnly && object.type &&
           typeRange(*object.type) && !isReadAnyway(file, object.object);
}

QJsonArray parametersOf(const DeviceFile &file, const QJsonArray &generic)
{
    QJsonArray rows;
    std::set<std::pair<std::uint16_t, std::uint8_t>> known;
    for (const QJsonValue &value : generic) {
        const QJsonObject row = value.toObject();
        const auto named = objectNamed(row[u"object"].toString());
        const FileObject *object = named ? file.find(*named) : nullptr;
        if (object == nullptr)
            continue;
        known.insert(orderOf(*named));
        rows.append(rowFor(row, *object));
    }
    const qsizetype most = rows.size() + mostFurther;
    for (const FileObject &object : file.objects)
        if (isFurther(file, object) && !known.contains(orderOf(object.object)) && rows.size() < most)
            rows.append(furtherRow(object, *typeRange(*object.type)));
    return rows;
}

bool hasObject(const DeviceFile &file, std::uint16_t index, std::uint8_t sub)
{
    return file.find({index, sub}) != nullptr;
}

QJsonObject capabilitiesOf(const DeviceFile &file, QJsonObject can)
{
    if (!hasObject(file, 0x6003, 0)) {
        can[u"presets"] = false;
        can[u"presetNeedsValue"] = false;
    }
    if (!hasObject(file, 0x1011, 1))
        can[u"resets"] = false;
    if (!hasObject(file, 0x6300, 1))
        can[u"cams"] = false;
    return can;
}

QString vendorText(const FileIdentity &identity)
{
    if (!identity.vendorName.isEmpty())
        return identity.vendorName;
    return identity.vendor ? QStringLiteral("Vendor %1").arg(hexNumber(*identity.vendor))
                           : QStringLiteral("EDS");
}

QString productText(const FileIdentity &identity)
{
    for (const QString &text : {identity.productName, identity.orderCode})
        if (!text.isEmpty() && text != QStringLiteral("0"))
            return text;
    return identity.product ? QStringLiteral("product %1").arg(hexNumber(*identity.product))
                            : QStringLiteral("CANopen encoder");
}

QJsonObject notesOn(const QString &from)
{
    return {
        {QStringLiteral("en"),
         QStringLiteral("Made from %1. Assumed, as of all makes: what is written acts at once and is lost "
                        "without supply until it is stored (1010h:1), the preset too. Objects of the "
                        "maker are only read.")
             .arg(from)},
        {QStringLiteral("de"),
         QStringLiteral("Aus %1 gemacht. Angenommen, wie bei allen Herstellern: Was geschrieben wird, wirkt "
                        "sofort und geht ohne Versorgung verloren, bis es gespeichert wird (1010h:1), auch "
                        "der Preset. Objekte des Herstellers werden nur gelesen.")
             .arg(from)}};
}

} // namespace

std::optional<std::uint32_t> deviceTypeIn(const DeviceFile &file)
{
    const FileObject *object = file.find({0x1000, 0});
    const auto type = object != nullptr ? plainNumber(object->valueOrFactory()) : std::nullopt;
    return type && *type != 0 ? std::optional(static_cast<std::uint32_t>(*type)) : std::nullopt;
}

QString descriptionKeyOf(const FileIdentity &identity)
{
    QString key;
    for (const QChar letter : vendorText(identity) + u' ' + productText(identity)) {
        const QChar small = letter.toLower();
        const bool isKept = (small >= u'a' && small <= u'z') || (small >= u'0' && small <= u'9');
        if (isKept)
            key += small;
        else if (!key.isEmpty() && !key.endsWith(u'-'))
            key += u'-';
    }
    while (key.endsWith(u'-'))
        key.chop(1);
    return key.isEmpty() ? QStringLiteral("canopen-device") : key;
}

QJsonObject descriptionOf(const DeviceFile &file, QJsonObject generic, const QString &key,
                          const QString &from)
{
    const FileIdentity &identity = file.identity;
    generic[u"key"] = key;
    generic[u"vendor"] = vendorText(identity);
    generic[u"name"] = productText(identity);
    const QString version = file.fileVersion.isEmpty() ? QString() : QStringLiteral(", ") + file.fileVersion;
    generic[u"manual"] = from + version;
    generic[u"notes"] = notesOn(from);
    const std::pair<const char *, std::optional<std::uint32_t>> numbers[] = {
        {"vendorNumber", identity.vendor},
        {"productNumber", identity.product},
        {"revisionNumber", identity.revision}};
    for (const auto &[name, number] : numbers)
        if (number)
            generic[QLatin1String(name)] = hexNumber(*number);
    generic[u"parameters"] = parametersOf(file, generic[u"parameters"].toArray());
    generic[u"capabilities"] = capabilitiesOf(file, generic[u"capabilities"].toObject());
    return generic;
}

} // namespace codewheel::canopen
