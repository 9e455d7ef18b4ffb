// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/job/job_review.h"

#include "encoder/refusal_text.h"
#include "journal/eeprom_cost.h"
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
#include <QKeyEvent>
#include <QPushButton>
#include <QTableView>

namespace codewheel {
namespace {

constexpr int narrowestColumn = 50; // px: longer texts wrap

} // namespace

QString eepromCostText(const EncoderSession &encoder, int atMost)
{
    QString text = JobReview::tr("EEPROM writes by this: at most %1.").arg(atMost);
    if (const auto budget = encoder.can().eepromBudget)
        text +=
            u' ' + JobReview::tr("The manual states about %1 writes for the encoder's life.").arg(*budget);
    return text;
}

JobReview::JobReview(const char *id, QWidget *parent)
    : QWidget(parent)
    , m_model(new ReviewTable(this))
    , m_table(new QTableView(this))
    , m_problem(new InlineMessage(this))
    , m_notes(wrappedLabel(this))
    , m_gate(new EepromGate(this))
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
    m_table->setMinimumHeight(2 * grid::largeIcon);
    WrappedCells::useIn(*m_table);
    m_writeAll->setToolTip(tr("Writes everything that is wanted once more. That costs EEPROM writes."));
    m_write->setObjectName(QLatin1String(id));
    m_write->setAccessibleName(tr("Write what is shown"));
    m_write->setDefault(true);
    m_write->hide(); // until it is known what it writes
    m_cancel->setToolTip(tr("Back; nothing is sent (Esc)"));

    m_options->addWidget(m_writeAll, 1);
    layOutColumn(this,
                 {{m_table, 1}, m_problem, m_notes, m_gate, m_options, layOutRow({{m_write, 1}, m_cancel})},
                 {.margins = QMargins()});

    connect(m_writeAll, &QCheckBox::toggled, this, &JobReview::showContents);
    connect(m_gate, &EepromGate::changed, this, &JobReview::allow);
    connect(m_write, &QPushButton::clicked, this, [this] { Q_EMIT confirmed(m_job); });
    connect(m_cancel, &QPushButton::clicked, this, &JobReview::cancelled);
}

void JobReview::addTitle(QWidget *title)
{
    static_cast<QBoxLayout *>(layout())->insertWidget(0, title);
}

void JobReview::showInstead(QWidget *picture)
{
    auto *rows = static_cast<QBoxLayout *>(layout());
    rows->insertWidget(rows->indexOf(m_table), new ContentScrollArea(picture, this), 1);
    m_table->hide();
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
    m_model->setColumns(std::move(columns), size);
    m_write->setToolTip(tip);
    m_write->show();
    connect(&encoder, &EncoderSession::knownChanged, this, &JobReview::showContents);
    connect(&encoder, &EncoderSession::latestChanged, this, [this] {
        if (isVisible()) // mode and the word in OUT decide what is sent
            showContents();
    });
    m_writeAll->setChecked(false);
    showContents();
    (m_write->isEnabled() ? m_write : m_cancel)->setFocus();
}

void JobReview::showContents()
{
    if (!m_encoder)
        return;
    Contents shown = contents(*m_encoder, m_writeAll->isChecked());
    m_job = std::move(shown.job);
    m_model->show(std::move(shown.rows));
    const int writes = m_model->rowCount() == 0 ? 0 : mostEepromWrites(*m_encoder, m_job);
    m_write->setText(shown.write);
    m_gate->setWrites(*m_encoder, writes);
    allow();
    if (shown.problem)
        m_problem->showMessage(Role::attention, refusalText(*shown.problem));
    else
        m_problem->withdraw();
    shown.notes << eepromCostText(*m_encoder, writes);
    m_notes->setText(shown.problem ? QString() : shown.notes.join(u'\n'));
}

void JobReview::allow()
{
    m_write->setEnabled(m_model->rowCount() > 0 && m_gate->isOpen());
}

void JobReview::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape)
        Q_EMIT cancelled();
    else
        QWidget::keyPressEvent(event);
}

} // namespace codewheel
