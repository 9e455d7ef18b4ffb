// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/esc/line/esc_line_panel.h"

#include "kinds/esc/line/esc_line_session.h"
#include "vocabulary/sentence.h"
#include "widgets/kinds/esc/line/esc_line_figures_model.h"
#include "widgets/look/describe.h"
#include "widgets/look/fonts.h"
#include "widgets/look/grid.h"
#include "widgets/look/layouts.h"
#include "widgets/look/role_label.h"

#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QScrollBar>
#include <QTableView>

namespace codewheel {
namespace {

constexpr int linePanelHeight = 300; // the rest is scrolled to

QString characterText(const SerialSettings &settings)
{
    const QString parity = settings.parity == SerialSettings::Parity::none   ? QStringLiteral("N")
                           : settings.parity == SerialSettings::Parity::even ? QStringLiteral("E")
                                                                             : QStringLiteral("O");
    return QString::number(settings.dataBits) + parity + QString::number(settings.stopBits);
}

QString latencyText(LowLatency latency)
{
    switch (latency) {
    case LowLatency::granted:
        return EscLinePanel::tr("granted", "low latency, by the adapter");
    case LowLatency::refused:
        return EscLinePanel::tr("refused by the adapter: answers may come up to 16 ms later");
    case LowLatency::notAsked:
        return EscLinePanel::tr("not asked for", "low latency");
    case LowLatency::notApplicable:
        break;
    }
    return EscLinePanel::tr("no adapter to ask");
}

} // namespace

EscLinePanel::EscLinePanel(QWidget *parent)
    : ScrolledPanel(tr("Serial line"), linePanelHeight, parent)
    , m_state(new RoleLabel(content()))
    , m_figures(new EscLineFiguresModel(this))
    , m_table(describe(new QTableView(content()), tr("Figures of the line and its encoders"),
                       tr("Since the line was opened. Times are from the end of a request to the end of its "
                          "answer; the median is that of the newest 1000.")))
    , m_dropped(new QLabel(content()))
{
    auto *column = layOut<QVBoxLayout>(content(), grid::margin, grid::unit);
    column->addWidget(m_state);
    auto *form = makeForm(nullptr, grid::unit);
    m_port = addLine(*form, tr("Port"), tr("The serial port of this line"));
    m_rate = addLine(*form, tr("Baud rate"), tr("Bits per second; data bits, parity, stop bits"));
    m_latency = addLine(*form, tr("Low latency"),
                        tr("Whether the adapter hands over bytes at once. Where it does not, time-outs are "
                           "longer, and positions come more slowly"));
    m_polling = addLine(*form, tr("Polling"), tr("Whether the encoders are asked in turn"));
    m_mode = addLine(*form, tr("Writing"), tr("In Watch only reads are sent"));
    column->addLayout(form);
    makeTable();
    column->addWidget(m_table);
    m_dropped->setWordWrap(true);
    m_dropped->hide();
    column->addWidget(m_dropped);
    column->addStretch(1);
    showState();
}

EscLinePanel::~EscLinePanel()
{
    m_table->setModel(nullptr);
}

void EscLinePanel::makeTable()
{
    m_table->setModel(m_figures);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setTabKeyNavigation(false);
    m_table->setShowGrid(false);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->verticalHeader()->setHighlightSections(false);
    // Columns are as wide as seven digits, whatever the figures, so that nothing jumps.
    m_table->horizontalHeader()->setDefaultSectionSize(
        QFontMetrics(numberFont()).horizontalAdvance(QStringLiteral("0,000,000")) + 2 * grid::unit);
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + grid::unit);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setFixedHeight(m_figures->rowCount() * m_table->verticalHeader()->defaultSectionSize() +
                            m_table->horizontalHeader()->sizeHint().height() +
                            m_table->horizontalScrollBar()->sizeHint().height() + grid::unit);
}

void EscLinePanel::setLine(EscLineSession *line)
{
    if (m_line)
        m_line->disconnect(this);
    m_line = line;
    if (line) {
        connect(line, &EscLineSession::stateChanged, this, &EscLinePanel::showState);
        connect(line, &EscLineSession::updated, this, &EscLinePanel::showFigures);
        connect(line, &QObject::destroyed, this, [this] { setLine(nullptr); });
    }
    showState();
    showFigures();
}

void EscLinePanel::showState()
{
    const bool isOpen = m_line && m_line->isOpen();
    const bool isConnected = isOpen && m_line->latest().connected;
    if (isConnected)
        m_state->setState(Role::running, tr("Open"));
    else if (isOpen && m_line->latest().otherAdapter)
        m_state->setState(Role::fault, tr("Another adapter is plugged in"));
    else if (isOpen)
        m_state->setState(Role::fault, tr("The port is gone; it is looked for each second"));
    else
        m_state->setState(Role::inactive, tr("Not connected"));
    const QString none = QStringLiteral("\u2013");
    m_port->setText(m_line ? m_line->linkName() : none);
    m_rate->setText(m_line ? sentence(tr("%1 Bd, %2"), {QString::number(m_line->settings().baudRate),
                                                        characterText(m_line->settings())})
                           : none);
    m_latency->setText(isConnected ? latencyText(m_line->latest().lowLatency) : none);
    m_polling->setText(!isConnected ? none : m_line->latest().running ? tr("runs") : tr("stopped"));
    m_mode->setText(!isConnected            ? none
                    : m_line->isOperating() ? tr("Operate: allowed")
                                            : tr("Watch: only reads are sent"));
}

void EscLinePanel::showFigures()
{
    const EscLineSnapshot shown = m_line ? m_line->latest() : EscLineSnapshot();
    m_figures->show(shown);
    m_dropped->setVisible(shown.droppedRows > 0);
    if (shown.droppedRows > 0)
        m_dropped->setText(
            sentence(tr("%1 rows of the terminal were lost: the window was busy for too long."),
                     {QLocale().toString(qulonglong{shown.droppedRows})}));
}

} // namespace codewheel
