// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/project/project_document.h"

#include <QWidget>

class QComboBox;
class QToolButton;

namespace codewheel {

class SequenceView;

// The sequences of the project, above the sequence view: one of them is open there, and editing it makes undo
// steps of the project.
class ProjectSequences : public QWidget
{
    Q_OBJECT

public:
    // Both must outlive it.
    ProjectSequences(ProjectDocument &document, SequenceView &view, QWidget *parent = nullptr);
    ~ProjectSequences() override;

private:
    void take();
    void keep();
    void open(int sequence);
    void add();
    void remove();
    void rename(const QString &typed);
    void edit(const QString &what, const std::function<void(std::vector<ProjectSequence> &)> &change,
              ProjectDocument::Gesture gesture = ProjectDocument::noGesture);
    QString freshName() const;

    ProjectDocument &m_document;
    SequenceView &m_view;
    std::size_t m_open = 0; // index of the open one
    QComboBox *m_names;
    QToolButton *m_add;
    QToolButton *m_remove;
    ProjectDocument::Gesture m_holding; // changes of the cycles, until their field is left
    bool m_isTaking = false;
    bool m_isPending = false; // the edits of one event make one step
};

} // namespace codewheel
