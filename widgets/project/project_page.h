// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/project/project_document.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace codewheel {

// What the project says of itself: title, link and note. What is typed into a field in one go is one step of
// undo.
class ProjectPage : public QWidget
{
    Q_OBJECT

public:
    // The document outlives the page.
    explicit ProjectPage(ProjectDocument &document, QWidget *parent = nullptr);

protected:
    bool eventFilter(QObject *field, QEvent *event) override;

private:
    void makeFields();
    void arrange();
    void setTitle(const QString &title);
    void setNote();
    void setLink();
    void edit(const QString &what, const std::function<void(Project &)> &change);
    void showProject();
    void showLink();

    ProjectDocument &m_document;
    ProjectDocument::Gesture m_typing; // since a field got the focus
    QLineEdit *m_title;
    QComboBox *m_link;
    QLabel *m_settings;
    QPlainTextEdit *m_note;
    QLabel *m_file;
};

} // namespace codewheel
