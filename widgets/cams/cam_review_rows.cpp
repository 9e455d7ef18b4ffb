// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_review_rows.h"

#include "cams/cam_fields.h"
#include "drivers/values_to_write.h"
#include "widgets/cams/cam_texts.h"
#include "widgets/job/step_text.h"
#include "words/k3_cam_word.h"

#include <QCoreApplication>

#include <algorithm>

namespace codewheel {
namespace {

// The context of these texts.
struct CamReviewRows
{
    Q_DECLARE_TR_FUNCTIONS(CamReviewRows)
};

QString valueText(CamField field, std::int64_t value)
{
    if (field.value != CamValue::activeCams)
        return cam_texts::position(value);
    QStringList cams;
    for (unsigned cam = 0; cam < CamProgram::cams; ++cam)
        if ((value >> cam & 1) != 0)
            cams << QString::number(cam);
    return cams.isEmpty() ? CamReviewRows::tr("none") : cams.join(QStringLiteral(", "));
}

bool setsCams(const Step &step)
{
    return step.kind == StepKind::camParameter;
}

std::optional<unsigned> programChosenBy(Word word)
{
    const Word number = word & ~k3::programWord;
    return number == 0 ? std::nullopt : std::optional<unsigned>(number);
}

CamReviewRow rowOf(const EncoderSession &encoder, std::optional<unsigned> program, const Step &step)
{
    CamReviewRow row{.program = program, .word = step.out, .meaning = stepText(encoder.device(), step)};
    const auto field = setsCams(step) ? fieldSetBy(step.out) : std::nullopt;
    if (!field)
        return row;
    const auto known = program ? encoder.cams(*program) : std::nullopt;
    if (!known) {
        row.old = CamReviewRows::tr("unknown");
        return row;
    }
    const std::int64_t there = valueOf(known->program, *field);
    row.old = valueText(*field, there);
    row.isThere = there == dataOf(*field, step.out);
    return row;
}

} // namespace

Result<std::vector<CamReviewRow>> camReviewRows(const EncoderSession &encoder, const WriteCams &job)
{
    const auto steps = encoder.planned({job});
    if (!steps)
        return tl::unexpected(steps.error());
    std::vector<CamReviewRow> rows;
    if (std::ranges::none_of(*steps, setsCams))
        return rows;
    std::optional<unsigned> program = encoder.latest().camProgram;
    for (const Step &step : *steps) {
        if (k3::isProgramWord(step.out))
            program = programChosenBy(step.out);
        if (!readsCams(step))
            rows.push_back(rowOf(encoder, program, step));
    }
    return rows;
}

} // namespace codewheel
