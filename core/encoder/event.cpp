// SPDX-License-Identifier: GPL-3.0-or-later
#include "encoder/event.h"

#include "esc/esc_request.h"
#include "words/la66_word.h"

namespace codewheel {
namespace {

bool isWritingRequest(const Step &step)
{
    if (step.kind != StepKind::request)
        return false;
    const auto request = esc::parseRequest(step.line);
    return request && esc::shapeOf(request->command).writes;
}

} // namespace

bool writesAnything(const Step &step)
{
    return step.kind == StepKind::parameter ||
           (step.kind == StepKind::serviceBit && la66::isWrite(step.out)) || isWritingRequest(step);
}

bool writesValue(const Step &step)
{
    return step.parameter && writesAnything(step);
}

} // namespace codewheel
