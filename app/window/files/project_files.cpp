// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/files/project_files.h"

#include "app/window/window_actions.h"
#include "app/window/window_settings.h"
#include "project/file_access.h"
#include "project/project_file.h"
#include "vocabulary/refusal_text.h"
#include "vocabulary/shown_text.h"
#include "widgets/help/help_topic.h"
#include "widgets/input/text_fields.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/label_text.h"
#include "widgets/look/save_file.h"
#include "widgets/project/project_document.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>

namespace codewheel {
namespace {

enum class Answer : std::uint8_t { safe, losing, none };

struct Offer
{
    QString text;
    QString toolTip;
};

// Offers the choice that loses nothing first.
Answer ask(QMessageBox &box, const Offer &safe, const Offer &losing)
{
    const auto add = [&box](const Offer &offer, QMessageBox::ButtonRole role) {
        QPushButton *button = box.addButton(offer.text, role);
        button->setToolTip(offer.toolTip);
        return button;
    };
    QPushButton *first = add(safe, QMessageBox::AcceptRole);
    const QPushButton *second = add(losing, QMessageBox::DestructiveRole);
    box.setEscapeButton(box.addButton(QMessageBox::Cancel));
    box.setDefaultButton(first);
    box.exec();
    return box.clickedButton() == first    ? Answer::safe
           : box.clickedButton() == second ? Answer::losing
                                           : Answer::none;
}

} // namespace

ProjectFiles::ProjectFiles(QMainWindow &window, ProjectDocument &document, WindowSettings &settings,
                           const WindowActions &actions, InlineMessage &notice)
    : QObject(&window)
    , m_window(window)
    , m_document(document)
    , m_settings(settings)
    , m_notice(notice)
    , m_recent(*actions.recentFiles)
{
    connect(actions.newProject, &QAction::triggered, this, &ProjectFiles::makeNew);
    connect(actions.openProject, &QAction::triggered, this, &ProjectFiles::askOpen);
    connect(actions.saveProject, &QAction::triggered, this, &ProjectFiles::save);
    connect(actions.saveProjectAs, &QAction::triggered, this, &ProjectFiles::saveAs);
    connect(&m_recent, &QMenu::aboutToShow, this, &ProjectFiles::fillRecent);
    connect(&document, &ProjectDocument::fileChanged, this, &ProjectFiles::showTitle);
    connect(&document, &ProjectDocument::savedChanged, this, &ProjectFiles::showTitle);
    connect(&document, &ProjectDocument::changed, this, &ProjectFiles::showTitle);
    fillRecent();
    showTitle();
}

void ProjectFiles::showTitle()
{
    const QString name =
        m_document.file().isEmpty() ? tr("Untitled") : QFileInfo(m_document.file()).fileName();
    m_window.setWindowTitle(name + QStringLiteral("[*]"));
    m_window.setWindowModified(!m_document.isSaved());
}

bool ProjectFiles::open(const QString &path)
{
    if (!mayClose())
        return false;
    auto project = loadProject(path);
    if (!project) {
        forget(path);
        refuse(project.error());
        return false;
    }
    m_notice.withdraw();
    const QByteArray mark = projectMark(*project);
    m_document.setProject(std::move(*project), QFileInfo(path).absoluteFilePath(), mark);
    remember(path);
    Q_EMIT told({.severity = Severity::information, .id = MessageId::projectOpened, .arguments = {path}});
    return true;
}

bool ProjectFiles::makeNew()
{
    if (!mayClose())
        return false;
    m_notice.withdraw();
    m_document.setProject({}, {});
    return true;
}

bool ProjectFiles::makeNewForTraining()
{
    const QString closed = m_document.file();
    if (!makeNew())
        return false;
    if (!closed.isEmpty())
        m_notice.showMessage(
            Role::running,
            tr("The project %1 was closed: the training bus has its own. File > Recent files opens it again.")
                .arg(shownInLine(QFileInfo(closed).fileName())));
    return true;
}

bool ProjectFiles::askOpen()
{
    const QString path =
        QFileDialog::getOpenFileName(&m_window, tr("Open a project"), QFileInfo(m_document.file()).path(),
                                     tr("Codewheel projects (*.codewheel)"));
    return !path.isEmpty() && open(path);
}

bool ProjectFiles::save()
{
    takeFocusedField();
    const QString file = m_document.file();
    if (file.isEmpty())
        return saveAs();
    return keep(file, m_document.fileMark());
}

bool ProjectFiles::saveBesideAnother()
{
    const QFileInfo file(m_document.file());
    QMessageBox box(QMessageBox::Question, tr("Project"),
                    tr("%1 no longer holds what was read or saved here: another program has changed it.")
                        .arg(file.fileName()),
                    QMessageBox::NoButton, &m_window);
    box.setObjectName(QStringLiteral("changedFileQuestion"));
    setHelpTopic(box, "project.md#files");
    box.setInformativeText(tr("It was changed at %1. If it is replaced, the project in it is kept as %2.")
                               .arg(QLocale().toString(file.lastModified(), QLocale::ShortFormat),
                                    QFileInfo(backupPath(file.canonicalFilePath())).fileName()));
    const Answer answer =
        ask(box, {tr("Save &as…"), tr("Saves the project in another file; this one stays unchanged")},
            {tr("&Replace"), tr("Saves the project in place of what is in the file")});
    return answer == Answer::safe ? saveAs() : answer == Answer::losing && keep(m_document.file());
}

bool ProjectFiles::saveAs()
{
    takeFocusedField();
    const QString proposed =
        m_document.file().isEmpty() ? tr("untitled.codewheel", "file name") : m_document.file();
    const QString path =
        askSaveFile(&m_window, tr("Save the project"), proposed, {tr("Codewheel projects (*.codewheel)")});
    return !path.isEmpty() && keep(path);
}

// `over`: what an existing file may contain; nothing: anything.
bool ProjectFiles::keep(const QString &path, const std::optional<QByteArray> &over)
{
    const Project &edited = m_document.project();
    const Project complete = m_complete ? m_complete(edited) : edited;
    const auto saved = over ? saveProjectOver(*over, complete, path) : saveProject(complete, path);
    if (!saved && saved.error().id == RefusalId::fileChanged)
        return saveBesideAnother();
    if (!saved) {
        refuse(saved.error());
        return false;
    }
    m_notice.withdraw();
    m_document.takeLastPositions(complete);
    m_document.setFile(path, projectMark(complete));
    remember(path);
    Q_EMIT told({.severity = Severity::information, .id = MessageId::projectSaved, .arguments = {path}});
    if (const QString left = leftOut(); !left.isEmpty())
        m_notice.showMessage(Role::attention, left);
    return true;
}

// What the project's file cannot contain; empty: nothing.
QString ProjectFiles::leftOut() const
{
    QStringList places;
    for (const std::vector<Place> &some : {m_document.notPlanned(), m_document.notKept()})
        for (const Place place : some)
            places << place.shown();
    if (places.isEmpty())
        return {};
    return tr("What is planned for %1 is in no file: the project has no device there. Compare (F9), take it "
              "into the project, then save.")
        .arg(places.join(QStringLiteral(", ")));
}

bool ProjectFiles::mayClose()
{
    return mayEndForOthers() && maySaveOrDiscard();
}

bool ProjectFiles::mayEndForOthers()
{
    const QString what = m_endsForOthers ? m_endsForOthers() : QString();
    if (what.isEmpty())
        return true;
    QMessageBox box(QMessageBox::Question, tr("Project"), tr("Others are connected to this program. Go on?"),
                    QMessageBox::NoButton, &m_window);
    box.setObjectName(QStringLiteral("othersQuestion"));
    setHelpTopic(box, "serving.md#in-the-window");
    box.setInformativeText(what);
    QPushButton *go = box.addButton(tr("&Disconnect them"), QMessageBox::DestructiveRole);
    go->setToolTip(tr("Ends what is offered, and goes on"));
    QPushButton *stay = box.addButton(QMessageBox::Cancel);
    box.setDefaultButton(stay);
    box.setEscapeButton(stay);
    box.exec();
    return box.clickedButton() == go;
}

bool ProjectFiles::maySaveOrDiscard()
{
    takeFocusedField();
    if (m_document.isSaved())
        return true;
    QMessageBox box(QMessageBox::Question, tr("Project"), tr("The project has changes that are not saved."),
                    QMessageBox::NoButton, &m_window);
    box.setObjectName(QStringLiteral("unsavedQuestion"));
    setHelpTopic(box, "project.md#files");
    QStringList details;
    if (const QString next = m_document.undoStack().undoText(); !next.isEmpty())
        details << tr("The last one: %1.").arg(next);
    if (const QString left = leftOut(); !left.isEmpty())
        details << left;
    box.setInformativeText(details.join(u'\n'));
    const Answer answer = ask(box, {tr("&Save"), tr("Saves the project, then goes on")},
                              {tr("&Discard"), tr("Goes on; what was changed is lost")});
    return answer == Answer::safe ? save() : answer == Answer::losing;
}

void ProjectFiles::refuse(const Refusal &why)
{
    m_notice.showMessage(Role::fault, refusalText(why));
}

void ProjectFiles::remember(const QString &path)
{
    constexpr qsizetype mostFiles = 10;
    QStringList files = m_settings.recentFiles();
    const QString absolute = QFileInfo(path).absoluteFilePath();
    files.removeAll(absolute);
    files.prepend(absolute);
    m_settings.setRecentFiles(files.first(std::min(mostFiles, files.size())));
    fillRecent();
    Q_EMIT recentChanged();
}

void ProjectFiles::forget(const QString &path)
{
    QStringList files = m_settings.recentFiles();
    if (files.removeAll(QFileInfo(path).absoluteFilePath()) == 0)
        return;
    m_settings.setRecentFiles(files);
    Q_EMIT recentChanged();
}

void ProjectFiles::fillRecent()
{
    m_recent.clear();
    int number = 0;
    for (const QString &path : m_settings.recentFiles()) {
        const QString name = asLabel(QFileInfo(path).fileName());
        QAction *action = m_recent.addAction(QStringLiteral("&%1  %2").arg(++number % 10).arg(name));
        action->setToolTip(path);
        action->setStatusTip(path);
        connect(
            action, &QAction::triggered, this, [this, path] { open(path); }, Qt::QueuedConnection);
    }
    m_recent.menuAction()->setEnabled(number > 0);
}

} // namespace codewheel
