// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_document.h"

#include <algorithm>

namespace codewheel {
namespace {

// The project keeps only the programs that are set, ordered by number.
void keep(std::vector<CamProgram> &kept, const CamProgram &program)
{
    const auto at = std::ranges::lower_bound(kept, program.number, {}, &CamProgram::number);
    const bool isThere = at != kept.end() && at->number == program.number;
    const bool isSet = program != CamProgram{.number = program.number};
    if (isThere && isSet)
        *at = program;
    else if (isThere)
        kept.erase(at);
    else if (isSet)
        kept.insert(at, program);
}

} // namespace

CamDocument::CamDocument(ProjectDocument &project, Place number, QObject *parent)
    : QObject(parent)
    , m_project(project)
    , m_number(number)
{
    take();
    connect(&m_project, &ProjectDocument::changed, this, &CamDocument::take);
}

const CamProgram &CamDocument::program(unsigned number) const
{
    return m_programs.at(number - 1);
}

void CamDocument::setProgram(const CamProgram &program, const QString &what, Gesture gesture)
{
    setPrograms({program}, tr("Program %1: %2").arg(program.number).arg(what), gesture);
}

void CamDocument::setPrograms(const std::vector<CamProgram> &programs, const QString &what, Gesture gesture)
{
    const QString step = tr("%1, %2", "what was done, at which encoder").arg(what, m_number.shown());
    m_project.editDevice(
        m_number, step,
        [&](ProjectDevice &device) {
            for (const CamProgram &program : programs)
                keep(device.wantedCams, program);
        },
        gesture);
}

void CamDocument::take()
{
    std::array<CamProgram, CamProgram::programs> programs;
    for (unsigned number = 1; number <= CamProgram::programs; ++number)
        programs.at(number - 1).number = number;
    for (const CamProgram &program : m_project.device(m_number).wantedCams)
        if (program.number >= 1 && program.number <= CamProgram::programs)
            programs.at(program.number - 1) = program;
    const auto before = std::exchange(m_programs, programs);
    for (unsigned number = 1; number <= CamProgram::programs; ++number)
        if (before.at(number - 1) != programs.at(number - 1))
            Q_EMIT programChanged(number);
}

} // namespace codewheel
