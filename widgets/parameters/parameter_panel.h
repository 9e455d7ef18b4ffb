// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/job/done_jobs.h"
#include "widgets/look/roles.h"
#include "widgets/models/shown_encoder.h"
#include "widgets/monitor/word_format.h"
#include "widgets/parameters/parameter_table.h"

#include <QWidget>

class QAction;
class QLabel;
class QPushButton;
class QStackedWidget;
class QToolButton;

namespace codewheel {

class Buses;
class CopyMenu;
class EmptyState;
class EncoderFunctions;
class ContentScrollArea;
class InlineMessage;
class KnownBeforeBar;
class JobStrip;
class ParameterModel;
class PresetReview;
class RoleLabel;
class ValueBar;
class WantedValues;
class WriteReview;

// The parameters of the encoder chosen in the bus structure: what it is known to have, what is wanted, and
// the ways to make them the same. Sends nothing unless asked, and first shows what will be written. While the
// encoder is not connected, only the wanted values of the planned one can be edited.
class ParameterPanel : public QWidget
{
    Q_OBJECT

public:
    // Buses and wanted values must outlive the panel.
    ParameterPanel(const Buses &buses, WantedValues &wanted, QWidget *parent = nullptr);

    // What is being typed in the table, and typed again in the panel in another language.
    std::optional<ParameterTable::Typed> typed() const { return m_table->typed(); }
    void goOn(const ParameterTable::Typed &typed) { m_table->goOn(typed); }
    void setEncoder(const codewheel::ShownEncoder &encoder);
    // Modes, FRABA preset, reset: for the menu here and that of the window.
    QList<QAction *> functionActions() const;
    QAction &isInPositionMode() const; // one of them: the user says so

    void showParameter(Parameter parameter); // chooses its row; nothing is read or written
    void showWhose();                        // the name of its bus has changed
    // Its end is told together with those of the jobs before it.
    void takeFollowing(const codewheel::FollowingJob &job) { m_following = job; }

Q_SIGNALS:
    void wizardRequested();
    void refusalShown(); // after one of the function actions

private:
    enum class Cause { input, refusal, outcome };

    QWidget *makeTablePage();
    QWidget *makeButtons();
    void makeMenu();
    void connectParts();
    void connectSession(EncoderSession &session);
    void showEnd(const Outcome &outcome);
    DoneJobs doneBefore(JobId job) const;
    void tellEnd();
    bool tellsEnd() const;
    void followSight();
    void followState();
    void followCount();
    void showWhyEmpty();
    void giveWayToQuestion();
    void showWhatIsPossible();

    void read();
    void review();
    void start(const Job &job);
    void bringBack();
    void takeKnownAsWanted();
    void askWhatItHas();
    void askWherePositionIs();
    void showMenu(const QPoint &position);
    Result<std::vector<Word>> chosenWords() const;
    void copyWords(WordNotation notation);

    void finished(const Outcome &outcome);
    void showRefusal(const Refusal &why);
    void showDifferences();
    void showValueNotes();
    void showRunningJob();
    void showWrongInput(const QString &wrong);
    void showMessage(Cause cause, Role role, const QString &sentence, const QString &action = {});
    void withdraw(Cause cause); // its message, if that is the one shown
    Parameter currentParameter() const;
    EncoderSession *session() const { return m_encoder.session(); } // null: not connected

    WantedValues &m_wanted;
    ShownEncoder m_encoder;
    std::optional<Cause> m_cause; // of the message that is shown
    std::optional<Outcome> m_end; // that it tells
    FollowingJob m_following;
    Instant m_endedAt{};

    ParameterModel *m_model;
    EncoderFunctions *m_functions;
    QLabel *m_whose;         // the encoder that is being set up
    QStackedWidget *m_pages; // empty, table, a review
    EmptyState *m_empty;
    QWidget *m_tablePage = nullptr;
    WriteReview *m_review;
    PresetReview *m_presetReview;
    QWidget *m_values = nullptr; // all above the buttons
    ParameterTable *m_table = nullptr;
    RoleLabel *m_differences = nullptr;
    QLabel *m_valueNotes = nullptr;
    QLabel *m_note = nullptr;
    KnownBeforeBar *m_before = nullptr;
    ContentScrollArea *m_saidArea = nullptr;
    InlineMessage *m_message = nullptr;
    ValueBar *m_bar = nullptr;
    QWidget *m_buttons = nullptr; // or, while a job runs,
    JobStrip *m_job = nullptr;
    QPushButton *m_read = nullptr;
    QPushButton *m_write = nullptr;
    QPushButton *m_wizard = nullptr;
    QToolButton *m_more = nullptr;
    CopyMenu *m_copyAs = nullptr;
    QAction *m_takeKnown = nullptr;
    QAction *m_leaveAll = nullptr;
    QAction *m_tellValue = nullptr;
    QAction *m_setPosition = nullptr;
};

} // namespace codewheel
