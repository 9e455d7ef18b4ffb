// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/encoder/device_tables_text.h"

#include "cli/call/text_table.h"
#include "cli/call/texts.h"

#include <QJsonArray>

namespace codewheel {
namespace {

QString heading(const QString &name, const LocalText &chapter)
{
    return u'\n' +
           CommandLine::tr("%1 (manual: %2)", "Electrical data (manual: 6.1)").arg(name, chapter.toString()) +
           u'\n';
}

QString ledText(const Leds &leds)
{
    TextTable table;
    for (const Led &lamp : leds.lamps)
        table.add({lamp.name, lamp.colour.toString(), lamp.meaning.toString()});
    TextTable states;
    for (const LedState &state : leds.states) {
        QStringList lamps = state.on;
        for (const QString &name : state.blinking)
            lamps << CommandLine::tr("%1 blinking").arg(name);
        states.add({lamps.join(QStringLiteral(" + ")), state.meaning.toString()});
    }
    return heading(CommandLine::tr("LEDs"), leds.chapter) + table.toString(2) + states.toString(2);
}

QString orderingKeyText(const OrderingKey &key)
{
    QString text = heading(CommandLine::tr("Ordering key, e.g. %1").arg(key.example), key.chapter);
    TextTable table;
    for (const OrderingKey::Part &part : key.parts) {
        QString name = part.name.toString();
        if (part.any > 0)
            table.add({name, QString(part.any, u'_'),
                       part.optional ? CommandLine::tr("any, may be missing") : CommandLine::tr("any")});
        for (const OrderingKey::Code &code : part.codes) {
            table.add({name, code.code, code.meaning.toString()});
            name.clear();
        }
    }
    return text + table.toString(2);
}

QJsonArray pinsJson(const Connector &connector)
{
    QJsonArray pins;
    for (const Pin &pin : connector.pins)
        pins.append(QJsonObject{{QStringLiteral("pin"), pin.pin},
                                {QStringLiteral("signal"), pin.signal.toString()},
                                {QStringLiteral("remark"), pin.remark.toString()}});
    return pins;
}

QJsonObject ledsJson(const Leds &leds)
{
    QJsonArray lamps;
    for (const Led &lamp : leds.lamps)
        lamps.append(QJsonObject{{QStringLiteral("name"), lamp.name},
                                 {QStringLiteral("colour"), lamp.colour.toString()},
                                 {QStringLiteral("meaning"), lamp.meaning.toString()}});
    QJsonArray states;
    for (const LedState &state : leds.states)
        states.append(QJsonObject{{QStringLiteral("on"), QJsonArray::fromStringList(state.on)},
                                  {QStringLiteral("blinking"), QJsonArray::fromStringList(state.blinking)},
                                  {QStringLiteral("meaning"), state.meaning.toString()}});
    return {{QStringLiteral("chapter"), leds.chapter.toString()},
            {QStringLiteral("lamps"), lamps},
            {QStringLiteral("states"), states}};
}

QJsonObject orderingKeyJson(const OrderingKey &key)
{
    QJsonArray parts;
    for (const OrderingKey::Part &part : key.parts) {
        QJsonArray codes;
        for (const OrderingKey::Code &code : part.codes)
            codes.append(QJsonObject{{QStringLiteral("code"), code.code},
                                     {QStringLiteral("meaning"), code.meaning.toString()}});
        parts.append(QJsonObject{{QStringLiteral("name"), part.name.toString()},
                                 {QStringLiteral("codes"), codes},
                                 {QStringLiteral("any"), part.any},
                                 {QStringLiteral("optional"), part.optional}});
    }
    return {{QStringLiteral("chapter"), key.chapter.toString()},
            {QStringLiteral("example"), key.example},
            {QStringLiteral("parts"), parts}};
}

QJsonObject limitsJson(const LimitTable &table)
{
    QJsonArray rows;
    for (const LimitTable::Row &row : table.rows)
        rows.append(QJsonObject{{QStringLiteral("name"), row.name.toString()},
                                {QStringLiteral("value"), row.value.toString()}});
    return {{QStringLiteral("name"), table.name.toString()},
            {QStringLiteral("chapter"), table.chapter.toString()},
            {QStringLiteral("rows"), rows}};
}

} // namespace

QString deviceTablesText(const DeviceDescription &device)
{
    QString text;
    if (!device.supply.value.isEmpty())
        text += heading(CommandLine::tr("Supply"), device.supply.chapter) + QStringLiteral("  ") +
                device.supply.value.toString() + u'\n';
    for (const Connector &connector : device.connectors) {
        TextTable table;
        for (const Pin &pin : connector.pins)
            table.add({pin.pin, pin.signal.toString(), pin.remark.toString()});
        text += heading(connector.name.toString(), connector.chapter) + table.toString(2);
    }
    if (device.leds)
        text += ledText(*device.leds);
    for (const LimitTable &limits : device.limits) {
        TextTable table;
        for (const LimitTable::Row &row : limits.rows)
            table.add({row.name.toString(), row.value.toString()});
        text += heading(limits.name.toString(), limits.chapter) + table.toString(2);
    }
    if (device.orderingKey)
        text += orderingKeyText(*device.orderingKey);
    return text;
}

QJsonObject deviceTablesJson(const DeviceDescription &device)
{
    QJsonArray connectors;
    for (const Connector &connector : device.connectors)
        connectors.append(QJsonObject{{QStringLiteral("name"), connector.name.toString()},
                                      {QStringLiteral("chapter"), connector.chapter.toString()},
                                      {QStringLiteral("pins"), pinsJson(connector)}});
    QJsonArray limits;
    for (const LimitTable &table : device.limits)
        limits.append(limitsJson(table));
    return {{QStringLiteral("connectors"), connectors},
            {QStringLiteral("leds"), device.leds ? QJsonValue(ledsJson(*device.leds)) : QJsonValue()},
            {QStringLiteral("supply"),
             device.supply.value.isEmpty() ? QJsonValue() : QJsonValue(device.supply.value.toString())},
            {QStringLiteral("limits"), limits},
            {QStringLiteral("orderingKey"),
             device.orderingKey ? QJsonValue(orderingKeyJson(*device.orderingKey)) : QJsonValue()}};
}

} // namespace codewheel
