// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "kinds/esc/line/esc_line_event.h"
#include "kinds/esc/protocol/esc_explain.h"
#include "vocabulary/place.h"
#include "widgets/look/roles.h"

#include <QDateTime>
#include <QPointer>
#include <QWidget>

class QAction;
class QPushButton;
class QStackedWidget;
class QToolBar;
class QVBoxLayout;

namespace codewheel {

class GoToPlace;
class InlineMessage;
class EscLineRecordView;
class TrafficTable;
class EscLineSession;
class MeaningLine;
class RequestField;
class TrafficModel;
struct TrafficRow;

// The terminal of a serial line: what passed both ways, as text, bytes and words; requests are typed and
// sent; the session is saved, looked at again and resent. What was collected outlives the connection.
class EscLineTerminal : public QWidget
{
    Q_OBJECT

public:
    explicit EscLineTerminal(QWidget *parent = nullptr);

    void setLine(codewheel::EscLineSession *line); // null: none
    void setExplainOptions(const esc::ExplainOptions &options);
    void setRecordingChosen(bool isChosen); // then nothing is sent
    void setMostRows(int rows);             // beyond these the oldest are dropped
    // The typed requests, oldest first, for the settings.
    QStringList history() const;
    void setHistory(const QStringList &history);

    // What was collected, for the terminal in another language.
    struct Collected
    {
        std::shared_ptr<const TrafficModel> rows;
        QDateTime begin;
    };
    Collected takeRows(); // it is about to go
    void goOn(const Collected &before);

    // They report on the spot what went wrong.
    bool save(const QString &path);       // all rows, docs/line-sessions.md
    bool open(const QString &path);       // to be looked at and sent again
    bool exportText(const QString &path); // the rows shown, UTF-8, tabs between the columns

Q_SIGNALS:
    void historyChanged();
    void goToWanted(codewheel::Place place); // the chosen row's

protected:
    void paintEvent(QPaintEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QWidget *makePage();
    void makeTools(QToolBar &bar);
    void makeSending(QVBoxLayout &rows);
    void send();
    void sendNow(const esc::Request &request);
    void askBeforeWrite(const esc::Request &request);
    QString questionText(const esc::Request &request) const;
    QString whoIsAt(const esc::Request &request) const;
    QString whatItShows(const esc::Request &request) const;
    void followPosition();
    void takeAnswer(const TypedAnswered &answer);
    void showAnswer(const TypedAnswered &answer);
    void askSave();
    void askOpen();
    void askExport();
    void add(const TrafficRow &row);
    void showCounts();
    void showWhatIsPossible();
    void keepQuestionWhole();
    bool isConnected() const;
    std::optional<Refusal> whyNotSent() const;
    bool hasJob() const;

    QPointer<EscLineSession> m_line;
    bool m_isRecordingChosen = false;
    esc::ExplainOptions m_options;
    std::optional<esc::Request> m_asked; // that the question is about
    std::optional<esc::Request> m_typed; // sent from the field and not answered yet
    QDateTime m_begin;                   // the date and time of Instant 0 of the rows
    TrafficModel *m_rows;
    QStackedWidget *m_pages;
    QStackedWidget *m_content = nullptr; // the table, or its empty state
    QWidget *m_rowOptions = nullptr;
    TrafficTable *m_table;
    EscLineRecordView *m_record;
    QAction *m_follow = nullptr;
    QAction *m_save = nullptr;
    QAction *m_bringBack = nullptr;
    GoToPlace *m_goTo;
    MeaningLine *m_counts;
    MeaningLine *m_answer; // to what was typed last: stays when its rows are gone
    RequestField *m_field;
    QPushButton *m_send;
    InlineMessage *m_question;
    InlineMessage *m_message;
};

} // namespace codewheel
