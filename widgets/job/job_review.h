// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/encoder_session.h"
#include "widgets/job/review_table.h"
#include "widgets/job/whole_table.h"
#include "widgets/look/quick_press.h"

#include <QPointer>
#include <QWidget>

class QBoxLayout;
class QCheckBox;
class QLabel;
class QPushButton;

namespace codewheel {

class ContentScrollArea;
class EepromGate;
class InlineMessage;

// "EEPROM writes by this: at most 2. The manual states about 200 ..."
QString eepromCostText(const EncoderSession &encoder, int atMost);

// Shown before anything is written: what will change, what is sent for it, what it costs. Follows what
// becomes known of the encoder. In a low panel rows and notes scroll; two rows, the EEPROM writes and the
// buttons are always in sight. The parameter panel and the cam editor derive theirs.
class JobReview : public QWidget
{
    Q_OBJECT

Q_SIGNALS:
    void confirmed(const codewheel::Job &job);
    void cancelled();

protected:
    struct Contents
    {
        Job job;
        std::vector<ReviewRow> rows{};    // none: there is nothing to write
        std::optional<Refusal> problem{}; // why not
        QStringList notes{};
        QString write{}; // on the button
    };

    // id: that of the button that writes; tip: what the button does.
    JobReview(const char *id, QWidget *parent);

    void begin(EncoderSession &encoder, std::vector<ReviewColumn> columns, const QString &tip,
               TextSize size = TextSize::normal);
    virtual Contents contents(const EncoderSession &encoder, bool writesAll) const = 0;
    void showContents();

    void addTitle(QWidget *title);
    void showInstead(QWidget *picture); // of the table: it says the same of one value
    void addOption(QWidget *option);
    void offerToWriteAll(bool on);
    QTableView &table() { return *m_table; }

    void keyPressEvent(QKeyEvent *event) override;

private:
    void layOut();
    void allow();
    void showCost();
    void keepRowsInSight();
    void keepScrollBar(int least, int most);
    void showCurrentRow(const QModelIndex &index);

    QPointer<EncoderSession> m_encoder;
    QuickPress m_press;
    Job m_job;
    int m_writes = 0; // to the EEPROM, at most
    ReviewTable *m_model;
    QWidget *m_parts; // rows and notes
    ContentScrollArea *m_area;
    WholeTable *m_table;
    InlineMessage *m_problem;
    QLabel *m_notes;
    EepromGate *m_gate;
    QLabel *m_cost;
    QBoxLayout *m_options;
    QCheckBox *m_writeAll;
    QPushButton *m_write;
    QPushButton *m_cancel;
};

} // namespace codewheel
