// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_document.h"

#include <QUndoCommand>

namespace codewheel {

// The one step of undo there is: program N becomes V.
class SetCamProgram final : public QUndoCommand
{
public:
    SetCamProgram(CamDocument &document, const CamProgram &after, const QString &what,
                  CamDocument::Gesture gesture)
        : QUndoCommand(what)
        , m_document(document)
        , m_before(document.program(after.number))
        , m_after(after)
        , m_gesture(gesture)
    {}

    void undo() override { m_document.replace(m_before); }
    void redo() override { m_document.replace(m_after); }
    int id() const override { return m_gesture == CamDocument::noGesture ? -1 : 1; }

    bool mergeWith(const QUndoCommand *next) override
    {
        const auto &later = static_cast<const SetCamProgram &>(*next);
        if (later.m_gesture != m_gesture || later.m_after.number != m_after.number)
            return false;
        m_after = later.m_after;
        setObsolete(m_after == m_before);
        return true;
    }

private:
    CamDocument &m_document;
    CamProgram m_before;
    CamProgram m_after;
    CamDocument::Gesture m_gesture;
};

CamDocument::CamDocument(QObject *parent)
    : QObject(parent)
{
    for (unsigned number = 1; number <= CamProgram::programs; ++number)
        m_programs[number - 1].number = number;
}

const CamProgram &CamDocument::program(unsigned number) const
{
    return m_programs.at(number - 1);
}

void CamDocument::setProgram(const CamProgram &program, const QString &what, Gesture gesture)
{
    if (program != this->program(program.number))
        m_undo.push(new SetCamProgram(*this, program, what, gesture));
}

void CamDocument::setPrograms(const std::vector<CamProgram> &programs, const QString &what)
{
    if (std::ranges::all_of(programs, [this](const CamProgram &p) { return p == program(p.number); }))
        return;
    m_undo.beginMacro(what);
    for (const CamProgram &each : programs)
        setProgram(each, what);
    m_undo.endMacro();
}

void CamDocument::replace(const CamProgram &program)
{
    m_programs.at(program.number - 1) = program;
    Q_EMIT programChanged(program.number);
}

} // namespace codewheel
