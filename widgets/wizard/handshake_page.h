// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/job/done_jobs.h"
#include "widgets/job/step_table.h"
#include "widgets/wizard/wizard_page.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QTableView;

namespace codewheel {

class InlineMessage;
class JobCancel;
struct CancelSituation;
class RoleLabel;

// The handshake, step by step, each with OUT and IN; "Next step" by hand, or running by itself. An error
// stops it; an encoder left in parameterization or error can be brought back from here.
class HandshakePage final : public WizardPage
{
    Q_OBJECT

public:
    explicit HandshakePage(Setup &setup, QWidget *parent = nullptr);

    void enter() override;
    bool mayGoOn() const override { return m_setup.record.outcome && !isBusy(); }
    bool mayGoBack() const override { return !isBusy(); }
    QString nextText() const override { return tr("&Report"); }
    void showLatest() override;
    void showProgress() override;
    void showOutcome(const Outcome &ended) override;

    // What is under way, for the page in another language.
    struct Work
    {
        std::vector<Job> jobs{};    // to come
        std::vector<Step> toCome{}; // their steps
        DoneJobs done{};            // before the running one
        std::optional<JobId> job{}; // of the handshake, or bringing the encoder back
        bool isRecovery = false;
        bool isCancelled = false;
        Word outNow = 0;
    };
    struct UnderWay
    {
        Work work;
        std::vector<StepRow> steps;
        int current = -1;
    };
    UnderWay underWay() const { return {m_work, m_steps.rows(), m_steps.current()}; }
    void resume(const UnderWay &before); // after enter()

    void start(); // by hand it sends nothing, otherwise the first word
    bool isBusy() const { return m_work.job.has_value(); }
    bool waitsForFirstStep() const;
    // Asks if the encoder has taken something, perhaps a moment later. False: the user goes on with the
    // handshake.
    bool cancel();
    void showRow(const Exchange &row);

Q_SIGNALS:
    void goesOn(const codewheel::FollowingJob &job); // the handshake has another job

private:
    Result<void> startJob();
    void tellWhatItFollows();
    std::vector<Step> stepsWithThoseToCome(const Progress &progress) const;
    void nextStep();
    void setByItself(bool on);
    void bringBack(bool restore);
    void showWhereItIs(const Progress &progress);
    void showEnd();
    QString verifiedText(const Outcome &last) const;
    void showWords();
    void noteBefore();
    QStringList validTexts(const Outcome &last) const;
    QString positionThenText() const;
    QString positionAfterRun() const;
    CancelSituation situation(const EncoderSession &encoder, const Progress &progress) const;
    void leaveEncoder(OnCancel how);
    void goOn();

    StepTable m_steps{StepTable::Stage::running};
    QTableView *m_view;
    RoleLabel *m_state;
    QLabel *m_out;
    QLabel *m_in;
    QPushButton *m_next;
    QCheckBox *m_byItself;
    InlineMessage *m_problem;
    QLabel *m_leftIn;
    QPushButton *m_restore;
    QPushButton *m_run;
    JobCancel *m_cancel;
    Work m_work;
    EncoderState m_shownState = EncoderState::notSeen; // in the sentence about the end
};

} // namespace codewheel
