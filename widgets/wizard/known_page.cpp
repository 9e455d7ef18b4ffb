// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/wizard/known_page.h"

#include "catalog/device_description.h"
#include "catalog/value_text.h"
#include "vocabulary/encoder_session.h"
#include "vocabulary/known_words.h"
#include "vocabulary/refusal_text.h"
#include "widgets/job/known_before_bar.h"
#include "widgets/job/known_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/fitted_columns.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/quiet_table.h"
#include "widgets/look/role_label.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/parameters/value_field.h"

#include <QItemSelectionModel>
#include <QPushButton>
#include <QTableView>

namespace codewheel {
namespace {

ReadParameters everythingOf(const DeviceDescription &device)
{
    ReadParameters job{device.readableValues()};
    std::erase(job.parameters, Parameter::temperature); // not every encoder has one
    return job;
}

} // namespace

KnownPage::KnownPage(Setup &setup, QWidget *parent)
    : WizardPage(setup, tr("What is known"), parent)
    , m_view(named(new QTableView(this), "known"))
    , m_explanation(wrappedLabel(this))
    , m_read(describe(new QPushButton(lineIcon(Icon::read), tr("&Read from encoder"), this), "readAll",
                      tr("Reads all values.")))
    , m_tellLabel(new QLabel(this))
    , m_tellRow(new QHBoxLayout)
    , m_tellUnit(new QLabel(this))
    , m_tell(named(new QPushButton(tr("&Set manually"), this), "tellValue"))
    , m_mode(new RoleLabel(this))
    , m_isPositionMode(describe(new QPushButton(tr("It is in &position mode"), this), "isPositionMode",
                                tr("Say that the encoder is in position mode, not in velocity or cam mode. "
                                   "Setting the position would change a cam otherwise.")))
    , m_problem(new InlineMessage(this))
    , m_before(new KnownBeforeBar(this))
{
    using Kind = ReviewColumn::Kind;
    m_table.setColumns({{tr("Parameter")}, {tr("Value"), Kind::number}, {tr("Known by")}});
    setUpQuietTable(*m_view, m_table, tr("What is known of the encoder"));
    FittedColumns::useIn(*m_view, 0);
    m_tell->setToolTip(tr("Say what the encoder has, for instance from its papers. Nothing is sent."));

    m_tellRow->addWidget(m_tellLabel);
    m_tellRow->addWidget(m_tellUnit);
    m_tellRow->addStretch();
    m_tellRow->addWidget(m_tell);

    layOutColumn(this,
                 {layOutRow({m_read, {m_explanation, 1}}),
                  m_before,
                  m_problem,
                  {m_view, 1},
                  m_tellRow,
                  layOutRow({m_mode, Stretch{1}, m_isPositionMode})},
                 {.spacing = grid::margin});

    setFocusProxy(m_read);
    connect(m_read, &QPushButton::clicked, this, &KnownPage::read);
    connect(m_tell, &QPushButton::clicked, this, &KnownPage::tell);
    connect(m_isPositionMode, &QPushButton::clicked, this, &KnownPage::tellPositionMode);
    connect(m_view->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &KnownPage::selectRow);
}

void KnownPage::enter()
{
    const EncoderSession &encoder = *m_setup.encoder;
    m_problem->withdraw();
    m_before->setEncoder(m_setup.encoder);
    m_read->setVisible(encoder.can().reads);
    m_read->setToolTip(encoder.can().readingHidesPosition
                           ? tr("Reads all values. Each one hides the position for some cycles.")
                           : tr("Reads all values."));
    m_explanation->setText(
        encoder.can().reads && !encoder.can().readingHidesPosition
            ? tr("Reading sends requests, which change nothing.")
        : encoder.can().reads
            ? tr("Reading sends words: the position is hidden for some cycles. Needs Operate.")
            : tr("The %1 has no read-out. Only what was written from here, or set manually, is known.")
                  .arg(encoder.device().fullName()));
    setFocusProxy(encoder.can().reads ? static_cast<QWidget *>(m_read) : m_view);
    showKnown();
    if (!m_view->currentIndex().isValid())
        m_view->selectRow(0);
    selectRow();
    showLatest();
}

bool KnownPage::mayGoOn() const
{
    return !m_reading;
}

void KnownPage::showKnown()
{
    showTable();
    const QModelIndex chosen = m_view->currentIndex();
    if (chosen.isValid() && m_tellField != nullptr && !m_tellField->focusProxy()->hasFocus())
        m_tellField->setValue(m_setup.valueNow(parameterAt(chosen.row())));
}

void KnownPage::showTable()
{
    const EncoderSession &encoder = *m_setup.encoder;
    std::vector<Parameter> parameters;
    std::vector<ReviewRow> rows;
    for (const ParameterDescription &described : encoder.device().parameters) {
        const Parameter parameter = described.parameter;
        if (described.isDetail)
            continue; // irrelevant to the wizard
        const auto known = encoder.known(parameter);
        parameters.push_back(parameter);
        rows.push_back({.cells = {parameterName(described),
                                  known ? valueWithUnit(encoder.device(), {parameter, known->value},
                                                        valueOptionsOf(&encoder))
                                        : QString(QChar(0x2013)),
                                  known_words::word(known)},
                        .tip = known ? known_words::explanation(known, encoder.can().reads)
                                     : (known_words::explanation(known, encoder.can().reads) + u'\n' +
                                        whyNotToldByWord(parameter, encoder))
                                           .trimmed()});
    }
    if (std::exchange(m_parameters, parameters) != parameters)
        m_table.setRows({}); // for an encoder of another kind, no row is selected any more
    m_table.show(std::move(rows));
}

void KnownPage::showPermission()
{
    if (std::exchange(m_isRefused, false))
        m_problem->withdraw();
}

void KnownPage::showLatest()
{
    const bool mayHaveModes = m_setup.encoder->device().mayHaveModes();
    const auto mode = m_setup.encoder->latest().mode;
    m_mode->setVisible(mayHaveModes);
    m_isPositionMode->setVisible(mayHaveModes && mode != Mode::position);
    if (!mode)
        m_mode->setState(Role::attention, tr("Mode not known: position, velocity or cam"));
    else if (*mode == Mode::position)
        m_mode->setState(Role::running, tr("Position mode"));
    else
        m_mode->setState(Role::attention, *mode == Mode::velocity ? tr("Velocity mode") : tr("Cam mode"));
}

void KnownPage::read()
{
    const auto job = m_setup.encoder->start(everythingOf(m_setup.encoder->device()));
    if (!job) {
        m_problem->showMessage(Role::attention, refusalText(job.error()));
        m_isRefused = true;
        return;
    }
    m_problem->withdraw();
    m_reading = *job;
    m_read->setEnabled(false);
    Q_EMIT changed();
}

void KnownPage::showProgress()
{
    if (m_reading)
        m_explanation->setText(tr("Reading, step %1 of %2…")
                                   .arg(m_setup.record.progress.index + 1)
                                   .arg(m_setup.record.progress.steps.size()));
}

void KnownPage::showOutcome(const Outcome &outcome)
{
    if (m_reading != outcome.job)
        return;
    m_reading.reset();
    m_read->setEnabled(true);
    if (outcome.result)
        m_explanation->setText(tr("All values were read."));
    else
        m_problem->showMessage(Role::fault, refusalText(outcome.result.error()));
    m_read->setFocus();
    Q_EMIT changed();
}

void KnownPage::selectRow()
{
    delete std::exchange(m_tellField, nullptr);
    const int row = m_view->currentIndex().row();
    const ParameterDescription *parameter =
        row < 0 ? nullptr : m_setup.encoder->device().find(parameterAt(row));
    const bool canTell = parameter != nullptr && (parameter->canBeWritten || parameter->onLabel);
    m_tellLabel->setVisible(canTell);
    m_tellUnit->setVisible(canTell);
    m_tell->setVisible(canTell);
    if (!canTell)
        return;
    m_tellLabel->setText((parameter->onLabel ? tr("%1, from its label:") : tr("%1, from its papers:"))
                             .arg(parameterName(*parameter)));
    m_tellField = new ValueField(*parameter, tr("unknown"), this);
    m_tellField->setValue(m_setup.valueNow(parameter->parameter));
    m_tellRow->insertWidget(1, m_tellField);
    m_tellUnit->setText(unitText(parameter->unit));
    setTabOrder(m_view, m_tellField);
    setTabOrder(m_tellField, m_tell);
}

void KnownPage::tell()
{
    const auto value = m_tellField->value();
    m_isRefused = false;
    if (!value) {
        m_problem->showMessage(Role::attention, refusalText(value.error()));
        return;
    }
    m_problem->withdraw();
    m_setup.encoder->tell(parameterAt(m_view->currentIndex().row()), *value);
}

void KnownPage::tellPositionMode()
{
    codewheel::tellPositionMode(*m_setup.encoder);
}

} // namespace codewheel
