// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/project.h"
#include "vocabulary/message.h"

#include <QObject>

#include <functional>

class QMainWindow;
class QMenu;

namespace codewheel {

class InlineMessage;
class ProjectDocument;
class WindowActions;
class WindowSettings;

// The project as a file of the window: new, open, save, recent files, the mark for unsaved changes; asks
// before anything is lost. Failures are reported inline.
class ProjectFiles : public QObject
{
    Q_OBJECT

public:
    // All must outlive it; the notice is part of the window.
    ProjectFiles(QMainWindow &window, ProjectDocument &document, WindowSettings &settings,
                 const WindowActions &actions, InlineMessage &notice);

    // What to add to the file besides what was edited.
    void setBeforeSaving(std::function<Project(Project)> complete) { m_complete = std::move(complete); }
    // What ends for others with the project, in sentences; empty: nothing.
    void setEndsForOthers(std::function<QString()> ends) { m_endsForOthers = std::move(ends); }

    // Each first asks what to do with unsaved changes, and whether something may end for others. False:
    // nothing was opened.
    bool open(const QString &path);
    bool makeNew();
    // The same for the training bus, which says what was closed.
    bool makeNewForTraining();
    // With a dialog.
    bool askOpen();
    // Removes it from the recent files.
    void forget(const QString &path);
    // False: it was not saved, and says why; or the user cancelled.
    bool save();
    bool saveAs();
    // False: the user stays.
    bool mayClose();

Q_SIGNALS:
    void told(const codewheel::Message &message);
    void recentChanged();

private:
    bool maySaveOrDiscard();
    bool mayEndForOthers();
    bool keep(const QString &path, const std::optional<QByteArray> &over = {});
    bool saveBesideAnother(); // the file has what another program saved
    QString leftOut() const;
    void refuse(const Refusal &why);
    void remember(const QString &path);
    void fillRecent();
    void showTitle();

    QMainWindow &m_window;
    ProjectDocument &m_document;
    WindowSettings &m_settings;
    InlineMessage &m_notice;
    QMenu &m_recent;
    std::function<Project(Project)> m_complete;
    std::function<QString()> m_endsForOthers;
};

} // namespace codewheel
