// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/strict_json.h"

#include <QRegularExpression>

#include <json/reader.h>
#include <memory>

namespace codewheel {
namespace {

// Deeper than any file of ours; keeps a hostile file from exhausting the stack.
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

// jsoncpp reports "* Line 3, Column 5\n  Duplicate key: 'name'\n", in English whatever the language is. Only
// what the user cannot see by looking at the line is taken over: the key that stands there twice.
void reportSyntaxError(const std::string &report, FaultKeeper &faults)
{
    static const QRegularExpression form(
        QStringLiteral(R"(\* Line (\d+), Column \d+\n\s*(?:Duplicate key: '([^\n]*)')?)"));
    const QRegularExpressionMatch match = form.match(QString::fromStdString(report));
    const int line = match.hasMatch() ? match.captured(1).toInt() : 1;
    if (const QString key = match.captured(2); !key.isEmpty())
        faults.report(line, key,
                      QCoreApplication::translate("codewheel::Catalog", "This key stands here twice."));
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
