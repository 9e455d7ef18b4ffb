// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cams/cam_file.h"
#include "widgets/cams/cam_jobs.h"
#include "widgets/cams/cam_sheet.h"
#include "widgets/look/page.h"
#include "widgets/look/printed_view.h"
#include "widgets/look/roles.h"
#include "widgets/models/shown_encoder.h"

#include <functional>
#include <memory>

class QAction;
class QMenu;
class QScrollArea;
class QStackedWidget;
class QToolBar;

namespace codewheel {

class AgeTimer;
class Buses;
class CamBoard;
class CamModeBar;
class CamRangeBar;
class CamReview;
class Catalog;
class EmptyState;
class InlineMessage;
class JobStrip;
struct Track;

// The cams of the encoder that is chosen in the bus structure: edit, read, write, compare, keep in files of
// their own. What is edited is part of the project, and can be edited while the encoder is not connected.
// Sends nothing unless asked, and shows what will be written before.
class CamEditor : public Page, public PrintsPicture
{
    Q_OBJECT

public:
    // The catalog names the device a file was made for. The programs are kept in the project. All must
    // outlive the editor.
    CamEditor(const Buses &buses, const Catalog &catalog, ProjectDocument &project,
              QWidget *parent = nullptr);

    void setEncoder(const codewheel::ShownEncoder &encoder);
    QString title() const override { return tr("Cams"); }
    QString about() const override;
    QString effect() const override;

    std::optional<PrintedView> printedView() const override;

    // All programs a file holds; or the open program alone. Each says on the spot what went wrong.
    bool load(const QString &path);
    bool loadProgram(const QString &path);
    bool save(const QString &path);
    bool saveProgram(const QString &path);

Q_SIGNALS:
    void trendWanted(const codewheel::Track &track);

private:
    // What is kept for an encoder while the program runs.
    struct Work
    {
        Work(ProjectDocument &project, Place number)
            : document(project, number)
        {}
        CamDocument document;
        unsigned program = 1;
        std::optional<std::int64_t> toldLargest;
    };
    enum class Cause { input, refusal, outcome, file };

    void makeTools();
    void makeMenu();
    void makePages();
    void connectParts();
    void connectSession(EncoderSession &session);
    Work &workOf(Place number);

    void chooseProgram(unsigned number);
    void showKnown();
    void showRange();
    void tellLargest(std::int64_t largest);
    void showLive();
    void showRunningJob();
    QString note(const Reading &reading) const;

    void readAll();
    void write();
    void writeAll();
    void readRange();
    void bringBack();
    void askLoad();
    void askLoadProgram();
    void askSave();
    void askSaveProgram();
    tl::expected<CamFile, QString> open(const QString &path) const;
    bool keep(const QString &path, const std::vector<CamProgram> &programs);

    void readPrograms(CamJobs::Purpose purpose, const std::vector<unsigned> &programs);
    void reviewPrograms(const std::vector<CamProgram> &programs);
    // First asks which mode to leave the encoder in, where its mode is not known.
    void withModeAfterwards(std::function<void(const SwitchMode &)> then);
    // In Watch it says so, before anything is asked that leads to nothing.
    bool isRefusedInWatch();
    void start(CamJobs::Purpose purpose, const Job &job);
    void finished(Place number, CamJobs::Purpose purpose, const Outcome &outcome);

    void sayWhatDiffers(const CamProgram &wanted, const CamProgram &there);
    void say(Cause cause, Role role, const QString &sentence, const QString &action = {});
    void withdraw(Cause cause);                                     // its message, if that is the one shown
    EncoderSession *session() const { return m_encoder.session(); } // null: not connected

    const Buses &m_buses;
    const Catalog &m_catalog;
    ProjectDocument &m_project;
    ShownEncoder m_encoder; // with cams, or none
    std::map<Place, std::unique_ptr<Work>> m_works;
    CamSheet *m_sheet;
    AgeTimer *m_age;
    CamJobs *m_jobs;
    std::function<void(const SwitchMode &)> m_whenAnswered;
    std::optional<Cause> m_cause; // of the message that is shown

    QToolBar *m_tools;
    QMenu *m_menu;
    QList<QAction *> m_jobActions;  // need an encoder with cams that is connected and has no job
    QList<QAction *> m_modeActions; // need one whose cams have a mode
    QList<QAction *> m_fileActions; // need an encoder with cams
    InlineMessage *m_message;
    CamModeBar *m_mode;
    CamRangeBar *m_range;
    QStackedWidget *m_pages; // empty, board, review
    EmptyState *m_empty;
    CamBoard *m_board;
    QScrollArea *m_scroll;
    CamReview *m_review;
    JobStrip *m_job;
};

} // namespace codewheel
