// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/description_reader.h"

#include <algorithm>

namespace codewheel {
namespace {

class TablesReader
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::TablesReader)

public:
    static QString twice() { return tr("This is here twice."); }
    static QString none() { return tr("At least one row is expected here."); }

    static LedState readState(const JsonObject &row, const Leds &leds);
};

template <typename Row, typename Value, typename Member>
bool isThere(const std::vector<Row> &among, const Value &value, Member member)
{
    return std::ranges::find(among, value, member) != among.end();
}

Connector readConnector(const JsonObject &json)
{
    Connector connector{json.localText("name"), json.localText("chapter"), {}};
    for (const JsonObject &row : json.array("pins", {"pin", "signal", "remark"})) {
        Pin pin{row.text("pin"), row.localText("signal"), row.localTextOr("remark", {})};
        if (isThere(connector.pins, pin.pin, &Pin::pin))
            row.report("pin", TablesReader::twice());
        connector.pins.push_back(std::move(pin));
    }
    if (connector.pins.empty())
        json.report("pins", TablesReader::none());
    return connector;
}

LedState TablesReader::readState(const JsonObject &row, const Leds &leds)
{
    LedState state{row.texts("on"), row.has("blinking") ? row.texts("blinking") : QStringList(),
                   row.localText("meaning")};
    QStringList known;
    for (const Led &lamp : leds.lamps)
        known << lamp.name;
    for (const QString &name : state.on)
        if (!known.contains(name))
            row.reportUnknownName("on", name, known);
    for (const QString &name : state.blinking) {
        if (!known.contains(name))
            row.reportUnknownName("blinking", name, known);
        if (state.on.contains(name))
            row.report("blinking", tr("\"%1\" cannot be on and blink.").arg(name));
    }
    const auto same = [&](const LedState &other) {
        return other.on == state.on && other.blinking == state.blinking;
    };
    if (std::ranges::any_of(leds.states, same))
        row.report("on", twice());
    return state;
}

LimitTable readLimitTable(const JsonObject &json)
{
    LimitTable table{json.localText("name"), json.localText("chapter"), {}};
    for (const JsonObject &row : json.array("rows", {"name", "value"})) {
        LimitTable::Row limit{row.localText("name"), row.localText("value")};
        if (isThere(table.rows, limit.name, &LimitTable::Row::name))
            row.report("name", TablesReader::twice());
        table.rows.push_back(std::move(limit));
    }
    if (table.rows.empty())
        json.report("rows", TablesReader::none());
    return table;
}

} // namespace

std::vector<Connector> readConnectors(const JsonObject &json)
{
    std::vector<Connector> connectors;
    for (const JsonObject &row : json.array("connectors", {"name", "chapter", "pins"})) {
        Connector connector = readConnector(row);
        if (isThere(connectors, connector.name, &Connector::name))
            row.report("name", TablesReader::twice());
        connectors.push_back(std::move(connector));
    }
    return connectors;
}

Leds readLeds(const JsonObject &json)
{
    const JsonObject object = json.object("leds", {"chapter", "lamps", "states"});
    Leds leds{object.localText("chapter"), {}, {}};
    for (const JsonObject &row : object.array("lamps", {"name", "colour", "meaning"})) {
        Led lamp{row.text("name"), row.localText("colour"), row.localText("meaning")};
        if (isThere(leds.lamps, lamp.name, &Led::name))
            row.report("name", TablesReader::twice());
        leds.lamps.push_back(std::move(lamp));
    }
    if (object.has("states"))
        for (const JsonObject &row : object.array("states", {"on", "blinking", "meaning"}))
            leds.states.push_back(TablesReader::readState(row, leds));
    return leds;
}

Supply readSupply(const JsonObject &json)
{
    const JsonObject object = json.object("supply", {"value", "chapter"});
    return {object.localText("value"), object.localText("chapter")};
}

std::vector<LimitTable> readLimits(const JsonObject &json)
{
    std::vector<LimitTable> tables;
    for (const JsonObject &row : json.array("limits", {"name", "chapter", "rows"})) {
        LimitTable table = readLimitTable(row);
        if (isThere(tables, table.name, &LimitTable::name))
            row.report("name", TablesReader::twice());
        tables.push_back(std::move(table));
    }
    return tables;
}

} // namespace codewheel
