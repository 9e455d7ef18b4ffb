// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/encoder/cam_text.h"

#include "cli/call/json.h"
#include "cli/call/keys.h"
#include "cli/call/text_table.h"
#include "cli/call/texts.h"
#include "jobs/protocol.h"
#include "vocabulary/hex.h"
#include "vocabulary/sentence.h"

#include <algorithm>

namespace codewheel {
namespace {

using Align = TextTable::Align;

constexpr NamedValue<CamValue> camValueKeys[] = {
    {"active", CamValue::activeCams},
    {"start", CamValue::start},
    {"stop", CamValue::stop},
    {"shift", CamValue::shift},
};

bool isOfOneCam(CamField field)
{
    return field.value == CamValue::start || field.value == CamValue::stop;
}

// Cams 7 to 0, in the order of the bits in the word.
QString bits(std::int64_t active)
{
    return QStringLiteral("%1").arg(active, 8, 2, QLatin1Char('0'));
}

QString valueText(CamField field, std::int64_t value)
{
    return field.value == CamValue::activeCams ? bits(value) : QString::number(value);
}

bool isUnset(const CamProgram &program)
{
    return program == CamProgram{.number = program.number, .cam = {}, .shift = 0};
}

} // namespace

std::vector<CamDifference> differencesOf(const DeviceDescription &device, const std::vector<CamProgram> &has,
                                         const std::vector<CamProgram> &wanted)
{
    const Protocol &protocol = protocolOf(device);
    std::vector<CamDifference> found;
    for (const CamProgram &program : wanted) {
        const CamProgram &other = *std::ranges::find(has, program.number, &CamProgram::number);
        const CamFieldSet different = differences(other, program);
        for (std::size_t i = 0; i < camFieldCount; ++i)
            if (different[i])
                found.push_back({program.number, camField(i), valueOf(other, camField(i)),
                                 valueOf(program, camField(i)),
                                 protocol.camWord(camField(i), valueOf(program, camField(i)))});
    }
    return found;
}

QString camTable(const std::vector<CamProgram> &programs)
{
    QString text;
    for (const CamProgram &program : programs) {
        if (isUnset(program)) {
            text += sentence(CommandLine::tr("Cam program %1: nothing is set"),
                             {QString::number(program.number)}) +
                    u'\n';
            continue;
        }
        text += sentence(CommandLine::tr("Cam program %1, shift %2"),
                         {QString::number(program.number), QString::number(program.shift)}) +
                u'\n';
        TextTable table({Align::right, Align::right, Align::right, Align::left});
        table.add({CommandLine::tr("cam"), CommandLine::tr("start"), CommandLine::tr("stop"),
                   CommandLine::tr("active")});
        for (std::size_t n = 0; n < CamProgram::cams; ++n) {
            const Cam &cam = program.cam[n];
            table.add({QString::number(n), QString::number(cam.start), QString::number(cam.stop),
                       cam.active ? CommandLine::tr("yes") : CommandLine::tr("no")});
        }
        text += table.toString(2);
    }
    return text;
}

QString differenceTable(const std::vector<CamDifference> &differences)
{
    TextTable table({Align::right, Align::right, Align::left, Align::right, Align::right, Align::left});
    table.add({CommandLine::tr("program"), CommandLine::tr("cam"), CommandLine::tr("value"),
               CommandLine::tr("encoder"), CommandLine::tr("file"), QStringLiteral("OUT")});
    for (const CamDifference &one : differences)
        table.add({QString::number(one.program),
                   isOfOneCam(one.field) ? QString::number(one.field.cam) : QStringLiteral("-"),
                   keyOf(camValueKeys, one.field.value), valueText(one.field, one.encoder),
                   valueText(one.field, one.wanted), hexWord(one.word)});
    return table.toString(2);
}

QJsonArray camsJson(const std::vector<CamProgram> &programs)
{
    QJsonArray json;
    for (const CamProgram &program : programs) {
        QJsonArray cams;
        for (std::size_t n = 0; n < CamProgram::cams; ++n) {
            const Cam &cam = program.cam[n];
            cams.append(QJsonObject{{QStringLiteral("cam"), static_cast<int>(n)},
                                    {QStringLiteral("start"), qint64{cam.start}},
                                    {QStringLiteral("stop"), qint64{cam.stop}},
                                    {QStringLiteral("active"), cam.active}});
        }
        json.append(QJsonObject{{QStringLiteral("program"), static_cast<int>(program.number)},
                                {QStringLiteral("shift"), static_cast<int>(program.shift)},
                                {QStringLiteral("cams"), cams}});
    }
    return json;
}

QJsonArray differencesJson(const std::vector<CamDifference> &differences)
{
    QJsonArray json;
    for (const CamDifference &one : differences)
        json.append(
            QJsonObject{{QStringLiteral("program"), static_cast<int>(one.program)},
                        {QStringLiteral("cam"),
                         isOfOneCam(one.field) ? QJsonValue(static_cast<int>(one.field.cam)) : QJsonValue()},
                        {QStringLiteral("value"), keyOf(camValueKeys, one.field.value)},
                        {QStringLiteral("encoder"), qint64{one.encoder}},
                        {QStringLiteral("file"), qint64{one.wanted}},
                        {QStringLiteral("word"), wordJson(one.word)}});
    return json;
}

} // namespace codewheel
