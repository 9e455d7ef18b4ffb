// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/write_review.h"

#include "catalog/value_text.h"
#include "encoder/refusal_text.h"
#include "line/line_encoder_session.h"
#include "widgets/eeprom/eeprom_gate.h"
#include "widgets/look/fonts.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/wrapped_cells.h"
#include "widgets/models/device_traits.h"
#include "widgets/parameters/parameter_words.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableView>

namespace codewheel {
namespace {

constexpr int narrowestColumn = 50; // px: what is longer stands on more lines

QString howItIsSent(const DeviceDescription &device)
{
    if (isOnLine(device))
        return WriteReview::tr("Sends these requests, and reads back each value");
    return activatesByRun(device)
               ? WriteReview::tr("Sends these words, then run (80000000)")
               : WriteReview::tr("Sends these words, each with its handshake on the service bit");
}

} // namespace

void WriteReviewModel::show(const EncoderSession &encoder, const WritePlan &plan)
{
    m_encoder = &encoder;
    setRows(plan.rows);
}

// Requests and factors are long, and the dock is narrow.
TextSize WriteReviewModel::size() const
{
    return m_encoder && isOnLine(m_encoder->device()) ? TextSize::small : TextSize::normal;
}

QVariant WriteReviewModel::headerCell(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return QVariant((column == name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::FontRole)
        return textFont(size());
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case name:
        return tr("Parameter");
    case oldValue:
        return tr("Old");
    case newValue:
        return tr("New");
    default:
        return m_encoder && isOnLine(m_encoder->device()) ? tr("Request") : tr("Word");
    }
}

QVariant WriteReviewModel::cell(const WritePlan::Row &row, int column, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
        return text(row, column);
    case Qt::ToolTipRole:
        if (column == oldValue && m_encoder)
            return parameter_words::howKnown(row.known,
                                             row.known ? m_encoder->dateTime(row.known->at) : QDateTime());
        if (column != word)
            return text(row, column);
        return row.step.line.isEmpty() ? tr("The word that will stand in OUT")
                                       : tr("What will be sent, between ESC and CR LF");
    case Qt::TextAlignmentRole:
        return QVariant((column == name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    case Qt::FontRole:
        return column == word ? numberFont(size()) : textFont(size());
    default:
        return {};
    }
}

QString WriteReviewModel::text(const WritePlan::Row &row, int column) const
{
    const ParameterDescription *parameter =
        m_encoder ? m_encoder->device().find(row.value.parameter) : nullptr;
    if (parameter == nullptr)
        return {};
    switch (column) {
    case name:
        return parameterName(row.value.parameter);
    case oldValue:
        return row.known ? valueText(*parameter, row.known->value, explainOptionsOf(m_encoder))
                         : tr("unknown");
    case newValue:
        return valueText(*parameter, row.value.value, explainOptionsOf(m_encoder));
    default:
        return sentText(row.step);
    }
}

WriteReview::WriteReview(QWidget *parent)
    : QWidget(parent)
    , m_model(new WriteReviewModel(this))
    , m_table(new QTableView(this))
    , m_problem(new InlineMessage(this))
    , m_notes(new QLabel(this))
    , m_gate(new EepromGate(this))
    , m_writeAll(new QCheckBox(tr("Write &all, also what is there"), this))
    , m_write(new QPushButton(lineIcon(Icon::write), {}, this))
    , m_cancel(new QPushButton(tr("&Cancel"), this))
{
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("What will be written"));
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table->horizontalHeader()->setMinimumSectionSize(narrowestColumn);
    m_table->horizontalHeader()->setSectionResizeMode(WriteReviewModel::word, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setShowGrid(false);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // no value may be out of sight
    WrappedCells::useIn(*m_table);
    m_notes->setWordWrap(true);
    m_writeAll->setToolTip(tr("Writes every wanted value once more. Each costs an EEPROM write."));
    m_write->setObjectName(QStringLiteral("confirmWrite"));
    m_write->setDefault(true);
    m_write->hide(); // until it is known what it writes
    m_cancel->setToolTip(tr("Back to the table; nothing is sent (Esc)"));

    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_write, 1);
    buttons->addWidget(m_cancel);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_problem);
    layout->addWidget(m_notes);
    layout->addWidget(m_gate);
    layout->addWidget(m_writeAll);
    layout->addLayout(buttons);

    connect(m_writeAll, &QCheckBox::toggled, this, &WriteReview::showPlan);
    connect(m_gate, &EepromGate::changed, this, &WriteReview::allow);
    m_write->setAccessibleName(tr("Write these values"));
    connect(m_write, &QPushButton::clicked, this, [this] { Q_EMIT confirmed(m_plan.job); });
    connect(m_cancel, &QPushButton::clicked, this, &WriteReview::cancelled);
}

void WriteReview::review(EncoderSession &encoder, const ParameterValues &wanted)
{
    if (m_encoder)
        m_encoder->disconnect(this);
    m_encoder = &encoder;
    m_wanted = wanted;
    m_write->setToolTip(howItIsSent(encoder.device()));
    m_write->show();
    connect(&encoder, &EncoderSession::knownChanged, this, &WriteReview::showPlan);
    m_writeAll->setChecked(false);
    showPlan();
    (m_write->isEnabled() ? m_write : m_cancel)->setFocus();
}

void WriteReview::showPlan()
{
    if (!m_encoder)
        return;
    m_plan = planWrite(*m_encoder, {.wanted = m_wanted, .writeAll = m_writeAll->isChecked()});
    m_model->show(*m_encoder, m_plan);
    const int count = m_model->rowCount();
    m_write->setText(count == 1 ? tr("&Write this value") : tr("&Write these %1 values").arg(count));
    m_gate->setWrites(*m_encoder, count == 0 ? 0 : mostEepromWrites(*m_encoder, m_plan.job));
    allow();
    if (m_plan.refusal)
        m_problem->showMessage(Role::attention, refusalText(*m_plan.refusal));
    else
        m_problem->withdraw();
    m_notes->setText(notes());
}

void WriteReview::allow()
{
    m_write->setEnabled(m_model->rowCount() > 0 && m_gate->isOpen());
}

QString WriteReview::notes() const
{
    if (m_plan.refusal)
        return {}; // it is told in its place
    QStringList lines;
    if (m_plan.rows.empty())
        lines << tr("The encoder is known to have all wanted values. There is nothing to write.");
    else if (!m_plan.leftOut.empty())
        lines << tr("Left out because they are there already: %1.").arg(m_plan.leftOut.size());
    if (m_plan.job.onlyWhatDiffers)
        lines << tr("The encoder is read first; what it already has is not written again.");
    if (m_plan.stepsMayBeLess)
        lines << tr("If the encoder counts steps minus 1, the word for the steps is one less.");
    for (const ValueNote &note : m_plan.notes)
        lines << noteText(note);
    if (valueOf(m_plan.job.values, Parameter::preset))
        lines << tr("The preset acts once it is initialised (40000000).");
    lines << tr("EEPROM writes: %1 so far by this program, up to %2 with this.")
                 .arg(m_encoder->eepromCount().writes)
                 .arg(m_plan.rows.size());
    if (const auto budget = m_encoder->can().eepromBudget)
        lines << tr("The manual states about %1 writes for the encoder's life.").arg(*budget);
    return lines.join(QLatin1Char('\n'));
}

void WriteReview::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape)
        Q_EMIT cancelled();
    else
        QWidget::keyPressEvent(event);
}

} // namespace codewheel
