// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/kinds/interbus/gateway/registers_page.h"

#include "kinds/interbus/gateway/gateway_check_text.h"
#include "vocabulary/hex.h"
#include "widgets/kinds/interbus/gateway/word_readings_model.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"
#include "widgets/look/inline_message.h"
#include "widgets/look/layouts.h"
#include "widgets/look/wrapped_label.h"

#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

namespace codewheel {
namespace {

WordOrder otherOrder(WordOrder order)
{
    return order == WordOrder::abcd ? WordOrder::cdab : WordOrder::abcd;
}

QString readingText(const WordReading &word)
{
    const QString verdict = plausibilityText(word.plausibility);
    const QString what =
        QStringLiteral("%1  %2  %3").arg(wordOrderName(word.order), hexWord(word.word), verdict);
    return word.meaning.isEmpty() ? what : QStringLiteral("%1: %2").arg(what, word.meaning);
}

} // namespace

RegistersPage::RegistersPage(QWidget *parent)
    : Page(parent)
    , m_model(new WordReadingsModel(this))
    , m_table(describe(new QTableView(this), "registers", tr("Registers of the devices"),
                       tr("The IN word of each device in the four orders. Bold: as it is read now")))
    , m_meanings(wrappedLabel(this, "meanings"))
    , m_told(new InlineMessage(this))
    , m_order(new InlineMessage(this))
    , m_read(new QPushButton(lineIcon(Icon::read), tr("Read &now"), this))
    , m_swap(new QPushButton(this))
{
    setAccessibleName(title());
    makeTable();
    m_meanings->setTextFormat(Qt::PlainText);
    m_meanings->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    for (QPushButton *button : {m_read, m_swap})
        button->setAutoDefault(false);
    connect(m_read, &QPushButton::clicked, this, &RegistersPage::read);
    connect(m_swap, &QPushButton::clicked, this, [this] { Q_EMIT orderWanted(otherOrder(m_set)); });
    connect(m_order, &InlineMessage::actionTriggered, this,
            [this] { Q_EMIT orderWanted(otherOrder(m_set)); });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &RegistersPage::showChosen);
    layOutColumn(this, {m_order, {m_table, 1}, m_meanings, m_told, layOutRow({Stretch{1}, m_read, m_swap})},
                 {.spacing = grid::margin, .margins = allAround(grid::margin)});
    setFocusProxy(m_table);
    showChosen();
    showOrder();
}

RegistersPage::~RegistersPage()
{
    m_table->setModel(nullptr);
}

void RegistersPage::makeTable()
{
    m_table->setModel(m_model);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setShowGrid(false);
    m_table->setIconSize({grid::smallIcon, grid::smallIcon});
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    for (const int narrow :
         {WordReadingsModel::place, WordReadingsModel::inRegisters, WordReadingsModel::outRegisters})
        m_table->horizontalHeader()->setSectionResizeMode(narrow, QHeaderView::ResizeToContents);
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 2 * grid::unit);
}

QString RegistersPage::effect() const
{
    return tr("Only reads. The word order is kept in the project.");
}

void RegistersPage::show(std::vector<DeviceRegisters> devices, WordOrder set, bool isLive)
{
    m_set = set;
    m_isLive = isLive;
    m_model->show(std::move(devices), set);
    if (chosen() < 0 && m_model->rowCount() > 0)
        m_table->setCurrentIndex(m_model->index(0, 0));
    showChosen();
    showOrder();
}

void RegistersPage::choose(const NodeId &device)
{
    for (int row = 0; row < m_model->rowCount(); ++row)
        if (m_model->rowAt(row).place == device)
            m_table->setCurrentIndex(m_model->index(row, 0));
}

int RegistersPage::chosen() const
{
    return m_table->currentIndex().isValid() ? m_table->currentIndex().row() : -1;
}

void RegistersPage::showChosen()
{
    QStringList lines;
    if (chosen() >= 0)
        for (const WordReading &word : m_model->rowAt(chosen()).readings)
            lines << readingText(word);
    const QString text = lines.join(u'\n');
    if (m_meanings->text() != text)
        m_meanings->setText(text);
    showButtons();
}

// Only if all words together leave one order.
void RegistersPage::showOrder()
{
    const auto fits = m_model->onlyFitting();
    if (!fits || *fits == m_set)
        m_order->withdraw();
    else
        m_order->showMessage(Role::attention,
                             *fits == WordOrder::cdab
                                 ? tr("What the registers show can only be low word first.")
                                 : tr("What the registers show can only be high word first."),
                             *fits == WordOrder::cdab ? tr("Set low word first") : tr("Set high word first"));
    m_swap->setText(m_set == WordOrder::abcd ? tr("&Set low word first") : tr("&Set high word first"));
    m_swap->setToolTip(tr("For IN and OUT of all devices, kept in the project. A bus that is connected is "
                          "connected anew, in Watch (Alt+S)"));
}

void RegistersPage::setReading(bool on)
{
    m_isReading = on;
    if (on)
        m_told->withdraw();
    showButtons();
}

void RegistersPage::showButtons()
{
    m_read->setEnabled(chosen() >= 0 && !m_isLive && !m_isReading);
    m_read->setToolTip(m_isLive ? tr("The bus is connected: what is shown is read with each exchange")
                                : tr("Connects to the gateway, reads the registers of the chosen device, and "
                                     "disconnects (Alt+N)"));
}

void RegistersPage::read()
{
    if (chosen() >= 0)
        Q_EMIT readWanted(m_model->rowAt(chosen()).place);
}

void RegistersPage::tell(const QString &sentence)
{
    m_told->showMessage(Role::attention, sentence);
}

} // namespace codewheel
