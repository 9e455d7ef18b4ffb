// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/project/project_document.h"

#include <QCoreApplication>
#include <QUndoCommand>

namespace codewheel {

// What a step changes in a document besides its devices.
struct ProjectDocument::Content
{
    Project header; // without devices
    std::map<Place, ProjectDevice> others;

    friend bool operator==(const Content &, const Content &) = default;
};

// The only kind of undo step: the project before and after. It keeps only the devices from the first to the
// last that changed.
class ProjectStep final : public QUndoCommand
{
    Q_DECLARE_TR_FUNCTIONS(codewheel::ProjectStep)

public:
    using Devices = std::vector<ProjectDevice>;
    using Ids = std::vector<ProjectDocument::DeviceId>;

    ProjectStep(ProjectDocument &document, Project after, Ids ids, std::map<Place, ProjectDevice> others,
                const QString &what, ProjectDocument::Gesture gesture);

    bool changesNothing() const { return m_before == m_after; }
    std::vector<Place> places() const; // devices and buses whose plan it changes, devices first
    void nameAnew();                   // in the present language, after the device it changes

    void undo() override;
    void redo() override;
    int id() const override { return m_gesture == ProjectDocument::noGesture ? -1 : 1; }
    bool mergeWith(const QUndoCommand *next) override;

private:
    struct State
    {
        ProjectDocument::Content content;
        Devices devices;
        Ids ids;

        friend bool operator==(const State &, const State &) = default;
    };

    ProjectDocument &m_document;
    std::size_t m_first = 0; // index of the first device that changes
    State m_before;
    State m_after;
    bool m_isNew = true; // not undone yet
    ProjectDocument::Gesture m_gesture;
};

} // namespace codewheel
