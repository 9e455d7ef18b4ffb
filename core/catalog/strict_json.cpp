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

struct SyntaxError
{
    int line = 1;
    QString text;
};

// jsoncpp reports "* Line 3, Column 5\n  Missing ',' or '}' in object declaration\n".
SyntaxError firstSyntaxError(const std::string &report)
{
    static const QRegularExpression form(QStringLiteral(R"(\* Line (\d+), Column \d+\n\s*([^\n]*))"));
    const QRegularExpressionMatch match = form.match(QString::fromStdString(report));
    return match.hasMatch() ? SyntaxError{match.captured(1).toInt(), match.captured(2)} : SyntaxError{};
}

} // namespace

Json::Value parseStrictly(const QByteArray &json, FaultKeeper &faults)
{
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
    const SyntaxError error = firstSyntaxError(report);
    faults.report(
        error.line, QString(),
        QCoreApplication::translate("codewheel::Catalog", "This is not valid JSON: %1").arg(error.text));
    return {};
}

} // namespace codewheel
