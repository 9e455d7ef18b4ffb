// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/cam_blocks.h"

#include "catalog/total_range.h"
#include "report/report_words.h"
#include "report/texts.h"
#include "vocabulary/known_words.h"
#include "vocabulary/sentence.h"

#include <algorithm>

namespace codewheel {
namespace {

using Column = ReportTable::Column;

// One cam program of an encoder, wanted or known; at least one of the two is there.
struct BothPrograms
{
    const CamProgram *wanted;
    const StoredCams *known;

    const CamProgram &any() const { return wanted ? *wanted : known->program; }
    bool isAsWanted() const { return wanted && known && *wanted == known->program; }
    bool isNothingSet() const
    {
        const CamProgram unset{.number = any().number};
        return (!wanted || *wanted == unset) && (!known || known->program == unset);
    }
};

QString camText(const Cam &cam)
{
    if (cam == Cam{})
        return ReportTexts::tr("not set");
    const QStringList range{numberText(cam.start), numberText(cam.stop)};
    QStringList parts{cam.active ? sentence(ReportTexts::tr("%1 to %2, active"), range)
                                 : sentence(ReportTexts::tr("%1 to %2, inactive"), range)};
    if (cam.hysteresis != 0)
        parts << sentence(ReportTexts::tr("hysteresis %1"), {numberText(cam.hysteresis)});
    if (cam.isInverted)
        parts << ReportTexts::tr("inverted");
    return parts.join(QStringLiteral(", "));
}

QString remark(bool isCompared, bool isEqual)
{
    if (!isCompared)
        return {};
    return isEqual ? ReportTexts::tr("as wanted") : ReportTexts::tr("differs");
}

ReportTable camTable(const BothPrograms &both, const CamAbilities &has)
{
    ReportTable table{{ReportTexts::tr("Cam"), ReportTexts::tr("Wanted"), ReportTexts::tr("Known"),
                       ReportTexts::tr("Remark")},
                      {Column::text, Column::text, Column::text, Column::text},
                      {}};
    const bool isCompared = both.wanted && both.known;
    const auto add = [&](const QString &name, auto textOf) {
        const QString wanted = both.wanted ? textOf(*both.wanted) : QString();
        const QString known = both.known ? textOf(both.known->program) : report_words::unknown();
        const bool isEqual = wanted == known;
        table.rows.push_back({{name, wanted, known, remark(isCompared, isEqual)}, isCompared && !isEqual});
    };
    for (std::size_t cam = 0; cam < has.cams; ++cam)
        add(QString::number(cam), [cam](const CamProgram &program) { return camText(program.cam[cam]); });
    if (has.hasShift)
        add(ReportTexts::tr("Shift"),
            [](const CamProgram &program) { return QString::number(program.shift); });
    return table;
}

CamAbilities camsOf(const ReportedDevice &device)
{
    return device.description ? device.description->capabilities.cams.value_or(CamAbilities{})
                              : CamAbilities{};
}

// The positions of the encoder, if known; otherwise those that the cams span.
CamPicture pictureOf(const ReportedDevice &device, const CamProgram &program, const QString &title)
{
    CamPicture picture{title, program, 1, numberText(0), {}, camsOf(device).cams};
    ParameterValues values = device.knownValues();
    for (const ParameterValue &wanted : device.planned->wanted)
        replaceValue(values, wanted);
    const auto range = device.description ? totalRange(*device.description, values) : std::nullopt;
    if (range) {
        picture.positions = *range;
        picture.lastText = numberText(*range - 1);
        return picture;
    }
    for (const Cam &cam : program.cam)
        picture.positions = std::max({picture.positions, cam.start + 1, cam.stop + 1});
    picture.lastText =
        sentence(ReportTexts::tr("%1, the largest position of a cam; the total range is unknown"),
                 {numberText(picture.positions - 1)});
    return picture;
}

QString wantedTitle(unsigned program)
{
    return sentence(ReportTexts::tr("Cam program %1, wanted"), {QString::number(program)});
}

QString knownTitle(const StoredCams &known, bool asWanted, const QDateTime &now)
{
    const QStringList parts{QString::number(known.program.number), known_words::word(known.evidence),
                            report_words::time(known.at, now)};
    return asWanted ? sentence(ReportTexts::tr("Cam program %1, as wanted, known: %2, %3"), parts)
                    : sentence(ReportTexts::tr("Cam program %1, known: %2, %3"), parts);
}

void addProgram(std::vector<ReportBlock> &blocks, const ReportedDevice &device, const BothPrograms &both,
                const QDateTime &now)
{
    if (both.wanted && !both.isAsWanted())
        blocks.emplace_back(pictureOf(device, *both.wanted, wantedTitle(both.wanted->number)));
    if (both.known)
        blocks.emplace_back(
            pictureOf(device, both.known->program, knownTitle(*both.known, both.isAsWanted(), now)));
    blocks.emplace_back(camTable(both, camsOf(device)));
}

} // namespace

std::vector<ReportBlock> camBlocks(const ReportedDevice &device, const QDateTime &now)
{
    std::vector<ReportBlock> blocks;
    QStringList unset;
    for (const unsigned program : device.camPrograms()) {
        const BothPrograms both{device.wantedCams(program), device.knownCams(program)};
        if (both.isNothingSet())
            unset << QString::number(program);
        else
            addProgram(blocks, device, both, now);
    }
    if (!unset.isEmpty())
        blocks.emplace_back(sentence(ReportTexts::tr("Cam programs in which nothing is set: %1."),
                                     {unset.join(QStringLiteral(", "))}));
    return blocks;
}

} // namespace codewheel
