// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/cam_program.h"

#include <QObject>
#include <QUndoStack>

#include <vector>

namespace codewheel {

// The eight cam programs the user wants an encoder to have: edited, not sent. The cam editor keeps one for
// each encoder.
class CamDocument : public QObject
{
    Q_OBJECT

public:
    // Changes of one gesture, such as a drag of the mouse, are one step of undo.
    using Gesture = int;
    static constexpr Gesture noGesture = 0;

    explicit CamDocument(QObject *parent = nullptr);

    const CamProgram &program(unsigned number) const; // 1..8
    // what: the name of the step, for undo: "Move cam 3".
    void setProgram(const CamProgram &program, const QString &what, Gesture gesture = noGesture);
    // All in one step.
    void setPrograms(const std::vector<CamProgram> &programs, const QString &what);
    Gesture newGesture() { return ++m_lastGesture; }

    QUndoStack &undoStack() { return m_undo; } // clean: as it was when it was saved
    const QUndoStack &undoStack() const { return m_undo; }

Q_SIGNALS:
    void programChanged(unsigned number);

private:
    friend class SetCamProgram;
    void replace(const CamProgram &program);

    std::array<CamProgram, CamProgram::programs> m_programs;
    QUndoStack m_undo;
    Gesture m_lastGesture = noGesture;
};

} // namespace codewheel
