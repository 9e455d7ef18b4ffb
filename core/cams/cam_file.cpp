// SPDX-License-Identifier: GPL-3.0-or-later
#include "cams/cam_file.h"

#include "cams/check_cams.h"
#include "catalog/strict_json.h"
#include "encoder/sentence.h"

#include <QStringList>

#include <algorithm>
#include <json/writer.h>

namespace codewheel {
namespace {

constexpr char formatName[] = "codewheel-cams";
constexpr std::int64_t formatVersion = 1;
constexpr std::int64_t largestTotalRange = largestCamPosition + 1;

// The rules of the file, part by part. One object a file.
class CamFileReader
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::CamFileReader)

public:
    explicit CamFileReader(std::optional<std::int64_t> largestPosition)
        : m_largestPosition(largestPosition.value_or(largestCamPosition))
    {}

    // Before anything else: what is of another kind has other keys.
    static void checkFormat(const Json::Value &root, FaultKeeper &faults);
    CamFile read(const JsonObject &json);

private:
    CamProgram readProgram(const JsonObject &json) const;
    void readCam(const JsonObject &json, CamProgram &program, unsigned &seen) const;

    std::int64_t m_largestPosition;
};

void CamFileReader::checkFormat(const Json::Value &root, FaultKeeper &faults)
{
    if (!root.isObject() || root["format"] == Json::Value(formatName))
        return;
    faults.report(
        root.isMember("format") ? root["format"] : root, QStringLiteral("format"),
        tr("This is no file of cam programs: the format is not \"%1\".").arg(QLatin1String(formatName)));
}

CamFile CamFileReader::read(const JsonObject &json)
{
    if (json.number("version") != formatVersion)
        json.report("version", tr("Only version %1 of the format can be read.").arg(formatVersion));
    CamFile file;
    file.device = json.text("device");
    file.totalRange = json.optionalNumber("totalRange", 1, largestTotalRange);
    if (file.totalRange)
        m_largestPosition = std::min(m_largestPosition, *file.totalRange - 1);

    for (const JsonObject &row : json.array("programs", {"program", "shift", "cams"})) {
        const CamProgram program = readProgram(row);
        if (std::ranges::find(file.programs, program.number, &CamProgram::number) != file.programs.end())
            row.report("program", tr("Cam program %1 stands above already.").arg(program.number));
        file.programs.push_back(program);
    }
    if (file.programs.empty())
        json.report("programs", tr("At least one cam program is expected here."));
    std::ranges::sort(file.programs, {}, &CamProgram::number);
    return file;
}

CamProgram CamFileReader::readProgram(const JsonObject &json) const
{
    CamProgram program;
    program.number = static_cast<unsigned>(json.number("program", 1, CamProgram::programs));
    program.shift = static_cast<unsigned>(json.number("shift", 0, CamProgram::largestShift));
    unsigned seen = 0;
    for (const JsonObject &row : json.array("cams", {"cam", "start", "stop", "active"}))
        readCam(row, program, seen);
    return program;
}

void CamFileReader::readCam(const JsonObject &json, CamProgram &program, unsigned &seen) const
{
    const auto number = static_cast<std::size_t>(json.number("cam", 0, CamProgram::cams - 1));
    const unsigned bit = 1U << number;
    if ((seen & bit) != 0)
        json.report("cam", tr("Cam %1 stands above already.").arg(number));
    seen |= bit;
    Cam &cam = program.cam[number];
    cam.start = json.number("start", 0, m_largestPosition);
    cam.stop = json.number("stop", 0, m_largestPosition);
    cam.active = json.flag("active");
}

QByteArray camLine(std::size_t number, const Cam &cam)
{
    return QByteArrayLiteral("        {\"cam\": ") + QByteArray::number(static_cast<qulonglong>(number)) +
           ", \"start\": " + QByteArray::number(static_cast<qlonglong>(cam.start)) +
           ", \"stop\": " + QByteArray::number(static_cast<qlonglong>(cam.stop)) +
           ", \"active\": " + (cam.active ? "true" : "false") + "}";
}

QByteArray programText(const CamProgram &program)
{
    QByteArrayList cams;
    for (std::size_t n = 0; n < CamProgram::cams; ++n)
        cams.append(camLine(n, program.cam[n]));
    return QByteArrayLiteral("    {\n      \"program\": ") + QByteArray::number(program.number) +
           ",\n      \"shift\": " + QByteArray::number(program.shift) + ",\n      \"cams\": [\n" +
           cams.join(",\n") + "\n      ]\n    }";
}

} // namespace

QByteArray camFileToJson(CamFile file)
{
    std::ranges::sort(file.programs, {}, &CamProgram::number);
    QByteArrayList programs;
    for (const CamProgram &program : file.programs)
        programs.append(programText(program));
    QByteArray json = QByteArrayLiteral("{\n  \"format\": \"") + formatName +
                      "\",\n  \"version\": " + QByteArray::number(formatVersion) + ",\n  \"device\": " +
                      QByteArray::fromStdString(Json::valueToQuotedString(file.device.toUtf8().constData())) +
                      ",\n";
    if (file.totalRange)
        json += "  \"totalRange\": " + QByteArray::number(static_cast<qlonglong>(*file.totalRange)) + ",\n";
    return json + "  \"programs\": [\n" + programs.join(",\n") + "\n  ]\n}\n";
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
    const auto isFrabaK3 = [](const DeviceDescription &device) {
        return device.profile == Profile::k3 && device.dialect == k3::Dialect::fraba;
    };
    return file.device == encoder.key || (madeFor != nullptr && isFrabaK3(*madeFor) && isFrabaK3(encoder));
}

QString otherDeviceText(const CamFile &file, const DeviceDescription &encoder, const QString &name)
{
    return sentence(CamFileReader::tr("%1 holds cam programs for the device %2; this encoder is %3. Nothing "
                                      "was taken from the file."),
                    {name, file.device, encoder.key});
}

} // namespace codewheel
