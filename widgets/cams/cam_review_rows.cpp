// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_review_rows.h"

#include "cams/cam_states.h"
#include "catalog/explain_word.h"
#include "drivers/planned_words.h"
#include "drivers/values_to_write.h"
#include "widgets/cams/cam_texts.h"

#include <QCoreApplication>

namespace codewheel {
namespace {

// The context of these texts.
struct CamReviewRows
{
    Q_DECLARE_TR_FUNCTIONS(CamReviewRows)
};

// What the word sets, as the encoder is known to have it.
std::int64_t setTo(const CamProgram &program, Word word)
{
    if (k3::isCamStart(word))
        return program.cam.at(k3::number(word)).start;
    if (k3::isCamStop(word))
        return program.cam.at(k3::number(word)).stop;
    return k3::isCamShift(word) ? program.shift : activeCams(program);
}

std::int64_t setBy(Word word)
{
    if (k3::isCamPosition(word))
        return k3::data(word);
    return word & 0xFF;
}

bool isThere(const KnownCams &known, Word word)
{
    return setTo(known.program, word) == setBy(word);
}

QString oldText(Word word, std::int64_t value)
{
    if (!k3::isCamConfiguration(word))
        return cam_texts::position(value);
    QStringList cams;
    for (unsigned cam = 0; cam < CamProgram::cams; ++cam)
        if ((value >> cam & 1) != 0)
            cams << QString::number(cam);
    return cams.isEmpty() ? CamReviewRows::tr("none") : cams.join(QStringLiteral(", "));
}

QString meaningOf(const DeviceDescription &device, Word word)
{
    return explanationText(device, explainWord(device, word,
                                               {.direction = WordDirection::out,
                                                .dialect = device.dialect,
                                                .mode = Mode::cam,
                                                .coding = {},
                                                .counterpart = {}}));
}

} // namespace

std::vector<CamReviewRow> camReviewRows(const EncoderSession &encoder, const WriteCams &job)
{
    std::vector<CamReviewRow> rows;
    for (const CamProgram &program : job.programs) {
        const auto steps =
            plannedSteps(encoder.device(), allKnown(encoder),
                         WriteCams{.programs = {program}, .onlyWhatDiffers = false, .afterwards = {}});
        if (!steps)
            continue;
        const auto known = encoder.cams(program.number);
        for (const Step &step : *steps)
            if (step.kind == StepKind::camParameter &&
                !(known && job.onlyWhatDiffers && isThere(*known, step.out)))
                rows.push_back({.program = program.number,
                                .word = step.out,
                                .meaning = meaningOf(encoder.device(), step.out),
                                .old = known ? oldText(step.out, setTo(known->program, step.out))
                                             : CamReviewRows::tr("unknown")});
    }
    return rows;
}

} // namespace codewheel
