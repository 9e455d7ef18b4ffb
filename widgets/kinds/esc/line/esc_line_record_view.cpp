// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/line/esc_line_record_view.h"

#include "kinds/esc/line/esc_line_session.h"
#include "vocabulary/sentence.h"
#include "widgets/kinds/esc/line/esc_line_row_options.h"
#include "widgets/kinds/esc/line/replay_model.h"
#include "widgets/look/fitted_columns.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/quiet_table.h"
#include "widgets/trace/traffic_table.h"

#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int writesNamed = 10; // in the question; the table lists all writes

std::vector<ShownTraffic> shownRows(const EscLineRecord &record, EscLineTraffic &traffic)
{
    std::vector<ShownTraffic> rows;
    rows.reserve(record.rows.size());
    for (const auto &[what, typed] : record.rows) {
        TrafficRow &row = rows.emplace_back(ShownTraffic{traffic.row(what)}).what;
        row.isTyped = typed;
        row.time = WallTime(record.begin).dateTime(row.at);
    }
    return rows;
}

bool writes(const ReplayStep &step)
{
    return esc::shapeOf(step.request.command).writes;
}

} // namespace

EscLineRecordView::EscLineRecordView(QWidget *parent)
    : QWidget(parent)
    , m_replay(new EscLineReplay(this))
    , m_rows(new TrafficModel(lineTrafficColumns, static_cast<int>(EscLineRecord::mostRows), this))
    , m_steps(new ReplayModel(this))
    , m_title(new QLabel(this))
    , m_table(new TrafficTable(*m_rows, tr("Rows of the saved session"), this))
    , m_question(new InlineMessage(this))
    , m_message(new InlineMessage(this))
    , m_stepTable(new QTableView(this))
{
    m_title->setTextFormat(Qt::PlainText);
    m_title->setWordWrap(true);
    setUpQuietTable(*m_stepTable, *m_steps, tr("Requests sent again"));
    FittedColumns::useIn(*m_stepTable, ReplayModel::meaning);
    m_stepTable->setMinimumHeight(2 * grid::largeIcon);
    m_stepTable->hide();

    auto *rows = layOut<QVBoxLayout>(this, grid::unit, grid::unit);
    auto *top = new QHBoxLayout;
    top->setSpacing(grid::unit);
    top->addWidget(m_title, 1);
    m_start = addButton(*top, tr("&Replay"),
                        tr("Sends the requests of this session again, and compares the answers (Alt+R)"));
    m_cancel = addButton(*top, tr("Cance&l"), tr("Sends no more of them (Alt+L)"));
    auto *back = addButton(*top, tr("Bac&k to the line"), tr("Closes this session (Alt+K)"));
    rows->addLayout(top);
    rows->addWidget(m_table, 1);
    rows->addWidget(new EscLineRowOptions(*m_table, this));
    rows->addWidget(m_question);
    rows->addWidget(m_message);
    rows->addWidget(m_stepTable, 1);

    connect(m_start, &QPushButton::clicked, this, &EscLineRecordView::replay);
    connect(m_cancel, &QPushButton::clicked, m_replay, &EscLineReplay::cancel);
    connect(back, &QPushButton::clicked, this, &EscLineRecordView::leave);
    connectReplay();
    showWhatIsPossible();
}

QPushButton *EscLineRecordView::addButton(QLayout &row, const QString &text, const QString &toolTip)
{
    auto *button = new QPushButton(text, this);
    button->setAutoDefault(false);
    button->setToolTip(toolTip);
    row.addWidget(button);
    return button;
}

void EscLineRecordView::connectReplay()
{
    connect(m_question, &InlineMessage::actionTriggered, this, [this] { begin(false); });
    connect(m_question, &InlineMessage::otherActionTriggered, this, [this] { begin(true); });
    connect(m_replay, &EscLineReplay::answered, this,
            [this](int step, EscLineReplay::Verdict verdict, const QByteArray &now) {
                m_steps->setAnswer(step, verdict, now);
                m_stepTable->scrollTo(m_steps->index(step, 0));
            });
    connect(m_replay, &EscLineReplay::ended, this, &EscLineRecordView::showEnd);
}

void EscLineRecordView::setLine(EscLineSession *line)
{
    if (m_line)
        m_line->disconnect(this);
    m_replay->cancel();
    m_line = line;
    m_question->withdraw();
    if (line) {
        connect(line, &EscLineSession::stateChanged, this, [this] {
            m_question->withdraw();
            showWhatIsPossible();
        });
        connect(line, &EscLineSession::alarmStopped, this, [this] { m_question->withdraw(); });
    }
    showWhatIsPossible();
}

void EscLineRecordView::setExplainOptions(const esc::ExplainOptions &options)
{
    m_options = options;
    m_traffic.setExplainOptions(options);
    m_rows->tellMeaningsChanged();
    m_steps->setExplainOptions(options);
}

void EscLineRecordView::showRecord(const EscLineRecord &record, const QString &name)
{
    m_replay->cancel();
    m_record = record;
    m_traffic = EscLineTraffic(m_options);
    m_rows->setRows(shownRows(record, m_traffic));
    m_steps->setSteps({});
    m_stepTable->hide();
    m_question->withdraw();
    m_message->withdraw();
    m_title->setText(sentence(tr("%1: %2, %3 Bd, %4; %5 rows", "file, port, baud rate, date and time, count"),
                              {name, record.port, QString::number(record.baudRate),
                               QLocale().toString(record.begin, QLocale::ShortFormat),
                               QLocale().toString(static_cast<qulonglong>(record.rows.size()))}));
}

void EscLineRecordView::leave()
{
    m_replay->cancel();
    Q_EMIT left();
}

void EscLineRecordView::replay()
{
    m_message->withdraw();
    const auto steps =
        replaySteps(m_record, {.automatic = !m_table->filter().hidesAutomatic(), .writes = true});
    m_steps->setSteps(steps);
    m_stepTable->setVisible(!steps.empty());
    if (steps.empty()) {
        m_message->showMessage(Role::attention,
                               tr("This session contains no request to send, except automatic ones: clear "
                                  "\"Hide automatic requests\" to send those again."));
        return;
    }
    const auto count = static_cast<int>(std::ranges::count_if(steps, writes));
    if (count > 0)
        askForWrites(steps, count);
    else
        begin(false);
}

void EscLineRecordView::askForWrites(const std::vector<ReplayStep> &steps, int writeCount)
{
    QStringList named;
    for (const ReplayStep &step : steps)
        if (writes(step) && named.size() < writesNamed)
            named << sentence(QStringLiteral("%1 (%2)"), {QString::fromLatin1(step.request.text()),
                                                          esc::requestText(step.request, m_options)});
    if (writeCount > writesNamed)
        named << tr("and %n more, listed below", nullptr, writeCount - writesNamed);
    const QString question =
        sentence(tr("%1 of the %2 requests write to encoders: %3."),
                 {QLocale().toString(writeCount), QLocale().toString(static_cast<qulonglong>(steps.size())),
                  named.join(QStringLiteral(", "))});
    if (m_line->isOperating())
        m_question->showMessage(Role::attention, question, tr("Send re&ads only"), tr("Send &writes too"));
    else
        m_question->showMessage(
            Role::attention,
            question + u' ' +
                tr("The program only watches: they are left out. Switch to Operate to send them."),
            tr("Send re&ads only"));
}

void EscLineRecordView::begin(bool withWrites)
{
    m_question->withdraw();
    if (!m_line)
        return;
    auto steps =
        replaySteps(m_record, {.automatic = !m_table->filter().hidesAutomatic(), .writes = withWrites});
    m_steps->setSteps(steps);
    m_replay->start(*m_line, std::move(steps));
    showWhatIsPossible();
}

void EscLineRecordView::showEnd(EscLineReplay::End how)
{
    const int same = m_steps->count(EscLineReplay::Verdict::same);
    const int silent = m_steps->count(EscLineReplay::Verdict::noAnswer);
    const int other = m_steps->count(EscLineReplay::Verdict::differs);
    const QString counts =
        sentence(tr("Sent: %1 of %2. The answer was the same: %3, another: %4, none came: %5."),
                 {QLocale().toString(same + silent + other), QLocale().toString(m_steps->rowCount()),
                  QLocale().toString(same), QLocale().toString(other), QLocale().toString(silent)});
    switch (how) {
    case EscLineReplay::End::done:
        m_message->showMessage(silent + other > 0 ? Role::attention : Role::running, counts);
        break;
    case EscLineReplay::End::cancelled:
        m_message->showMessage(Role::attention, tr("Cancelled.") + u' ' + counts);
        break;
    case EscLineReplay::End::portGone:
        m_message->showMessage(Role::fault, tr("The serial line is gone.") + u' ' + counts);
        break;
    case EscLineReplay::End::watchOnly:
        m_message->showMessage(Role::attention,
                               tr("The program only watches now: the next request writes.") + u' ' + counts);
        break;
    }
    showWhatIsPossible();
}

void EscLineRecordView::showWhatIsPossible()
{
    const bool isConnected = m_line && m_line->isOpen() && m_line->latest().connected;
    m_start->setEnabled(isConnected && !m_replay->isRunning());
    m_cancel->setEnabled(m_replay->isRunning());
    m_start->setToolTip(isConnected
                            ? tr("Sends the requests of this session again, and compares the answers (Alt+R)")
                            : tr("The serial line is not open. Connect it first."));
}

} // namespace codewheel
