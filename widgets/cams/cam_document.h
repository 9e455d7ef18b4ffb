// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/cam_program.h"
#include "vocabulary/place.h"
#include "widgets/project/project_document.h"

#include <array>
#include <vector>

namespace codewheel {

// The eight cam programs the user wants an encoder to have: edited, not sent. A facade of the project; the
// cam editor has one for each encoder.
class CamDocument : public QObject
{
    Q_OBJECT

public:
    // Changes within one gesture, such as a mouse drag, are one undo step.
    using Gesture = ProjectDocument::Gesture;
    static constexpr Gesture noGesture = ProjectDocument::noGesture;

    CamDocument(ProjectDocument &project, Place number, QObject *parent = nullptr);

    const CamProgram &program(unsigned number) const; // 1..8
    // what: the name of the undo step: "Move cam 3".
    void setProgram(const CamProgram &program, const QString &what, Gesture gesture = noGesture);
    // All in one step.
    void setPrograms(const std::vector<CamProgram> &programs, const QString &what,
                     Gesture gesture = noGesture);
    Gesture newGesture() { return m_project.newGesture(); }

    QUndoStack &undoStack() { return m_project.undoStack(); } // of the whole project

Q_SIGNALS:
    void programChanged(unsigned number);

private:
    void take();

    ProjectDocument &m_project;
    Place m_number;
    std::array<CamProgram, CamProgram::programs> m_programs;
};

} // namespace codewheel
