// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/cam_review.h"

#include "encoder/hex.h"
#include "encoder/refusal_text.h"
#include "widgets/cams/cam_review_rows.h"
#include "widgets/eeprom/eeprom_gate.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTableView>

#include <algorithm>

namespace codewheel {

QVariant CamReviewModel::headerCell(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return QVariant((column == oldColumn ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case programColumn:
        return tr("Program");
    case wordColumn:
        return tr("Word");
    case meaningColumn:
        return tr("Meaning");
    default:
        return tr("Encoder has");
    }
}

QVariant CamReviewModel::cell(const CamReviewRow &row, int column, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
    case Qt::ToolTipRole:
        return text(row, column);
    case Qt::TextAlignmentRole:
        return QVariant((column == oldColumn ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    case Qt::FontRole:
        return column == wordColumn ? numberFont() : textFont();
    default:
        return {};
    }
}

QString CamReviewModel::text(const CamReviewRow &row, int column) const
{
    switch (column) {
    case programColumn:
        return row.program ? QString::number(*row.program) : QString();
    case wordColumn:
        return hexWord(row.word);
    case meaningColumn:
        return row.meaning;
    default:
        return row.old;
    }
}

CamReview::CamReview(QWidget *parent)
    : QWidget(parent)
    , m_model(new CamReviewModel(this))
    , m_title(new QLabel(this))
    , m_table(new QTableView(this))
    , m_notes(new QLabel(this))
    , m_gate(new EepromGate(this))
    , m_afterwards(describe(new QComboBox(this), tr("Mode afterwards"),
                            tr("Cams are written in cam mode: the position is away meanwhile. A program is "
                               "stored in EEPROM when it is left.")))
    , m_writeAll(new QCheckBox(tr("Write &all, also what is there"), this))
    , m_write(describe(new QPushButton(lineIcon(Icon::write), {}, this), "confirmWriteCams",
                       tr("Write these words"),
                       tr("Sends these words in this order, and reads before and after")))
    , m_cancel(new QPushButton(tr("&Cancel"), this))
{
    m_table->setModel(m_model);
    m_table->setAccessibleName(tr("What will be written"));
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(CamReviewModel::meaningColumn, QHeaderView::Stretch);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setShowGrid(false);
    m_table->setWordWrap(false);
    m_table->setMinimumHeight(2 * grid::largeIcon);
    QFont strong = font();
    strong.setBold(true);
    m_title->setFont(strong);
    m_notes->setWordWrap(true);
    m_writeAll->setToolTip(tr("Writes every cam of the program once more"));
    m_write->setDefault(true);
    m_cancel->setToolTip(tr("Back to the editor; nothing is sent (Esc)"));

    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(grid::margin);
    buttons->addWidget(m_writeAll);
    buttons->addStretch();
    buttons->addWidget(m_write);
    buttons->addWidget(m_cancel);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_title);
    layout->addWidget(m_table, 1);
    layout->addWidget(makeAfterwards());
    layout->addWidget(m_notes);
    layout->addWidget(m_gate);
    layout->addLayout(buttons);

    connect(m_writeAll, &QCheckBox::toggled, this, &CamReview::showPlan);
    connect(m_afterwards, &QComboBox::currentIndexChanged, this, &CamReview::showPlan);
    connect(m_gate, &EepromGate::changed, this, &CamReview::allow);
    connect(m_write, &QPushButton::clicked, this, [this] { Q_EMIT confirmed(job()); });
    connect(m_cancel, &QPushButton::clicked, this, &CamReview::cancelled);
}

QWidget *CamReview::makeAfterwards()
{
    auto *line = new QWidget(this);
    auto *row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(grid::groupGap);
    auto *label = new QLabel(tr("A&fterwards the encoder is in"), line);
    label->setBuddy(m_afterwards);
    row->addWidget(label);
    row->addWidget(m_afterwards);
    row->addStretch();
    return line;
}

void CamReview::offerAfterwards(const SwitchMode &before)
{
    const QSignalBlocker untilAllAreThere(m_afterwards);
    m_choices = {before};
    const auto offer = [this](const SwitchMode &mode) {
        if (std::ranges::find(m_choices, mode) == m_choices.end())
            m_choices.push_back(mode);
    };
    offer({.mode = Mode::position});
    offer({.mode = Mode::cam, .camProgram = m_programs.back().number});
    m_afterwards->clear();
    for (const SwitchMode &choice : m_choices)
        m_afterwards->addItem(choice.mode == Mode::position ? tr("position mode")
                              : choice.mode == Mode::velocity
                                  ? tr("velocity mode")
                                  : tr("cam mode, program %1").arg(choice.camProgram));
}

void CamReview::review(EncoderSession &encoder, const std::vector<CamProgram> &programs,
                       const SwitchMode &before)
{
    if (m_encoder)
        m_encoder->disconnect(this);
    m_encoder = &encoder;
    m_programs = programs;
    connect(&encoder, &EncoderSession::knownChanged, this, &CamReview::showPlan);
    connect(&encoder, &EncoderSession::latestChanged, this, [this] {
        if (isVisible())
            showPlan();
    });
    offerAfterwards(before);
    m_title->setText(programs.size() == 1 ? tr("Write cam program %1 to the encoder at %2")
                                                .arg(programs.front().number)
                                                .arg(encoder.place().shown())
                                          : tr("Write %1 cam programs to the encoder at %2")
                                                .arg(programs.size())
                                                .arg(encoder.place().shown()));
    m_writeAll->setChecked(false);
    showPlan();
    (m_write->isEnabled() ? m_write : m_cancel)->setFocus();
}

WriteCams CamReview::job() const
{
    return {.programs = m_programs,
            .onlyWhatDiffers = !m_writeAll->isChecked(),
            .afterwards = m_choices.at(static_cast<std::size_t>(std::max(m_afterwards->currentIndex(), 0)))};
}

void CamReview::showPlan()
{
    if (!m_encoder || m_choices.empty())
        return;
    auto rows = camReviewRows(*m_encoder, job());
    m_problem = rows ? std::nullopt : std::optional(rows.error());
    if (!rows)
        rows.emplace();
    if (*rows != m_model->rows())
        m_model->setRows(*std::move(rows));
    const int count = m_model->rowCount();
    m_write->setText(count == 1 ? tr("&Write this word") : tr("&Write these %1 words").arg(count));
    m_gate->setWrites(*m_encoder, count == 0 ? 0 : mostEepromWrites(*m_encoder, job()));
    allow();
    m_notes->setText(notes());
}

void CamReview::allow()
{
    m_write->setEnabled(m_model->rowCount() > 0 && m_gate->isOpen());
}

QString CamReview::notes() const
{
    QStringList sentences;
    if (m_problem)
        sentences << refusalText(*m_problem);
    else if (m_model->rowCount() == 0)
        sentences << tr("The encoder is known to have all of it. There is nothing to write.");
    else
        sentences << notesOnWords();
    sentences << tr("A program that is changed is stored in EEPROM when it is left: one write. EEPROM writes "
                    "so far "
                    "by this program: %1.")
                     .arg(m_encoder->eepromCount().writes);
    if (const auto budget = m_encoder->can().eepromBudget)
        sentences << tr("The manual states about %1 writes for the encoder's life.").arg(*budget);
    return sentences.join(QLatin1Char(' '));
}

QString CamReview::notesOnWords() const
{
    QString readOuts = tr("Not listed are the words that read: 2020.... and the 00000000 behind each.");
    if (m_writeAll->isChecked())
        return readOuts;
    QStringList sentences{tr("The encoder is read first; what it already has is not written again."),
                          readOuts};
    QStringList opening;
    for (const CamReviewRow &row : m_model->rows())
        if (row.isThere && !opening.contains(hexWord(row.word)))
            opening << hexWord(row.word);
    if (!opening.isEmpty())
        sentences
            << tr("Sent although it is there: %1. Outside cam mode the word behind it would mean something "
                  "else.")
                   .arg(opening.join(QStringLiteral(", ")));
    return sentences.join(QLatin1Char(' '));
}

void CamReview::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape)
        Q_EMIT cancelled();
    else
        QWidget::keyPressEvent(event);
}

} // namespace codewheel
