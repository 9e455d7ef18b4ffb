// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"

#include "catalog/description_reader.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>

#include <algorithm>
#include <json/reader.h>
#include <memory>

namespace codewheel {
namespace {

// Deeper than any description; keeps a hostile file from exhausting the stack.
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

void parseStrictly(const QByteArray &json, Json::Value &root, FaultKeeper &faults)
{
    std::string report;
    try {
        if (strictReader()->parse(json.constData(), json.constData() + json.size(), &root, &report))
            return;
    } catch (const Json::Exception &) { // nested too deeply
        faults.report(1, QString(),
                      QCoreApplication::translate("codewheel::Catalog", "The file is nested too deeply."));
        return;
    }
    const SyntaxError error = firstSyntaxError(report);
    faults.report(
        error.line, QString(),
        QCoreApplication::translate("codewheel::Catalog", "This is not valid JSON: %1").arg(error.text));
}

} // namespace

Catalog Catalog::builtIn()
{
    Catalog catalog;
    QDirIterator files(QStringLiteral(":/devices"), {QStringLiteral("*.json")});
    while (files.hasNext()) {
        QFile file(files.next());
        if (!file.open(QIODevice::ReadOnly))
            qFatal("%s cannot be read", qPrintable(file.fileName()));
        if (const auto added = catalog.add(file.readAll(), file.fileName()); !added)
            qFatal("%s:%d: %s: %s", qPrintable(added.error().file), added.error().line,
                   qPrintable(added.error().key), qPrintable(added.error().reason));
    }
    std::ranges::sort(catalog.m_devices, {}, &DeviceDescription::key);
    return catalog;
}

tl::expected<void, Catalog::Fault> Catalog::add(const QByteArray &json, const QString &file)
{
    FaultKeeper faults(json, file);
    Json::Value root;
    parseStrictly(json, root, faults);
    if (faults.first())
        return tl::unexpected(*faults.first());

    DeviceDescription device = readDescription(root, faults);
    if (find(device.key))
        faults.report(root["key"], QStringLiteral("key"),
                      QCoreApplication::translate("codewheel::Catalog",
                                                  "A device with the key \"%1\" is in the catalog already.")
                          .arg(device.key));
    if (faults.first())
        return tl::unexpected(*faults.first());
    m_devices.push_back(std::move(device));
    return {};
}

const DeviceDescription *Catalog::find(QStringView key) const
{
    const auto found = std::ranges::find(m_devices, key, &DeviceDescription::key);
    return found == m_devices.end() ? nullptr : &*found;
}

const DeviceDescription *Catalog::generic(unsigned deviceCode) const
{
    const auto found = std::ranges::find_if(m_devices, [deviceCode](const DeviceDescription &device) {
        return device.isGeneric() && device.deviceCode == deviceCode;
    });
    return found == m_devices.end() ? nullptr : &*found;
}

} // namespace codewheel
