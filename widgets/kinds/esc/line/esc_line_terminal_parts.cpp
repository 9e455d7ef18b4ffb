// SPDX-License-Identifier: GPL-3.0-or-later
#include "kinds/esc/line/esc_line_record.h"
#include "widgets/kinds/esc/line/esc_line_record_view.h"
#include "widgets/kinds/esc/line/esc_line_row_options.h"
#include "widgets/kinds/esc/line/esc_line_terminal.h"
#include "widgets/kinds/esc/line/request_field.h"
#include "widgets/look/empty_state.h"
#include "widgets/look/grid.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/tool.h"
#include "widgets/models/go_to_place.h"
#include "widgets/monitor/meaning_line.h"
#include "widgets/trace/traffic_table.h"
#include "widgets/trace/traffic_tools.h"

#include <QAction>
#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>

namespace codewheel {

EscLineTerminal::EscLineTerminal(QWidget *parent)
    : QWidget(parent)
    , m_rows(new TrafficModel(lineTrafficColumns, static_cast<int>(EscLineRecord::mostRows), this))
    , m_pages(new QStackedWidget(this))
    , m_table(new TrafficTable(*m_rows, tr("Traffic on the line"), this))
    , m_record(new EscLineRecordView(this))
    , m_goTo(new GoToPlace(this))
    , m_counts(new MeaningLine(this, Qt::AlignRight))
    , m_answer(new MeaningLine(this))
    , m_field(new RequestField(this))
    , m_send(new QPushButton(lineIcon(Icon::start), tr("Send"), this))
    , m_question(new InlineMessage(this))
    , m_message(new InlineMessage(this))
{
    setAccessibleName(tr("Line terminal"));
    m_pages->addWidget(makePage());
    m_pages->addWidget(m_record);
    auto *layout = layOut<QVBoxLayout>(this, 0);
    layout->addWidget(m_pages, 1);
    setFocusProxy(m_field);

    connect(m_rows, &TrafficModel::countsChanged, this, &EscLineTerminal::showCounts);
    connect(m_field, &QLineEdit::returnPressed, this, &EscLineTerminal::send);
    connect(m_field, &QLineEdit::textChanged, this, [this] {
        m_question->withdraw();
        m_message->withdraw();
    });
    connect(m_send, &QPushButton::clicked, this, &EscLineTerminal::send);
    connect(m_question, &InlineMessage::actionTriggered, this, [this] {
        m_question->withdraw();
        sendNow(*m_asked);
    });
    connect(m_question, &InlineMessage::otherActionTriggered, m_question, &InlineMessage::withdraw);
    connect(m_record, &EscLineRecordView::left, this, [this] { m_pages->setCurrentIndex(0); });
    showCounts();
    showWhatIsPossible();
}

QWidget *EscLineTerminal::makePage()
{
    auto *page = new QWidget(this);
    auto *rows = layOut<QVBoxLayout>(page, grid::unit, QMargins(grid::unit, 0, grid::unit, grid::unit));
    auto *tools = new QToolBar(tr("Line terminal"), page);
    makeTools(*tools);
    rows->addWidget(tools);
    m_content = new QStackedWidget(page);
    m_content->addWidget(m_table);
    m_content->addWidget(new EmptyState(
        Icon::trace, tr("Nothing has passed on the line yet"),
        tr("What is sent and answered on a serial line is shown here. Connect one, or open a saved session."),
        page));
    m_content->setMinimumHeight(2 * grid::largeIcon);
    rows->addWidget(m_content, 1);
    m_rowOptions = new QWidget(page);
    auto *options = layOut<QHBoxLayout>(m_rowOptions, grid::margin);
    auto *columns = new EscLineRowOptions(*m_table, page);
    connect(columns, &EscLineRowOptions::changed, this, &EscLineTerminal::showCounts);
    options->addWidget(columns);
    options->addWidget(m_counts, 1);
    rows->addWidget(m_rowOptions);
    makeSending(*rows);
    return page;
}

void EscLineTerminal::makeTools(QToolBar &bar)
{
    const TrafficTools tools(*this, bar, *m_table, QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C));
    m_follow = tools.follow;
    m_bringBack = tools.bringBack;
    m_save = addTool(*this, bar,
                     {Icon::save, tr("Save"), QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_S),
                      tr("Save all rows in a file, to look at and send again")});
    QAction *opening = addTool(*this, bar,
                               {Icon::open, tr("Open"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O),
                                tr("Look at a saved session, and send it again")});
    bar.insertActions(tools.exportRows, {m_save, opening});
    connect(m_table, &LogTable::chosenChanged, this, [this] { m_goTo->setPlace(m_table->chosenPlace()); });
    connect(m_goTo, &GoToPlace::wanted, this, &EscLineTerminal::goToWanted);
    m_table->addActions({tools.copy, m_goTo, tools.exportRows, tools.clear, m_bringBack});
    connect(tools.hold, &QAction::toggled, m_rows, &TrafficModel::setHeld);
    connect(tools.copy, &QAction::triggered, m_table, &TrafficTable::copy);
    connect(m_save, &QAction::triggered, this, &EscLineTerminal::askSave);
    connect(opening, &QAction::triggered, this, &EscLineTerminal::askOpen);
    connect(tools.exportRows, &QAction::triggered, this, &EscLineTerminal::askExport);
    connect(tools.clear, &QAction::triggered, m_rows, &TrafficModel::clear);
    connect(m_bringBack, &QAction::triggered, m_rows, &TrafficModel::bringBack);
}

// The rows give way to the question before a write, all of which has to be read.
bool EscLineTerminal::eventFilter(QObject *watched, QEvent *event)
{
    const bool comes = event->type() == QEvent::ShowToParent;
    if (watched == m_question && (comes || event->type() == QEvent::HideToParent))
        for (QWidget *part : std::initializer_list<QWidget *>{m_content, m_rowOptions})
            part->setVisible(!comes);
    if (watched == m_question && (comes || event->type() == QEvent::Resize)) // once it is arranged
        QTimer::singleShot(0, this, &EscLineTerminal::keepQuestionWhole);
    return QWidget::eventFilter(watched, event);
}

// A panel does not know that lines wrap.
void EscLineTerminal::keepQuestionWhole()
{
    if (!m_question->isHidden())
        m_question->setMinimumHeight(m_question->heightForWidth(m_question->width()));
}

void EscLineTerminal::makeSending(QVBoxLayout &rows)
{
    m_question->installEventFilter(this);
    rows.addWidget(m_question);
    rows.addWidget(m_message);
    auto *label = new QLabel(tr("Request"), this);
    label->setBuddy(m_field);
    QFont bold = m_answer->font();
    bold.setBold(true);
    m_answer->setFont(bold);
    m_answer->hide();
    rows.addWidget(m_answer);
    m_field->setAccessibleName(tr("Request to send"));
    m_field->setPlaceholderText(QStringLiteral("05P"));
    m_send->setAccessibleName(tr("Send the request"));
    m_send->setAutoDefault(false);
    auto *row = new QHBoxLayout;
    row->setSpacing(grid::groupGap);
    row->addWidget(label);
    row->addWidget(m_field, 1);
    row->addWidget(m_send);
    rows.addLayout(row);
}

} // namespace codewheel
