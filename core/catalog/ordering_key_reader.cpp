// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/description_reader.h"
#include "catalog/label_key.h"

#include <algorithm>

namespace codewheel {
namespace {

constexpr std::int64_t mostAny = 20;
constexpr std::int64_t mostSteps = 1 << 25;

class OrderingKeyReader
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::OrderingKeyReader)

public:
    static OrderingKey::Code readCode(const JsonObject &row, const OrderingKey::Part &part);
    static OrderingKey::Part readPart(const JsonObject &row);
    static void refuseToldTwice(const JsonObject &row, const OrderingKey::Part &part, const OrderingKey &key);
    static OrderingKey readKey(const JsonObject &json);
};

bool isCode(const QString &text)
{
    return std::ranges::all_of(text,
                               [](QChar c) { return (c >= u'A' && c <= u'Z') || (c >= u'0' && c <= u'9'); });
}

std::optional<int> asInt(std::optional<std::int64_t> number)
{
    return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

// If one code were the beginning of another, what is typed could be either.
OrderingKey::Code OrderingKeyReader::readCode(const JsonObject &row, const OrderingKey::Part &part)
{
    OrderingKey::Code code{row.text("code"), row.localText("meaning"),
                           asInt(row.optionalNumber("turns", 1, mostSteps)),
                           asInt(row.optionalNumber("stepsPerTurn", 1, mostSteps))};
    if (!isCode(code.code))
        row.report("code", tr("A code consists of the letters A to Z and digits."));
    for (const OrderingKey::Code &other : part.codes) {
        if (other.code == code.code)
            row.report("code", tr("This code is here twice."));
        else if (other.code.startsWith(code.code) || code.code.startsWith(other.code))
            row.report("code", tr("\"%1\" and \"%2\" cannot be told apart: one begins with the other.")
                                   .arg(other.code, code.code));
    }
    return code;
}

OrderingKey::Part OrderingKeyReader::readPart(const JsonObject &row)
{
    OrderingKey::Part part{row.localText("name"), {}, 0, row.flagOr("optional", false)};
    if (row.has("codes") == row.has("any")) {
        row.report("codes", tr("A part has either codes or any."));
        return part;
    }
    if (row.has("any")) {
        part.any = static_cast<int>(row.number("any", 1, mostAny));
        return part;
    }
    for (const JsonObject &json : row.array("codes", {"code", "meaning", "turns", "stepsPerTurn"}))
        part.codes.push_back(readCode(json, part));
    if (part.codes.empty())
        row.report("codes", tr("At least one code is expected here."));
    return part;
}

void OrderingKeyReader::refuseToldTwice(const JsonObject &row, const OrderingKey::Part &part,
                                        const OrderingKey &key)
{
    const auto tells = [](const OrderingKey::Part &each, auto member) {
        return std::ranges::any_of(each.codes,
                                   [&](const OrderingKey::Code &code) { return (code.*member).has_value(); });
    };
    for (const OrderingKey::Part &other : key.parts) {
        if (tells(part, &OrderingKey::Code::turns) && tells(other, &OrderingKey::Code::turns))
            row.report("codes", tr("Another part tells the turns already."));
        if (tells(part, &OrderingKey::Code::stepsPerTurn) && tells(other, &OrderingKey::Code::stepsPerTurn))
            row.report("codes", tr("Another part tells the steps per turn already."));
    }
}

OrderingKey OrderingKeyReader::readKey(const JsonObject &json)
{
    OrderingKey key{json.localText("chapter"), json.text("example"), {}};
    for (const JsonObject &row : json.array("parts", {"name", "codes", "any", "optional"})) {
        const OrderingKey::Part part = readPart(row);
        refuseToldTwice(row, part, key);
        if (!key.parts.empty() && key.parts.back().optional)
            row.report("name", tr("Only the last part may be optional."));
        key.parts.push_back(part);
    }
    if (const auto read = readLabelKey(key, key.example); !read)
        json.report("example",
                    tr("\"%1\" in the example is not understood by the parts.").arg(read.error().written));
    return key;
}

} // namespace

OrderingKey readOrderingKey(const JsonObject &json)
{
    return OrderingKeyReader::readKey(json.object("orderingKey", {"chapter", "example", "parts"}));
}

} // namespace codewheel
