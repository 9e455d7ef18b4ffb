// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/project_json.h"

#include "catalog/strict_json.h"
#include "project/project_keys.h"
#include "project/project_reader.h"

namespace codewheel {
namespace {

// What applies to the file as a whole, before any part of it is looked at.
class FileHeader
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::ProjectReader)

public:
    static std::int64_t readVersion(const Json::Value &root, FaultKeeper &faults);
};

// A file of another kind has other keys.
std::int64_t FileHeader::readVersion(const Json::Value &root, FaultKeeper &faults)
{
    if (!root.isObject() || root["format"] != Json::Value(project_keys::formatName)) {
        const bool hasFormat = root.isObject() && root.isMember("format");
        faults.report(hasFormat ? root["format"] : root, QStringLiteral("format"),
                      tr("This is not a project: the format is not \"%1\".")
                          .arg(QLatin1String(project_keys::formatName)));
        return 0;
    }
    const Json::Value &version = root["version"];
    const bool isWhole = version.type() == Json::intValue || version.type() == Json::uintValue;
    if (!isWhole || !version.isInt64() || version.asInt64() < 1) {
        faults.report(version.isNull() ? root : version, QStringLiteral("version"),
                      tr("A whole number from 1 is expected here."));
        return 0;
    }
    return version.asInt64();
}

// Moves the member to another object, under this name; no effect if it is missing.
void move(Json::Value &from, const char *key, Json::Value &to, const char *name)
{
    Json::Value member;
    if (from.removeMember(key, &member))
        to[name] = std::move(member);
}

// 1: one ring, and a serial line beside it. Whatever broke a rule still does, at its line.
void ringAndLineBecomeBuses(Json::Value &root)
{
    Json::Value ring(Json::objectValue);
    ring["kind"] = "interbus";
    ring["number"] = firstBus.number;
    ring["name"] = "Ring";
    for (const char *key : {"link", "addresses", "cableKilometres", "devices"})
        move(root, key, ring, key);
    Json::Value buses(Json::arrayValue);
    buses.append(std::move(ring));
    Json::Value line;
    if (root.removeMember("serialLine", &line)) {
        if (line.isObject()) {
            line["kind"] = "esc";
            line["number"] = firstLine.number;
            line["name"] = "Line";
            if (!line.isMember("encoders"))
                line["encoders"] = Json::Value(Json::arrayValue);
            move(line, "encoders", line, "devices");
        }
        buses.append(std::move(line));
    }
    root["buses"] = std::move(buses);
}

Result<Project> refuseFirst(const FaultKeeper &faults)
{
    const Catalog::Fault &fault = *faults.first();
    return refuse(RefusalKind::badInput, RefusalId::projectFileBroken,
                  {fault.file, std::int64_t{fault.line}, fault.key, fault.reason});
}

} // namespace

std::span<const MigrationStep> projectMigrations()
{
    static constexpr MigrationStep steps[] = {ringAndLineBecomeBuses};
    return steps;
}

Result<Project> projectFromJson(const QByteArray &json, const QString &name,
                                std::span<const MigrationStep> steps)
{
    FaultKeeper faults(json, name);
    Json::Value root = parseStrictly(json, faults);
    const std::int64_t version = faults.first() ? 0 : FileHeader::readVersion(root, faults);
    if (faults.first())
        return refuseFirst(faults);
    const auto newest = static_cast<std::int64_t>(steps.size()) + 1;
    if (version > newest)
        return refuse(RefusalKind::badInput, RefusalId::projectFileNewer, {name, version, newest});

    for (const MigrationStep step : steps.subspan(static_cast<std::size_t>(version) - 1))
        step(root);
    Project project = ProjectReader::read(root, faults);
    if (faults.first())
        return refuseFirst(faults);
    return project;
}

} // namespace codewheel
