// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/word_list.h"
#include "vocabulary/place.h"
#include "widgets/input/number_fields.h"
#include "widgets/look/roles.h"
#include "widgets/monitor/word_format.h"
#include "widgets/sequence/sequence_job.h"

#include <QPointer>
#include <QWidget>

#include <functional>
#include <optional>
#include <vector>

class QAction;
class QLabel;
class QPushButton;
class QStackedWidget;
class QTableView;
class QToolBar;

namespace codewheel {

class EmptyState;
class InlineMessage;
class SequenceModel;

// A list of words sent one after the other to the selected encoder, as printed in manuals. The list stays
// when another encoder is selected; ProjectSequences keeps it in the project.
class SequenceView : public QWidget
{
    Q_OBJECT

public:
    explicit SequenceView(QWidget *parent = nullptr);
    ~SequenceView() override;

    // Null: an empty state, which says so if the chosen encoder is not connected.
    void setEncoder(codewheel::EncoderSession *encoder, std::optional<codewheel::Place> offline = {});

    // The words sent to an encoder, for when it is dropped here from the bus structure.
    using WordsOf = std::function<std::vector<Word>(Place)>;
    void setWordsOf(WordsOf wordsOf) { m_wordsOf = std::move(wordsOf); }

    WordList list() const;
    void setList(const WordList &list);
    bool isSending() const { return m_job->isRunning(); }
    // Reports on the spot what went wrong.
    bool load(const QString &path);
    bool save(const QString &path);

Q_SIGNALS:
    void listChanged(); // or may have: also after a word was sent
    void holdTaken();   // the field for the cycles was left, or Return was pressed in it
    void sendingEnded();
    void terminalRequested(); // where requests for an encoder on a serial line are typed

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void insert(const std::vector<Word> &words); // below the selected row
    void makeTable();
    void makeTools();
    void makeSending();
    void add();
    void removeSelected();
    void moveUp() { moveSelected(-1); }
    void moveDown() { moveSelected(1); }
    void moveSelected(int by);
    void makeCopying();
    void copy(WordNotation notation);
    void paste();
    void askLoad();
    void askSave();
    void send();
    void stop(OnCancel how);
    void showEnd(const Outcome &outcome, int words);
    void showWhatIsPossible();
    void explainWords();
    void showWhyEmpty(const EncoderSession *encoder, std::optional<Place> offline);
    int selectedRow() const; // -1: none
    void say(Role role, const QString &sentence);

    QPointer<EncoderSession> m_encoder;
    SequenceModel *m_model;
    SequenceJob *m_job;
    QStackedWidget *m_pages;
    EmptyState *m_empty;
    QToolBar *m_tools;
    QTableView *m_table;
    IntegerField *m_hold;
    QLabel *m_summary;
    QPushButton *m_send;
    QPushButton *m_stop;
    InlineMessage *m_message;
    WordsOf m_wordsOf;
    bool m_isRefused = false;      // the message is a refusal: it goes when sending is allowed
    QList<QAction *> m_rowActions; // need a selected row
};

} // namespace codewheel
