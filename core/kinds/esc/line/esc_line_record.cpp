// SPDX-License-Identifier: GPL-3.0-or-later
// docs/line-sessions.md
#include "kinds/esc/line/esc_line_record.h"

#include "catalog/json_writer.h"
#include "catalog/strict_json.h"
#include "vocabulary/sentence.h"

namespace codewheel {
namespace {

constexpr char sessionFormat[] = "codewheel-line-session";
constexpr std::int64_t sessionVersion = 1;
constexpr std::int64_t latestRow = std::int64_t{366} * 24 * 3600 * 1'000'000; // us; a year on one line
constexpr qsizetype mostBytes = 65'536;                                       // in a row
constexpr int fastestSession = 10'000'000;                                    // Bd

constexpr NamedValue<esc::EscLineRow::Kind> rowKinds[] = {
    {"sent", esc::EscLineRow::Kind::sent}, {"answer", esc::EscLineRow::Kind::answer},
    {"echo", esc::EscLineRow::Kind::echo}, {"garbage", esc::EscLineRow::Kind::garbage},
    {"late", esc::EscLineRow::Kind::late},
};

const char *kindName(esc::EscLineRow::Kind kind)
{
    return rowKinds[static_cast<std::size_t>(kind)].name;
}

// The rules of the file, part by part.
class EscLineRecordReader
{
    Q_DECLARE_TR_FUNCTIONS(EscLineRecordFile)

public:
    // Before anything else: a file of another kind has other keys.
    static void checkFormat(const Json::Value &root, FaultKeeper &faults);
    static EscLineRecord read(const JsonObject &json);
    static QString textOf(const Catalog::Fault &fault);

private:
    static QByteArray bytesOf(const JsonObject &json);
};

void EscLineRecordReader::checkFormat(const Json::Value &root, FaultKeeper &faults)
{
    if (root.isObject() && root["format"] == Json::Value(sessionFormat))
        return;
    faults.report(root, QString(),
                  tr("This is not a session of a serial line: \"format\" is not \"%1\".")
                      .arg(QLatin1String(sessionFormat)));
}

EscLineRecord EscLineRecordReader::read(const JsonObject &json)
{
    if (json.number("version") != sessionVersion)
        json.report("version", tr("Only version %1 of the format can be read.").arg(sessionVersion));
    EscLineRecord record;
    record.begin = QDateTime::fromString(json.text("begin"), Qt::ISODateWithMs);
    if (!record.begin.isValid())
        json.report("begin", tr("A date and time is expected here, as in 2026-11-21T12:00:00.000+01:00."));
    record.port = json.freeText("port");
    record.baudRate = static_cast<int>(json.number("baudRate", 1, fastestSession));
    const auto rows = json.array("rows", {"at", "kind", "bytes", "typed"}, EscLineRecord::mostRows);
    record.rows.reserve(rows.size());
    for (const JsonObject &row : rows)
        record.rows.push_back({.what = {.at = Instant{row.number("at", 0, latestRow)},
                                        .kind = row.oneOf("kind", rowKinds),
                                        .bytes = bytesOf(row)},
                               .typed = row.flagOr("typed", false)});
    return record;
}

QByteArray EscLineRecordReader::bytesOf(const JsonObject &json)
{
    const QByteArray hex = json.text("bytes").toLatin1();
    QByteArray bytes = QByteArray::fromHex(hex);
    // fromHex() skips characters it does not know.
    if (bytes.toHex(' ').toUpper() != hex)
        json.report("bytes", tr("Bytes are expected here, as in \"1B 30 35 50 0D 0A\"."));
    else if (bytes.size() > mostBytes)
        json.report("bytes", tr("A row has %1 bytes at most.").arg(mostBytes));
    return bytes;
}

QString EscLineRecordReader::textOf(const Catalog::Fault &fault)
{
    const QString line = QString::number(fault.line);
    if (fault.key.isEmpty())
        return sentence(tr("%1, line %2: %3"), {fault.file, line, fault.reason});
    return sentence(tr("%1, line %2, %3: %4"), {fault.file, line, fault.key, fault.reason});
}

} // namespace

QByteArray lineRecordToJson(const EscLineRecord &record)
{
    JsonWriter json;
    json.member("format", sessionFormat);
    json.member("version", sessionVersion);
    json.member("begin",
                record.begin.toOffsetFromUtc(record.begin.offsetFromUtc()).toString(Qt::ISODateWithMs));
    json.member("port", record.port);
    json.member("baudRate", record.baudRate);
    json.lines("rows", record.rows, [&](const EscLineRecord::Row &row) {
        json.member("at", row.what.at.count());
        json.member("kind", kindName(row.what.kind));
        json.member("bytes", QString::fromLatin1(row.what.bytes.toHex(' ').toUpper()));
        if (row.typed)
            json.flag("typed", true);
    });
    return json.finish();
}

tl::expected<EscLineRecord, QString> lineRecordFromJson(const QByteArray &json, const QString &name)
{
    FaultKeeper faults(json, name);
    const Json::Value root = parseStrictly(json, faults);
    EscLineRecord record;
    if (!faults.first())
        EscLineRecordReader::checkFormat(root, faults);
    if (!faults.first())
        record = EscLineRecordReader::read(
            JsonObject(root, QString(), {"format", "version", "begin", "port", "baudRate", "rows"}, faults));
    if (const auto &fault = faults.first())
        return tl::unexpected(EscLineRecordReader::textOf(*fault));
    return record;
}

} // namespace codewheel
