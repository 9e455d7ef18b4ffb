// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/job_review.h"

#include "catalog/kept_values.h"
#include "journal/eeprom_cost.h"
#include "vocabulary/refusal_text.h"
#include "widgets/eeprom/eeprom_gate.h"
#include "widgets/look/content_scroll_area.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_cells.h"
#include "widgets/look/wrapped_label.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QPushButton>
#include <QScrollBar>

#include <algorithm>

namespace codewheel {
namespace {

constexpr int narrowestColumn = 40; // px: longer texts wrap
constexpr int reviewRowsInSight = 2;
constexpr int mostInSight = 8 * grid::largeIcon; // px, where texts wrap much

QString atMostText(int writes)
{
    return JobReview::tr("EEPROM writes by this: at most %1.").arg(writes);
}

QString statedText(const EncoderSession &encoder)
{
    const auto budget = encoder.can().eepromBudget;
    return budget ? JobReview::tr("The manual states about %1 writes for the encoder's life.").arg(*budget)
                  : QString();
}

} // namespace

QString eepromCostText(const EncoderSession &encoder, int atMost)
{
    return QStringLiteral("%1 %2").arg(atMostText(atMost), statedText(encoder)).trimmed();
}

JobReview::JobReview(const char *id, QWidget *parent)
    : QWidget(parent)
    , m_model(new ReviewTable(this))
    , m_parts(new QWidget(this))
    , m_area(new ContentScrollArea(m_parts, this))
    , m_table(new WholeTable(m_parts))
    , m_problem(new InlineMessage(m_parts))
    , m_notes(wrappedLabel(m_parts))
    , m_gate(new EepromGate(m_parts))
    , m_cost(wrappedLabel(this, "eepromCost"))
    , m_options(new QHBoxLayout)
    , m_writeAll(new QCheckBox(tr("Write &all, including what is there"), this))
    , m_write(new QPushButton(lineIcon(Icon::write), {}, this))
    , m_cancel(new QPushButton(tr("&Cancel"), this))
{
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("What will be written"));
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setMinimumSectionSize(narrowestColumn);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setShowGrid(false);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // no value may be out of sight
    WrappedCells::useIn(*m_table);
    m_write->setObjectName(QLatin1String(id));
    m_write->setAccessibleName(tr("Write what is shown"));
    m_write->setDefault(true);
    m_write->hide(); // until it is known what it writes
    m_cancel->setToolTip(tr("Back; nothing is sent (Esc)"));
    m_writeAll->setToolTip(tr("Writes everything that is wanted once more."));

    layOut();
    connect(m_writeAll, &QCheckBox::toggled, this, &JobReview::showContents);
    connect(m_gate, &EepromGate::changed, this, &JobReview::allow);
    connect(m_write, &QPushButton::clicked, this, [this] {
        if (!m_press.isSecond())
            Q_EMIT confirmed(m_job);
    });
    connect(m_cancel, &QPushButton::clicked, this, &JobReview::cancelled);
    // Not in the middle of a layout, which it would begin anew.
    connect(m_table, &WholeTable::heightChanged, this, &JobReview::keepRowsInSight, Qt::QueuedConnection);
    connect(m_area->verticalScrollBar(), &QScrollBar::rangeChanged, this, &JobReview::keepScrollBar);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &JobReview::showCurrentRow);
}

void JobReview::layOut()
{
    m_options->addWidget(m_writeAll, 1);
    layOutColumn(m_parts, {m_problem, {m_table, 1}, m_notes, m_options, m_gate}, {.margins = QMargins()});
    layOutColumn(this, {{m_area, 1}, m_cost, layOutRow({{m_write, 1}, m_cancel})}, {.margins = QMargins()});
}

// Rows are higher where a scroll bar leaves them less width, so during a review the room only grows.
void JobReview::keepRowsInSight()
{
    const int wanted = std::min(m_table->heightOf(reviewRowsInSight), mostInSight);
    if (!m_table->isHidden() && wanted > m_area->minimumHeight())
        m_area->setMinimumHeight(wanted);
}

// Without it there would be room for wider, lower rows, which need none: it would come and go for ever.
void JobReview::keepScrollBar(int, int most)
{
    if (most > 0)
        m_area->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
}

// By the keyboard.
void JobReview::showCurrentRow(const QModelIndex &index)
{
    const QRect row = m_table->visualRect(index);
    const QPoint middle = m_table->viewport()->mapTo(m_parts, row.center());
    m_area->ensureVisible(middle.x(), middle.y(), 0, row.height());
}

void JobReview::addTitle(QWidget *title)
{
    static_cast<QBoxLayout *>(layout())->insertWidget(0, title);
}

void JobReview::showInstead(QWidget *picture)
{
    auto *rows = static_cast<QBoxLayout *>(m_parts->layout());
    rows->insertWidget(rows->indexOf(m_notes) + 1, picture, 1); // what is said comes first
    m_table->hide();
    m_area->setMinimumHeight(0);
}

void JobReview::addOption(QWidget *option)
{
    m_options->addWidget(option);
}

void JobReview::offerToWriteAll(bool on)
{
    m_writeAll->setVisible(on);
}

void JobReview::begin(EncoderSession &encoder, std::vector<ReviewColumn> columns, const QString &tip,
                      TextSize size)
{
    if (m_encoder)
        m_encoder->disconnect(this);
    m_encoder = &encoder;
    m_press.begin();
    m_area->setMinimumHeight(0);
    m_area->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_model->setColumns(std::move(columns), size);
    m_write->setToolTip(tip);
    m_write->show();
    m_writeAll->setToolTip(
        keepsValues(encoder.device())
            ? tr("Writes everything that is wanted once more. That costs EEPROM writes.")
            : tr("Writes everything that is wanted once more. That costs no EEPROM write."));
    connect(&encoder, &EncoderSession::knownChanged, this, &JobReview::showContents);
    connect(&encoder, &EncoderSession::latestChanged, this, [this] {
        if (isVisible()) // mode and the word in OUT decide what is sent
            showContents();
    });
    m_writeAll->setChecked(false);
    showContents();
    m_area->verticalScrollBar()->setValue(0);
    (m_write->isEnabled() ? m_write : m_cancel)->setFocus();
}

void JobReview::showContents()
{
    if (!m_encoder)
        return;
    Contents shown = contents(*m_encoder, m_writeAll->isChecked());
    m_job = std::move(shown.job);
    m_model->show(std::move(shown.rows));
    m_writes = m_model->rowCount() == 0 ? 0 : mostEepromWrites(*m_encoder, m_job);
    m_write->setText(shown.write);
    m_gate->setWrites(*m_encoder, m_writes);
    allow();
    if (shown.problem)
        m_problem->showMessage(Role::attention, refusalText(*shown.problem));
    else
        m_problem->withdraw();
    shown.notes.removeAll(QString());
    m_notes->setText(shown.problem ? QString() : shown.notes.join(u'\n'));
    m_cost->setVisible(!shown.problem);
}

void JobReview::allow()
{
    m_write->setEnabled(m_model->rowCount() > 0 && m_gate->isOpen());
    showCost();
}

// What has to be agreed to may be further down.
void JobReview::showCost()
{
    QStringList sentences{m_encoder ? eepromCostText(*m_encoder, m_writes) : atMostText(m_writes)};
    if (!m_gate->isOpen())
        sentences << tr("Agree to that first, at the end of the list.");
    m_cost->setText(sentences.join(u' '));
}

void JobReview::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape)
        Q_EMIT cancelled();
    else
        QWidget::keyPressEvent(event);
}

} // namespace codewheel
