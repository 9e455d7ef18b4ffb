// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/look/page.h"
#include "widgets/project/project_document.h"

class QLabel;

namespace codewheel {

class BusList;
class NoteField;
class TextField;

// The project's own data: title, buses and note. Leaving an edited field is one undo step.
class ProjectPage : public Page
{
    Q_OBJECT

public:
    // The document outlives the page.
    explicit ProjectPage(ProjectDocument &document, QWidget *parent = nullptr);
    ~ProjectPage() override;

    BusList &buses() { return *m_buses; }
    QString title() const override { return tr("Project"); }
    QString about() const override { return m_document.project().title; }
    QString effect() const override;

private:
    void makeFields();
    void arrange();
    void setTitle(const QString &title);
    void setNote(const QString &note);
    void edit(const QString &what, const std::function<void(Project &)> &change);
    void showProject();

    ProjectDocument &m_document;
    TextField *m_title;
    BusList *m_buses;
    NoteField *m_note;
    QLabel *m_file;
};

} // namespace codewheel
