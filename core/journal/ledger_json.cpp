// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal/ledger_json.h"

#include "catalog/strict_json.h"
#include "journal/journal_texts.h"
#include "vocabulary/value_json.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <limits>

namespace codewheel {
namespace {

constexpr char recordsFormat[] = "codewheel-ledger";
constexpr std::int64_t recordsVersion = 2; // can be read as well: 1, without computer and user
constexpr int mostWritesOfEntry = 1'000'000;

constexpr QLatin1String parameterMember("parameter");
constexpr QLatin1String valueMember("value");
constexpr QLatin1String evidenceMember("evidence");
constexpr QLatin1String atMember("at");

constexpr std::array countedByKeys{std::pair{CountedBy::serialNumber, QLatin1String("serial-number")},
                                   std::pair{CountedBy::labelSerialNumber, QLatin1String("label")},
                                   std::pair{CountedBy::place, QLatin1String("place")}};
constexpr std::array evidenceKeys{std::pair{Evidence::read, QLatin1String("read")},
                                  std::pair{Evidence::echoed, QLatin1String("echoed")},
                                  std::pair{Evidence::told, QLatin1String("told")}};

template <typename Pairs, typename Id>
QString keyIn(const Pairs &pairs, Id id)
{
    const auto found = std::ranges::find(pairs, id, [](const auto &pair) { return pair.first; });
    return found == pairs.end() ? QString() : found->second;
}

template <typename Id, std::size_t size>
std::optional<Id> idIn(const std::array<std::pair<Id, QLatin1String>, size> &pairs, const QString &key)
{
    const auto found = std::ranges::find_if(pairs, [&](const auto &pair) { return pair.second == key; });
    return found == pairs.end() ? std::nullopt : std::optional(found->first);
}

QJsonObject toJson(const Ledger::Record &record)
{
    const Ledger::Entry &entry = record.entry;
    return {{QStringLiteral("id"), record.origin},
            {atMember, entry.at.toUTC().toString(Qt::ISODateWithMs)},
            {QStringLiteral("identity"), entry.identity},
            {QStringLiteral("countedBy"), countedByKey(entry.by)},
            {QStringLiteral("bus"), entry.place.bus.number},
            {QStringLiteral("place"), entry.place.toString()},
            {QStringLiteral("device"), entry.device},
            {QStringLiteral("computer"), entry.writer.computer},
            {QStringLiteral("user"), entry.writer.user},
            {QStringLiteral("planned"), entry.planned},
            {QStringLiteral("writes"), entry.writes},
            {QStringLiteral("settled"), entry.settled},
            {QStringLiteral("before"), valuesToJson(entry.before)},
            {QStringLiteral("written"), valuesToJson(entry.written)}};
}

std::vector<Ledger::Value> valuesOf(const JsonObject &json, const char *key,
                                    std::initializer_list<const char *> allowed)
{
    std::vector<Ledger::Value> values;
    for (const JsonObject &one : json.array(key, allowed))
        if (const auto parameter = parameterFromKey(one.text("parameter")))
            values.push_back({*parameter, one.number("value"),
                              idIn(evidenceKeys, one.freeText("evidence")).value_or(Evidence::told),
                              QDateTime::fromString(one.freeText("at"), Qt::ISODateWithMs)});
    return values;
}

// Files from before buses were told apart hold only the place.
Place placeOf(const JsonObject &json)
{
    const auto place = Place::parse(json.freeText("place"));
    if (!place || !json.has("bus"))
        return place.value_or(Place());
    return {{static_cast<int>(json.number("bus", 1, std::numeric_limits<int>::max()))}, place->node};
}

Ledger::Record recordOf(const JsonObject &json)
{
    Ledger::Record record{.origin = json.text("id")};
    Ledger::Entry &entry = record.entry;
    entry.at = QDateTime::fromString(json.text("at"), Qt::ISODateWithMs);
    if (!entry.at.isValid())
        json.report("at", Journal::tr("This is not a time such as 2026-03-01T13:00:00.000Z."));
    entry.identity = json.text("identity");
    const auto by = countedByFromKey(json.text("countedBy"));
    if (!by)
        json.reportUnknownName("countedBy", json.text("countedBy"),
                               {countedByKey(CountedBy::serialNumber),
                                countedByKey(CountedBy::labelSerialNumber), countedByKey(CountedBy::place)});
    entry.by = by.value_or(CountedBy::place);
    entry.place = placeOf(json);
    entry.device = json.freeText("device");
    if (json.has("computer"))
        entry.writer = {json.freeText("computer"), json.freeText("user")};
    entry.planned = static_cast<int>(json.number("planned", 0, mostWritesOfEntry));
    entry.writes = static_cast<int>(json.number("writes", 0, mostWritesOfEntry));
    entry.settled = json.flag("settled");
    entry.before = valuesOf(json, "before", {"parameter", "value", "evidence", "at"});
    for (const Ledger::Value &value : valuesOf(json, "written", {"parameter", "value"}))
        entry.written.push_back({value.parameter, value.value});
    return record;
}

QString ledgerFaultText(const Catalog::Fault &fault)
{
    return fault.key.isEmpty()
               ? Journal::tr("Line %1: %2").arg(QString::number(fault.line), fault.reason)
               : Journal::tr("Line %1, %2: %3").arg(QString::number(fault.line), fault.key, fault.reason);
}

} // namespace

QString countedByKey(CountedBy by)
{
    return keyIn(countedByKeys, by);
}

std::optional<CountedBy> countedByFromKey(const QString &key)
{
    return idIn(countedByKeys, key);
}

QJsonArray valuesToJson(const std::vector<Ledger::Value> &values)
{
    QJsonArray json;
    for (const Ledger::Value &value : values)
        json.append(QJsonObject{{parameterMember, parameterKey(value.parameter)},
                                {valueMember, valueToJson(value.value)},
                                {evidenceMember, keyIn(evidenceKeys, value.evidence)},
                                {atMember, value.at.toUTC().toString(Qt::ISODateWithMs)}});
    return json;
}

QJsonArray valuesToJson(const ParameterValues &values)
{
    QJsonArray json;
    for (const ParameterValue &value : values)
        json.append(QJsonObject{{parameterMember, parameterKey(value.parameter)},
                                {valueMember, valueToJson(value.value)}});
    return json;
}

std::vector<Ledger::Value> ledgerValues(const QJsonArray &json)
{
    std::vector<Ledger::Value> values;
    for (const QJsonValue element : json) {
        const QJsonObject one = element.toObject();
        const auto parameter = parameterFromKey(one.value(parameterMember).toString());
        const auto value = valueFromJson(one.value(valueMember));
        if (parameter && value)
            values.push_back(
                {*parameter, *value,
                 idIn(evidenceKeys, one.value(evidenceMember).toString()).value_or(Evidence::told),
                 QDateTime::fromString(one.value(atMember).toString(), Qt::ISODateWithMs)});
    }
    return values;
}

QByteArray recordsToJson(const std::vector<Ledger::Record> &records, bool inOneLine)
{
    QJsonArray entries;
    for (const Ledger::Record &record : records)
        entries.append(toJson(record));
    return QJsonDocument(QJsonObject{{QStringLiteral("format"), QLatin1String(recordsFormat)},
                                     {QStringLiteral("version"), qint64{recordsVersion}},
                                     {QStringLiteral("entries"), entries}})
        .toJson(inOneLine ? QJsonDocument::Compact : QJsonDocument::Indented);
}

tl::expected<std::vector<Ledger::Record>, QString> recordsFromJson(const QByteArray &json)
{
    FaultKeeper faults(json, QString());
    const Json::Value root = parseStrictly(json, faults);
    if (!faults.first() && (!root.isObject() || root["format"] != Json::Value(recordsFormat)))
        faults.report(root, QString(),
                      Journal::tr("These are no EEPROM counts: \"format\" is not \"%1\".")
                          .arg(QLatin1String(recordsFormat)));
    std::vector<Ledger::Record> records;
    if (!faults.first()) {
        const JsonObject file(root, QString(), {"format", "version", "entries"}, faults);
        if (const std::int64_t version = file.number("version"); version < 1 || version > recordsVersion)
            file.report("version",
                        Journal::tr("Only versions 1 to %1 of the format can be read.").arg(recordsVersion));
        for (const JsonObject &entry :
             file.array("entries", {"id", "at", "identity", "countedBy", "bus", "place", "device", "computer",
                                    "user", "planned", "writes", "settled", "before", "written"}))
            records.push_back(recordOf(entry));
    }
    if (faults.first())
        return tl::unexpected(ledgerFaultText(*faults.first()));
    return records;
}

} // namespace codewheel
