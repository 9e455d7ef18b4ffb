// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/strict_json.h"

#include <QRegularExpression>
#include <QStringDecoder>

#include <algorithm>
#include <json/reader.h>
#include <memory>
#include <optional>

namespace codewheel {
namespace {

// Deeper than any of our files; keeps a hostile file from exhausting the stack.
constexpr int deepestNesting = 16;

std::unique_ptr<Json::CharReader> strictReader()
{
    Json::CharReaderBuilder builder;
    Json::CharReaderBuilder::strictMode(&builder.settings_);
    builder["failIfExtra"] = true;
    builder["rejectDupKeys"] = true;
    builder["stackLimit"] = deepestNesting;
    return std::unique_ptr<Json::CharReader>(builder.newCharReader());
}

bool isUtf8(QByteArrayView text)
{
    QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    const QString decoded = decoder(text);
    return !decoder.hasError();
}

// The first line that is not UTF-8 text, counted from 1; empty if all are.
std::optional<int> firstLineNotUtf8(const QByteArray &text)
{
    if (isUtf8(text))
        return std::nullopt;
    const QByteArrayList lines = text.split('\n');
    const auto bad = std::ranges::find_if_not(lines, [](const QByteArray &line) { return isUtf8(line); });
    return static_cast<int>(bad - lines.begin()) + 1;
}

int lineOf(const QByteArray &text, qsizetype place)
{
    return static_cast<int>(std::count(text.begin(), text.begin() + place, '\n')) + 1;
}

// jsoncpp takes a NUL for the end of the file. It skips a byte order mark, which editors of Windows put
// there.
bool hasForeignBytes(const QByteArray &json, FaultKeeper &faults)
{
    if (const qsizetype place = json.indexOf('\0'); place >= 0)
        faults.report(lineOf(json, place), QString(),
                      QCoreApplication::translate(
                          "codewheel::Catalog",
                          "There is a NUL character here, which is not part of a text: remove it."));
    return faults.first().has_value();
}

// jsoncpp reports "* Line 3, Column 5\n  Duplicate key: 'name'\n", in English whatever the language. Only
// what the user cannot see by looking at the line is kept: the key that is there twice.
void reportSyntaxError(const std::string &report, FaultKeeper &faults)
{
    static const QRegularExpression form(
        QStringLiteral(R"(\* Line (\d+), Column \d+\n\s*(?:Duplicate key: '([^\n]*)')?)"));
    const QRegularExpressionMatch match = form.match(QString::fromStdString(report));
    const int line = match.hasMatch() ? match.captured(1).toInt() : 1;
    if (const QString key = match.captured(2); !key.isEmpty())
        faults.report(line, key,
                      QCoreApplication::translate("codewheel::Catalog", "This key is here twice."));
    faults.report(
        line, QString(),
        QCoreApplication::translate("codewheel::Catalog",
                                    "This is not valid JSON: check brackets, commas and quotation marks."));
}

} // namespace

Json::Value parseStrictly(const QByteArray &json, FaultKeeper &faults)
{
    if (json.trimmed().isEmpty()) {
        faults.report(1, QString(), QCoreApplication::translate("codewheel::Catalog", "The file is empty."));
        return {};
    }
    if (const auto line = firstLineNotUtf8(json)) {
        faults.report(*line, QString(),
                      QCoreApplication::translate("codewheel::Catalog",
                                                  "This is not UTF-8 text: save the file as UTF-8."));
        return {};
    }
    if (hasForeignBytes(json, faults))
        return {};
    Json::Value root;
    std::string report;
    try {
        if (strictReader()->parse(json.constData(), json.constData() + json.size(), &root, &report))
            return root;
    } catch (const Json::Exception &) { // nested too deeply
        faults.report(1, QString(),
                      QCoreApplication::translate("codewheel::Catalog", "The file is nested too deeply."));
        return {};
    }
    reportSyntaxError(report, faults);
    return {};
}

} // namespace codewheel
