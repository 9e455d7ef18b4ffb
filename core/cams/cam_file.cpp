// SPDX-License-Identifier: GPL-3.0-or-later
#include "cams/cam_file.h"

#include "cams/cam_program_json.h"
#include "cams/check_cams.h"
#include "catalog/json_writer.h"
#include "catalog/strict_json.h"
#include "vocabulary/sentence.h"

#include <QStringList>

#include <algorithm>

namespace codewheel {
namespace {

constexpr char camFormat[] = "codewheel-cams";
constexpr std::int64_t camVersion = 1;

// The rules of the file, part by part.
class CamFileReader
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CamFileReader)

public:
    explicit CamFileReader(std::optional<std::int64_t> largestPosition)
        : m_largestPosition(largestPosition.value_or(largestCamPosition))
    {}

    // Before anything else: a file of another kind has other keys.
    static void checkFormat(const Json::Value &root, FaultKeeper &faults);
    CamFile read(const JsonObject &json) const;

private:
    std::int64_t m_largestPosition;
};

void CamFileReader::checkFormat(const Json::Value &root, FaultKeeper &faults)
{
    if (!root.isObject() || root["format"] == Json::Value(camFormat))
        return;
    faults.report(
        root.isMember("format") ? root["format"] : root, QStringLiteral("format"),
        tr("This is not a file of cam programs: the format is not \"%1\".").arg(QLatin1String(camFormat)));
}

CamFile CamFileReader::read(const JsonObject &json) const
{
    if (json.number("version") != camVersion)
        json.report("version", tr("Only version %1 of the format can be read.").arg(camVersion));
    CamFile file;
    file.device = json.text("device");
    file.totalRange = json.optionalNumber("totalRange", 1, largestCamPosition + 1);

    CamProgramReader programs(file.totalRange ? std::min(m_largestPosition, *file.totalRange - 1)
                                              : m_largestPosition);
    for (const JsonObject &row : json.array("programs", {"program", "shift", "cams"}, CamProgram::programs))
        file.programs.push_back(programs.read(row));
    if (file.programs.empty())
        json.report("programs", tr("At least one cam program is expected here."));
    std::ranges::sort(file.programs, {}, &CamProgram::number);
    return file;
}

} // namespace

QByteArray camFileToJson(CamFile file)
{
    std::ranges::sort(file.programs, {}, &CamProgram::number);
    JsonWriter json;
    json.member("format", camFormat);
    json.member("version", camVersion);
    json.member("device", file.device);
    if (file.totalRange)
        json.member("totalRange", *file.totalRange);
    json.list("programs", file.programs, [&](const CamProgram &program) { writeCamProgram(json, program); });
    return json.finish();
}

Result<CamFile> camFileFromJson(const QByteArray &json, const QString &name,
                                std::optional<std::int64_t> largestPosition)
{
    FaultKeeper faults(json, name);
    const Json::Value root = parseStrictly(json, faults);
    CamFile file;
    if (!faults.first())
        CamFileReader::checkFormat(root, faults);
    if (!faults.first())
        file = CamFileReader(largestPosition)
                   .read(JsonObject(root, QString(),
                                    {"format", "version", "device", "totalRange", "programs"}, faults));
    if (const auto &fault = faults.first())
        return refuse(RefusalKind::badInput, RefusalId::camFileBroken,
                      {fault->file, std::int64_t{fault->line}, fault->key, fault->reason});
    return file;
}

Result<CamProgram> camProgramOf(const CamFile &file, unsigned number, const QString &name)
{
    QStringList held;
    for (const CamProgram &program : file.programs) {
        if (program.number == number)
            return program;
        held << QString::number(program.number);
    }
    return refuse(RefusalKind::badInput, RefusalId::camFileOfOtherProgram,
                  {name, held.join(QStringLiteral(", ")), std::int64_t{number}});
}

bool suits(const CamFile &file, const DeviceDescription &encoder, const DeviceDescription *madeFor)
{
    const bool haveTheSame = madeFor != nullptr && madeFor->profile == encoder.profile &&
                             encoder.capabilities.cams &&
                             madeFor->capabilities.cams == encoder.capabilities.cams;
    return file.device == encoder.key || haveTheSame;
}

QString otherDeviceText(const CamFile &file, const DeviceDescription &encoder, const QString &name)
{
    return sentence(CamFileReader::tr("%1 contains cam programs for the device %2; this encoder is %3. "
                                      "Nothing was taken from the file."),
                    {name, file.device, encoder.key});
}

} // namespace codewheel
